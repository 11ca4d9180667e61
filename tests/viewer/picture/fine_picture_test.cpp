#include "viewer/picture/fine_picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "tests/support/picture_bytes.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

using test::pngFile;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

Result<FinePicture> fineOf(const std::string& file) {
  return decodeFinePng(bytesOf(file), "fine.png");
}

TEST(FinePng, SixteenBitsKeepTheirSamplesAndAgreeWithEightBits) {
  const std::string file =
      pngFile(2, 1, 16, 2, std::string("\0\x12\x34\x56\x78\x9A\xBC\xFF\xFF\0\0\0\1", 13));
  const auto fine = fineOf(file);
  ASSERT_TRUE(fine.ok()) << fine.error().text();
  EXPECT_EQ(fine->encoding, (PictureEncoding{3, 16, false}));
  EXPECT_THAT(fine->samples, ElementsAre(0x1234, 0x5678, 0x9ABC, 65535, 65535, 0, 1, 65535));
  const auto eight = decodePng(bytesOf(file), "eight.png");
  ASSERT_TRUE(eight.ok());
  EXPECT_EQ(fine->picture, *eight);
}

TEST(FinePng, SaysWhichComponentsAndDepthAFileHas) {
  struct Case {
    int depth, color_type;
    std::string row, more;
    int components, bits;
  };
  const std::string palette = test::pngChunk("PLTE", std::string("\1\2\3", 3));
  for (const Case& made : {
           Case{8, 0, std::string(2, '\0'), "", 1, 8},
           Case{1, 0, std::string(2, '\0'), "", 1, 8},
           Case{16, 0, std::string(3, '\0'), "", 1, 16},
           Case{8, 0, std::string(2, '\0'), test::pngChunk("tRNS", std::string(2, '\0')), 2, 8},
           Case{8, 2, std::string(4, '\0'), "", 3, 8},
           Case{8, 2, std::string(4, '\0'), test::pngChunk("tRNS", std::string(6, '\0')), 4, 8},
           Case{8, 3, std::string(2, '\0'), palette, 3, 8},
           Case{8, 4, std::string(3, '\0'), "", 2, 8},
           Case{16, 4, std::string(5, '\0'), "", 2, 16},
           Case{8, 6, std::string(5, '\0'), "", 4, 8},
           Case{16, 6, std::string(9, '\0'), "", 4, 16},
       }) {
    SCOPED_TRACE(std::to_string(made.color_type) + " at " + std::to_string(made.depth));
    const auto fine = fineOf(pngFile(1, 1, made.depth, made.color_type, made.row, made.more));
    ASSERT_TRUE(fine.ok()) << fine.error().text();
    EXPECT_EQ(fine->encoding, (PictureEncoding{made.components, made.bits, false}));
    EXPECT_EQ(fine->samples.empty(), made.bits == 8);
  }
}

TEST(FinePicture, WordsForPeople) {
  EXPECT_EQ((PictureEncoding{4, 8, false}).depthText(), "8 bits per component");
  EXPECT_EQ((PictureEncoding{4, 32, true}).depthText(), "32-bit floating point");
  EXPECT_EQ((PictureEncoding{1, 8, false}).componentsText(), "grey");
  EXPECT_EQ((PictureEncoding{4, 8, false}).componentsText(), "RGBA");
}

TEST(FinePicture, FoldersAndFilesThatCannotBeReadGetASentence) {
  const test::TemporaryFolder folder;
  const auto of_folder = readFinePicture(folder.path());
  ASSERT_FALSE(of_folder.ok());
  EXPECT_EQ(of_folder.error().what, "is a folder, not a picture");
  const auto missing = readFinePicture(folder / "missing.png");
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().what, "the picture does not exist");
  // Reading it fails, even for root.
  const auto refused = readFinePicture("/proc/self/mem");
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().what, "is not a readable picture");
  std::ofstream(folder / "empty.png");
  const auto empty = readFinePicture(folder / "empty.png");
  ASSERT_FALSE(empty.ok());
  EXPECT_EQ(empty.error().what, "is an empty file");
  std::ofstream(folder / "pointer.png")
      << "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n";
  const auto pointer = readFinePicture(folder / "pointer.png");
  ASSERT_FALSE(pointer.ok());
  EXPECT_EQ(pointer.error().what,
            "is a Git LFS pointer, not the picture; `git lfs pull` fetches it");
}

