#include "viewer/shown/xy_shape.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

using Line = std::vector<PlotShape::Point>;

/// From 0 to 8 over 64 pixels: a unit is eight of them.
PlotScale eights() {
  PlotScale scale;
  scale.low = 0;
  scale.high = 8;
  return scale;
}

XyShape xyShapeOf(const XyColumns& columns) {
  const PlotValue value;
  const PlotScale scale = eights();
  return xyShape(columns, {value, scale, 64}, {value, scale, 64});
}

ValueColumn sampledXy(float low, float high, float last) {
  ValueColumn column;
  column.bin = {low, high, last, false};
  column.held = last;
  return column;
}
ValueColumn sampledXy(float value) { return sampledXy(value, value, value); }
ValueColumn holdingXy(float value) {
  ValueColumn column;
  column.held = value;
  return column;
}
ValueColumn ended() {
  ValueColumn column;
  column.bin.ends = true;
  return column;
}

TEST(XyShape, GoesThroughWhereBothAre) {
  const XyShape shape = xyShapeOf(
      {{sampledXy(1), sampledXy(2), sampledXy(3)}, {sampledXy(5), holdingXy(5), sampledXy(7)}});
  ASSERT_EQ(shape.lines.size(), 1U);
  EXPECT_EQ(shape.lines[0], (Line{{8, 40}, {16, 40}, {24, 56}}));
  EXPECT_TRUE(shape.boxes.empty()) << "one sample in a stretch is a point";
}

TEST(XyShape, AGapOfEitherIsAGap) {
  const std::vector<ValueColumn> whole(5, holdingXy(1));
  const std::vector<ValueColumn> cut{sampledXy(1), ended(), {}, sampledXy(4), holdingXy(4)};
  for (const XyColumns& columns : {XyColumns{cut, whole}, XyColumns{whole, cut}}) {
    EXPECT_EQ(xyShapeOf(columns).lines.size(), 2U);
  }
  const XyShape turned = xyShapeOf({whole, cut});
  EXPECT_EQ(turned.lines[0], (Line{{8, 8}}));
  EXPECT_EQ(turned.lines[1], (Line{{8, 32}}));
  EXPECT_TRUE(xyShapeOf({cut, std::vector<ValueColumn>(5)}).lines.empty());
  EXPECT_TRUE(xyShapeOf({}).lines.empty());
}

TEST(XyShape, ExtremesWithinAStretchAreABox) {
  const XyShape shape =
      xyShapeOf({{sampledXy(1), sampledXy(0.5, 9, 2)}, {sampledXy(1), sampledXy(1, 4, 4)}});
  ASSERT_EQ(shape.boxes.size(), 1U);
  EXPECT_EQ(shape.boxes[0], (XyShape::Box{4, 72, 8, 32}));
  EXPECT_EQ(shape.lines[0], (Line{{8, 8}, {16, 32}}));
  // Of one that moves alone the box is a line, and what nobody can see is none.
  const XyShape flat = xyShapeOf({{sampledXy(1, 8, 1)}, {sampledXy(3)}});
  ASSERT_EQ(flat.boxes.size(), 1U);
  EXPECT_EQ(flat.boxes[0], (XyShape::Box{8, 64, 24, 24}));
  EXPECT_TRUE(xyShapeOf({{sampledXy(1, 1.05F, 1)}, {sampledXy(3)}}).boxes.empty());
}

TEST(XyShape, StandingStillIsOnePoint) {
  const std::vector<ValueColumn> still(5000, holdingXy(2));
  const XyShape shape = xyShapeOf({still, still});
  ASSERT_EQ(shape.lines.size(), 1U);
  EXPECT_EQ(shape.lines[0].size(), 1U);
}

TEST(XyShape, EqualUnitsTakeEqualPixels) {
  ValueRange x{0, 2}, y{4, 5};
  makeEqual(x, y, 400, 100);
  EXPECT_DOUBLE_EQ((x.second - x.first) / 400, (y.second - y.first) / 100);
  EXPECT_LE(x.first, 0);
  EXPECT_GE(x.second, 2);
  EXPECT_DOUBLE_EQ(y.first, 4) << "already the larger one";
  EXPECT_DOUBLE_EQ(y.second, 5);
  ValueRange point{1, 1};
  makeEqual(point, point, 100, 100);
  EXPECT_EQ(point, (ValueRange{1, 1}));
}

TEST(XyShape, APairIsWhereBothAreThen) {
  const XyColumns columns{{sampledXy(1), sampledXy(2), ended()},
                          {sampledXy(5), holdingXy(5), holdingXy(6)}};
  EXPECT_EQ(pairAt(columns, 0.1), std::pair(1.0, 5.0));
  EXPECT_EQ(pairAt(columns, 0.5), std::pair(2.0, 5.0));
  EXPECT_EQ(pairAt(columns, 0.9), std::nullopt);
  EXPECT_EQ(pairAt(columns, 1), std::nullopt);
  EXPECT_EQ(pairAt(columns, -0.1), std::nullopt);
  EXPECT_EQ(pairAt({}, 0.5), std::nullopt);
}

}  // namespace
}  // namespace rocinante
