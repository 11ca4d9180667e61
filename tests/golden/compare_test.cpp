#include "golden/compare.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

Picture grey(int width, int height, std::uint8_t level = 100) {
  Picture picture{width, height, {}};
  picture.rgba.assign(static_cast<std::size_t>(width * height) * 4, level);
  return picture;
}

std::uint8_t* pixel(Picture& picture, int x, int y) {
  return picture.rgba.data() + static_cast<std::ptrdiff_t>((y * picture.width + x) * 4);
}

TEST(CompareWithGolden, EqualPicturesAreTheSameInEveryTier) {
  const Picture picture = grey(40, 30);
  for (const Tolerance& tolerance : {Tolerance::exactly(), Tolerance::cpu(), Tolerance::loose()}) {
    const Comparison found = compare(picture, picture, tolerance);
    EXPECT_EQ(found.verdict, Verdict::same);
    EXPECT_EQ(found.rule, "equal pixels");
  }
}

TEST(CompareWithGolden, ACroppedFrameNeverPasses) {
  // Debian's idiff passes this one: the rest of the larger picture is black.
  Picture golden = grey(32, 64, 0);
  const Picture frame = grey(64, 64, 0);
  for (const Tolerance& tolerance : {Tolerance::exactly(), Tolerance::loose()}) {
    const Comparison found = compare(frame, golden, tolerance);
    EXPECT_EQ(found.verdict, Verdict::incomparable);
    EXPECT_EQ(found.rule, "the frame is 64x64, the golden 32x64");
  }
}

TEST(CompareWithGolden, PicturesWithoutPixelsOrTooFewAreIncomparable) {
  EXPECT_EQ(compare(Picture{}, Picture{}, {}).verdict, Verdict::incomparable);
  Picture cut = grey(8, 8);
  cut.rgba.pop_back();
  EXPECT_EQ(compare(cut, grey(8, 8), {}).verdict, Verdict::incomparable);
}

TEST(CompareWithGolden, OneLevelInOnePixelFailsTheExactTierAlone) {
  const Picture golden = grey(40, 30);
  Picture frame = golden;
  pixel(frame, 39, 29)[3] += 1;  // alpha counts as much as a colour
  const Comparison exact = compare(frame, golden, Tolerance::exactly());
  EXPECT_EQ(exact.verdict, Verdict::different);
  EXPECT_EQ(exact.rule, "1 differing pixels (exact)");
  EXPECT_EQ(exact.differing, 1);
  EXPECT_EQ(exact.over_1, 0);
  EXPECT_EQ(exact.max, 1);
  EXPECT_EQ(compare(frame, golden, Tolerance::cpu()).verdict, Verdict::same);
}

TEST(CompareWithGolden, SaysWhereTheWorstPixelIsAndBothValues) {
  const Picture golden = grey(40, 30);
  Picture frame = golden;
  pixel(frame, 7, 5)[1] = 90;
  pixel(frame, 21, 13)[0] = 150;
  const Comparison found = compare(frame, golden, Tolerance::exactly());
  EXPECT_EQ(found.worst_x, 21);
  EXPECT_EQ(found.worst_y, 13);
  EXPECT_EQ(found.max, 50);
  EXPECT_EQ(found.worst_frame, (std::array<std::uint8_t, 4>{150, 100, 100, 100}));
  EXPECT_EQ(found.worst_golden, (std::array<std::uint8_t, 4>{100, 100, 100, 100}));
  EXPECT_EQ(found.differing, 2);
  EXPECT_EQ(found.over_8, 2);
  EXPECT_EQ(found.over_32, 1);
}

