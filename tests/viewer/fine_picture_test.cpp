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
  EXPECT_EQ((PictureEncoding{4, 8, false}).depthText(), "8 bits a component");
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
  EXPECT_EQ(refused.error().what, "is no picture that can be read");
  std::ofstream(folder / "empty.png");
  const auto empty = readFinePicture(folder / "empty.png");
  ASSERT_FALSE(empty.ok());
  EXPECT_EQ(empty.error().what, "is an empty file");
  std::ofstream(folder / "pointer.png")
      << "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n";
  const auto pointer = readFinePicture(folder / "pointer.png");
  ASSERT_FALSE(pointer.ok());
  EXPECT_EQ(pointer.error().what,
            "is a Git LFS pointer and not the picture; `git lfs pull` fetches it");
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
}

#endif

}  // namespace
}  // namespace rocinante
