#pragma once

#include "core/recording/session_clock.h"

namespace rocinante::test {

/// Two clocks that only the test moves. Both begin at 1,000 s.
class FakeClocks {
 public:
  void pass(Nanoseconds duration) {
    steady_ += duration;
    wall_ += duration;
  }
  void setWall(Nanoseconds forward) { wall_ += forward; }
  WallTime wall() const { return wall_; }
  /// A reading 100 ns wide.
  ClockReading look(Nanoseconds width = Nanoseconds(100)) const {
    return {steady_ - width / 2, wall_, steady_ + width / 2};
  }

 private:
  SteadyTime steady_{std::chrono::seconds(1'000)};
  WallTime wall_{std::chrono::seconds(1'000)};
};

inline LogTime logTime(Nanoseconds since_start) {
  return LogTime(std::chrono::seconds(1'000) + since_start);
}

}  // namespace rocinante::test
