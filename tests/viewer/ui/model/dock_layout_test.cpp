#include "viewer/ui/model/dock_layout.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <vector>

namespace rocinante {
namespace {

DockWish usualWish() {
  DockWish wish;
  wish.left.width = 316;
  wish.right.width = 300;
  wish.time = 92;
  wish.plots = 200;
  return wish;
}

bool isThere(const PanelRectangle& place) { return place.width > 0 && place.height > 0; }

bool overlap(const PanelRectangle& a, const PanelRectangle& b) {
  constexpr float kRounding = 0.01F;
  return a.x + kRounding < b.x + b.width && b.x + kRounding < a.x + a.width &&
         a.y + kRounding < b.y + b.height && b.y + kRounding < a.y + a.height;
}

std::vector<PanelRectangle> placesOf(const DockLayout& layout, bool with_peeked) {
  std::vector<PanelRectangle> places{layout.time, layout.time_strip, layout.plots,
                                     layout.plots_strip, layout.picture};
  for (const DockedSide& side : {layout.left, layout.right}) {
    places.push_back(side.strip);
    if (side.peeked && !with_peeked) continue;
    places.push_back(side.panel);
    places.push_back(side.gutter);
  }
  std::erase_if(places, [](const PanelRectangle& place) { return !isThere(place); });
  return places;
}

TEST(DockLayout, ALargeWindowHasThemAllRoundThePicture) {
  const DockLayout layout = dockLayout(usualWish(), 1280, 720);
  EXPECT_EQ(layout.left.panel, (PanelRectangle{0, 0, 316, 428}));
  EXPECT_EQ(layout.left.gutter, (PanelRectangle{316, 0, 7, 428}));
  EXPECT_EQ(layout.right.gutter, (PanelRectangle{973, 0, 7, 428}));
  EXPECT_EQ(layout.right.panel, (PanelRectangle{980, 0, 300, 428}));
  EXPECT_EQ(layout.plots, (PanelRectangle{0, 428, 1280, 200}));
  EXPECT_EQ(layout.time, (PanelRectangle{0, 628, 1280, 92}));
  EXPECT_EQ(layout.picture, (PanelRectangle{323, 0, 650, 428}));
}

TEST(DockLayout, ThePictureHasAllOfAWindowWithoutPanels) {
  EXPECT_EQ(dockLayout({}, 640, 480).picture, (PanelRectangle{0, 0, 640, 480}));
}

TEST(DockLayout, WhatYieldsInASmallerWindowYieldsInOrder) {
  const DockLayout narrower = dockLayout(usualWish(), 900, 720);
  EXPECT_TRUE(isThere(narrower.left.panel) && isThere(narrower.right.panel));
  EXPECT_LT(narrower.left.panel.width, 316);
  EXPECT_LT(narrower.right.panel.width, 300);
  const DockLayout narrow = dockLayout(usualWish(), 640, 720);
  EXPECT_TRUE(isThere(narrow.left.panel));
  EXPECT_TRUE(isThere(narrow.right.strip));
  const DockLayout smallest = dockLayout(usualWish(), 480, 320);
  EXPECT_TRUE(isThere(smallest.left.strip) && isThere(smallest.right.strip));
  EXPECT_TRUE(isThere(smallest.plots) && isThere(smallest.time));
  EXPECT_GE(smallest.picture.height, kLeastPictureHeight);
  EXPECT_TRUE(isThere(dockLayout(usualWish(), 480, 260).plots_strip));
  EXPECT_TRUE(isThere(dockLayout(usualWish(), 480, 180).time_strip));
}

TEST(DockLayout, WhatTheUserFoldedIsAStripUntilItIsLookedAt) {
  DockWish wish = usualWish();
  wish.left.folded = wish.time_folded = wish.plots_folded = true;
  const DockLayout folded = dockLayout(wish, 1280, 720);
  EXPECT_EQ(folded.left.strip, (PanelRectangle{0, 0, 22, 676}));
  EXPECT_FALSE(isThere(folded.left.panel));
  EXPECT_EQ(folded.picture, (PanelRectangle{22, 0, 951, 676}));
  wish.peeked = "left";
  const DockLayout peeked = dockLayout(wish, 1280, 720);
  EXPECT_TRUE(peeked.left.peeked);
  EXPECT_EQ(peeked.left.panel, (PanelRectangle{22, 0, 316, 676}));
  EXPECT_EQ(peeked.picture, folded.picture);
}

TEST(DockLayout, WhatHasNoRoomIsLookedAtAtThePicturesCost) {
  DockWish wish = usualWish();
  EXPECT_TRUE(isThere(dockLayout(wish, 480, 180).time_strip));
  wish.peeked = "bottom";
  EXPECT_EQ(dockLayout(wish, 480, 180).time, (PanelRectangle{0, 88, 480, 92}));
  EXPECT_TRUE(isThere(dockLayout(wish, 480, 100).time_strip))
      << "the picture keeps a strip's height";
  EXPECT_TRUE(isThere(dockLayout(wish, 480, 92 + kDockStrip).time_strip)) << "and the plots theirs";
  EXPECT_TRUE(isThere(dockLayout(wish, 480, 92 + 2 * kDockStrip).time));
  EXPECT_TRUE(isThere(dockLayout(wish, 480, 260).plots_strip));
  wish.peeked = kPlotsPeek;
  EXPECT_TRUE(isThere(dockLayout(wish, 480, 260).plots));
  EXPECT_TRUE(isThere(dockLayout(wish, 480, 200).plots_strip));
}

TEST(DockLayout, NothingIsPeekedAtThatHasRoom) {
  DockWish wish = usualWish();
  for (const char* peeked : {"", "left", "right", "bottom", kPlotsPeek}) {
    wish.peeked = peeked;
    EXPECT_TRUE(isPeekNeedless(wish, 1280, 720)) << peeked;
    EXPECT_EQ(isPeekNeedless(wish, 480, 150), wish.peeked.empty()) << peeked;
  }
  wish.peeked = "right";
  EXPECT_FALSE(isPeekNeedless(wish, 640, 720));
  wish.peeked = "left";
  EXPECT_TRUE(isPeekNeedless(wish, 640, 720));
  wish.left.folded = true;
  EXPECT_FALSE(isPeekNeedless(wish, 1280, 720));
  wish.left.width = 0;
  EXPECT_TRUE(isPeekNeedless(wish, 1280, 720)) << "nothing stands there";
  wish.peeked = kPlotsPeek;
  wish.plots_folded = true;
  EXPECT_TRUE(isPeekNeedless(wish, 480, 150)) << "hidden plots are not looked at";
}

TEST(DockLayout, AnEdgeThatIsOnlyPeekedAtClosesAsTheUserHadIt) {
  PanelPlaces places;
  places.peeked = "bottom";
  closeEdge(places, DockEdge::bottom);
  EXPECT_TRUE(places.peeked.empty());
  EXPECT_EQ(places.find("bottom"), nullptr);
  places.places["left"].collapsed = true;
  places.peeked = "left";
  closeEdge(places, DockEdge::left);
  EXPECT_TRUE(places.places["left"].collapsed);
  closeEdge(places, DockEdge::bottom);
  EXPECT_TRUE(places.places["bottom"].collapsed);
}

RC_GTEST_PROP(DockLayout, NothingOverlapsAndAllOfTheWindowIsGiven, ()) {
  const auto upTo = [](int most) { return static_cast<float>(*rc::gen::inRange(0, most)); };
  DockWish wish;
  wish.left = {upTo(900), *rc::gen::arbitrary<bool>()};
  wish.right = {upTo(900), *rc::gen::arbitrary<bool>()};
  wish.time = *rc::gen::element(0.0F, 92.0F);
  wish.time_folded = *rc::gen::arbitrary<bool>();
  wish.plots = *rc::gen::element(0.0F, 90.0F, 200.0F, 4000.0F);
  wish.plots_folded = *rc::gen::arbitrary<bool>();
  wish.peeked = *rc::gen::element("", "left", "right", "bottom", kPlotsPeek);
  const float width = 64 + upTo(2600), height = 64 + upTo(1600);
  const DockLayout layout = dockLayout(wish, width, height);
  const std::vector<PanelRectangle> places = placesOf(layout, false);
  float area = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    area += places[i].width * places[i].height;
    for (std::size_t j = i + 1; j < places.size(); ++j) RC_ASSERT(!overlap(places[i], places[j]));
  }
  for (const PanelRectangle& place : placesOf(layout, true)) {
    RC_ASSERT(place.x >= 0 && place.y >= 0);
    RC_ASSERT(place.x + place.width <= width + 0.01F && place.y + place.height <= height + 0.01F);
  }
  RC_ASSERT(std::abs(area - width * height) <= 0.001F * width * height);
  if (width >= kLeastPictureWidth + 2 * kDockStrip) {
    RC_ASSERT(layout.picture.width + 0.5F >= kLeastPictureWidth);
  }
}

}  // namespace
}  // namespace rocinante
