#include "core/math/turn_angle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math/transform.h"
#include "core/math/trigonometry.h"

namespace rocinante {
namespace {

const Vec3 kAxis = normalized(Vec3{1, -2, 0.5}).value();

TEST(TurnAngle, IsTheAngleOfTheRotationFromOneToTheOther) {
  const Mat4 from = matrixOf({{1, 2, 3}, quaternionFromRpy({0.3, -1.1, 2.0})});
  EXPECT_EQ(turnAngle(from, from), 0);
  for (const double angle : {1e-12, 1e-8, 0.001, 0.5, kPi / 2, 3.0}) {
    SCOPED_TRACE(angle);
    const Mat4 turned = from * rotationMatrix(quaternionAbout(kAxis, angle));
    EXPECT_NEAR(turnAngle(from, turned), angle, 1e-15 + 1e-14 * angle);
    EXPECT_NEAR(turnAngle(turned, from), angle, 1e-15 + 1e-14 * angle);
  }
}

TEST(TurnAngle, OfHalfATurnHasHalfTheDigits) {
  EXPECT_NEAR(turnAngle(Mat4{1.0}, rotationMatrix(quaternionAbout(kAxis, kPi))), kPi, 1e-7);
}

TEST(TurnAngle, OfWhatIsNotFiniteIsNaN) {
  Mat4 broken{1.0};
  broken[1][1] = std::nan("");
  EXPECT_TRUE(std::isnan(turnAngle(broken, Mat4{1.0})));
  EXPECT_TRUE(std::isnan(turnAngle(broken, broken)));
}

}  // namespace
}  // namespace rocinante
