#pragma once

#include "core/base/bytes.h"
#include "core/log/log_index.h"

namespace rocinante {

/// The index made by walking over the whole file, record by record. Chunks are only expanded where
/// their message indexes do not tell enough. Goes on after damage. The file begins with the magic.
LogIndex indexByWalking(ByteView file);

}  // namespace rocinante
