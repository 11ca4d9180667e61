#include "viewer/overlay/label_layout.h"

#include <gtest/gtest.h>

#include <cmath>

#include "viewer/overlay/scale_bar.h"

namespace rocinante {
namespace {

/// Places that look scattered, the same on every run.
std::vector<LabelAnchor> scattered(int count, int width, int height) {
  std::vector<LabelAnchor> anchors;
  std::uint32_t seed = 7;
  const auto next = [&](int below) {
    seed = seed * 1664525U + 1013904223U;
    return static_cast<int>((seed >> 8) % static_cast<unsigned>(below));
  };
  for (int i = 0; i < count; ++i) {
    anchors.push_back({next(width) + 0.5, next(height) + 0.25, {20 + next(90), 16}});
  }
  return anchors;
}

TEST(LabelLayout, NoPlateCoversAnotherOrTheEdgeOrWhatIsTaken) {
  const std::vector<ScreenBox> taken{{0, 400, 84, 480}};
  const auto anchors = scattered(10'000, 640, 480);
  const auto plates = layOutLabels(anchors, taken, 640, 480);
  ASSERT_EQ(plates.size(), anchors.size());
  std::vector<ScreenBox> placed = taken;
  for (const auto& plate : plates) {
    if (!plate) continue;
    EXPECT_TRUE(plate->left >= 0 && plate->top >= 0 && plate->right <= 640 && plate->bottom <= 480);
    for (const ScreenBox& other : placed) ASSERT_FALSE(plate->overlaps(other));
    placed.push_back(*plate);
  }
  EXPECT_GT(placed.size(), 60U) << "the picture is well filled";
}

TEST(LabelLayout, ALabelAloneStandsUpAndRightAndTheFirstGetsTheBetterPlace) {
  const LabelAnchor anchor{100.5, 100.5, {40, 16}};
  const auto one = layOutLabels({anchor}, {}, 640, 480);
  ASSERT_TRUE(one[0]);
  EXPECT_EQ(*one[0], (ScreenBox{110, 70, 158, 90}));
  const auto two = layOutLabels({anchor, anchor}, {}, 640, 480);
  EXPECT_EQ(two[0], one[0]);
  ASSERT_TRUE(two[1]);
  EXPECT_GT(two[1]->top, 100);
}

TEST(LabelLayout, WhatIsTooLargeFindsNoPlace) {
  EXPECT_FALSE(layOutLabels({{5, 5, {2'000'000'000 / 4, 16}}}, {}, 640, 480)[0]);
  EXPECT_FALSE(layOutLabels({{0, 0, {10, 16}}}, {}, 1, 1)[0]);
}

TEST(ScaleBar, IsTheLongestOfOneTwoFiveThatFits) {
  const auto text = [](double metres_per_pixel) {
    const auto bar = scaleBar(metres_per_pixel, 180);
    if (!bar) return std::string("none");
    EXPECT_LE(bar->pixels, 180);
    EXPECT_GT(bar->pixels, 180 / 2.6);
    EXPECT_NEAR(bar->pixels * metres_per_pixel, bar->metres, bar->metres * 1e-12);
    return bar->text;
  };
  EXPECT_EQ(text(0.01), "1 m");
  EXPECT_EQ(text(0.0112), "2 m");
  EXPECT_EQ(text(0.03), "5 m");
  EXPECT_EQ(text(0.001), "100 mm");
  EXPECT_EQ(text(2e-6), "200 µm");
  EXPECT_EQ(text(100), "10 km");
  EXPECT_EQ(text(1e-9), "100 nm");
}

TEST(ScaleBar, SaysNothingWhereItWouldNotBeTrue) {
  for (const double size : {0.0, -1.0, 1e-13, 1e9, 1e300, std::nan(""), HUGE_VAL}) {
    EXPECT_FALSE(scaleBar(size, 180).has_value()) << size;
  }
}

}  // namespace
}  // namespace rocinante
