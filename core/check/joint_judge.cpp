#include "core/check/joint_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace rocinante {
namespace {

/// A value is outside its limits when it is so by more than this: senders round.
constexpr double kLimitSlack = 1e-6;
/// A joint whose model gives no velocity is not believed to cross its whole range faster.
constexpr double kRangeTime_s = 0.2;

constexpr std::array kPlanar = {".x", ".y", ".yaw"};
constexpr std::array kFloating = {".x", ".y", ".z", ".qx", ".qy", ".qz", ".qw"};

}  // namespace

JointJudge::JointJudge(const Joint& joint, std::size_t component,
                       const MotionThresholds& thresholds)
    : name_(joint.name) {
  const bool is_planar = joint.type == JointType::planar;
  const bool is_floating = joint.type == JointType::floating;
  if (is_planar) name_ += kPlanar[component];
  if (is_floating) name_ += kFloating[component];
  is_angle_ = !is_floating && joint.type != JointType::prismatic && (!is_planar || component == 2);
  if (!is_angle_) unit_ = "m";

  MotionLimits motion;
  motion.wraps = joint.type == JointType::continuous || (is_planar && component == 2);
  const bool is_limited = joint.type == JointType::revolute || joint.type == JointType::prismatic;
  if (is_limited && joint.limits) {
    lower_ = joint.limits->lower;
    upper_ = joint.limits->upper;
  }
  // Planar and floating joints have no velocity; a limit of zero is one that was left out.
  if (!is_planar && !is_floating && joint.limits && joint.limits->velocity.value_or(0) > 0) {
    velocity_limit_ = *joint.limits->velocity;
    motion.speed = *velocity_limit_ * thresholds.velocity_factor;
  } else if (std::isfinite(upper_ - lower_) && upper_ > lower_) {
    motion.speed = (upper_ - lower_) / kRangeTime_s;
    motion.only_jumps = true;
  }
  if (thresholds.acceleration > 0 && !motion.only_jumps && !is_planar && !is_floating) {
    acceleration_limit_ = motion.acceleration = thresholds.acceleration;
  }
  motion_.setLimits(motion);
}

void JointJudge::judge(double value, const PacketPlace& place) {
  is_written_ = true;
  value_ = value;
  least_ = std::min(least_, value);
  most_ = std::max(most_, value);
  const double excess = std::max(lower_ - value, value - upper_);
  if (excess <= kLimitSlack) {
    // What is said again says nothing of motion.
    if (!place.is_restated) judgeMotion(value, place);
    return;
  }
  // How it got there is no second fault.
  motion_.forget();
  beyond_.hit(place);
  if (excess > worst_excess_) {
    worst_excess_ = excess;
    worst_ = value;
  }
}

void JointJudge::judgeMotion(double value, const PacketPlace& place) {
  switch (motion_.judge(value, place)) {
    case MotionJudge::Answer::sound:
      return;
    case MotionJudge::Answer::jump:
      jump_.hit(place);
      if (motion_.distance() <= jump_distance_) return;
      jump_distance_ = motion_.distance();
      jump_s_ = motion_.seconds();
      return;
    case MotionJudge::Answer::velocity: {
      velocity_.hit(place);
      const double velocity = motion_.distance() / motion_.seconds();
      if (velocity <= worst_velocity_) return;
      worst_velocity_ = velocity;
      velocity_s_ = motion_.seconds();
      return;
    }
    case MotionJudge::Answer::acceleration:
      acceleration_.hit(place);
      worst_acceleration_ = std::max(worst_acceleration_, motion_.acceleration());
      return;
  }
}

bool JointJudge::fitsAsDegrees() const {
  constexpr double kRadians = std::numbers::pi / 180;
  return least_ * kRadians >= lower_ - kLimitSlack && most_ * kRadians <= upper_ + kLimitSlack;
}

double JointJudge::largest() const { return std::max(std::abs(least_), std::abs(most_)); }

void JointJudge::collect(Tally& all) const {
  for (const Tally* tally : {&beyond_, &jump_, &velocity_, &acceleration_}) all.merge(*tally);
}

void JointJudge::report(const std::string& device, std::vector<Finding>& findings) const {
  const auto add = [&](const Tally& tally, const char* rule, std::string text) {
    if (tally.count > 0) findings.push_back(tally.finding(rule, device, std::move(text)));
  };
  add(beyond_, "joint.limit",
      fmt::format("{}/{} is outside its limits [{:.6g}, {:.6g}] {}; the worst is {:.6g}", device,
                  name_, lower_, upper_, unit_, worst_));
  const std::string speed =
      velocity_limit_ ? fmt::format("its limit is {:.6g} {}/s", *velocity_limit_, unit_)
                      : fmt::format("its whole range is {:.6g} {}", upper_ - lower_, unit_);
  add(jump_, "joint.jump",
      fmt::format("{}/{} jumps by {:.6g} {} within {:.3g} s; {}", device, name_, jump_distance_,
                  unit_, jump_s_, speed));
  add(velocity_, "joint.velocity",
      fmt::format("{}/{} moves at {:.3g} {}/s for {:.3g} s; {}", device, name_, worst_velocity_,
                  unit_, velocity_s_, speed));
  add(acceleration_, "joint.acceleration",
      fmt::format("{}/{} speeds up or slows down by {:.3g} {}/s^2, above {:.6g}", device, name_,
                  worst_acceleration_, unit_, acceleration_limit_));
}

}  // namespace rocinante
