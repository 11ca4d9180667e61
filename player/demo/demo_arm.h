#pragma once

#include <array>
#include <optional>

#include "core/math/vector.h"

namespace rocinante {

/// Six joint values of the demo arm, radians, in the order of examples/demo/arm.urdf.
using ArmJoints = std::array<double, 6>;

/// The kinematics of examples/demo/arm.urdf in closed form: a shoulder set forward, an elbow with
/// an offset, and a spherical wrist. Its numbers repeat those of the URDF file (a test compares the
/// two). Lengths in metres; poses in the arm's own space: base on the floor, x forward, z up. The
/// tool's x axis points out of the flange, its origin is the centre of the ball at the tip.
struct DemoArm {
  static constexpr double kShoulderForward = 0.15;
  static constexpr double kShoulderHeight = 0.73;
  static constexpr double kUpperArm = 0.65;
  static constexpr double kForearm = 0.68;        ///< along the forearm, elbow to wrist
  static constexpr double kForearmOffset = 0.12;  ///< across it, upwards at zero
  static constexpr double kWristToTip = 0.31;
};

/// The pose of the tool's tip.
Pose armTip(const ArmJoints& joints);

/// The joint values that put the tip at `tip`: elbow up, wrist not flipped. Empty when out of
/// reach. Joint limits are not checked.
std::optional<ArmJoints> armJointsFor(const Pose& tip);

/// The orientation of a tool that points along `direction` (unit length, not straight up), reached
/// from straight down by the smallest rotation.
Quat toolPointing(const Vec3& direction);

}  // namespace rocinante
