#include <gtest/gtest.h>

#include "tests/support/picture_bytes.h"
#include "viewer/picture/picture.h"
#include "viewer/picture/png_files.h"

namespace rocinante {
namespace {

using test::pngChunk;
using test::pngFile;

std::uint32_t nextRandom(std::uint32_t& seed) {
  seed = seed * 1664525U + 1013904223U;
  return seed >> 16U;
}

/// The fast way is written for x86-64.
class PlainPng : public testing::Test {
 protected:
  void SetUp() override {
#ifndef __SSE2__
    GTEST_SKIP() << "no SSE2: libspng reads every PNG";
#endif
  }
};

/// Rows of noise, each behind one of the five filters, drawn by lot: all of the same in a row
/// happen, and so do all neighbourhoods. `levels`: few of them make neighbours that are equally
/// near.
std::string filteredNoise(std::uint32_t width, std::uint32_t height, int components,
                          std::uint32_t seed, std::uint32_t levels = 256) {
  std::string rows;
  for (std::uint32_t y = 0; y < height; ++y) {
    rows += static_cast<char>(nextRandom(seed) % 5);
    for (std::uint32_t i = 0; i < width * static_cast<std::uint32_t>(components); ++i) {
      rows += static_cast<char>(nextRandom(seed) % levels);
    }
  }
  return rows;
}

/// The same pixels where libspng alone reads them: a chunk of text keeps the fast way out.
Result<Picture> bySpng(std::uint32_t width, std::uint32_t height, int color_type,
                       const std::string& rows) {
  return decodePng(bytesOf(pngFile(width, height, 8, color_type, rows,
                                   pngChunk("tEXt", std::string("a\0b", 3)))),
                   "spng.png");
}

TEST_F(PlainPng, GivesThePixelsOfLibspngForEveryFilterAndWidth) {
  for (const int components : {3, 4}) {
    const int color_type = components == 3 ? 2 : 6;
    for (std::uint32_t width = 1; width <= 20; ++width) {
      constexpr std::uint32_t kHeight = 87;  // the last four rows lack one
      const std::string rows =
          filteredNoise(width, kHeight, components, width, width % 2 == 0 ? 256 : 3);
      const std::string file = pngFile(width, kHeight, 8, color_type, rows);
      std::vector<std::uint8_t> rgba(std::size_t{width} * kHeight * 4);
      ASSERT_TRUE(decodePlainPng(bytesOf(file), width, kHeight, components, rgba));
      const Result<Picture> slow = bySpng(width, kHeight, color_type, rows);
      ASSERT_TRUE(slow.ok()) << slow.error().text();
      ASSERT_EQ(rgba, slow->rgba) << width << " " << components;
    }
  }
}

TEST_F(PlainPng, ReadsPicturesOfManyPiecesAndManyChunks) {
  // Larger than what is inflated at once; the stream is cut into chunks of 1,000 bytes.
  constexpr std::uint32_t kWidth = 301;
  constexpr std::uint32_t kHeight = 700;
  const std::string rows = filteredNoise(kWidth, kHeight, 4, 5);
  const std::string packed = test::zlibStream(rows);
  std::string file = test::kPngSignature + test::pngHeader(kWidth, kHeight, 8, 6);
  for (std::size_t at = 0; at < packed.size(); at += 1000) {
    file += pngChunk("IDAT", packed.substr(at, 1000));
  }
  file += pngChunk("IEND", "");
  std::vector<std::uint8_t> rgba(std::size_t{kWidth} * kHeight * 4);
  ASSERT_TRUE(decodePlainPng(bytesOf(file), kWidth, kHeight, 4, rgba));
  const Result<Picture> slow = bySpng(kWidth, kHeight, 6, rows);
  ASSERT_TRUE(slow.ok());
  EXPECT_EQ(rgba, slow->rgba);
}

TEST_F(PlainPng, LeavesAnythingElseToLibspng) {
  const std::string rows = filteredNoise(6, 5, 4, 1);
  const std::string good = pngFile(6, 5, 8, 6, rows);
  std::vector<std::uint8_t> rgba(6 * 5 * 4);
  const auto fast = [&](const std::string& file) {
    return decodePlainPng(bytesOf(file), 6, 5, 4, rgba);
  };
  ASSERT_TRUE(fast(good));
  EXPECT_FALSE(fast(good + "x")) << "something after the end";
  EXPECT_FALSE(fast(pngFile(6, 5, 8, 6, rows, pngChunk("gAMA", std::string("\0\0\xB1\x8F", 4)))));
  EXPECT_FALSE(fast(pngFile(6, 5, 8, 6, rows + "x"))) << "a byte too many";
  EXPECT_FALSE(fast(pngFile(6, 5, 8, 6, rows.substr(1)))) << "a byte too few";
  std::string odd_filter = rows;
  odd_filter[0] = 5;
  EXPECT_FALSE(fast(pngFile(6, 5, 8, 6, odd_filter)));
  const std::string packed = test::zlibStream(rows);
  const auto file = [&](const std::string& stream) {
    return test::kPngSignature + test::pngHeader(6, 5, 8, 6) + pngChunk("IDAT", stream) +
           pngChunk("IEND", "");
  };
  ASSERT_TRUE(fast(file(packed)));
  for (std::size_t more = 1; more <= 9; ++more) {
    EXPECT_FALSE(fast(file(packed + std::string(more, 'x')))) << "after the stream: " << more;
  }
  for (std::size_t cut = 1; cut <= 5; ++cut) {
    EXPECT_FALSE(fast(file(packed.substr(0, packed.size() - cut)))) << cut;
  }
  std::string wrong_sum = packed;
  wrong_sum.back() = static_cast<char>(wrong_sum.back() ^ 1);
  EXPECT_FALSE(fast(file(wrong_sum))) << "Adler-32";
}

TEST_F(PlainPng, HostileStreamsAreRefusedOrReadAsLibspngReadsThem) {
  // Checksums of the chunks are right, what is in them is not.
  const std::string rows = filteredNoise(40, 9, 3, 9);
  const std::string packed = test::zlibStream(rows);
  std::uint32_t seed = 77;
  for (int turn = 0; turn < 3000; ++turn) {
    std::string stream = packed;
    for (std::uint32_t i = 0; i <= nextRandom(seed) % 4; ++i) {
      stream[nextRandom(seed) % stream.size()] = static_cast<char>(nextRandom(seed));
    }
    if (turn % 3 == 0) stream.resize(nextRandom(seed) % stream.size());
    const std::string file = test::kPngSignature + test::pngHeader(40, 9, 8, 2) +
                             pngChunk("IDAT", stream) + pngChunk("IEND", "");
    std::vector<std::uint8_t> rgba(40 * 9 * 4);
    if (!decodePlainPng(bytesOf(file), 40, 9, 3, rgba)) continue;
    const Result<Picture> slow =
        decodePng(bytesOf(test::kPngSignature + test::pngHeader(40, 9, 8, 2) +
                          pngChunk("tEXt", std::string("a\0b", 3)) + pngChunk("IDAT", stream) +
                          pngChunk("IEND", "")),
                  "slow.png");
    ASSERT_TRUE(slow.ok()) << turn << " " << slow.error().text();
    ASSERT_EQ(rgba, slow->rgba) << turn;
  }
}

}  // namespace
}  // namespace rocinante
