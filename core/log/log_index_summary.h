#pragma once

#include <optional>
#include <vector>

#include "core/base/bytes.h"
#include "core/log/log_index.h"

namespace rocinante {

/// The index from the file's own summary: empty when there is none, or when it is incomplete,
/// damaged, or disagrees with the file. `damage` says so if that is a fault.
std::optional<LogIndex> indexFromSummary(ByteView file, std::vector<DamageSpan>& damage);

}  // namespace rocinante