#ifdef ROCINANTE_HAS_OPENIMAGEIO

class FineByModule : public ::testing::Test {
 protected:
  Result<FinePicture> read(const std::string& name, const std::string& content) {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return readFinePicture(folder_ / name);
  }
  test::TemporaryFolder folder_;
};

TEST_F(FineByModule, FloatingPointKeepsItsNumbers) {
  const auto fine = read("a.exr", test::exrFile(2, 1, "BGR", {0.25F, 7.5F, 0, 1, -1, 0.5F}));
  ASSERT_TRUE(fine.ok()) << fine.error().text();
  EXPECT_EQ(fine->encoding, (PictureEncoding{3, 32, true}));
  EXPECT_THAT(fine->samples, ElementsAre(-1, 0, 0.25F, 1, 0.5F, 1, 7.5F, 1));
  EXPECT_EQ(fine->not_finite, 0);
  EXPECT_EQ(fine->picture.rgba[6], 255) << "what is over 1 is cut at 8 bits";
}

TEST_F(FineByModule, NumbersThatAreNoneAreCountedAndFound) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinite = std::numeric_limits<float>::infinity();
  const auto fine =
      read("a.exr", test::exrFile(2, 2, "BGR", {0, 0, 0, 0, 0, 0, 0, kNan, 0, 0, -kInfinite, 0}));
  ASSERT_TRUE(fine.ok()) << fine.error().text();
  EXPECT_EQ(fine->not_finite, 2);
  EXPECT_EQ(fine->not_finite_x, 0);
  EXPECT_EQ(fine->not_finite_y, 1);
}

TEST_F(FineByModule, SixteenBitsAndEightBits) {
  const auto deep = read("a.pgm", "P5\n2 1\n65535\n" + std::string("\x12\x34\0\1", 4));
  ASSERT_TRUE(deep.ok()) << deep.error().text();
  EXPECT_EQ(deep->encoding, (PictureEncoding{1, 16, false}));
  EXPECT_THAT(deep->samples, ElementsAre(0x1234, 0x1234, 0x1234, 65535, 1, 1, 1, 65535));
  const auto flat = read("b.pgm", "P5\n2 1\n255\n" + std::string("\x12\x34", 2));
  ASSERT_TRUE(flat.ok()) << flat.error().text();
  EXPECT_EQ(flat->encoding, (PictureEncoding{1, 8, false}));
  EXPECT_THAT(flat->samples, IsEmpty());
}

TEST_F(FineByModule, WhatWouldGoUnjudgedIsRefused) {
  const auto depth = read("z.exr", test::exrFile(1, 1, "ABGRZ", {1, 0, 0, 0, 5}));
  ASSERT_FALSE(depth.ok());
  EXPECT_EQ(depth.error().what, "holds 5 components; grey, RGB and alpha are judged");
  const auto opaque_depth = read("z.exr", test::exrFile(1, 1, "BGRZ", {0, 0, 0, 5}));
  ASSERT_FALSE(opaque_depth.ok()) << "Z is no alpha";
  EXPECT_EQ(opaque_depth.error().what, "holds 4 components; grey, RGB and alpha are judged");
}

/// A TIFF of one pixel, little-endian: `photometric` as TIFF 6.0 numbers it.
std::string tiffPixel(int photometric, const std::string& samples) {
  const auto u16 = [](std::size_t value) {
    return std::string{static_cast<char>(value & 255U), static_cast<char>(value >> 8U)};
  };
  const auto entry = [&](std::size_t tag, std::size_t value) {
    return u16(tag) + u16(3) + u16(1) + u16(0) + u16(value) + u16(0);
  };
  const std::size_t count = samples.size(), behind = 8 + 2 + 9 * 12 + 4;
  std::string bits;
  for (std::size_t i = 0; i < count; ++i) bits += u16(8);
  return "II" + u16(42) + u16(8) + u16(0) + u16(9) + entry(256, 1) + entry(257, 1) + u16(258) +
         u16(3) + u16(count) + u16(0) + u16(behind) + u16(0) + entry(259, 1) +
         entry(262, static_cast<std::size_t>(photometric)) + entry(273, behind + bits.size()) +
         entry(277, count) + entry(278, 1) + entry(279, count) + std::string(4, '\0') + bits +
         samples;
}

