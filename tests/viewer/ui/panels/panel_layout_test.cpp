#include "viewer/ui/panels/panel_layout.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

TEST(PanelLayout, AListTakesTheHeightThatItsRowsNeedAndThatIsThere) {
  EXPECT_EQ(listHeight(5, 20, 1000), 100);
  EXPECT_EQ(listHeight(40, 20, 500), 500);
  EXPECT_EQ(listHeight(1, 20, 500), 60);
  EXPECT_EQ(listHeight(40, 20, -10), 60);
}

/// Each byte is one wide.
std::string lines(std::string_view text, float room) {
  return inLines(text, room, [](std::string_view part) { return static_cast<float>(part.size()); });
}

TEST(PanelLayout, ATextBreaksAtSpacesAlone) {
  EXPECT_EQ(lines("one two three", 100), "one two three");
  EXPECT_EQ(lines("one two three", 7), "one two\nthree");
  EXPECT_EQ(lines("one two three", 3), "one\ntwo\nthree");
  EXPECT_EQ(lines("at 0.125, not 3.5", 8), "at\n0.125,\nnot 3.5") << "not after a point";
  EXPECT_EQ(lines("a very_long_word b", 6), "a\nvery_long_word\nb");
  EXPECT_EQ(lines("one\n\n  two three", 7), "one\n\n  two\nthree") << "its own breaks and indent";
  EXPECT_EQ(lines("", 7), "");
  EXPECT_EQ(lines("one two\n", 7), "one two\n");
}

TEST(PanelLayout, ANumberStaysWithItsUnit) {
  EXPECT_EQ(lines("apart by 0.12 mm here", 13), "apart by\n0.12 mm here");
  EXPECT_EQ(lines("apart by 0.12 mm here", 14), "apart by\n0.12 mm here");
  EXPECT_EQ(lines("apart by 0.12 seconds", 14), "apart by 0.12\nseconds");
  EXPECT_EQ(lines("apart 1 m and 2 m", 7), "apart\n1 m and\n2 m");
  EXPECT_EQ(lines("0.125 mm", 6), "0.125\nmm") << "no room for both";
}

}  // namespace
}  // namespace rocinante
