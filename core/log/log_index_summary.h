#pragma once

#include <optional>
#include <vector>

#include "core/base/bytes.h"
#include "core/log/log_index.h"

namespace rocinante {

/// The index that the file's own summary holds: empty when there is no summary, or when it is
/// incomplete, damaged, or does not agree with the file. `damage` says so where that is a fault.
std::optional<LogIndex> indexFromSummary(ByteView file, std::vector<DamageSpan>& damage);

}  // namespace rocinante
