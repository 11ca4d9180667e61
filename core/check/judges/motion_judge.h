#pragma once

#include <limits>

#include "core/check/judges/tally.h"

namespace rocinante {

/// How a joint value can move. Radians or metres, seconds.
struct MotionLimits {
  double speed = std::numeric_limits<double>::infinity();
  bool only_jumps = false;  ///< `speed` is a guess: only motion far beyond it is reported
  double acceleration = std::numeric_limits<double>::infinity();
  bool wraps = false;  ///< angles that differ by a full turn are equal
};

/// Follows one joint value through time and detects motion that is not possible.
///
/// Time is the sender's TIME; without one, or when it does not advance, the arrival, which is
/// trusted less. Robust against noise and uneven packets: a fault is an interval T in which the
/// value moved farther than speed * (T + slack). Late and lost packets never cause one; the caller
/// must keep out restatements, other sources and new runs: see begin().
class MotionJudge {
 public:
  enum class Answer : std::uint8_t { sound, jump, velocity, acceleration };

  void setLimits(const MotionLimits& limits) { limits_ = limits; }

  /// The value at `place`, taken without judging: another source, a new run.
  void begin(double value, const PacketPlace& place);
  /// The next value starts a new sequence.
  void forget() { is_begun_ = false; }
  Answer judge(double value, const PacketPlace& place);

  /// The last fault: distance, time, and for an acceleration the amount per second squared.
  double distance() const { return distance_; }
  double seconds() const { return seconds_; }
  double acceleration() const { return worst_acceleration_; }
  /// The two values that caused the last jump or velocity fault: whether their TIMEs are much
  /// nearer to each other than usual for this source, so that the TIME and not the value is wrong;
  /// how near, in seconds; and their SEQUENCEs.
  bool timesWereNear() const { return near_times_; }
  double interval() const { return interval_s_; }
  std::uint64_t sequenceBefore() const { return sequence_before_; }
  std::uint64_t sequence() const { return sequence_; }

 private:
  Answer judgeAcceleration(double moved, double seconds);
  bool timesNearlySame() const;

  MotionLimits limits_;
  bool is_begun_ = false;
  double value_ = 0;
  LogTime arrived_{};
  std::optional<std::int64_t> sent_ns_;
  std::uint32_t source_ = 0, stretch_ = 0;
  /// How far it is ahead of what the speed allows, since it last was not: upwards, downwards.
  struct Ahead {
    double by = 0, moved = 0, seconds = 0;
  };
  Ahead up_, down_;
  /// The interval over which the velocity is measured, and the one before it.
  double span_moved_ = 0, span_s_ = 0, velocity_ = 0, velocity_span_s_ = 0;
  double distance_ = 0, seconds_ = 0, worst_acceleration_ = 0;
  /// TIMEs since begin(), to know the usual interval.
  double sent_span_s_ = 0, interval_s_ = 0;
  std::uint32_t intervals_ = 0;
  bool is_interval_sent_ = false, near_times_ = false;
  std::uint64_t sequence_ = 0, sequence_before_ = 0;

  bool take(Ahead& ahead, double moved, double seconds, double slack_s);
};

}  // namespace rocinante
