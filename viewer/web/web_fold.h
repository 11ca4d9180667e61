#pragma once

#include <cstdint>
#include <string>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace rocinante {

/// What folding a whole log gave.
struct WholeFold {
  std::uint64_t messages = 0;  ///< read
  std::uint64_t applied = 0;   ///< changed the state
  std::string state;           ///< xxh3 of the state as packet text
};

/// Reads a log from its beginning to its end and folds every message, without a keyframe's help:
/// what tests/web/fold compares between a browser and this machine.
Result<WholeFold> foldWhole(ByteView log);

}  // namespace rocinante
