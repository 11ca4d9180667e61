#include "viewer/shown/plot_scale.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rocinante {
namespace {

TEST(PlotScale, HasRoundTicksWithinItsRange) {
  for (const double size : {1e-9, 0.003, 0.2, 1.0, 7.7, 360.0, 2e6, 1e30}) {
    for (const double low : {-size, 0.0, size * 0.9}) {
      SCOPED_TRACE(testing::Message() << low << " to " << low + size);
      const PlotScale scale = plotScale(low, low + size, PlotUnit::other, 6);
      EXPECT_LT(scale.low, scale.high);
      EXPECT_GE(scale.first, scale.low - scale.step * 1e-9);
      const double ticks = (scale.high - scale.low) / scale.step;
      EXPECT_GE(ticks, 2);
      EXPECT_LE(ticks, 13);
      const double mantissa = scale.step / std::pow(10, std::floor(std::log10(scale.step) + 1e-9));
      const double nearest = mantissa < 1.5 ? 1 : mantissa < 3.5 ? 2 : mantissa < 7.5 ? 5 : 10;
      EXPECT_NEAR(mantissa, nearest, 1e-6);
    }
  }
}

TEST(PlotScale, AValueThatStaysHasARangeAroundIt) {
  const PlotScale scale = plotScale(12, 12, PlotUnit::degrees, 4);
  EXPECT_LT(scale.low, 11.5);
  EXPECT_GT(scale.high, 12.5);
  const PlotScale nothing = plotScale(1, -1, PlotUnit::metres, 4);
  EXPECT_LT(nothing.low, 0);
  EXPECT_GT(nothing.high, 0);
  EXPECT_EQ(plotScale(90, 110, PlotUnit::per_second, 4).low, 0);
}

TEST(PlotScale, TextHasTheUnitThatPeopleUse) {
  EXPECT_EQ(plotText(12.3456, PlotUnit::degrees, plotScale(0, 90, PlotUnit::degrees, 5)), "12.35°");
  EXPECT_EQ(plotText(0.0123, PlotUnit::metres, plotScale(0, 0.02, PlotUnit::metres, 5)), "12.3 mm");
  EXPECT_EQ(plotText(1.25, PlotUnit::metres, plotScale(0, 3, PlotUnit::metres, 5)), "1.250 m");
  EXPECT_EQ(plotText(99.96, PlotUnit::per_second, plotScale(0, 100, PlotUnit::per_second, 5)),
            "100.0 /s");
}

/// Two joints, the second of which follows the first.
Model follower() {
  Model model;
  model.links.resize(3);
  model.joints.resize(2);
  model.joints[0].name = "lead";
  model.joints[0].type = JointType::revolute;
  model.joints[0].child = 1;
  model.joints[0].limits = JointLimits{-1, 1, {}, {}};
  model.joints[1].name = "follow";
  model.joints[1].type = JointType::prismatic;
  model.joints[1].child = 2;
  model.joints[1].mimic = Mimic{0, 0.5, 0.25};
  return model;
}

TEST(PlotValue, IsInDegreesWithItsLimits) {
  const Model model = follower();
  const PlotValue value = plotValue({SeriesKey::Kind::joint, "arm", "lead"}, &model);
  EXPECT_EQ(value.unit, PlotUnit::degrees);
  EXPECT_NEAR(value.shown(1), 57.29578, 1e-5);
  EXPECT_NEAR(*value.upper, 57.29578, 1e-5);
}

TEST(PlotValue, OfAJointThatFollowsIsMadeOfTheOther) {
  const Model model = follower();
  const PlotValue value = plotValue({SeriesKey::Kind::joint, "arm", "follow"}, &model);
  EXPECT_EQ(value.series.part, "lead");
  EXPECT_EQ(value.unit, PlotUnit::metres);
  EXPECT_DOUBLE_EQ(value.shown(2), 1.25);
}

TEST(PlotValue, OfWhatIsDerivedHasItsUnit) {
  const Model model = follower();
  PosedScene scene;
  scene.devices.emplace_back();
  scene.devices[0].name = "arm";
  scene.devices[0].model = &model;
  scene.device_by_name.emplace("arm", 0);
  const auto of = [&](const char* text) { return plotValue(*parseSeriesKey(text), scene); };
  const PlotValue speed = of("mean 0.1 d/dt arm.lead");
  EXPECT_EQ(speed.unit, PlotUnit::degrees);
  EXPECT_EQ(speed.per_seconds, 1);
  EXPECT_NEAR(speed.shown(1), 57.29578, 1e-5);
  EXPECT_FALSE(speed.upper.has_value()) << "a limit of the joint is none of its speed";
  PlotScale scale = plotScale(-10, 10, speed.unit, 4);
  scale.per_seconds = speed.per_seconds;
  EXPECT_EQ(plotText(12.5, speed.unit, scale), "12.50°/s");
  const PlotValue faster = of("d/dt d/dt arm/tip:x");
  EXPECT_EQ(faster.unit, PlotUnit::metres);
  scale = plotScale(-10, 10, faster.unit, 4);
  scale.per_seconds = faster.per_seconds;
  EXPECT_EQ(unitText(faster.unit, scale), "m/s²");
  EXPECT_EQ(of("arm:x - arm/tip:x").unit, PlotUnit::metres);
  const PlotValue mixed = of("arm.lead - arm:x");
  EXPECT_EQ(mixed.unit, PlotUnit::other);
  EXPECT_EQ(mixed.shown(2), 2);
}

TEST(PlotScale, LeavesOutWhatIsBeyondSinglePrecision) {
  ValueColumn column;
  column.bin.take(1e300);
  column.bin.take(2);
  const auto range = rangeOf({column}, PlotValue());
  ASSERT_TRUE(range.has_value());
  EXPECT_EQ(range->second, 2);
}

TEST(PlotValue, WithoutAModelIsAsStated) {
  const PlotValue value = plotValue({SeriesKey::Kind::joint, "arm", "1"}, nullptr);
  EXPECT_EQ(value.unit, PlotUnit::other);
  EXPECT_EQ(value.shown(2), 2);
}

}  // namespace
}  // namespace rocinante
