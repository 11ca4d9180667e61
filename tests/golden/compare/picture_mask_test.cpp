#include "golden/compare/picture_mask.h"

#include <gtest/gtest.h>

#include "tests/golden/compare/test_pictures.h"

namespace rocinante {
namespace {

TEST(MaskRectangle, IsReadFromTextAndWrittenAgain) {
  const auto rectangle = MaskRectangle::parse("10,20,30x40");
  ASSERT_TRUE(rectangle.ok());
  EXPECT_EQ(*rectangle, (MaskRectangle{10, 20, 30, 40}));
  EXPECT_EQ(rectangle->text(), "10,20,30x40");
}

TEST(MaskRectangle, RefusesAnythingElse) {
  for (const char* text : {"", "1", "1,2", "1,2,3", "1,2,3,4", "1,2,3x", "1,2,3x4 ", " 1,2,3x4",
                           "-1,2,3x4", "1,2,0x4", "1,2,3x0", "1,2,3x-4", "1,2,3x4x5", "a,b,cxd",
                           "1,2,3x99999999999", "1.5,2,3x4", "1,2,3X4", "+1,2,3x4"}) {
    const auto rectangle = MaskRectangle::parse(text);
    ASSERT_FALSE(rectangle.ok()) << text;
    EXPECT_EQ(rectangle.error().what, "a mask is X,Y,WIDTHxHEIGHT in pixels");
  }
}

TEST(PictureMask, HidesExactlyTheRectangle) {
  PictureMask mask(8, 6);
  mask.hide(MaskRectangle{2, 1, 3, 2}, "gauge");
  std::string shown;
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 8; ++x) shown += mask.hides(x, y) ? '#' : '.';
  }
  EXPECT_EQ(shown,
            "........"
            "..###..."
            "..###..."
            "........"
            "........"
            "........");
  EXPECT_EQ(mask.hiddenPixels(), 6);
  EXPECT_FALSE(mask.hidesEverything());
}

TEST(PictureMask, CutsARectangleAtThePictureAndCountsAUselessOne) {
  PictureMask mask(8, 6);
  mask.hide(MaskRectangle{6, 4, 2'147'483'647, 2'147'483'647}, "corner");
  mask.hide(MaskRectangle{8, 0, 4, 4}, "beside");
  mask.hide(MaskRectangle{-5, -5, 6, 6}, "before");
  ASSERT_EQ(mask.parts().size(), 3U);
  EXPECT_EQ(mask.parts()[0].pixels, 4);
  EXPECT_EQ(mask.parts()[1].name, "beside");
  EXPECT_EQ(mask.parts()[1].pixels, 0);
  EXPECT_EQ(mask.parts()[2].pixels, 1);
}

TEST(PictureMask, OverlappingMasksCountEachAndTogetherOnce) {
  PictureMask mask(8, 6);
  mask.hide(MaskRectangle{0, 0, 4, 4}, "a");
  mask.hide(MaskRectangle{2, 2, 4, 4}, "b");
  EXPECT_EQ(mask.parts()[0].pixels, 16);
  EXPECT_EQ(mask.parts()[1].pixels, 16);
  EXPECT_EQ(mask.hiddenPixels(), 28);
  mask.hide(MaskRectangle{0, 0, 8, 6}, "all");
  EXPECT_TRUE(mask.hidesEverything());
}

// 0 is nothing, 1 a link of interest, 2 another one.
const std::vector<std::uint32_t> kIds = {
    0, 0, 0, 0, 0,  //
    0, 1, 0, 0, 0,  //
    0, 0, 0, 0, 2,  //
    0, 0, 0, 0, 2,
};

std::string shownSet(const PixelSet& pixels, std::size_t width) {
  std::string text;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (i > 0 && i % width == 0) text += '/';
    text += pixels[i] != 0 ? '#' : '.';
  }
  return text;
}

TEST(PixelsWithIds, AreThoseOfTheWantedIds) {
  EXPECT_EQ(shownSet(pixelsWithIds(kIds, {false, true, false}, 5, 4, 0), 5),
            "...../.#.../...../.....");
  EXPECT_EQ(shownSet(pixelsWithIds(kIds, {false, false, true}, 5, 4, 0), 5),
            "...../...../....#/....#");
  // An id that nobody listed is not wanted.
  EXPECT_EQ(shownSet(pixelsWithIds(kIds, {}, 5, 4, 0), 5), "...../...../...../.....");
}

TEST(PixelsWithIds, GrowByTheMarginWithinThePicture) {
  EXPECT_EQ(shownSet(pixelsWithIds(kIds, {false, true, false}, 5, 4), 5),
            "###../###../###../.....");
  EXPECT_EQ(shownSet(pixelsWithIds(kIds, {false, false, true}, 5, 4), 5),
            "...../...##/...##/...##");
}

TEST(PictureMask, HidesASetOrEverythingButIt) {
  PixelSet label = pixelsWithIds(kIds, {false, true, false}, 5, 4, 0);
  unite(label, pixelsWithIds(kIds, {false, false, true}, 5, 4, 0));
  PictureMask mask(5, 4);
  mask.hide(label, "drawing/*");
  EXPECT_EQ(mask.hiddenPixels(), 3);
  PictureMask others(5, 4);
  others.hideOthers(label, "only drawing/*");
  EXPECT_EQ(others.hiddenPixels(), 17);
  EXPECT_FALSE(others.hides(1, 1));
  EXPECT_TRUE(others.hides(0, 0));
}

TEST(PictureMask, AppliedTakesTheGoldensPixelsWhereItHides) {
  const Picture golden = greyPicture(4, 2, 10);
  const Picture frame = greyPicture(4, 2, 20);
  PictureMask mask(4, 2);
  mask.hide(MaskRectangle{1, 0, 2, 1}, "middle");
  Picture judged = mask.applied(frame, golden);
  EXPECT_EQ(pixelAt(judged, 0, 0)[0], 20);
  EXPECT_EQ(pixelAt(judged, 1, 0)[0], 10);
  EXPECT_EQ(pixelAt(judged, 2, 0)[3], 10);
  EXPECT_EQ(pixelAt(judged, 3, 0)[0], 20);
  EXPECT_EQ(pixelAt(judged, 1, 1)[0], 20);
}

}  // namespace
}  // namespace rocinante
