#pragma once

#include "core/base/bytes.h"
#include "core/log/log_index.h"

namespace rocinante {

/// Builds the index by walking over the whole file, record by record. Expands chunks only when
/// their message indexes are not sufficient. Continues after damage. The file must start with the
/// magic.
LogIndex indexByWalking(ByteView file);

}  // namespace rocinante
