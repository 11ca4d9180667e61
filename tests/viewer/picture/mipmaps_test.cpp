#include "viewer/picture/mipmaps.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

Picture pictureOf(int width, int height, std::vector<std::uint8_t> rgba) {
  return Picture{width, height, std::move(rgba)};
}

TEST(Mipmaps, EndAtOnePixelWhateverTheShape) {
  const Picture wide = pictureOf(13, 4, std::vector<std::uint8_t>(13 * 4 * 4, 77));
  std::vector<std::pair<int, int>> sizes;
  for (const Picture& level : mipmapsOf(wide)) sizes.emplace_back(level.width, level.height);
  EXPECT_EQ(sizes, (std::vector<std::pair<int, int>>{{6, 2}, {3, 1}, {1, 1}}));
  EXPECT_TRUE(mipmapsOf(pictureOf(1, 1, {1, 2, 3, 4})).empty());
}

TEST(Mipmaps, AOneColorPictureKeepsItsColorExactly) {
  for (int value = 0; value < 256; ++value) {
    SCOPED_TRACE(value);
    const auto byte = static_cast<std::uint8_t>(value);
    std::vector<std::uint8_t> rgba;
    for (int i = 0; i < 7 * 5; ++i) rgba.insert(rgba.end(), {byte, byte, byte, 200});
    for (const Picture& level : mipmapsOf(pictureOf(7, 5, rgba))) {
      EXPECT_EQ(level.rgba[0], byte);
      EXPECT_EQ(level.rgba[3], 200);
    }
  }
}

TEST(Mipmaps, BlackAndWhiteMixInLightNotInDisplayValues) {
  const Picture half = halved(pictureOf(2, 1, {0, 0, 0, 255, 255, 255, 255, 255}));
  // Half the light of white is the display value 188, not 128.
  EXPECT_EQ(half.rgba, (std::vector<std::uint8_t>{188, 188, 188, 255}));
}

TEST(Mipmaps, TransparentPixelsLendNoColor) {
  const Picture half = halved(pictureOf(2, 1, {255, 0, 0, 255, 0, 255, 0, 0}));
  EXPECT_EQ(half.rgba, (std::vector<std::uint8_t>{255, 0, 0, 128}));
}

TEST(Mipmaps, AnOddSideWeighsItsThreePixelsEqually) {
  // 3 -> 1: each pixel is a third. A third of white's light is display value 156.
  const Picture one = halved(pictureOf(3, 1, {0, 0, 0, 255, 255, 255, 255, 255, 0, 0, 0, 255}));
  EXPECT_EQ(one.width, 1);
  EXPECT_EQ(one.rgba[0], 156);
  // The same pixel at the end weighs the same: nothing shifts.
  const Picture last = halved(pictureOf(3, 1, {0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255, 255}));
  EXPECT_EQ(last.rgba[0], 156);
}

}  // namespace
}  // namespace rocinante
