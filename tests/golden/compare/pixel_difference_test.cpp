#include "golden/compare/pixel_difference.h"

#include <gtest/gtest.h>

#include "tests/golden/compare/test_pictures.h"

namespace rocinante {
namespace {

TEST(DifferenceRow, IsTheLargestOfTheFourComponents) {
  const std::uint8_t a[] = {10, 20, 30, 40, 0, 0, 0, 0, 255, 0, 0, 7};
  const std::uint8_t b[] = {11, 18, 30, 40, 0, 0, 0, 200, 0, 255, 9, 7};
  std::vector<std::uint8_t> row(3);
  differenceRow(a, b, row);
  EXPECT_EQ(row, (std::vector<std::uint8_t>{2, 200, 255}));
}

TEST(DifferenceRow, IsTheSameFastAndPlainAtEveryLength) {
  const Picture a = noisePicture(70, 1, 1);
  Picture b = noisePicture(70, 1, 2);
  for (int x = 0; x < 70; x += 3) pixelAt(b, x, 0)[3] = static_cast<std::uint8_t>(x * 3);
  for (std::size_t length = 0; length <= 70; ++length) {
    std::vector<std::uint8_t> fast(length);
    std::vector<std::uint8_t> plain(length);
    differenceRow(a.rgba.data(), b.rgba.data(), fast);
    differenceRowPlain(a.rgba.data(), b.rgba.data(), plain);
    ASSERT_EQ(fast, plain) << length;
  }
}

/// Every tile by the words of the page, one after the other.
WorstTile slowWorstTile(const std::vector<std::uint8_t>& differences, int width, int height) {
  const auto starts = [](int length) {
    std::vector<int> at;
    for (int start = 0; start + 16 <= length; start += 8) at.push_back(start);
    if (at.empty() || at.back() + 16 < length) at.push_back(std::max(0, length - 16));
    return at;
  };
  WorstTile worst{-1, 0, 0, std::min(16, width), std::min(16, height), 0};
  for (const int top : starts(height)) {
    for (const int left : starts(width)) {
      int sum = 0;
      int over = 0;
      for (int y = top; y < top + worst.height; ++y) {
        for (int x = left; x < left + worst.width; ++x) {
          const int value = differences[static_cast<std::size_t>(y * width + x)];
          sum += value;
          over += value > 32 ? 1 : 0;
        }
      }
      worst.mean = std::max(worst.mean, sum / static_cast<double>(worst.width * worst.height));
      worst.over = std::max<std::int64_t>(worst.over, over);
    }
  }
  return worst;
}

TEST(PixelDifferences, OfALargePictureAreThoseOfItsPixels) {
  // Large enough for a second thread; a width that eight pixels do not divide.
  constexpr int kWidth = 1237;
  constexpr int kHeight = 811;
  const std::size_t pixels = std::size_t{kWidth} * kHeight;
  Picture a{kWidth, kHeight, std::vector<std::uint8_t>(pixels * 4, 100)};
  Picture b = a;
  std::vector<std::uint8_t> expected(pixels);
  LevelCounts counts{};
  for (std::size_t i = 0; i < pixels; ++i) {
    if (i % 977 == 0 || i + 3 > pixels) expected[i] = static_cast<std::uint8_t>(1 + i % 99);
    b.rgba[i * 4 + i % 4] = static_cast<std::uint8_t>(100 - expected[i]);
    ++counts[expected[i]];
  }
  const PixelDifferences found = pixelDifferences(a, b);
  EXPECT_EQ(found.levels, expected);
  EXPECT_EQ(found.counts, counts);
}

TEST(WorstTile, IsTheSlowOneAtEverySize) {
  std::uint32_t seed = 1;
  for (int width = 1; width <= 50; ++width) {
    for (const int height : {1, 7, 15, 16, 17, 23, 24, 25, 31, 40, 41}) {
      std::vector<std::uint8_t> differences(static_cast<std::size_t>(width * height));
      for (std::uint8_t& value : differences) {
        seed = seed * 1664525U + 1013904223U;
        value = (seed >> 28U) == 0 ? static_cast<std::uint8_t>(seed >> 20U) : std::uint8_t{0};
      }
      const WorstTile fast = worstTile(differences, width, height);
      const WorstTile slow = slowWorstTile(differences, width, height);
      ASSERT_EQ(fast.mean, slow.mean) << width << "x" << height;
      ASSERT_EQ(fast.over, slow.over) << width << "x" << height;
      // And it is where it says.
      std::vector<std::uint8_t> one;
      for (int y = 0; y < fast.height; ++y) {
        const auto first = differences.begin() + (fast.y + y) * width + fast.x;
        one.insert(one.end(), first, first + fast.width);
      }
      ASSERT_EQ(worstTile(one, fast.width, fast.height).mean, fast.mean);
    }
  }
}

TEST(WorstTile, OfEqualOnesNamesTheFirst) {
  std::vector<std::uint8_t> differences(40 * 40, 3);
  const WorstTile found = worstTile(differences, 40, 40);
  EXPECT_EQ(found.x, 0);
  EXPECT_EQ(found.y, 0);
}

TEST(WorstTile, FindsAFullTileAtEveryPlace) {
  constexpr int kWidth = 45;
  constexpr int kHeight = 37;
  for (int top = 0; top + 16 <= kHeight; ++top) {
    for (int left = 0; left + 16 <= kWidth; ++left) {
      std::vector<std::uint8_t> differences(kWidth * kHeight);
      for (int y = top; y < top + 16; ++y) {
        std::fill_n(differences.begin() + y * kWidth + left, 16, std::uint8_t{255});
      }
      // A square of a tile's size, wherever it lies, fills at least three quarters by three
      // quarters of some tile at stride 8: never more than 4 pixels off.
      ASSERT_GE(worstTile(differences, kWidth, kHeight).mean, 255.0 * 12 * 12 / 256)
          << left << " " << top;
    }
  }
}

}  // namespace
}  // namespace rocinante