TEST(CompareWithGolden, TheTileMeanLimitIsInclusive) {
  const Picture golden = grey(64, 64);
  Picture frame = golden;
  // 16x16 pixels that differ by exactly 4, on a tile's place.
  for (int y = 8; y < 24; ++y) {
    for (int x = 16; x < 32; ++x) pixel(frame, x, y)[2] = 104;
  }
  const Comparison at_limit = compare(frame, golden, Tolerance::cpu());
  EXPECT_EQ(at_limit.verdict, Verdict::same);
  EXPECT_DOUBLE_EQ(at_limit.worst_tile_mean, 4.0);
  pixel(frame, 20, 12)[2] = 105;
  const Comparison over = compare(frame, golden, Tolerance::cpu());
  EXPECT_EQ(over.verdict, Verdict::different);
  EXPECT_EQ(over.rule, "worst tile's mean 4.00 > 4.00 (cpu)");
}

TEST(CompareWithGolden, ThreePixelsOfATileOver32FailTheCpuTier) {
  const Picture golden = grey(64, 64);
  Picture frame = golden;
  pixel(frame, 1, 1)[0] = 133;
  pixel(frame, 9, 3)[0] = 133;
  EXPECT_EQ(compare(frame, golden, Tolerance::cpu()).verdict, Verdict::same);
  pixel(frame, 15, 15)[0] = 132;  // 32 is not over 32
  EXPECT_EQ(compare(frame, golden, Tolerance::cpu()).verdict, Verdict::same);
  pixel(frame, 15, 15)[0] = 133;
  const Comparison found = compare(frame, golden, Tolerance::cpu());
  EXPECT_EQ(found.verdict, Verdict::different);
  EXPECT_EQ(found.rule, "3 pixels of a tile over 32 > 2 (cpu)");
}

TEST(CompareWithGolden, TilesReachTheFarEdgeOfAnySize) {
  // 37 and 29 are multiples of nothing: the last tile lies flush with the edge.
  const Picture golden = grey(37, 29);
  Picture frame = golden;
  for (int y = 13; y < 29; ++y) {
    for (int x = 21; x < 37; ++x) pixel(frame, x, y)[0] = 110;
  }
  EXPECT_DOUBLE_EQ(compare(frame, golden, Tolerance::cpu()).worst_tile_mean, 10.0);
}

TEST(CompareWithGolden, APictureSmallerThanATileIsOneTile) {
  const Picture golden = grey(5, 3);
  Picture frame = golden;
  pixel(frame, 4, 2)[0] = 115;
  EXPECT_DOUBLE_EQ(compare(frame, golden, Tolerance::cpu()).worst_tile_mean, 1.0);
}

TEST(DifferenceMap, ShowsWhereByHowMuch) {
  const Picture golden = grey(8, 4);
  Picture frame = golden;
  pixel(frame, 0, 0)[0] = 101;
  pixel(frame, 3, 0)[0] = 105;
  pixel(frame, 5, 3)[0] = 120;
  pixel(frame, 7, 3)[0] = 200;
  EXPECT_EQ(differenceMap(frame, golden, 8), (std::vector<std::string>{".  :    ", "     + #"}));
}

TEST(DifferencePicture, LeavesEqualPixelsGreyAndMarksTheOthers) {
  const Picture golden = grey(2, 1);
  Picture frame = golden;
  pixel(frame, 1, 0)[0] = 200;
  Picture shown = differencePicture(frame, golden);
  EXPECT_EQ(pixel(shown, 0, 0)[0], pixel(shown, 0, 0)[1]);
  EXPECT_EQ(pixel(shown, 1, 0)[0], 255);
  EXPECT_EQ(pixel(shown, 1, 0)[2], 0);
}

TEST(ReducedPicture, AveragesWholeBlocksAndLeavesSmallOnesAlone) {
  Picture picture = grey(640, 4, 0);
  pixel(picture, 0, 0)[0] = 200;  // one of the four of the first block
  const Picture reduced = reducedPicture(picture, 320);
  EXPECT_EQ(reduced.width, 320);
  EXPECT_EQ(reduced.height, 2);
  EXPECT_EQ(reduced.rgba[0], 50);
  EXPECT_EQ(reducedPicture(grey(5, 3), 320), grey(5, 3));
  EXPECT_EQ(reducedPicture(grey(700, 1), 320), grey(700, 1));
}

}  // namespace
}  // namespace rocinante
