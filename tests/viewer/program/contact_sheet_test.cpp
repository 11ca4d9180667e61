#include "viewer/program/contact_sheet.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

Picture plain(int width, int height, std::uint8_t value) {
  Picture picture{width, height,
                  std::vector<std::uint8_t>(static_cast<std::size_t>(width * height) * 4, value)};
  return picture;
}

TEST(ContactSheet, LaysFramesOutInRowsWithTheirTimesBelow) {
  const TextAtlas atlas(18);
  auto made = ContactSheet::create(5, 60, 40, atlas);
  ASSERT_TRUE(made.has_value());
  // Whatever the order in which they come.
  for (const int i : {3, 0, 4, 1, 2}) {
    made->put(static_cast<std::size_t>(i), plain(60, 40, static_cast<std::uint8_t>(10 * i)),
              std::to_string(i) + " s");
  }
  const Picture* sheet = &made->picture();
  EXPECT_EQ(sheet->width, 3 * 72 + 12);
  EXPECT_EQ(sheet->height, 2 * (40 + 18 + 12) + 12);
  const auto red = [&](int x, int y) {
    return sheet->rgba[static_cast<std::size_t>(y * sheet->width + x) * 4];
  };
  EXPECT_EQ(red(12, 12), 0);
  EXPECT_EQ(red(12 + 72, 12), 10);
  EXPECT_EQ(red(12 + 72, 12 + 70), 40);
  EXPECT_EQ(red(1, 1), 0xF4);
  int ink = 0;
  for (int y = 54; y < 72; ++y) {
    for (int x = 12; x < 72; ++x) ink += red(x, y) < 100 ? 1 : 0;
  }
  EXPECT_GT(ink, 5);
}

TEST(ContactSheet, WhatHasItsSizeInPixelsShrinksWithTheTile) {
  EXPECT_EQ(tileScale(640, 480, 1), 1);
  EXPECT_EQ(tileScale(1920, 1080, 1), 1) << "never larger than asked for";
  EXPECT_EQ(tileScale(480, 480, 1), 0.75);
  EXPECT_EQ(tileScale(640, 360, 2), 1.5);
  EXPECT_EQ(tileScale(160, 90, 1), 0.5) << "as small as text can be read";
  EXPECT_EQ(tileScale(160, 90, 0.5), 0.5);
  EXPECT_EQ(tileScale(160, 90, 4), 0.75);
}

TEST(ContactSheet, RefusesNoneAndTooMany) {
  const TextAtlas atlas(18);
  EXPECT_FALSE(ContactSheet::create(0, 60, 40, atlas).has_value());
  EXPECT_FALSE(ContactSheet::create(1, 16384, 16384, atlas).has_value());
  EXPECT_FALSE(ContactSheet::create(std::size_t{1} << 40, 1, 1, atlas).has_value());
}

}  // namespace
}  // namespace rocinante
