#include "viewer/ui/panels/panel_layout.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

using Figures = PanelLayout::Figures;

TEST(PanelLayout, ALargeWindowHasThemAll) {
  const PanelLayout layout = panelLayout(1280, 720, false, true, true);
  EXPECT_TRUE(layout.scene && layout.device);
  EXPECT_EQ(layout.figures, Figures::full);
}

TEST(PanelLayout, WhatIsLeftOutComesBackAsTheWindowGrows) {
  EXPECT_EQ(panelLayout(320, 240, false, true, true).figures, Figures::brief);
  EXPECT_FALSE(panelLayout(320, 240, false, true, true).scene);
  EXPECT_FALSE(panelLayout(320, 240, false, true, true).device);
  EXPECT_EQ(panelLayout(100, 80, false, true, true).figures, Figures::none);
  // What was selected is worth more than figures.
  EXPECT_EQ(panelLayout(900, 380, false, true, false).figures, Figures::full);
  EXPECT_EQ(panelLayout(900, 380, false, true, true).figures, Figures::brief);
  EXPECT_TRUE(panelLayout(900, 380, false, true, true).device);
}

TEST(PanelLayout, AListTakesTheHeightThatItsRowsNeedAndThatIsThere) {
  EXPECT_EQ(listHeight(5, 20, 1000), 100);
  EXPECT_EQ(listHeight(40, 20, 500), 500);
  EXPECT_EQ(listHeight(1, 20, 500), 60);
  EXPECT_EQ(listHeight(40, 20, -10), 60);
}

TEST(PanelLayout, PanelsSideBySideHaveRoom) {
  for (const bool live : {false, true}) {
    for (float width = 64; width < 2000; width += 7) {
      for (float height = 64; height < 1400; height += 31) {
        const PanelLayout layout = panelLayout(width, height, live, true, true);
        const float beside = layout.scene ? scenePanelWidth(live) + kPanelMargin : 0;
        if (layout.device) {
          ASSERT_LE(beside + kDevicePanelWidth + 2 * kPanelMargin, width);
        }
        if (layout.figures == Figures::full) {
          ASSERT_LE(beside + 280, width);
        }
      }
    }
  }
}

}  // namespace
}  // namespace rocinante
