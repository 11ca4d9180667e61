#include "core/check/judges/joint_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/figure_text.h"

namespace rocinante {
namespace {

/// An excess of less than this part of the range looks like the noise of a sensor.
constexpr double kNoisePart = 0.01;
/// A joint without a velocity limit may not cross its whole range faster than this.
constexpr double kRangeTime_s = 0.2;

constexpr std::array kPlanar = {".x", ".y", ".yaw"};
constexpr std::array kFloating = {".x", ".y", ".z", ".qx", ".qy", ".qz", ".qw"};

}  // namespace

JointJudge::JointJudge(const Joint& joint, std::size_t component,
                       const MotionThresholds& thresholds)
    : name_(joint.name), slack_(thresholds.limit_slack) {
  const bool is_planar = joint.type == JointType::planar;
  const bool is_floating = joint.type == JointType::floating;
  if (is_planar) name_ += kPlanar[component];
  if (is_floating) name_ += kFloating[component];
  is_angle_ = !is_floating && joint.type != JointType::prismatic && (!is_planar || component == 2);

  MotionLimits motion;
  motion.wraps = joint.type == JointType::continuous || (is_planar && component == 2);
  const bool is_limited = joint.type == JointType::revolute || joint.type == JointType::prismatic;
  if (is_limited && joint.limits) {
    lower_ = joint.limits->lower;
    upper_ = joint.limits->upper;
  }
  // Planar and floating joints have no velocity; a limit of zero means none.
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
  if (excess <= slack_) {
    // Restated values do not show motion.
    if (!place.is_restated) judgeMotion(value, place);
    return;
  }
  // The motion that led there is not a second fault.
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
      jump_twins_ = twinsText();
      return;
    case MotionJudge::Answer::velocity: {
      velocity_.hit(place);
      const double velocity = motion_.distance() / motion_.seconds();
      if (velocity <= worst_velocity_) return;
      worst_velocity_ = velocity;
      velocity_s_ = motion_.seconds();
      velocity_twins_ = twinsText();
      return;
    }
    case MotionJudge::Answer::acceleration:
      acceleration_.hit(place);
      worst_acceleration_ = std::max(worst_acceleration_, motion_.acceleration());
      return;
  }
}

void JointJudge::dropFindings() {
  if (is_written_) least_ = most_ = value_;
  beyond_ = jump_ = velocity_ = acceleration_ = {};
  worst_excess_ = worst_ = 0;
  jump_distance_ = jump_s_ = worst_velocity_ = velocity_s_ = worst_acceleration_ = 0;
  jump_twins_.clear();
  velocity_twins_.clear();
}

bool JointJudge::fitsAsDegrees() const {
  constexpr double kRadians = std::numbers::pi / 180;
  return least_ * kRadians >= lower_ - slack_ && most_ * kRadians <= upper_ + slack_;
}

bool JointJudge::fitsAsPercent() const { return least_ >= -slack_ && most_ <= 100 + slack_; }

double JointJudge::largest() const { return std::max(std::abs(least_), std::abs(most_)); }

void JointJudge::collect(Tally& all) const {
  for (const Tally* tally : {&beyond_, &jump_, &velocity_, &acceleration_}) all.merge(*tally);
}

void JointJudge::report(const std::string& device, Findings& findings) const {
  const auto add = [&](const Tally& tally, const char* rule, std::string text,
                       std::optional<double> worst) {
    if (tally.count == 0) return;
    findings.push_back(tally.finding(rule, device, std::move(text)));
    findings.back().worst = worst;
  };
  const std::string beyond =
      is_angle_ ? fmt::format("[{}, {}]; the worst is {}", angleText(lower_), angleText(upper_),
                              angleText(worst_))
                : fmt::format("[{:.6g}, {:.6g}] m; the worst is {:.6g}", lower_, upper_, worst_);
  add(beyond_, "joint.limit", fmt::format("{}/{} is outside its limits {}", device, name_, beyond),
      statedExcess());
  if (beyond_.count > 0) findings.back().hint = unitHint();
  if (beyond_.count > 0 && findings.back().hint.empty() &&
      worst_excess_ < kNoisePart * (upper_ - lower_)) {
    findings.back().hint = fmt::format(
        "if it is the noise of a sensor: [rules] \"joint.limit\" = {{ \"{}/{}\" = {{ rad_or_m = "
        "{:.1g} }} }} in a cell",
        device, name_, 2 * worst_excess_);
  }
  const std::string speed = velocity_limit_
                                ? fmt::format("its limit is {}/s", valueText(*velocity_limit_))
                                : "its whole range is " + valueText(upper_ - lower_);
  const auto twins = [&](const std::string& packets) {
    return fmt::format("{}; {}/{} moved between them, and {}", packets, device, name_, speed);
  };
  add(jump_, "joint.jump",
      jump_twins_.empty() ? fmt::format("{}/{} jumps by {} within {:.3g} s; {}", device, name_,
                                        valueText(jump_distance_), jump_s_, speed)
                          : twins(jump_twins_),
      jump_twins_.empty() ? statedOf(jump_distance_) : std::nullopt);
  add(velocity_, "joint.velocity",
      velocity_twins_.empty() ? fmt::format("{}/{} moves at {}/s for {:.3g} s; {}", device, name_,
                                            valueText(worst_velocity_), velocity_s_, speed)
                              : twins(velocity_twins_),
      velocity_twins_.empty() ? statedOf(worst_velocity_) : std::nullopt);
  add(acceleration_, "joint.acceleration",
      fmt::format("{}/{} speeds up or slows down by {}/s^2, above {}/s^2", device, name_,
                  valueText(worst_acceleration_), valueText(acceleration_limit_)),
      statedOf(worst_acceleration_));
}

std::string JointJudge::unitHint() const {
  if (is_angle_ || largest() < 10 * std::max(std::abs(lower_), std::abs(upper_))) return {};
  const bool fits_mm = least_ / 1000 >= lower_ - slack_ && most_ / 1000 <= upper_ + slack_;
  const bool fits_percent = fitsAsPercent() && most_ > 1;
  if (fits_mm && fits_percent) return "are these millimetres, or percent? packets give metres";
  if (fits_mm) return "are these millimetres? packets give metres";
  if (fits_percent) return "are these percent? packets give metres: lower + value / 100 * range";
  return {};
}

std::string JointJudge::twinsText() const {
  if (!motion_.timesWereNear()) return {};
  return fmt::format("SEQUENCE {} and {} have nearly the same TIME, {:.3g} ms apart",
                     motion_.sequenceBefore(), motion_.sequence(), motion_.interval() * 1e3);
}

std::string JointJudge::valueText(double value) const {
  if (is_angle_) return angleText(value);
  return fmt::format("{:.6g} m", value);
}

std::optional<double> JointJudge::statedOf(double value) const {
  return statedValue(is_angle_ ? value * (180 / std::numbers::pi) : value);
}

std::optional<double> JointJudge::statedExcess() const {
  const auto lower = statedOf(lower_), upper = statedOf(upper_), worst = statedOf(worst_);
  if (!lower || !upper || !worst) return std::nullopt;
  return std::max(*lower - *worst, *worst - *upper);
}

}  // namespace rocinante
