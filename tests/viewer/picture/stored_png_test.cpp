#include <gtest/gtest.h>

#include "viewer/picture/png_files.h"

namespace rocinante {
namespace {

Picture noiseOf(int width, int height, bool opaque) {
  Picture picture{width, height, {}};
  std::uint32_t seed = 7;
  for (int i = 0; i < width * height * 4; ++i) {
    seed = seed * 1664525U + 1013904223U;
    picture.rgba.push_back(opaque && i % 4 == 3 ? 255 : static_cast<std::uint8_t>(seed >> 24U));
  }
  return picture;
}

TEST(StoredPngTest, EveryDecoderGivesThePixelsBack) {
  // 65,535 bytes are a block of their own: 151 x 145 RGB rows are 454 * 145 = 65,830 bytes.
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(3, 2), std::pair(151, 145),
                                      std::pair(300, 200), std::pair(65534 / 3, 1)}) {
    for (const bool opaque : {true, false}) {
      const Picture picture = noiseOf(width, height, opaque);
      const Bytes png = storedPng(picture);
      const auto read = decodePng(png, "stored");
      ASSERT_TRUE(read.ok()) << read.error().text();
      EXPECT_EQ(*read, picture) << width << " x " << height;
      EXPECT_TRUE(checkWholePng(png, "stored").ok());
#ifdef __SSE2__
      std::vector<std::uint8_t> rgba(picture.rgba.size());
      ASSERT_TRUE(decodePlainPng(png, static_cast<std::uint32_t>(width),
                                 static_cast<std::uint32_t>(height), opaque ? 3 : 4, rgba))
          << "the fast way takes it";
      EXPECT_EQ(rgba, picture.rgba);
#endif
    }
  }
}

TEST(StoredPngTest, NoPictureIsNoBytes) {
  EXPECT_TRUE(storedPng({}).empty());
  EXPECT_TRUE(storedPng({2, 2, {1, 2, 3}}).empty());
}

}  // namespace
}  // namespace rocinante
