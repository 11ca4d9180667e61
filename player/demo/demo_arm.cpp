#include "player/demo/demo_arm.h"

#include <cmath>

#include "core/math/transform.h"
#include "core/math/trigonometry.h"

namespace rocinante {
namespace {

constexpr Vec3 kAlong{1, 0, 0};
constexpr Vec3 kAcross{0, 1, 0};
constexpr Vec3 kUp{0, 0, 1};

Pose turned(const Vec3& origin, const Vec3& axis, double angle_rad) {
  return Pose{origin, quaternionAbout(axis, angle_rad)};
}

}  // namespace

Pose armTip(const ArmJoints& joints) {
  const Pose steps[] = {
      turned({0, 0, 0}, kUp, joints[0]),
      turned({DemoArm::kShoulderForward, 0, DemoArm::kShoulderHeight}, kAcross, joints[1]),
      turned({0, 0, DemoArm::kUpperArm}, kAcross, joints[2]),
      turned({DemoArm::kForearm, 0, DemoArm::kForearmOffset}, kAlong, joints[3]),
      turned({0, 0, 0}, kAcross, joints[4]),
      turned({0, 0, 0}, kAlong, joints[5]),
      Pose{{DemoArm::kWristToTip, 0, 0}, Quat{1, 0, 0, 0}},
  };
  Pose tip;
  for (const Pose& step : steps) {
    tip = composed(tip, step);
  }
  return tip;
}

std::optional<ArmJoints> armJointsFor(const Pose& tip) {
  const Mat4 turn = rotationMatrix(tip.orientation);
  const Vec3 tool_x(turn[0]);
  const Vec3 wrist = tip.position - DemoArm::kWristToTip * tool_x;

  const double q1 = arcTangent2(wrist.y, wrist.x);
  const double out = std::sqrt(wrist.x * wrist.x + wrist.y * wrist.y) - DemoArm::kShoulderForward;
  const double rise = wrist.z - DemoArm::kShoulderHeight;
  const double forearm_squared =
      DemoArm::kForearm * DemoArm::kForearm + DemoArm::kForearmOffset * DemoArm::kForearmOffset;
  const double reach_squared = out * out + rise * rise;
  const double reach = std::sqrt(reach_squared);
  if (!(reach > 0)) {
    return std::nullopt;
  }
  const double cosine_at_shoulder =
      (DemoArm::kUpperArm * DemoArm::kUpperArm + reach_squared - forearm_squared) /
      (2 * DemoArm::kUpperArm * reach);
  if (!(cosine_at_shoulder >= -1 && cosine_at_shoulder <= 1)) {
    return std::nullopt;
  }
  // Angles in the arm's vertical plane, from the horizontal upwards.
  const double upper_angle = arcTangent2(rise, out) + arcCosine(cosine_at_shoulder);
  const double forearm_angle = arcTangent2(rise - DemoArm::kUpperArm * sine(upper_angle),
                                           out - DemoArm::kUpperArm * cosine(upper_angle));
  const double forearm_at_zero = arcTangent2(DemoArm::kForearmOffset, DemoArm::kForearm);
  const double q2 = kPi / 2 - upper_angle;
  const double q3 = forearm_at_zero - forearm_angle - q2;

  const Quat forearm = quaternionAbout(kUp, q1) * quaternionAbout(kAcross, q2 + q3);
  const Mat4 hand = rotationMatrix(glm::conjugate(forearm) * tip.orientation);
  // hand = Rx(q4) Ry(q5) Rx(q6); its first column is (c5, s4 s5, -c4 s5), its first row
  // (c5, s5 s6, s5 c6).
  const double sine5 = std::sqrt(hand[0][1] * hand[0][1] + hand[0][2] * hand[0][2]);
  if (sine5 < 1e-9) {
    return std::nullopt;  // the wrist is straight: q4 and q6 share an axis
  }
  return ArmJoints{q1,
                   q2,
                   q3,
                   arcTangent2(hand[0][1], -hand[0][2]),
                   arcTangent2(sine5, hand[0][0]),
                   arcTangent2(hand[1][0], hand[2][0])};
}

Quat toolPointing(const Vec3& direction) {
  constexpr Vec3 down{0, 0, -1};
  // Ry(90 degrees) takes x to straight down.
  const Quat pointing_down = quaternionAbout(kAcross, kPi / 2);
  const Vec3 axis = glm::cross(down, direction);
  const Quat tilt(1 + glm::dot(down, direction), axis.x, axis.y, axis.z);
  return normalized(tilt).value_or(Quat{1, 0, 0, 0}) * pointing_down;
}

}  // namespace rocinante
