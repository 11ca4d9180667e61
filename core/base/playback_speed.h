#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/base/time.h"

namespace rocinante {

/// Log seconds played per real second, kept as a reduced ratio so that no speed is rounded.
/// A plain value; from 0.01 to 1000.
class PlaybackSpeed {
 public:
  /// "1", "0.25", "10", "3/2". bad_argument when it is not a number, has more than nine digits (on
  /// each side of a slash), or is outside 0.01 .. 1000.
  static Result<PlaybackSpeed> parse(std::string_view text);

  constexpr PlaybackSpeed() = default;

  /// How long `recorded` lasts when played, rounded toward zero to a whole nanosecond. Never
  /// decreases as `recorded` grows. Saturates at the limits of Nanoseconds.
  Nanoseconds realDuration(Nanoseconds recorded) const;
  /// How much of the log plays in `real`; rounded and saturating as above.
  Nanoseconds logDuration(Nanoseconds real) const;

  /// For reports and rates; never used for scheduling.
  double ratio() const { return static_cast<double>(log_part_) / static_cast<double>(real_part_); }
  /// "0.25", "10", "1/3": parse(text()) gives the same speed.
  std::string text() const;

  bool operator==(const PlaybackSpeed&) const = default;

 private:
  constexpr PlaybackSpeed(std::int64_t log_part, std::int64_t real_part)
      : log_part_(log_part), real_part_(real_part) {}

  std::int64_t log_part_ = 1;
  std::int64_t real_part_ = 1;
};

}  // namespace rocinante