/// A JPEG of 8x8 pixels of one CMYK colour, as Adobe writes it: inks inverted, 228 28 28 248.
std::string cmykJpeg() {
  const auto bytes = [](std::initializer_list<int> values) {
    std::string made;
    for (const int value : values) made += static_cast<char>(value);
    return made;
  };
  return bytes({0xFF, 0xD8, 0xFF, 0xEE, 0, 14}) + "Adobe" + bytes({0, 100, 0, 0, 0, 0, 0}) +
         bytes({0xFF, 0xDB, 0, 67, 0}) + std::string(64, '\1') +
         bytes({0xFF, 0xC0, 0, 20, 8, 0, 8, 0, 8, 4, 1, 0x11, 0, 2, 0x11, 0, 3, 0x11, 0, 4, 0x11}) +
         bytes({0, 0xFF, 0xC4, 0, 31, 0, 0, 0, 0, 12, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}) +
         bytes({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 0xFF, 0xC4, 0, 20, 0x10, 1}) +
         std::string(16, '\0') + bytes({0xFF, 0xDA, 0, 14, 4, 1, 0, 2, 0, 3, 0, 4, 0, 0, 63, 0}) +
         // Category 10 and the mean, eightfold, of each component; no detail.
         bytes({0xAC, 0x81, 0x46, 0xFA, 0x8D, 0xF5, 0x78, 0x0F, 0xFF, 0xD9});
}

TEST_F(FineByModule, InksAreReadForALookAndNotJudged) {
  for (const auto& [name, file] : {std::pair<std::string, std::string>{"a.jpg", cmykJpeg()},
                                   {"a.tif", tiffPixel(5, "\x1B\xE3\xE3\x07")}}) {
    SCOPED_TRACE(name);
    const auto judged = read(name, file);
    ASSERT_FALSE(judged.ok());
    EXPECT_EQ(judged.error().what, "has CMYK colours; grey and RGB are judged");
    const auto look = readPicture(folder_ / name);
    ASSERT_TRUE(look.ok()) << look.error().text();
    EXPECT_NEAR(look->rgba[0], 222, 1);
    EXPECT_NEAR(look->rgba[1], 27, 1);
    EXPECT_NEAR(look->rgba[2], 27, 1);
  }
  const auto lab = read("lab.tif", tiffPixel(8, "abc"));
  ASSERT_FALSE(lab.ok());
  EXPECT_EQ(lab.error().what, "has CIELAB colours; grey, RGB and CMYK are read");
  EXPECT_TRUE(read("rgb.tif", tiffPixel(2, "abc")).ok());
}

TEST_F(FineByModule, PixelsOfAPartOfThePictureAreNotJudged) {
  std::string file = test::exrFile(2, 1, "BGR", {0, 0, 0, 0, 0, 0});
  ASSERT_TRUE(read("whole.exr", file).ok());
  const std::size_t window = file.find("displayWindow");
  file[window + std::string("displayWindow.box2i.").size() + 4 + 8] = 9;
  const auto part = read("part.exr", file);
  ASSERT_FALSE(part.ok());
  EXPECT_EQ(part.error().what,
            "has a data window that differs from its display window; only whole pictures are "
            "judged");
  EXPECT_TRUE(readPicture(folder_ / "part.exr").ok());
}

TEST_F(FineByModule, NoMemoryIsMadeForAttributesLongerThanTheirFile) {
  std::string file = test::exrFile(2, 1, "BGR", {0, 0, 0, 0, 0, 0});
  const std::size_t size = file.find("lineOrder") + std::string("lineOrder.lineOrder.").size();
  file.replace(size, 4, "\xFF\xFF\xFF\x7F");
  const auto long_attribute = read("a.exr", file);
  ASSERT_FALSE(long_attribute.ok());
  EXPECT_EQ(long_attribute.error().what, "is cut short") << "said before the library is asked";
}

TEST_F(FineByModule, AChannelOfAnUnknownTypeEndsNoProgram) {
  std::string file = test::exrFile(2, 1, "BGR", {0, 0, 0, 0, 0, 0});
  const std::size_t first = file.find("chlist") + std::string("chlist.").size() + 4;
  ASSERT_EQ(file.substr(first, 3), std::string("B\0\2", 3));
  file[first + 2] = 3;
  const auto unknown = read("a.exr", file);
  ASSERT_FALSE(unknown.ok());
  EXPECT_EQ(unknown.error().what, "cannot be decoded: it has a channel of an unknown type");
}

#endif

}  // namespace
}  // namespace rocinante
