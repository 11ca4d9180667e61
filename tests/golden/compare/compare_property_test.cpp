// Any two pictures of one shape, judged under any limits: what must hold of every verdict.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>

#include "golden/compare/compare.h"
#include "golden/compare/picture_mask.h"
#include "tests/golden/compare/test_pictures.h"

namespace rocinante {
namespace {

/// A golden, a frame that differs from it in some pixels by little, and a mask.
struct JudgedPair {
  Picture golden, frame;
  PictureMask mask{1, 1};

  const PictureMask* maskOrNone() const { return mask.hiddenPixels() > 0 ? &mask : nullptr; }
};

/// Differences lie around the limits: of one level for the most part, in about 2 % of the pixels.
JudgedPair anyPair() {
  const int width = *rc::gen::inRange(1, 60);
  const int height = *rc::gen::inRange(1, 40);
  JudgedPair made{noisePicture(width, height, *rc::gen::arbitrary<std::uint32_t>()),
                  {},
                  PictureMask(width, height)};
  made.frame = made.golden;
  const int changes = *rc::gen::inRange(0, width * height / 25 + 2);
  const int most = *rc::gen::element(1, 1, 1, 2, 40);
  for (int i = 0; i < changes; ++i) {
    const auto sample = static_cast<std::size_t>(*rc::gen::inRange(0, width * height * 4));
    const int level = made.golden.rgba[sample] + *rc::gen::inRange(-most, most + 1);
    made.frame.rgba[sample] = static_cast<std::uint8_t>(std::clamp(level, 0, 255));
  }
  if (*rc::gen::arbitrary<bool>()) {
    made.mask.hide(MaskRectangle{*rc::gen::inRange(0, width), *rc::gen::inRange(0, height),
                                 *rc::gen::inRange(1, width + 1), *rc::gen::inRange(1, height + 1)},
                   "area");
  }
  RC_PRE(!made.mask.hidesEverything());
  return made;
}

Tolerance anyLimits() {
  return {"any",
          false,
          *rc::gen::inRange(0, 60) / 8.0,
          *rc::gen::inRange(0, 20),
          *rc::gen::element(0, 1, 2, 255),
          *rc::gen::element(0, 1, 2, 3, 100)};
}

bool isSame(const JudgedPair& pair, const Tolerance& tolerance) {
  return compare(pair.frame, pair.golden, tolerance, pair.maskOrNone()).verdict == Verdict::same;
}

RC_GTEST_PROP(CompareProperty, EachTierPassesWhatAStricterOnePasses, ()) {
  const JudgedPair pair = anyPair();
  bool passed = false;
  for (const Tolerance& tolerance :
       {Tolerance::exactly(), Tolerance::rounding(), Tolerance::cpu(), Tolerance::loose()}) {
    const bool passes = isSame(pair, tolerance);
    RC_ASSERT(passes || !passed);
    passed = passes;
  }
}

RC_GTEST_PROP(CompareProperty, WiderLimitsPassWhatNarrowOnesPass, ()) {
  const JudgedPair pair = anyPair();
  const Tolerance narrow = anyLimits();
  Tolerance wide = narrow;
  wide.tile_mean += *rc::gen::inRange(0, 20) / 8.0;
  wide.tile_over += *rc::gen::inRange(0, 10);
  wide.level += *rc::gen::inRange(0, 3);
  wide.percent += *rc::gen::inRange(0, 3);
  RC_ASSERT(isSame(pair, wide) || !isSame(pair, narrow));
}

RC_GTEST_PROP(CompareProperty, FrameAndGoldenMayBeSwapped, ()) {
  const JudgedPair pair = anyPair();
  for (const Tolerance& tolerance : {Tolerance::exactly(), Tolerance::rounding(), anyLimits()}) {
    const Comparison there = compare(pair.frame, pair.golden, tolerance, pair.maskOrNone());
    const Comparison back = compare(pair.golden, pair.frame, tolerance, pair.maskOrNone());
    RC_ASSERT(there.verdict == back.verdict);
    RC_ASSERT(there.rule == back.rule);
    RC_ASSERT(there.differing == back.differing);
    RC_ASSERT(there.max == back.max);
  }
}

/// By the words of docs/golden-suites.md, one pixel after the other.
RC_GTEST_PROP(CompareProperty, RoundingIsOneLevelInTwoPercent, ()) {
  const JudgedPair pair = anyPair();
  std::int64_t judged = 0, differing = 0;
  int largest = 0;
  for (int y = 0; y < pair.golden.height; ++y) {
    for (int x = 0; x < pair.golden.width; ++x) {
      if (pair.mask.hides(x, y)) continue;
      ++judged;
      int most = 0;
      for (int component = 0; component < 4; ++component) {
        const auto at = static_cast<std::size_t>((y * pair.golden.width + x) * 4 + component);
        most = std::max(most, std::abs(int{pair.frame.rgba[at]} - int{pair.golden.rgba[at]}));
      }
      largest = std::max(largest, most);
      differing += most > 0;
    }
  }
  const bool expected = largest <= 1 && differing <= judged / 50;
  RC_CLASSIFY(expected && differing > 0);
  RC_ASSERT(isSame(pair, Tolerance::rounding()) == expected);
}

}  // namespace
}  // namespace rocinante
