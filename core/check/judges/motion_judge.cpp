#include "core/check/judges/motion_judge.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace rocinante {
namespace {

/// Slack of a TIME, and of an arrival, which networks and bursty senders delay.
constexpr double kSentSlack_s = 0.05;
constexpr double kArrivalSlack_s = 0.25;
/// Sensors and senders round.
constexpr double kResolution = 1e-4;
/// A single step at this many times the speed limit is a jump; a slower one is a velocity fault.
constexpr double kJumpFactor = 3;
/// Velocities are measured over intervals at least this long, so that noise is not acceleration.
constexpr double kVelocitySpan_s = 0.05;
/// A value that was not sent for longer is not followed across the gap.
constexpr double kLongestSpan_s = 0.5;
constexpr double kNoise = 1e-3;
/// This many intervals show the usual one.
constexpr std::uint32_t kUsualIntervals = 4;
constexpr double kNearTimes_s = 1e-3;

}  // namespace

void MotionJudge::begin(double value, const PacketPlace& place) {
  is_begun_ = true;
  value_ = value;
  arrived_ = place.time;
  sent_ns_ = place.sent_ns;
  source_ = place.source;
  stretch_ = place.stretch;
  up_ = down_ = {};
  span_moved_ = span_s_ = velocity_span_s_ = 0;
  sent_span_s_ = 0;
  intervals_ = 0;
  is_interval_sent_ = false;
  sequence_ = place.sequence;
}

bool MotionJudge::timesNearlySame() const {
  if (!is_interval_sent_ || intervals_ < kUsualIntervals) return false;
  const double usual_s = (sent_span_s_ - interval_s_) / (intervals_ - 1);
  return interval_s_ < usual_s / 10 || (interval_s_ < kNearTimes_s && interval_s_ < usual_s / 2);
}

MotionJudge::Answer MotionJudge::judge(double value, const PacketPlace& place) {
  if (!is_begun_ || source_ != place.source || stretch_ != place.stretch) {
    begin(value, place);
    return Answer::sound;
  }
  double moved = value - value_;
  if (limits_.wraps) moved = std::remainder(moved, 2 * std::numbers::pi);
  double seconds = static_cast<double>((place.time - arrived_).count()) * 1e-9;
  double slack_s = kArrivalSlack_s;
  // As doubles: two TIMEs may be farther apart than an integer reaches.
  const double sent_s =
      sent_ns_ && place.sent_ns
          ? (static_cast<double>(*place.sent_ns) - static_cast<double>(*sent_ns_)) * 1e-9
          : 0;
  const bool is_sent = sent_s > 0;
  if (is_sent) {
    seconds = sent_s;
    slack_s = kSentSlack_s;
  }
  value_ = value;
  arrived_ = place.time;
  sent_ns_ = place.sent_ns;
  sequence_before_ = std::exchange(sequence_, place.sequence);
  is_interval_sent_ = is_sent;
  interval_s_ = seconds;
  if (is_sent) {
    sent_span_s_ += sent_s;
    ++intervals_;
  }

  const double step = std::abs(moved);
  // The usual case: not too fast now nor before, so that nothing below changes.
  if (step <= limits_.speed * seconds && up_.by == 0 && down_.by == 0 &&
      limits_.acceleration == std::numeric_limits<double>::infinity()) {
    return Answer::sound;
  }
  if (step > limits_.speed * (seconds + slack_s) + kResolution &&
      step > kJumpFactor * limits_.speed * seconds) {
    near_times_ = timesNearlySame();
    begin(value, place);
    distance_ = step;
    seconds_ = seconds;
    return Answer::jump;
  }
  if (limits_.only_jumps) return Answer::sound;
  // Both directions are updated, even if the first one is a fault.
  const bool is_up = take(up_, moved, seconds, slack_s);
  const bool is_down = take(down_, -moved, seconds, slack_s);
  if (is_up || is_down) {
    near_times_ = timesNearlySame();
    span_moved_ = span_s_ = velocity_span_s_ = 0;
    return Answer::velocity;
  }
  if (is_sent && std::isfinite(limits_.acceleration)) return judgeAcceleration(moved, seconds);
  span_moved_ = span_s_ = velocity_span_s_ = 0;
  return Answer::sound;
}

bool MotionJudge::take(Ahead& ahead, double moved, double seconds, double slack_s) {
  ahead.by += moved - limits_.speed * seconds;
  if (!(ahead.by > 0)) {
    ahead = {};
    return false;
  }
  ahead.moved += moved;
  ahead.seconds += seconds;
  if (ahead.by <= limits_.speed * slack_s + kResolution) return false;
  distance_ = ahead.moved;
  seconds_ = ahead.seconds;
  ahead = {};
  return true;
}

// The mean velocities of two adjacent intervals differ by at most acceleration * half of both.
MotionJudge::Answer MotionJudge::judgeAcceleration(double moved, double seconds) {
  span_moved_ += moved;
  span_s_ += seconds;
  if (span_s_ < kVelocitySpan_s) return Answer::sound;
  const double velocity = span_moved_ / span_s_;
  const double span_s = span_s_;
  span_moved_ = span_s_ = 0;
  const double before = std::exchange(velocity_, velocity);
  const double before_s = std::exchange(velocity_span_s_, span_s <= kLongestSpan_s ? span_s : 0);
  if (velocity_span_s_ == 0 || before_s == 0) return Answer::sound;
  const double time = (span_s + before_s) / 2;
  const double noise = kNoise * (1 / span_s + 1 / before_s);
  const double change = std::abs(velocity - before) - noise;
  if (change <= limits_.acceleration * time) return Answer::sound;
  worst_acceleration_ = std::abs(velocity - before) / time;
  seconds_ = span_s + before_s;
  return Answer::acceleration;
}

}  // namespace rocinante
