#include "viewer/shown/plot_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rocinante {
namespace {

constexpr float kLaneHeight = 100;

/// From -10 to 10.
PlotScale tens() {
  PlotScale scale;
  scale.low = -10;
  scale.high = 10;
  return scale;
}

PlotShape shapeOf(const std::vector<ValueColumn>& columns) {
  return plotShape(columns, PlotValue(), tens(), kLaneHeight);
}

ValueColumn sampled(float low, float high, float last) {
  ValueColumn column;
  column.bin = {low, high, last, false};
  column.held = last;
  return column;
}

ValueColumn holding(float value) {
  ValueColumn column;
  column.held = value;
  return column;
}

TEST(PlotShape, NothingDrawsNothing) {
  EXPECT_TRUE(shapeOf({}).lines.empty());
  EXPECT_TRUE(shapeOf(std::vector<ValueColumn>(50)).lines.empty());
}

TEST(PlotShape, AValueThatHoldsIsOneLevelLine) {
  std::vector<ValueColumn> columns(1000, holding(0));
  columns[0] = sampled(0, 0, 0);
  const PlotShape shape = shapeOf(columns);
  ASSERT_EQ(shape.lines.size(), 1U);
  EXPECT_EQ(shape.lines[0].size(), 2U);
  EXPECT_EQ(shape.lines[0].front().y, kLaneHeight / 2);
  EXPECT_EQ(shape.lines[0].back().x, 1000);
  EXPECT_TRUE(shape.bars.empty());
}

TEST(PlotShape, AStepIsLevelThenUpright) {
  std::vector<ValueColumn> columns(20, holding(-5));
  columns[0] = sampled(-5, -5, -5);
  columns[10] = sampled(5, 5, 5);
  for (std::size_t i = 11; i < 20; ++i) columns[i] = holding(5);
  const PlotShape shape = shapeOf(columns);
  ASSERT_EQ(shape.lines.size(), 1U);
  const auto& line = shape.lines[0];
  const auto low = std::ranges::find_if(line, [](const auto& point) { return point.x == 10.5F; });
  ASSERT_NE(low, line.end());
  EXPECT_EQ(low->y, 25);
  EXPECT_EQ(std::next(low)->x, 10.5F);
  EXPECT_EQ(std::next(low)->y, 75);
}

TEST(PlotShape, AGapEndsTheLine) {
  std::vector<ValueColumn> columns(30, holding(1));
  columns[0] = sampled(1, 1, 1);
  for (std::size_t i = 10; i < 20; ++i) columns[i] = ValueColumn();
  columns[20] = sampled(1, 1, 1);
  EXPECT_EQ(shapeOf(columns).lines.size(), 2U);
}

TEST(PlotShape, WhatMovesTooFastForALineIsABarOfItsExtent) {
  std::vector<ValueColumn> columns(10, sampled(-8, 8, 0));
  const PlotShape shape = shapeOf(columns);
  ASSERT_EQ(shape.bars.size(), 10U);
  EXPECT_EQ(shape.bars[4].low, 10);
  EXPECT_EQ(shape.bars[4].high, 90);
}

TEST(PlotShape, ASmoothCurveStaysWithinAPixel) {
  std::vector<ValueColumn> columns;
  const auto curve = [](double x) { return 9 * std::sin(x / 60); };
  for (int i = 0; i < 1000; ++i) {
    const auto value = static_cast<float>(curve(i + 0.5));
    columns.push_back(sampled(value, value, value));
  }
  const PlotShape shape = shapeOf(columns);
  ASSERT_EQ(shape.lines.size(), 1U);
  EXPECT_LT(shape.lines[0].size(), 700U);
  const auto& line = shape.lines[0];
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double middle = (line[i - 1].x + line[i].x) / 2.0;
    const double drawn = (line[i - 1].y + line[i].y) / 2.0;
    EXPECT_NEAR(drawn, curve(middle) * 5 + 50, 1) << middle;
  }
}

TEST(PlotShape, ValuesFarOutsideAreCut) {
  const PlotShape shape = shapeOf({sampled(-1e30F, 1e30F, 1e30F), holding(1e30F)});
  for (const auto& bar : shape.bars) {
    EXPECT_GE(bar.low, -kLaneHeight);
    EXPECT_LE(bar.high, 2 * kLaneHeight);
  }
}

}  // namespace
}  // namespace rocinante
