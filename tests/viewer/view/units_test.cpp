#include "viewer/view/units.h"

#include <gtest/gtest.h>

#include <numbers>

namespace rocinante {
namespace {

constexpr double kRightAngle = std::numbers::pi / 2;

TEST(Units, AreWrittenAsPeopleReadThem) {
  EXPECT_EQ(angleText(kRightAngle, AngleUnit::degrees), "90.00°");
  EXPECT_EQ(angleText(kRightAngle, AngleUnit::radians), "1.5708 rad");
  EXPECT_EQ(lengthText(1.23456, LengthUnit::millimetres), "1234.6 mm");
  EXPECT_EQ(lengthText(1.23456, LengthUnit::metres), "1.2346 m");
  EXPECT_EQ(angleNumber(-kRightAngle, AngleUnit::degrees), "-90.00");
}

TEST(Units, WriteNoSignOfZero) {
  EXPECT_EQ(angleNumber(-1e-9, AngleUnit::degrees), "0.00");
  EXPECT_EQ(lengthNumber(-0.0, LengthUnit::metres), "0.0000");
  EXPECT_EQ(lengthNumber(-0.00004, LengthUnit::millimetres), "0.0");
}

TEST(Units, ReadNumbersWithTheirUnitOrTheChosenOne) {
  EXPECT_DOUBLE_EQ(*parseAngle("90", AngleUnit::degrees), kRightAngle);
  EXPECT_DOUBLE_EQ(*parseAngle(" 90 deg ", AngleUnit::radians), kRightAngle);
  EXPECT_DOUBLE_EQ(*parseAngle("90.00°", AngleUnit::radians), kRightAngle);
  EXPECT_DOUBLE_EQ(*parseAngle("+0.5rad", AngleUnit::degrees), 0.5);
  EXPECT_DOUBLE_EQ(*parseLength("120", LengthUnit::millimetres), 0.12);
  EXPECT_DOUBLE_EQ(*parseLength("12cm", LengthUnit::metres), 0.12);
  EXPECT_DOUBLE_EQ(*parseLength("-0.12 m", LengthUnit::millimetres), -0.12);
  EXPECT_DOUBLE_EQ(*parseLength("1e2mm", LengthUnit::metres), 0.1);
}

TEST(Units, RefuseWhatIsNoValue) {
  for (const char* text : {"", " ", "deg", "1 2", "nan", "inf", "1e999", "12 mm", "1,5", "+-1"}) {
    EXPECT_FALSE(parseAngle(text, AngleUnit::degrees).has_value()) << text;
  }
  for (const char* text : {"", "mm", "12 deg", "0x10", "1e308 m 1"}) {
    EXPECT_FALSE(parseLength(text, LengthUnit::metres).has_value()) << text;
  }
}

TEST(Units, AreChosenByName) {
  Units units;
  EXPECT_TRUE(setUnit(units, "rad"));
  EXPECT_TRUE(setUnit(units, "m"));
  EXPECT_EQ(units, (Units{AngleUnit::radians, LengthUnit::metres}));
  EXPECT_FALSE(setUnit(units, "inch"));
  EXPECT_TRUE(setUnit(units, "deg"));
  EXPECT_TRUE(setUnit(units, "mm"));
  EXPECT_EQ(units, Units{});
}

}  // namespace
}  // namespace rocinante
