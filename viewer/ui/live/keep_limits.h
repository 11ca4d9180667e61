#pragma once

#include <cstdint>
#include <string_view>

#include "core/base/result.h"
#include "core/base/time.h"

namespace rocinante {

/// How much of a live session the window keeps: whichever is reached first.
struct KeepLimits {
  Nanoseconds time = std::chrono::minutes(10);
  std::uint64_t bytes = 2'000'000'000;

  bool none() const { return time == Nanoseconds(0) || bytes == 0; }
};

/// "10m", "2GB", "10m,2GB" or "0": a duration, a size, both, or nothing at all; what is not given
/// stays as above. bad_argument for less than a second or 10 MB: a piece needs some room.
Result<KeepLimits> parseKeepLimits(std::string_view text);

}  // namespace rocinante
