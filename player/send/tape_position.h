#pragma once

#include <compare>
#include <cstdint>
#include <limits>

#include "core/base/time.h"

namespace rocinante {

/// A position in several logs played as one, ordered by time, then log, then place in the file. A
/// player's position is not just a time: each of several messages of equal time can be reached.
struct TapePosition {
  LogTime time{};
  std::uint32_t log = 0;          ///< index of the argument, from 0
  std::uint64_t file_offset = 0;  ///< LogMessage::file_offset

  auto operator<=>(const TapePosition&) const = default;

  /// Before every message of `moment`.
  static constexpr TapePosition at(LogTime moment) { return {moment, 0, 0}; }
  /// Right after the message at `place`.
  static constexpr TapePosition behind(TapePosition place) {
    if (place.file_offset < std::numeric_limits<std::uint64_t>::max()) ++place.file_offset;
    return place;
  }
};

}  // namespace rocinante
