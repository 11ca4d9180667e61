#include "golden/compare/compare.h"

#include <gtest/gtest.h>

#include "golden/compare/picture_mask.h"
#include "tests/golden/compare/test_pictures.h"

namespace rocinante {
namespace {

TEST(CompareWithGolden, EqualPicturesAreTheSameInEveryTier) {
  const Picture picture = greyPicture(40, 30);
  for (const Tolerance& tolerance :
       {Tolerance::exactly(), Tolerance::rounding(), Tolerance::cpu(), Tolerance::loose()}) {
    const Comparison found = compare(picture, picture, tolerance);
    EXPECT_EQ(found.verdict, Verdict::same);
    EXPECT_EQ(found.rule, "equal pixels");
  }
}

TEST(CompareWithGolden, ACroppedFrameNeverPasses) {
  // Debian's idiff passes this one: the rest of the larger picture is black.
  Picture golden = greyPicture(32, 64, 0);
  const Picture frame = greyPicture(64, 64, 0);
  for (const Tolerance& tolerance :
       {Tolerance::exactly(), Tolerance::rounding(), Tolerance::loose()}) {
    const Comparison found = compare(frame, golden, tolerance);
    EXPECT_EQ(found.verdict, Verdict::incomparable);
    EXPECT_EQ(found.rule, "the frame is 64x64, the golden 32x64");
  }
}

TEST(CompareWithGolden, ATurnedFrameNeverPasses) {
  // As many pixels, all equal, and as many bytes.
  EXPECT_EQ(compare(greyPicture(30, 20), greyPicture(20, 30), Tolerance::loose()).rule,
            "the frame is 30x20, the golden 20x30");
}

TEST(CompareWithGolden, PicturesWithoutPixelsOrTooFewAreIncomparable) {
  EXPECT_EQ(compare(Picture{}, Picture{}, {}).verdict, Verdict::incomparable);
  Picture cut = greyPicture(8, 8);
  cut.rgba.pop_back();
  EXPECT_EQ(compare(cut, greyPicture(8, 8), {}).verdict, Verdict::incomparable);
}

TEST(CompareWithGolden, OneLevelInOnePixelFailsTheExactTierAlone) {
  const Picture golden = greyPicture(40, 30);
  Picture frame = golden;
  pixelAt(frame, 39, 29)[3] += 1;  // alpha counts as much as a colour
  const Comparison exact = compare(frame, golden, Tolerance::exactly());
  EXPECT_EQ(exact.verdict, Verdict::different);
  EXPECT_EQ(exact.rule, "1 differing pixel (exact)");
  EXPECT_EQ(exact.differing, 1);
  EXPECT_EQ(exact.over_1, 0);
  EXPECT_EQ(exact.max, 1);
  EXPECT_EQ(compare(frame, golden, Tolerance::cpu()).verdict, Verdict::same);
}

TEST(CompareWithGolden, SaysWhereTheWorstPixelIsAndBothValues) {
  const Picture golden = greyPicture(40, 30);
  Picture frame = golden;
  pixelAt(frame, 7, 5)[1] = 90;
  pixelAt(frame, 21, 13)[0] = 150;
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
  const Picture golden = greyPicture(64, 64);
  Picture frame = golden;
  // 16x16 pixels that differ by exactly 4, on a tile's place.
  for (int y = 8; y < 24; ++y) {
    for (int x = 16; x < 32; ++x) pixelAt(frame, x, y)[2] = 104;
  }
  const Comparison at_limit = compare(frame, golden, Tolerance::cpu());
  EXPECT_EQ(at_limit.verdict, Verdict::same);
  EXPECT_DOUBLE_EQ(at_limit.worst_tile_mean, 4.0);
  pixelAt(frame, 20, 12)[2] = 105;
  const Comparison over = compare(frame, golden, Tolerance::cpu());
  EXPECT_EQ(over.verdict, Verdict::different);
  EXPECT_EQ(over.rule, "worst tile's mean 4.00 > 4.00 (cpu)");
}

TEST(CompareWithGolden, ThreePixelsOfATileOver32FailTheCpuTier) {
  const Picture golden = greyPicture(64, 64);
  Picture frame = golden;
  pixelAt(frame, 1, 1)[0] = 133;
  pixelAt(frame, 9, 3)[0] = 133;
  EXPECT_EQ(compare(frame, golden, Tolerance::cpu()).verdict, Verdict::same);
  pixelAt(frame, 15, 15)[0] = 132;  // 32 is not over 32
  EXPECT_EQ(compare(frame, golden, Tolerance::cpu()).verdict, Verdict::same);
  pixelAt(frame, 15, 15)[0] = 133;
  const Comparison found = compare(frame, golden, Tolerance::cpu());
  EXPECT_EQ(found.verdict, Verdict::different);
  EXPECT_EQ(found.rule, "3 pixels of a tile over 32 > 2 (cpu)");
}

TEST(CompareWithGolden, TilesReachTheFarEdgeOfAnySize) {
  // 37 and 29 are multiples of nothing: the last tile lies flush with the edge.
  const Picture golden = greyPicture(37, 29);
  Picture frame = golden;
  for (int y = 13; y < 29; ++y) {
    for (int x = 21; x < 37; ++x) pixelAt(frame, x, y)[0] = 110;
  }
  EXPECT_DOUBLE_EQ(compare(frame, golden, Tolerance::cpu()).worst_tile_mean, 10.0);
}

TEST(CompareWithGolden, APictureSmallerThanATileIsOneTile) {
  const Picture golden = greyPicture(5, 3);
  Picture frame = golden;
  pixelAt(frame, 4, 2)[0] = 115;
  EXPECT_DOUBLE_EQ(compare(frame, golden, Tolerance::cpu()).worst_tile_mean, 1.0);
}

TEST(CompareWithGolden, SaysWhereTheWorstTileIs) {
  const Picture golden = greyPicture(64, 48);
  Picture frame = golden;
  for (int y = 16; y < 32; ++y) {
    for (int x = 40; x < 56; ++x) pixelAt(frame, x, y)[0] = 103;
  }
  pixelAt(frame, 0, 0)[0] = 255;  // more than the tile, in one pixel
  const Comparison found = compare(frame, golden, Tolerance::cpu());
  EXPECT_DOUBLE_EQ(found.worst_tile_mean, 3.0);
  EXPECT_EQ(found.worst_tile_x, 40);
  EXPECT_EQ(found.worst_tile_y, 16);
  EXPECT_EQ(found.worst_tile_over, 1);
}

TEST(CompareWithGolden, CountsEveryLimitWithoutTheLimitItself) {
  const Picture golden = greyPicture(16, 4);
  Picture frame = golden;
  int x = 0;
  for (const int difference : {1, 2, 3, 8, 9, 32, 33, 155}) {
    pixelAt(frame, x++, 2)[1] = static_cast<std::uint8_t>(100 + difference);
  }
  const Comparison found = compare(frame, golden, Tolerance::exactly());
  EXPECT_EQ(found.differing, 8);
  EXPECT_EQ(found.over_1, 7);
  EXPECT_EQ(found.over_2, 6);
  EXPECT_EQ(found.over_8, 4);
  EXPECT_EQ(found.over_32, 2);
  EXPECT_EQ(found.max, 155);
}

TEST(CompareWithGolden, IsTheSameInBothDirections) {
  const Picture golden = noisePicture(41, 23, 7);
  const Picture frame = noisePicture(41, 23, 8);
  const Comparison there = compare(frame, golden, Tolerance::loose());
  const Comparison back = compare(golden, frame, Tolerance::loose());
  EXPECT_EQ(there.rule, back.rule);
  EXPECT_EQ(there.max, back.max);
  EXPECT_EQ(there.worst_tile_mean, back.worst_tile_mean);
  EXPECT_EQ(there.over_8, back.over_8);
}

TEST(CompareWithGolden, LooksAtEveryPixelAndComponent) {
  const Picture golden = noisePicture(19, 21, 3);
  for (std::size_t i = 0; i < golden.rgba.size(); ++i) {
    Picture frame = golden;
    frame.rgba[i] ^= 1U;
    const Comparison found = compare(frame, golden, Tolerance::exactly());
    ASSERT_EQ(found.verdict, Verdict::different) << i;
    ASSERT_EQ(found.differing, 1) << i;
    ASSERT_EQ(found.worst_x, static_cast<int>(i / 4 % 19)) << i;
    ASSERT_EQ(found.worst_y, static_cast<int>(i / 4 / 19)) << i;
  }
}

TEST(CompareWithGolden, TheLimitsOfTheTiersAreTheDocumentedOnes) {
  struct Case {
    Tolerance tolerance;
    int level;  // of a whole tile, at the limit
    int over;   // pixels over 32, at the limit
  };
  for (const Case& tier : {Case{Tolerance::cpu(), 4, 2}, Case{Tolerance::loose(), 6, 16}}) {
    SCOPED_TRACE(tier.tolerance.name);
    const Picture golden = greyPicture(32, 32);
    Picture frame = greyPicture(32, 32, static_cast<std::uint8_t>(100 + tier.level));
    EXPECT_EQ(compare(frame, golden, tier.tolerance).verdict, Verdict::same);
    pixelAt(frame, 9, 9)[2] += 1;
    EXPECT_EQ(compare(frame, golden, tier.tolerance).verdict, Verdict::different);

    Picture dotted = golden;
    for (int i = 0; i < tier.over; ++i) pixelAt(dotted, 8 + i % 8, 8 + i / 8)[0] = 133;
    EXPECT_EQ(compare(dotted, golden, tier.tolerance).verdict, Verdict::same);
    pixelAt(dotted, 15, 15)[0] = 133;
    EXPECT_EQ(compare(dotted, golden, tier.tolerance).verdict, Verdict::different);
  }
}

/// `count` pixels, spread over the picture, differ by one level in one component or another.
Picture roundedPicture(Picture picture, int count) {
  const int pixels = picture.width * picture.height;
  for (int i = 0; i < count; ++i) {
    const int at = i * (pixels / count);
    std::uint8_t& sample = picture.rgba[static_cast<std::size_t>(at * 4 + i % 4)];
    sample = static_cast<std::uint8_t>(i % 3 == 0 ? sample - 1 : sample + 1);
  }
  return picture;
}

TEST(CompareRounding, OneLevelInTwoPercentOfThePixelsIsTheSameAndOnePixelMoreIsNot) {
  // 1,200 pixels: 24 of them are 2 %.
  const Picture golden = greyPicture(40, 30);
  const Comparison at_limit = compare(roundedPicture(golden, 24), golden, Tolerance::rounding());
  EXPECT_EQ(at_limit.verdict, Verdict::same);
  EXPECT_EQ(at_limit.rule, "24 of 1200 pixels differ (<= 2 %), by at most 1 (rounding)");
  const Comparison over = compare(roundedPicture(golden, 25), golden, Tolerance::rounding());
  EXPECT_EQ(over.verdict, Verdict::different);
  EXPECT_EQ(over.rule, "25 of 1200 pixels differ (> 2 %), by at most 1 (rounding)");
}

TEST(CompareRounding, TheShareIsNotRounded) {
  // 2 % of 1,274 pixels are 25.48, of 1,275 they are 25.5.
  for (const int width : {1'274, 1'275}) {
    const Picture golden = greyPicture(width, 1);
    EXPECT_EQ(compare(roundedPicture(golden, 25), golden, Tolerance::rounding()).verdict,
              Verdict::same);
    EXPECT_EQ(compare(roundedPicture(golden, 26), golden, Tolerance::rounding()).verdict,
              Verdict::different);
  }
}

TEST(CompareRounding, TwoLevelsInOneComponentOfOnePixelAreAChange) {
  const Picture golden = greyPicture(40, 30);
  for (int component = 0; component < 4; ++component) {
    for (const int level : {98, 102}) {
      SCOPED_TRACE(component);
      Picture frame = golden;
      pixelAt(frame, 39, 29)[component] = static_cast<std::uint8_t>(level);
      const Comparison found = compare(frame, golden, Tolerance::rounding());
      EXPECT_EQ(found.verdict, Verdict::different);
      EXPECT_EQ(found.rule, "largest difference 2 > 1 (rounding)");
    }
  }
}

TEST(CompareRounding, OneLevelInAllComponentsOfAPixelIsOnePixel) {
  const Picture golden = greyPicture(50, 1);
  Picture frame = golden;
  for (int component = 0; component < 4; ++component) pixelAt(frame, 7, 0)[component] += 1;
  const Comparison found = compare(frame, golden, Tolerance::rounding());
  EXPECT_EQ(found.verdict, Verdict::same);
  EXPECT_EQ(found.differing, 1);
}

TEST(CompareRounding, AtTheEndsOfTheRangeALevelIsALevel) {
  for (const auto& [before, after] : {std::pair(0, 1), {1, 0}, {254, 255}, {255, 254}}) {
    const Picture golden = greyPicture(10, 10, static_cast<std::uint8_t>(before));
    Picture frame = golden;
    pixelAt(frame, 3, 3)[0] = static_cast<std::uint8_t>(after);
    EXPECT_EQ(compare(frame, golden, Tolerance::rounding()).verdict, Verdict::same);
  }
  Picture frame = greyPicture(10, 10, 0);
  pixelAt(frame, 3, 3)[0] = 255;  // 0 - 1 wraps to it
  EXPECT_EQ(compare(frame, greyPicture(10, 10, 0), Tolerance::rounding()).verdict,
            Verdict::different);
}

TEST(CompareRounding, OfFewerThanFiftyPixelsNoneMayDiffer) {
  for (const int width : {1, 49}) {
    const Picture golden = greyPicture(width, 1);
    EXPECT_EQ(compare(golden, golden, Tolerance::rounding()).verdict, Verdict::same);
    EXPECT_EQ(compare(roundedPicture(golden, 1), golden, Tolerance::rounding()).verdict,
              Verdict::different);
  }
  EXPECT_EQ(
      compare(roundedPicture(greyPicture(1, 1), 1), greyPicture(1, 1), Tolerance::rounding()).rule,
      "1 of 1 pixels differ (> 2 %), by at most 1 (rounding)");
  EXPECT_EQ(
      compare(roundedPicture(greyPicture(50, 1), 1), greyPicture(50, 1), Tolerance::rounding())
          .verdict,
      Verdict::same);
}

TEST(CompareRounding, AFlatShiftOfOneLevelIsAChange) {
  // Every pixel one level brighter: no rounding, though nothing is off by more than one.
  EXPECT_EQ(compare(greyPicture(64, 64, 101), greyPicture(64, 64), Tolerance::rounding()).verdict,
            Verdict::different);
}

TEST(CompareRounding, TheShareIsOfThePixelsThatNoMaskHides) {
  const Picture golden = greyPicture(40, 30);
  PictureMask mask(40, 30);
  mask.hide(MaskRectangle{0, 15, 40, 15}, "lower half");  // 600 pixels are left: 12 of them
  for (const auto& [count, verdict] :
       {std::pair(12, Verdict::same), std::pair(13, Verdict::different)}) {
    Picture frame = golden;
    for (int i = 0; i < count; ++i) pixelAt(frame, 3 * i, 14)[1] += 1;
    const Comparison found = compare(frame, golden, Tolerance::rounding(), &mask);
    EXPECT_EQ(found.verdict, verdict);
    EXPECT_EQ(found.masked, 600);
    EXPECT_EQ(found.differing, count);
    for (int x = 0; x < 40; ++x) pixelAt(frame, x, 20)[0] = 255;  // hidden
    EXPECT_EQ(compare(frame, golden, Tolerance::rounding(), &mask).rule, found.rule);
  }
}

TEST(CompareRounding, EachTierHoldsWhatTheOneBeforeItPasses) {
  const Picture golden = greyPicture(64, 48);
  const Picture frame = roundedPicture(golden, 60);
  EXPECT_EQ(compare(frame, golden, Tolerance::exactly()).verdict, Verdict::different);
  for (const Tolerance& tolerance : {Tolerance::rounding(), Tolerance::cpu(), Tolerance::loose()}) {
    EXPECT_EQ(compare(frame, golden, tolerance).verdict, Verdict::same) << tolerance.name;
  }
}

TEST(CompareRounding, IsFoundByItsName) {
  for (const char* name : {"exact", "rounding", "cpu", "loose"}) {
    const auto tolerance = Tolerance::named(name);
    ASSERT_TRUE(tolerance.ok()) << name;
    EXPECT_EQ(tolerance->name, name);
  }
  EXPECT_EQ(Tolerance::named("rounding")->level, 1);
  EXPECT_EQ(Tolerance::named("rounding")->percent, 2);
  EXPECT_EQ(Tolerance::named("round").error().text(),
            "a tolerance is exact, rounding, cpu or loose (round)");
}

TEST(CompareMasked, WhatAMaskHidesIsNotJudged) {
  const Picture golden = greyPicture(40, 30);
  Picture frame = golden;
  pixelAt(frame, 10, 5)[0] = 200;
  PictureMask mask(40, 30);
  mask.hide(MaskRectangle{10, 5, 1, 1}, "label");
  const Comparison found = compare(frame, golden, Tolerance::exactly(), &mask);
  EXPECT_EQ(found.verdict, Verdict::same);
  EXPECT_EQ(found.masked, 1);
  pixelAt(frame, 11, 5)[0] = 200;
  const Comparison beside = compare(frame, golden, Tolerance::exactly(), &mask);
  EXPECT_EQ(beside.verdict, Verdict::different);
  EXPECT_EQ(beside.differing, 1);
  EXPECT_EQ(beside.masked, 1);
}

TEST(CompareMasked, NothingLeftToJudgeIsIncomparable) {
  const Picture golden = greyPicture(40, 30);
  PictureMask mask(40, 30);
  mask.hide(MaskRectangle{0, 0, 40, 30}, "all");
  const Comparison found = compare(golden, golden, Tolerance::loose(), &mask);
  EXPECT_EQ(found.verdict, Verdict::incomparable);
  EXPECT_EQ(found.rule, "the masks hide every pixel, so nothing would be judged");
}

TEST(CompareMasked, AMaskOfAnotherSizeIsIncomparable) {
  const Picture golden = greyPicture(40, 30);
  const PictureMask mask(30, 40);
  EXPECT_EQ(compare(golden, golden, Tolerance::loose(), &mask).verdict, Verdict::incomparable);
}

FinePicture deepPicture(int width, int height, float sample) {
  FinePicture fine;
  fine.picture = greyPicture(width, height);
  fine.encoding = {4, 16, false};
  fine.samples.assign(static_cast<std::size_t>(width * height) * 4, sample);
  return fine;
}

TEST(CompareFine, SixteenBitsThatDifferBelowTheEighthAreNotExactlyTheSame) {
  const FinePicture golden = deepPicture(20, 20, 25'700);
  FinePicture frame = golden;
  frame.samples[4 * 20 + 2] = 25'701;
  const Comparison exact = compareFine(frame, golden, Tolerance::exactly());
  EXPECT_EQ(exact.verdict, Verdict::different);
  EXPECT_EQ(exact.rule, "1 differing sample of 16 bits per component, 0 pixels at 8 bits (exact)");
  EXPECT_EQ(exact.fine_max, 1);
  EXPECT_EQ(compareFine(frame, golden, Tolerance::cpu()).verdict, Verdict::same);
  EXPECT_EQ(compareFine(frame, golden, Tolerance::cpu()).rule, "equal pixels at 8 bits (cpu)");
  EXPECT_EQ(compareFine(frame, golden, Tolerance::rounding()).rule,
            "equal pixels at 8 bits (rounding)");
  PictureMask mask(20, 20);
  mask.hide(MaskRectangle{0, 1, 1, 1}, "corner");
  EXPECT_EQ(compareFine(frame, golden, Tolerance::exactly(), &mask).verdict, Verdict::same);
  EXPECT_EQ(compareFine(golden, golden, Tolerance::exactly()).verdict, Verdict::same);
}

TEST(CompareFine, AnotherDepthIsIncomparableThoughEveryPixelIsEqual) {
  const FinePicture golden = deepPicture(20, 20, 25'700);
  FinePicture eight = golden;
  eight.encoding.bits = 8;
  eight.samples.clear();
  FinePicture half = golden;
  half.encoding.floating = true;
  for (const Tolerance& tolerance : {Tolerance::exactly(), Tolerance::loose()}) {
    const Comparison found = compareFine(eight, golden, tolerance);
    EXPECT_EQ(found.verdict, Verdict::incomparable);
    EXPECT_EQ(found.rule, "the frame has 8 bits per component, the golden 16 bits per component");
    EXPECT_EQ(compareFine(golden, eight, tolerance).verdict, Verdict::incomparable);
    EXPECT_EQ(compareFine(half, golden, tolerance).verdict, Verdict::incomparable);
  }
}

TEST(CompareFine, ANumberThatIsNoneNeverPassesNotEvenAgainstItself) {
  FinePicture golden = deepPicture(20, 20, 1);
  golden.encoding = {4, 32, true};
  FinePicture frame = golden;
  frame.not_finite = 3;
  frame.not_finite_x = 7;
  frame.not_finite_y = 2;
  for (const Tolerance& tolerance : {Tolerance::exactly(), Tolerance::loose()}) {
    const Comparison found = compareFine(frame, golden, tolerance);
    EXPECT_EQ(found.verdict, Verdict::incomparable);
    EXPECT_EQ(found.rule, "3 of the frame's numbers are NaN or infinite, first at (7, 2)");
    EXPECT_EQ(compareFine(golden, frame, tolerance).verdict, Verdict::incomparable);
    EXPECT_EQ(compareFine(frame, frame, tolerance).verdict, Verdict::incomparable);
  }
}

TEST(CompareFine, ShapeComesFirst) {
  FinePicture frame = deepPicture(20, 19, 1);
  frame.not_finite = 1;
  EXPECT_EQ(compareFine(frame, deepPicture(20, 20, 1), {}).rule,
            "the frame is 20x19, the golden 20x20");
}

TEST(DifferenceMap, ShowsWhereByHowMuch) {
  const Picture golden = greyPicture(8, 4);
  Picture frame = golden;
  pixelAt(frame, 0, 0)[0] = 101;
  pixelAt(frame, 3, 0)[0] = 105;
  pixelAt(frame, 5, 3)[0] = 120;
  pixelAt(frame, 7, 3)[0] = 200;
  EXPECT_EQ(differenceMap(frame, golden, 8), (std::vector<std::string>{".  :    ", "     + #"}));
}

TEST(DifferencePicture, LeavesEqualPixelsGreyAndMarksTheOthers) {
  const Picture golden = greyPicture(2, 1);
  Picture frame = golden;
  pixelAt(frame, 1, 0)[0] = 200;
  Picture shown = differencePicture(frame, golden);
  EXPECT_EQ(pixelAt(shown, 0, 0)[0], pixelAt(shown, 0, 0)[1]);
  EXPECT_EQ(pixelAt(shown, 1, 0)[0], 255);
  EXPECT_EQ(pixelAt(shown, 1, 0)[2], 0);
}

TEST(ReducedPicture, AveragesWholeBlocksAndLeavesSmallOnesAlone) {
  Picture picture = greyPicture(640, 4, 0);
  pixelAt(picture, 0, 0)[0] = 200;  // one of the four of the first block
  const Picture reduced = reducedPicture(picture, 320);
  EXPECT_EQ(reduced.width, 320);
  EXPECT_EQ(reduced.height, 2);
  EXPECT_EQ(reduced.rgba[0], 50);
  EXPECT_EQ(reducedPicture(greyPicture(5, 3), 320), greyPicture(5, 3));
  EXPECT_EQ(reducedPicture(greyPicture(700, 1), 320), greyPicture(700, 1));
}

}  // namespace
}  // namespace rocinante
