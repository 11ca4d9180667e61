#include "player/demo/demo_arm.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math/trigonometry.h"

namespace rocinante {
namespace {

void expectSamePose(const Pose& a, const Pose& b) {
  EXPECT_LT(glm::length(a.position - b.position), 1e-12);
  EXPECT_GT(std::abs(glm::dot(a.orientation, b.orientation)), 1 - 1e-12);
}

TEST(DemoArm, AtZeroTheTipIsStraightAhead) {
  const Pose tip = armTip(ArmJoints{});
  EXPECT_DOUBLE_EQ(tip.position.x, 0.15 + 0.68 + 0.31);
  EXPECT_DOUBLE_EQ(tip.position.y, 0);
  EXPECT_DOUBLE_EQ(tip.position.z, 0.73 + 0.65 + 0.12);
  EXPECT_EQ(tip.orientation, (Quat{1, 0, 0, 0}));
}

TEST(DemoArm, FindsTheJointsOfEveryElbowUpPose) {
  int tried = 0;
  for (double q1 = -2.5; q1 < 2.6; q1 += 0.5) {
    for (double q2 = -0.6; q2 < 1.0; q2 += 0.4) {
      for (double q3 = -0.9; q3 < 1.2; q3 += 0.35) {
        for (double q5 = 0.2; q5 < 2.0; q5 += 0.6) {
          for (double q4 = -1.2; q4 < 1.3; q4 += 0.6) {
            const ArmJoints joints{q1, q2, q3, q4, q5, 0.3 - q4};
            SCOPED_TRACE(::testing::PrintToString(joints));
            const Pose tip = armTip(joints);
            const std::optional<ArmJoints> found = armJointsFor(tip);
            ASSERT_TRUE(found.has_value());
            expectSamePose(armTip(*found), tip);
            // The same joints too, while the wrist is before the base's axis.
            const Pose wrist = armTip({q1, q2, q3, 0, 0, 0});
            const double ahead = cosine(q1) * wrist.position.x + sine(q1) * wrist.position.y;
            if (ahead > 0.5) {
              for (std::size_t i = 0; i < joints.size(); ++i) {
                EXPECT_NEAR((*found)[i], joints[i], 1e-9) << "joint " << i + 1;
              }
            }
            ++tried;
          }
        }
      }
    }
  }
  EXPECT_GT(tried, 3000);
}

TEST(DemoArm, RefusesWhatIsOutOfReach) {
  EXPECT_FALSE(armJointsFor(Pose{{3, 0, 0.5}, toolPointing({0, 0, -1})}).has_value());
  const double nan = std::nan("");
  EXPECT_FALSE(armJointsFor(Pose{{nan, 0, 0.5}, toolPointing({0, 0, -1})}).has_value());
}

TEST(DemoArm, RefusesAStraightWristSinceTwoJointsThenTurnAboutOneLine) {
  EXPECT_FALSE(armJointsFor(armTip({0.2, 0.1, 0.3, 0, 0, 0.5})).has_value());
}

TEST(DemoArm, AToolPointsWhereItIsTold) {
  const Vec3 directions[] = {{0, 0, -1}, {0.6, 0, -0.8}, {0, -0.6, -0.8}, {1, 0, 0}};
  for (const Vec3& direction : directions) {
    SCOPED_TRACE(::testing::PrintToString(direction.x) + " " +
                 ::testing::PrintToString(direction.y));
    const Vec3 x = toolPointing(direction) * Vec3(1, 0, 0);
    EXPECT_LT(glm::length(x - direction), 1e-12);
  }
}

}  // namespace
}  // namespace rocinante
