#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/check/judges/motion_judge.h"
#include "core/check/judges/tally.h"
#include "core/kinematics/model.h"

namespace rocinante {

/// Thresholds of the rules of motion.
struct MotionThresholds {
  double velocity_factor = 1.1;  ///< of the model's velocity limit
  double acceleration = 0;       ///< rad/s^2 or m/s^2; 0: not judged
  double limit_slack = 1e-4;     ///< rad or m beyond a limit that are accepted
};

/// Judges one value of one joint: that of a revolute joint, or the `.yaw` of a planar one.
class JointJudge {
 public:
  /// `component` of the joint's values, named as packets name it.
  JointJudge(const Joint& joint, std::size_t component, const MotionThresholds& thresholds);

  const std::string& name() const { return name_; }
  void judge(double value, const PacketPlace& place);

  bool isWritten() const { return is_written_; }
  bool isLimited() const { return lower_ > -std::numeric_limits<double>::infinity(); }
  bool isAngle() const { return is_angle_; }
  double value() const { return value_; }
  /// Whether any value was beyond the limits.
  bool wasBeyond() const { return beyond_.count > 0; }
  /// Whether all its values are within the limits when read as degrees.
  bool fitsAsDegrees() const;
  /// Whether all its values are from 0 to 100.
  bool fitsAsPercent() const;
  double largest() const;
  /// Adds the tallies of all faults, when the values have another unit.
  void collect(Tally& all) const;

  void report(const std::string& device, Findings& findings) const;
  /// Forgets what was found; its motion is followed on.
  void dropFindings();

 private:
  /// The packets with nearly the same TIME, if they caused the last fault of motion.
  std::string twinsText() const;
  /// A value as text: "12.5°", "0.3 m".
  std::string valueText(double value) const;
  /// In the unit of valueText().
  std::optional<double> statedOf(double value) const;
  /// How far the worst value is beyond the limits, as the sentence states them.
  std::optional<double> statedExcess() const;

  std::string name_;
  /// What unit the values of a sliding joint seem to have; empty: none.
  std::string unitHint() const;

  bool is_angle_ = true, is_written_ = false;
  double slack_ = 1e-4;
  double lower_ = -std::numeric_limits<double>::infinity();
  double upper_ = std::numeric_limits<double>::infinity();
  std::optional<double> velocity_limit_;
  double acceleration_limit_ = 0;
  double value_ = 0;
  double least_ = std::numeric_limits<double>::infinity();
  double most_ = -std::numeric_limits<double>::infinity();
  MotionJudge motion_;
  Tally beyond_, jump_, velocity_, acceleration_;
  double worst_excess_ = 0, worst_ = 0;
  double jump_distance_ = 0, jump_s_ = 0, worst_velocity_ = 0, velocity_s_ = 0;
  /// The packets of the worst fault, if their TIMEs are too near.
  std::string jump_twins_, velocity_twins_;
  double worst_acceleration_ = 0;

  void judgeMotion(double value, const PacketPlace& place);
};

}  // namespace rocinante
