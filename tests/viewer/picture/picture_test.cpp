#include "viewer/picture/picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <limits>

#include "core/base/atomic_file.h"
#include "tests/support/picture_bytes.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"
#include "viewer/picture/srgb_curve.h"

namespace rocinante {
namespace {

using ::testing::AnyOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string bytes(std::initializer_list<int> values) {
  std::string text;
  for (const int value : values) text += static_cast<char>(value);
  return text;
}

std::vector<int> componentsOf(const Result<Picture>& picture) {
  EXPECT_TRUE(picture.ok()) << picture.error().text();
  if (!picture) return {};
  return {picture->rgba.begin(), picture->rgba.end()};
}

std::vector<int> decoded(const std::string& file) {
  return componentsOf(decodePng(bytesOf(file), "test.png"));
}

Picture gradient(int width, int height) {
  Picture picture{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (const int component : {x * 3, y * 5, x * y, 255 - x}) {
        picture.rgba.push_back(static_cast<std::uint8_t>(component));
      }
    }
  }
  return picture;
}

TEST(Png, DecodesEveryColourTypeToRgba) {
  EXPECT_THAT(decoded(test::pngFile(2, 1, 8, 2, bytes({0, 1, 2, 3, 4, 5, 6}))),
              ElementsAre(1, 2, 3, 255, 4, 5, 6, 255));
  EXPECT_THAT(decoded(test::pngFile(1, 2, 8, 6, bytes({0, 1, 2, 3, 4, 0, 5, 6, 7, 8}))),
              ElementsAre(1, 2, 3, 4, 5, 6, 7, 8));
  EXPECT_THAT(decoded(test::pngFile(2, 1, 8, 0, bytes({0, 9, 200}))),
              ElementsAre(9, 9, 9, 255, 200, 200, 200, 255));
  EXPECT_THAT(decoded(test::pngFile(1, 1, 8, 4, bytes({0, 9, 100}))), ElementsAre(9, 9, 9, 100));
}

TEST(Png, DecodesEveryDepth) {
  EXPECT_THAT(decoded(test::pngFile(2, 1, 1, 0, bytes({0, 0x40}))),
              ElementsAre(0, 0, 0, 255, 255, 255, 255, 255));
  EXPECT_THAT(decoded(test::pngFile(2, 1, 2, 0, bytes({0, 0x60}))),
              ElementsAre(85, 85, 85, 255, 170, 170, 170, 255));
  EXPECT_THAT(decoded(test::pngFile(1, 1, 4, 0, bytes({0, 0xF0}))),
              ElementsAre(255, 255, 255, 255));
  EXPECT_THAT(decoded(test::pngFile(1, 1, 16, 2, bytes({0, 1, 255, 2, 255, 3, 255}))),
              ElementsAre(1, 2, 3, 255));
  EXPECT_THAT(decoded(test::pngFile(1, 1, 16, 6, bytes({0, 1, 0, 2, 0, 3, 0, 4, 0}))),
              ElementsAre(1, 2, 3, 4));
}

TEST(Png, DecodesPalettesAndTransparency) {
  const std::string palette = test::pngChunk("PLTE", bytes({10, 20, 30, 40, 50, 60}));
  EXPECT_THAT(decoded(test::pngFile(2, 1, 8, 3, bytes({0, 1, 0}),
                                    palette + test::pngChunk("tRNS", bytes({7})))),
              ElementsAre(40, 50, 60, 255, 10, 20, 30, 7));
  EXPECT_THAT(
      decoded(test::pngFile(2, 1, 8, 0, bytes({0, 9, 8}), test::pngChunk("tRNS", bytes({0, 9})))),
      ElementsAre(9, 9, 9, 0, 8, 8, 8, 255));
}

TEST(Png, RefusesMorePixelsThanAllowedBeforeAllocating) {
  const std::string huge = test::pngFile(20000, 20000, 8, 6, "");
  const Result<Picture> picture = decodePng(bytesOf(huge), "huge.png");
  ASSERT_FALSE(picture.ok());
  EXPECT_EQ(picture.error().kind, ErrorKind::unsupported);
  EXPECT_EQ(picture.error().text(),
            "is 20000 x 20000 pixels; at most 268435456 are read (huge.png)");
  EXPECT_TRUE(decodePng(bytesOf(test::pngFile(2, 1, 8, 0, bytes({0, 9, 8}))), "x", 2).ok());
  EXPECT_FALSE(decodePng(bytesOf(test::pngFile(2, 1, 8, 0, bytes({0, 9, 8}))), "x", 1).ok());
  // Allowed by its size, but its bytes could never hold it.
  const std::string hollow = test::pngFile(16000, 16000, 8, 6, "");
  EXPECT_THAT(decodePng(bytesOf(hollow), "x").error().what, HasSubstr("too short for its size"));
}

TEST(Png, RefusesEveryCutAndEveryFlippedByte) {
  const Bytes whole = encodePng(gradient(20, 10));
  for (std::size_t length = 0; length + 12 < whole.size(); ++length) {
    const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
    EXPECT_FALSE(decodePng(cut, "cut").ok()) << length;
  }
  for (std::size_t at = 0; at + 12 < whole.size(); ++at) {
    Bytes flipped = whole;
    flipped[at] ^= std::byte{0x10};
    const Result<Picture> picture = decodePng(flipped, "flipped");
    // Each chunk has a checksum, the header a signature: no flipped byte goes unnoticed but one in
    // the empty end.
    EXPECT_FALSE(picture.ok()) << at;
  }
}

TEST(Png, EncodesWhatItDecodesAndAlwaysTheSameBytes) {
  for (const auto& [width, height] : {std::pair{1, 1}, {33, 7}, {640, 480}}) {
    const Picture picture = gradient(width, height);
    const Bytes encoded = encodePng(picture);
    EXPECT_EQ(encoded, encodePng(picture));
    const Result<Picture> back = decodePng(encoded, "back");
    ASSERT_TRUE(back.ok()) << back.error().text();
    EXPECT_EQ(*back, picture);
  }
}

TEST(Png, AppearsWholeAndReplacesOnlyWhenAllowed) {
  const test::TemporaryFolder folder;
  const Picture picture = gradient(8, 8);
  ASSERT_TRUE(writePng(folder / "a.png", picture).ok());
  EXPECT_TRUE(writePng(folder / "a.png", picture).ok());
  EXPECT_EQ(writePng(folder / "a.png", picture, false).error().kind, ErrorKind::refused);
  EXPECT_EQ(*readPng(folder / "a.png"), picture);
  EXPECT_EQ(*readPicture(folder / "a.png"), picture);
  EXPECT_FALSE(writePng(folder / "no/such/a.png", picture).ok());
  EXPECT_EQ(readPng(folder / "none.png").error().kind, ErrorKind::not_found);
  EXPECT_EQ(readPicture(folder / "none.jpg").error().kind, ErrorKind::not_found);
}

TEST(PictureHash, IsOverRowsAndForXxh3AlsoOverTheSize) {
  // printf '\1\2\3\4\5\6\7\10' | sha256sum
  const Picture wide{2, 1, {1, 2, 3, 4, 5, 6, 7, 8}};
  const Picture high{1, 2, {1, 2, 3, 4, 5, 6, 7, 8}};
  EXPECT_EQ(pictureSha256(wide),
            "66840dda154e8a113c31dd0ad32f7f3a366a80e8136979d8f5a101d3d29d6f72");
  EXPECT_EQ(pictureSha256(high), pictureSha256(wide));
  EXPECT_NE(pictureXxh3(high), pictureXxh3(wide));
  EXPECT_EQ(pictureXxh3(wide),
            hexOf(xxh3(bytesOf(bytes({2, 0, 0, 0, 1, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8})))));
}

TEST(SrgbCurve, IsTheStandardsCurve) {
  const SrgbCurve curve;
  EXPECT_EQ(curve.encode(0.0F), 0);
  EXPECT_EQ(curve.encode(1.0F), 255);
  EXPECT_EQ(curve.encode(0.5F), 188);
  EXPECT_EQ(curve.encode(0.2158605F), 128);
  EXPECT_EQ(curve.encode(0.001F), 3);
  EXPECT_EQ(curve.encode(-1.0F), 0);
  EXPECT_EQ(curve.encode(1e30F), 255);
  EXPECT_EQ(curve.encode(std::numeric_limits<float>::quiet_NaN()), 0);
}

#ifdef ROCINANTE_HAS_OPENIMAGEIO

class OtherPictures : public ::testing::Test {
 protected:
  std::vector<int> read(const std::string& name, const std::string& content) {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return componentsOf(readPicture(folder_ / name));
  }
  test::TemporaryFolder folder_;
};

TEST_F(OtherPictures, AreReadWithColoursGreyAndSixteenBits) {
  EXPECT_THAT(read("a.ppm", "P6\n2 1\n255\n" + bytes({1, 2, 3, 4, 5, 6})),
              ElementsAre(1, 2, 3, 255, 4, 5, 6, 255));
  EXPECT_THAT(read("a.pgm", "P5\n2 1\n255\n" + bytes({9, 200})),
              ElementsAre(9, 9, 9, 255, 200, 200, 200, 255));
  EXPECT_THAT(read("b.pgm", "P5\n2 1\n65535\n" + bytes({9, 128, 200, 128})),
              ElementsAre(9, 9, 9, 255, 200, 200, 200, 255));
}

TEST_F(OtherPictures, KeepStraightAlpha) {
  // Targa, uncompressed, 32 bits, 8 of them alpha, first row on top; a footer with attributes type
  // 3: alpha is straight. Blue, green, red, alpha.
  std::string targa = bytes({0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 1, 0, 32, 0x28});
  targa += bytes({30, 20, 200, 128, 3, 2, 1, 255});
  EXPECT_THAT(read("a.tga", targa), ElementsAre(200, 20, 30, 128, 1, 2, 3, 255));
}

TEST_F(OtherPictures, OfGifsKeepTheirColours) {
  // Two colours, red and blue, a pixel of each: codes 4 (clear), 0, 1, 5 (end) of three bits.
  std::string gif = "GIF89a" + bytes({2, 0, 1, 0, 0x80, 0, 0, 255, 0, 0, 0, 0, 255});
  gif += "," + bytes({0, 0, 0, 0, 2, 0, 1, 0, 0, 2, 2, 0x44, 0x0A, 0}) + ";";
  EXPECT_THAT(read("a.gif", gif), ElementsAre(255, 0, 0, 255, 0, 0, 255, 255));
}

TEST_F(OtherPictures, AreToldByTheirBytesNotByTheirName) {
  EXPECT_THAT(read("a.jpg", test::pngFile(1, 1, 8, 0, bytes({0, 9}))), ElementsAre(9, 9, 9, 255));
}

TEST_F(OtherPictures, GiveASentenceWhenTheyAreNone) {
  std::ofstream(folder_ / "a.jpg") << "this is a text, not a picture";
  const Result<Picture> text = readPicture(folder_ / "a.jpg");
  ASSERT_FALSE(text.ok());
  EXPECT_EQ(text.error().text().find('\n'), std::string::npos);
  EXPECT_THAT(text.error().text(), HasSubstr("a.jpg"));
  std::ofstream(folder_ / "b.ppm", std::ios::binary) << "P6\n20000 20000\n255\nx";
  // OpenImageIO 3.1 refuses it first, in words of its own.
  EXPECT_THAT(readPicture(folder_ / "b.ppm").error().text(),
              AnyOf(HasSubstr("at most 268435456"), HasSubstr("a 1144 MB image from a 20 byte")));
}

TEST_F(OtherPictures, JpegTexturesDecodeToTheSameBytesEverywhere) {
  ROCINANTE_NEEDS_SHARED_DATA("robots/kuka_iiwa/objects/tray.jpg");
  const Result<Picture> tray = readPicture(test::sharedData("robots/kuka_iiwa/objects/tray.jpg"));
  ASSERT_TRUE(tray.ok()) << tray.error().text();
  EXPECT_EQ(pictureSha256(*tray),
            "636ea8960b10e7d54ddc59415e6fef027a29491db827e4b998161c47da26b511");
}

TEST_F(OtherPictures, OfWhichAPartIsMissingAreRefused) {
  ROCINANTE_NEEDS_SHARED_DATA("robots/kuka_iiwa/objects/tray.jpg");
  const auto tray = readFile(test::sharedData("robots/kuka_iiwa/objects/tray.jpg"));
  ASSERT_TRUE(tray.ok());
  const std::string half = tray->substr(0, tray->size() / 2);
  std::ofstream(folder_ / "half.jpg", std::ios::binary) << half;
  EXPECT_THAT(readPicture(folder_ / "half.jpg").error().text(), HasSubstr("is cut short"));
  EXPECT_EQ(decodePicture(bytesOf(half), "half").error().kind, ErrorKind::damaged);
  const Result<Picture> longer = decodePicture(bytesOf(*tray + "what a camera appends"), "tray");
  EXPECT_TRUE(longer.ok()) << longer.error().text();
}

#endif

TEST(RealPictures, AllTexturesOfTheWasteYardAreRead) {
  ROCINANTE_NEEDS_SHARED_DATA("env/waste_yard/textures");
  std::int64_t pixels = 0;
  for (const auto& file :
       std::filesystem::directory_iterator(test::sharedData("env/waste_yard/textures"))) {
#ifndef ROCINANTE_HAS_OPENIMAGEIO
    if (file.path().extension() == ".jpg") continue;
#endif
    const Result<Picture> picture = readPicture(file.path());
    ASSERT_TRUE(picture.ok()) << picture.error().text();
    pixels += std::int64_t{picture->width} * picture->height;
  }
#ifdef ROCINANTE_HAS_OPENIMAGEIO
  EXPECT_NEAR(static_cast<double>(pixels) * 3e-6, 18.3, 0.1);
#endif
}

}  // namespace
}  // namespace rocinante
