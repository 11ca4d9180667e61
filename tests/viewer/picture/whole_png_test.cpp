#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/picture_bytes.h"
#include "viewer/picture/fine_picture.h"
#include "viewer/picture/png_files.h"

namespace rocinante {
namespace {

using test::kPngSignature;
using test::pngChunk;
using test::pngFile;
using test::pngHeader;
using test::zlibStream;
using ::testing::StartsWith;

/// Two rows of three grey pixels of 8 bits.
const std::string kRows("\0\1\2\3\0\4\5\6", 8);
const std::string kText = pngChunk("tEXt", std::string("a\0b", 3));

/// What a judge says; empty: it takes the file. Textures take it in each case.
std::string refusal(const std::string& file, ErrorKind kind = ErrorKind::damaged) {
  const auto as_texture = decodePng(bytesOf(file), "x.png");
  EXPECT_TRUE(as_texture.ok()) << as_texture.error().text();
  const auto judged = decodeFinePng(bytesOf(file), "x.png");
  if (judged.ok()) return "";
  EXPECT_EQ(judged.error().kind, kind);
  return judged.error().what;
}

std::string greyOf(const std::string& data_chunks, const std::string& behind = "") {
  return kPngSignature + pngHeader(3, 2, 8, 0) + data_chunks + pngChunk("IEND", "") + behind;
}

std::string number(std::uint32_t value) {
  std::string bytes;
  test::appendBigEndian(bytes, value);
  return bytes;
}

TEST(WholePng, TakesWhatIsWhole) {
  EXPECT_EQ(refusal(pngFile(3, 2, 8, 0, kRows)), "");
  EXPECT_EQ(refusal(pngFile(3, 2, 8, 0, kRows, kText)), "");
  const std::string packed = zlibStream(kRows);
  std::string split;
  for (const char byte : packed) split += pngChunk("IDAT", std::string(1, byte));
  EXPECT_EQ(refusal(greyOf(split)), "") << "a byte a chunk";
  EXPECT_EQ(refusal(greyOf(pngChunk("IDAT", packed) + pngChunk("IDAT", ""))), "");
}

TEST(WholePng, TakesEverySizeDepthAndInterlacing) {
  // By libspng's own count of passes: what it reads to the end, the sum must agree with.
  for (std::uint32_t width = 1; width <= 9; ++width) {
    for (std::uint32_t height = 1; height <= 9; ++height) {
      for (const int depth : {1, 8, 16}) {
        std::string header = number(width) + number(height);
        header += {static_cast<char>(depth), 0, 0, 0, 1};
        constexpr std::uint32_t kX[] = {0, 4, 0, 2, 0, 1, 0}, kXStep[] = {8, 8, 4, 4, 2, 2, 1};
        constexpr std::uint32_t kY[] = {0, 0, 4, 0, 2, 0, 1}, kYStep[] = {8, 8, 8, 4, 4, 2, 2};
        std::string rows;
        for (int pass = 0; pass < 7; ++pass) {
          for (std::uint32_t y = kY[pass]; y < height; y += kYStep[pass]) {
            std::size_t bits = 0;
            for (std::uint32_t x = kX[pass]; x < width; x += kXStep[pass]) {
              bits += static_cast<std::size_t>(depth);
            }
            if (bits > 0) rows += std::string(1 + (bits + 7) / 8, '\0');
          }
        }
        const std::string file = kPngSignature + pngChunk("IHDR", header) +
                                 pngChunk("IDAT", zlibStream(rows)) + pngChunk("IEND", "");
        ASSERT_EQ(refusal(file), "") << width << "x" << height << " at " << depth;
      }
    }
  }
}

TEST(WholePng, RefusesWhatFollowsTheEnd) {
  const std::string good = pngFile(3, 2, 8, 0, kRows);
  EXPECT_EQ(refusal(good + "x"), "is not a valid PNG: 1 byte after its end (IEND)");
  EXPECT_EQ(refusal(good + good, ErrorKind::unsupported),
            "has several pictures; only files with one picture are judged");
  const std::string plain = pngFile(1, 1, 8, 2, std::string("\0\1\2\3", 4));
  EXPECT_EQ(refusal(plain + kText), "is not a valid PNG: 15 bytes after its end (IEND)");
}

TEST(WholePng, RefusesAnimations) {
  const std::string control = pngChunk("acTL", number(2) + number(0));
  EXPECT_EQ(refusal(pngFile(3, 2, 8, 0, kRows, control), ErrorKind::unsupported),
            "is an animation of 2 frames; only still pictures are judged");
}

TEST(WholePng, RefusesPixelsThatAreNotOfThePicture) {
  EXPECT_EQ(refusal(pngFile(3, 2, 8, 0, kRows + "x")),
            "is not a valid PNG: it has more pixels than its header says");
  const std::string packed = zlibStream(kRows);
  EXPECT_EQ(refusal(greyOf(pngChunk("IDAT", packed + "xy"))),
            "is not a valid PNG: 2 bytes after the end of its compressed pixels");
  EXPECT_EQ(refusal(greyOf(pngChunk("IDAT", packed) + pngChunk("IDAT", "x"))),
            "is not a valid PNG: 1 byte after the end of its compressed pixels");
  // Enough for every pixel, and no checksum behind it.
  EXPECT_EQ(refusal(greyOf(pngChunk("IDAT", packed.substr(0, packed.size() - 4)))),
            "is not a valid PNG: its compressed pixels have no end");
}

TEST(WholePng, RefusesColoursThatThePaletteDoesNotHave) {
  const std::string palette = pngChunk("PLTE", "abcdefghi");
  // Three colours of two bits: 0 1 2 of three pixels, then 0 1 3.
  EXPECT_EQ(refusal(pngFile(3, 1, 2, 3, std::string("\0\x18", 2), palette)), "");
  EXPECT_EQ(refusal(pngFile(3, 1, 2, 3, std::string("\0\x1C", 2), palette)),
            "is not a valid PNG: pixel (2, 0) is colour 3 of a palette of 3");
  EXPECT_EQ(refusal(pngFile(2, 2, 8, 3, std::string("\0\0\1\0\2\3", 6), palette)),
            "is not a valid PNG: pixel (1, 1) is colour 3 of a palette of 3");
  // What fills a row's last byte is nobody's.
  EXPECT_EQ(refusal(pngFile(3, 1, 2, 3, std::string("\0\x1B", 2), palette)), "");
}

}  // namespace
}  // namespace rocinante
