#pragma once

#include <limits>

#include "core/check/judges/packet_place.h"

namespace rocinante {

/// How a joint value can move. Radians or metres, seconds.
struct MotionLimits {
  double speed = std::numeric_limits<double>::infinity();
  bool only_jumps = false;  ///< `speed` is a guess: only what is far beyond it is told
  double acceleration = std::numeric_limits<double>::infinity();
  bool wraps = false;  ///< angles that differ by a turn are the same
};

/// Follows one joint value through time and says when it moves as no machine can.
///
/// Time is the sender's TIME; where there is none, or it stands still, the arrival, which is
/// trusted less. Robust against noise and uneven packets: what is told is a stretch of time T in
/// which the value went farther than speed * (T + slack). Late and lost packets never make one;
/// restatements, other sources and new runs are the caller's to keep away: see begin().
class MotionJudge {
 public:
  enum class Answer : std::uint8_t { sound, jump, velocity, acceleration };

  void setLimits(const MotionLimits& limits) { limits_ = limits; }

  /// The value at `place`, taken without judging: another source, a new run.
  void begin(double value, const PacketPlace& place);
  /// The next begins anew.
  void forget() { is_begun_ = false; }
  Answer judge(double value, const PacketPlace& place);

  /// Of the last answer that was not sound: how far, in what time, and, for an acceleration, how
  /// much per second squared.
  double distance() const { return distance_; }
  double seconds() const { return seconds_; }
  double acceleration() const { return worst_acceleration_; }
  /// Of the last jump or velocity, and the two values that made it: whether their TIMEs are far
  /// nearer to each other than TIMEs of this source usually are, so that it is the TIME and not the
  /// value that is wrong; how near, in seconds; how far the value moved between them; and the
  /// SEQUENCEs that said them.
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
  /// The span over which the velocity is being measured, and that of the one before it.
  double span_moved_ = 0, span_s_ = 0, velocity_ = 0, velocity_span_s_ = 0;
  double distance_ = 0, seconds_ = 0, worst_acceleration_ = 0;
  /// TIMEs since begin(), for what is usual.
  double sent_span_s_ = 0, interval_s_ = 0;
  std::uint32_t intervals_ = 0;
  bool is_interval_sent_ = false, near_times_ = false;
  std::uint64_t sequence_ = 0, sequence_before_ = 0;

  bool take(Ahead& ahead, double moved, double seconds, double slack_s);
};

}  // namespace rocinante
