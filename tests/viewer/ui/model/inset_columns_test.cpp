#include "viewer/ui/model/inset_columns.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>

#include "viewer/view/inset_layout.h"

namespace rocinante {
namespace {

constexpr std::array kCorners{InsetCorner::top_left, InsetCorner::top_right,
                              InsetCorner::bottom_left, InsetCorner::bottom_right};

WantedInset insetIn(InsetCorner corner, double width = 0.3, double height = 0.3) {
  WantedInset wanted;
  wanted.inset.camera = "over";
  wanted.inset.corner = corner;
  wanted.inset.width = width;
  wanted.inset.height = height;
  return wanted;
}

TEST(InsetColumns, WhatHasRoomIsAsInAPicture) {
  const std::vector<WantedInset> wanted{insetIn(InsetCorner::top_right),
                                        insetIn(InsetCorner::bottom_right)};
  const InsetColumns fitted = fitInsets(wanted, 1280, 720, 1);
  EXPECT_EQ(fitted.insets, (std::vector<CellInset>{wanted[0].inset, wanted[1].inset}));
  EXPECT_EQ(fitted.shown, (std::vector<std::size_t>{0, 1}));
  EXPECT_TRUE(fitted.tabs.empty());
}

TEST(InsetColumns, ThreeOfAColumnBecomeSmallerByOneFactorAndKeepTheirShapes) {
  const std::vector<WantedInset> wanted(3, insetIn(InsetCorner::top_right, 0.4, 0.4));
  const InsetColumns fitted = fitInsets(wanted, 1000, 600, 1);
  ASSERT_EQ(fitted.insets.size(), 3U);
  for (const CellInset& inset : fitted.insets) {
    EXPECT_TRUE(inset.in_pixels);
    EXPECT_EQ(inset.height, fitted.insets.front().height);
    EXPECT_NEAR(inset.width / inset.height, 400.0 / 240.0, 0.02);
  }
  // With their margins they fill the picture's height.
  EXPECT_NEAR(3 * fitted.insets.front().height + 4 * 12, 600, 3);
}

TEST(InsetColumns, WhatWouldBecomeTooSmallFoldsAndOpensInPlaceOfAnother) {
  std::vector<WantedInset> wanted(3, insetIn(InsetCorner::top_right));
  const InsetColumns fitted = fitInsets(wanted, 400, 220, 1);
  EXPECT_EQ(fitted.shown, (std::vector<std::size_t>{0, 1}));
  ASSERT_EQ(fitted.tabs.size(), 1U);
  EXPECT_EQ(fitted.tabs.front().number, 2U);
  wanted[2].opened = 1;
  const InsetColumns opened = fitInsets(wanted, 400, 220, 1);
  EXPECT_EQ(opened.shown, (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(opened.tabs.front().number, 1U);
}

bool overlap(const PixelRectangle& a, const PixelRectangle& b) {
  const PixelRectangle both = overlapOf(a, b);
  return both.width > 0 && both.height > 0;
}

RC_GTEST_PROP(InsetColumns, NoTwoOverlapAndNoneIsForgotten, ()) {
  std::vector<WantedInset> wanted;
  const auto count = *rc::gen::inRange(0, 7);
  for (int i = 0; i < count; ++i) {
    wanted.push_back(insetIn(*rc::gen::elementOf(kCorners), *rc::gen::inRange(5, 101) / 100.0,
                             *rc::gen::inRange(5, 101) / 100.0));
    wanted.back().opened = *rc::gen::inRange<std::uint64_t>(0, 4);
  }
  const int width = *rc::gen::inRange(120, 2600), height = *rc::gen::inRange(100, 1500);
  const double scale = *rc::gen::element(1.0, 1.25, 2.0);
  const InsetColumns fitted = fitInsets(wanted, width, height, scale);
  std::vector<PixelRectangle> places = placeInsets(fitted.insets, width, height, scale);
  for (const PixelRectangle& place : places) RC_ASSERT(place.width > 0);
  RC_ASSERT(fitted.insets.size() == fitted.shown.size());
  for (const InsetColumns::Tab& tab : fitted.tabs) places.push_back(tab.place);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const PixelRectangle& place = places[i];
    RC_ASSERT(place.x >= 0 && place.y >= 0);
    RC_ASSERT(place.x + place.width <= width && place.y + place.height <= height);
    for (std::size_t j = i + 1; j < places.size(); ++j) RC_ASSERT(!overlap(place, places[j]));
  }
}

}  // namespace
}  // namespace rocinante
