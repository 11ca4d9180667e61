#include "viewer/shown/value_text.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

TEST(ValueText, OfAJointIsInTheUnitOfItsKind) {
  const Units units;
  EXPECT_EQ(jointValueText(ValueKind::angle, 0.75, units), "42.97°");
  EXPECT_EQ(jointValueText(ValueKind::length, 0.75, units), "750.0 mm");
  EXPECT_EQ(jointValueText(ValueKind::turn, 0.75, units), "0.7500");
  const Units bases{AngleUnit::radians, LengthUnit::metres};
  EXPECT_EQ(jointValueText(ValueKind::angle, 0.75, bases), "0.7500 rad");
  EXPECT_EQ(jointValueText(ValueKind::length, 0.75, bases), "0.7500 m");
  EXPECT_EQ(jointValueText(ValueKind::turn, 0.75, bases), "0.7500");
}

TEST(ValueText, OfAPositionNamesItsUnitOnce) {
  const Vec3 position{1.2345, -0.02, -1e-9};
  EXPECT_EQ(positionText(position, LengthUnit::millimetres), "at 1234.5 -20.0 0.0 mm");
  EXPECT_EQ(positionText(position, LengthUnit::metres), "at 1.2345 -0.0200 0.0000 m");
}

}  // namespace
}  // namespace rocinante
