#include "viewer/ui/model/panel_places.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

constexpr float kWidth = 1000, kHeight = 600, kMargin = 10, kReach = 12;

PanelRectangle snappedAlone(PanelRectangle moving) {
  return snapped(moving, {}, kWidth, kHeight, kMargin, kReach);
}

TEST(SnappedPanel, KeepsItsPlaceFarFromEverything) {
  const PanelRectangle far{300, 200, 100, 50};
  EXPECT_EQ(snappedAlone(far), far);
}

TEST(SnappedPanel, GoesToTheMarginOfTheWindow) {
  EXPECT_EQ(snappedAlone({3, 200, 100, 50}), (PanelRectangle{10, 200, 100, 50}));
  EXPECT_EQ(snappedAlone({885, 545, 100, 50}), (PanelRectangle{890, 540, 100, 50}));
}

TEST(SnappedPanel, StaysInTheWindow) {
  EXPECT_EQ(snappedAlone({-400, -400, 100, 50}), (PanelRectangle{0, 0, 100, 50}));
  EXPECT_EQ(snappedAlone({4000, 4000, 100, 50}), (PanelRectangle{900, 550, 100, 50}));
  // Larger than the window: its top left stays to be seen.
  EXPECT_EQ(snappedAlone({50, 50, 2000, 900}), (PanelRectangle{0, 0, 2000, 900}));
}

TEST(SnappedPanel, GoesBesideAnother) {
  const PanelRectangle other{400, 100, 200, 300};
  const auto with = [&](PanelRectangle moving) {
    return snapped(moving, {&other, 1}, kWidth, kHeight, kMargin, kReach);
  };
  EXPECT_EQ(with({604, 200, 100, 50}).x, 610);                               // at its right
  EXPECT_EQ(with({295, 200, 100, 50}).x, 290);                               // at its left
  EXPECT_EQ(with({450, 403, 100, 50}).y, 410);                               // below it
  EXPECT_EQ(with({605, 95, 100, 50}), (PanelRectangle{610, 100, 100, 50}));  // and in line
  // Not beside it: too far above.
  EXPECT_EQ(with({604, 20, 100, 20}).x, 604);
}

TEST(PanelPlace, StaysAtTheNearerEdgesWhenTheWindowGrows) {
  const PanelRectangle right_below{890, 540, 100, 50};
  const PanelPlace place = placeOf(right_below, kWidth, kHeight);
  EXPECT_EQ(rectangleOf(place, 100, 50, kWidth, kHeight), right_below);
  EXPECT_EQ(rectangleOf(place, 100, 50, 2000, 1000), (PanelRectangle{1890, 940, 100, 50}));
  const PanelPlace left_above = placeOf({10, 20, 100, 50}, kWidth, kHeight);
  EXPECT_EQ(rectangleOf(left_above, 100, 50, 2000, 1000), (PanelRectangle{10, 20, 100, 50}));
  // In a window that has become small it is not lost.
  EXPECT_EQ(rectangleOf(placeOf({400, 300, 100, 50}, kWidth, kHeight), 100, 50, 120, 60),
            (PanelRectangle{20, 0, 100, 50}));
}

}  // namespace
}  // namespace rocinante
