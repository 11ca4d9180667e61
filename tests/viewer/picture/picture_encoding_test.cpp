#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/atomic_file.h"
#include "tests/support/temporary_folder.h"
#include "viewer/picture/picture_options.h"

namespace rocinante {
namespace {

/// Every level in each component, opaque or not.
Picture levels(bool opaque) {
  Picture picture;
  picture.width = 256;
  picture.height = 3;
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 256; ++x) {
      const auto level = static_cast<std::uint8_t>(x);
      const auto other = static_cast<std::uint8_t>(255 - x);
      picture.rgba.insert(picture.rgba.end(),
                          {level, y == 1 ? other : level, y == 2 ? other : level,
                           opaque ? std::uint8_t{255} : static_cast<std::uint8_t>(255 - y * 60)});
    }
  }
  return picture;
}

TEST(PictureEncoding, PngIsEncodePng) {
  const auto encoded = encodePicture("a.PNG", levels(true));
  ASSERT_TRUE(encoded.ok());
  EXPECT_EQ(*encoded, encodePng(levels(true)));
  EXPECT_TRUE(mayEncodePicture("a.png").ok());
}

TEST(PictureEncoding, ANameWithoutEndingIsRefused) {
  EXPECT_EQ(mayEncodePicture("folder.d/frame").error().kind, ErrorKind::bad_argument);
}

#ifdef ROCINANTE_HAS_OPENIMAGEIO
TEST(PictureEncoding, WhatHoldsTheValuesGivesThemBack) {
  for (const char* name : {"a.tif", "a.bmp", "a.tga", "a.ppm", "a.exr"}) {
    SCOPED_TRACE(name);
    EXPECT_TRUE(mayEncodePicture(name).ok());
    const auto encoded = encodePicture(name, levels(true));
    ASSERT_TRUE(encoded.ok()) << encoded.error().text();
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeFileWhole(folder / name, *encoded, false).ok());
    const auto read = readPicture(folder / name);
    ASSERT_TRUE(read.ok()) << read.error().text();
    EXPECT_EQ(*read, levels(true));
    const auto again = encodePicture(name, levels(true));
    ASSERT_TRUE(again.ok());
    EXPECT_TRUE(*again == *encoded);
    if (std::string_view(name) == "a.tif") {
      EXPECT_NE(textOf(*encoded).find("1970:01:01 00:00:00"), std::string_view::npos);
    }
  }
}

TEST(PictureEncoding, AlphaIsKeptWhereThereIsSome) {
  for (const char* name : {"a.tif"}) {
    SCOPED_TRACE(name);
    const auto encoded = encodePicture(name, levels(false));
    ASSERT_TRUE(encoded.ok()) << encoded.error().text();
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeFileWhole(folder / name, *encoded, false).ok());
    const auto read = readPicture(folder / name);
    ASSERT_TRUE(read.ok()) << read.error().text();
    EXPECT_EQ(*read, levels(false));
  }
}

TEST(PictureEncoding, AnUnknownEndingIsRefused) {
  EXPECT_EQ(mayEncodePicture("a.xyz").error().kind, ErrorKind::unsupported);
  EXPECT_EQ(encodePicture("a.xyz", levels(true)).error().kind, ErrorKind::unsupported);
}
#else
TEST(PictureEncoding, OtherKindsNeedTheModule) {
  EXPECT_THAT(mayEncodePicture("a.jpg").error().what, testing::HasSubstr("only PNG is written"));
}
#endif

}  // namespace
}  // namespace rocinante
