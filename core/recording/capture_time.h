#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "core/base/time.h"
#include "core/recording/session_clock.h"
#include "core/report/account.h"

namespace rocinante {

/// The time line of a capture file: its own timestamps, made monotonic. Timestamps slightly out of
/// order (several network cards, several processors) are raised to the time reached; where the
/// clock was set back, time continues from there and the jump is reported as a step. Pure.
class CaptureTime {
 public:
  /// A larger step back is a clock that was set, not disorder.
  static constexpr Nanoseconds kDisorder = std::chrono::milliseconds(20);

  LogTime at(WallTime stamp);
  /// The clock step that the last timestamp revealed, if any.
  std::optional<ClockStep> takeStep() { return std::exchange(step_, std::nullopt); }
  /// How many timestamps were raised, and by how much at most.
  Account leftOut() const;

 private:
  std::optional<LogTime> reached_;
  Nanoseconds shift_{0}, most_raised_{0};
  std::uint64_t raised_ = 0;
  std::optional<ClockStep> step_;
};

}  // namespace rocinante
