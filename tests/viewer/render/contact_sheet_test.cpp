#include "viewer/render/contact_sheet.h"

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
  std::vector<SheetFrame> frames;
  for (int i = 0; i < 5; ++i) {
    frames.push_back({plain(60, 40, static_cast<std::uint8_t>(10 * i)), std::to_string(i) + " s"});
  }
  const auto sheet = contactSheet(frames, atlas);
  ASSERT_TRUE(sheet.has_value());
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

TEST(ContactSheet, RefusesNoneAndTooMany) {
  const TextAtlas atlas(18);
  EXPECT_FALSE(contactSheet({}, atlas).has_value());
  SheetFrame huge;
  huge.picture.width = huge.picture.height = 16384;  // judged by its size alone
  EXPECT_FALSE(contactSheet({huge}, atlas).has_value());
}

}  // namespace
}  // namespace rocinante
