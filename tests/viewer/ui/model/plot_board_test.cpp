#include "viewer/ui/model/plot_board.h"

#include <gtest/gtest.h>

#include <set>

namespace rocinante {
namespace {

SeriesKey joint(int number) {
  return {SeriesKey::Kind::joint, "arm", "j" + std::to_string(number)};
}

TEST(PlotBoard, HoldsTwentyCurvesInDifferentColours) {
  PlotBoard board;
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(board.add(joint(i)));
  EXPECT_FALSE(board.add(joint(20)));
  EXPECT_TRUE(board.add(joint(3)));  // it is there
  std::set<std::size_t> colors;
  for (const PlotBoard::Curve& curve : board.curves()) colors.insert(curve.color);
  EXPECT_EQ(colors.size(), 20U);
}

TEST(PlotBoard, AFreedColourIsUsedAgainAndOthersStay) {
  PlotBoard board;
  for (int i = 0; i < 3; ++i) board.add(joint(i));
  board.toggle(joint(1));
  EXPECT_EQ(board.find(joint(1)), nullptr);
  EXPECT_EQ(board.find(joint(2))->color, 2U);
  board.add(joint(9));
  EXPECT_EQ(board.find(joint(9))->color, 1U);
}

TEST(PlotBoard, AddingShowsItAgain) {
  PlotBoard board;
  EXPECT_FALSE(board.shown());
  board.add(joint(0));
  board.hidden = true;
  EXPECT_FALSE(board.shown());
  board.add(joint(1));
  EXPECT_TRUE(board.shown());
  board.clear();
  EXPECT_FALSE(board.shown());
}

TEST(PlotBoard, HoldsValuesOverOneAnother) {
  PlotBoard board;
  EXPECT_TRUE(board.addPath(joint(1), joint(2)));
  EXPECT_TRUE(board.shown());
  EXPECT_GE(board.height, PlotBoard::kPathHeight);
  EXPECT_TRUE(board.addPath(joint(1), joint(2)));
  EXPECT_TRUE(board.addPath(joint(2), joint(1)));
  ASSERT_EQ(board.paths().size(), 2U);
  EXPECT_EQ(board.paths()[0].text(), "arm.j1 over arm.j2");
  board.add(joint(3));
  EXPECT_EQ(board.curves()[0].color, 2U) << "none has the colour of another";
  for (int i = 3; i < 20; ++i) board.addPath(joint(i), joint(0));
  EXPECT_EQ(board.paths().size(), PlotBoard::kMaxPaths);
  EXPECT_TRUE(board.removePath(joint(1), joint(2)));
  EXPECT_FALSE(board.removePath(joint(1), joint(2)));
  board.clear();
  EXPECT_FALSE(board.shown());
}

TEST(PlotBoard, APathIsReadByTheWordBetween) {
  const auto read = [](const char* text) {
    const auto path = parsePath(text);
    return path ? path->first + "|" + path->second : std::string("-");
  };
  EXPECT_EQ(read("arm/tip:y over arm/tip:x"), "arm/tip:y|arm/tip:x");
  EXPECT_EQ(read("d/dt arm.a - arm.b over mean 0.5 signal - load"),
            "d/dt arm.a - arm.b|mean 0.5 signal - load");
  EXPECT_EQ(read("arm/tip:y in the table over arm/tip:x in the table"),
            "arm/tip:y in the table|arm/tip:x in the table");
  EXPECT_EQ(read("signal arm over over arm.b"), "signal arm over|arm.b");
  EXPECT_EQ(read("arm.a"), "-");
  EXPECT_EQ(read("arm.a over"), "-");
  EXPECT_EQ(read("arm over arm.b"), "-");
}

}  // namespace
}  // namespace rocinante
