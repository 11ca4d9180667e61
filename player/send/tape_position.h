#pragma once

#include <compare>
#include <cstdint>
#include <limits>

#include "core/base/time.h"

namespace rocinante {

/// A place on the tape of several logs, in the order in which they are played: before every message
/// that is later, or as early and of a later log, or behind it in the same file. A position of a
/// player is such a place and not a time: of equal times each message can be gone to.
struct TapePosition {
  LogTime time{};
  std::uint32_t log = 0;          ///< which of the arguments, from 0
  std::uint64_t file_offset = 0;  ///< LogMessage::file_offset

  auto operator<=>(const TapePosition&) const = default;

  /// Before every message of `moment`.
  static constexpr TapePosition at(LogTime moment) { return {moment, 0, 0}; }
  /// Right behind the message at `place`.
  static constexpr TapePosition behind(TapePosition place) {
    if (place.file_offset < std::numeric_limits<std::uint64_t>::max()) ++place.file_offset;
    return place;
  }
};

}  // namespace rocinante
