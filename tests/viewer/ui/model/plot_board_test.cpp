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

}  // namespace
}  // namespace rocinante
