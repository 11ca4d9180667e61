#include "core/math/transform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/math/trigonometry.h"

namespace rocinante {
namespace {

double distanceBetween(const Mat4& a, const Mat4& b) {
  double worst = 0.0;
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 4; ++r) worst = std::max(worst, std::fabs(a[c][r] - b[c][r]));
  }
  return worst;
}

Quat randomRotation(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return normalized(Quat{normal(random), normal(random), normal(random), normal(random)}).value();
}

TEST(Transform, RollPitchYawTurnAboutTheFixedAxesInThatOrder) {
  const Mat4 yaw = rotationMatrix(quaternionFromRpy({0, 0, kPi / 2}));
  EXPECT_NEAR(transformPoint(yaw, {1, 0, 0}).y, 1.0, 1e-15);  // x to y
  const Mat4 pitch = rotationMatrix(quaternionFromRpy({0, kPi / 2, 0}));
  EXPECT_NEAR(transformPoint(pitch, {1, 0, 0}).z, -1.0, 1e-15);  // x down
  const Mat4 roll = rotationMatrix(quaternionFromRpy({kPi / 2, 0, 0}));
  EXPECT_NEAR(transformPoint(roll, {0, 1, 0}).z, 1.0, 1e-15);  // y up

  const Vec3 rpy{0.3, -1.1, 2.0};
  const Mat4 written_out = rotationMatrix(quaternionAbout({0, 0, 1}, rpy.z)) *
                           rotationMatrix(quaternionAbout({0, 1, 0}, rpy.y)) *
                           rotationMatrix(quaternionAbout({1, 0, 0}, rpy.x));
  EXPECT_LT(distanceBetween(rotationMatrix(quaternionFromRpy(rpy)), written_out), 1e-15);
}

TEST(Transform, AMatrixGivesItsPoseBack) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 1000; ++i) {
    const Pose pose{{1.5 * i, -2.0, 1e3}, randomRotation(random)};
    EXPECT_LT(distanceBetween(matrixOf(poseOf(matrixOf(pose))), matrixOf(pose)), 1e-14);
  }
  for (const Quat half_turn : {Quat{0, 1, 0, 0}, Quat{0, 0, 1, 0}, Quat{0, 0, 0, 1}}) {
    EXPECT_LT(distanceBetween(rotationMatrix(poseOf(rotationMatrix(half_turn)).orientation),
                              rotationMatrix(half_turn)),
              1e-15);
  }
}

TEST(Transform, TheInverseTakesPointsBack) {
  std::mt19937_64 random(5);
  const Mat4 there = matrixOf({{100, -20, 3}, randomRotation(random)});
  EXPECT_LT(distanceBetween(inverseOfRigid(there) * there, Mat4{1.0}), 1e-13);
}

TEST(Transform, ComposedPosesAreTheProductOfTheirMatrices) {
  std::mt19937_64 random(6);
  const Pose a{{1, 2, 3}, randomRotation(random)}, b{{-4, 5, 0.5}, randomRotation(random)};
  EXPECT_LT(distanceBetween(matrixOf(composed(a, b)), matrixOf(a) * matrixOf(b)), 1e-14);
}

TEST(Transform, OnlyQuaternionsWithADirectionCanBeNormalized) {
  EXPECT_FALSE(normalized(Quat{0, 0, 0, 0}));
  EXPECT_FALSE(normalized(Quat{std::nan(""), 0, 0, 0}));
  EXPECT_FALSE(normalized(Vec3{0, HUGE_VAL, 0}));
  EXPECT_EQ(normalized(Quat{0, 0, 0, -2}), (Quat{0, 0, 0, -1}));
  // The squares of these would be zero or infinite.
  EXPECT_EQ(normalized(Vec3{1e-200, 0, 0}), (Vec3{1, 0, 0}));
  EXPECT_EQ(normalized(Vec3{0, -1e200, 0}), (Vec3{0, -1, 0}));
}

}  // namespace
}  // namespace rocinante
