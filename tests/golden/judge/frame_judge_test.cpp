#include "golden/judge/frame_judge.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "golden/judge/judged_frame.h"
#include "golden/judge/stability.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

using testing::HasSubstr;

constexpr char kJudgedKey[] = "llvmpipe 32x32 1x";
constexpr char kOtherKey[] = "older 32x32 1x";

Picture evenPicture(std::uint8_t level, int side = 32) {
  Picture picture{side, side, std::vector<std::uint8_t>(static_cast<std::size_t>(side * side) * 4)};
  for (std::size_t i = 0; i < picture.rgba.size(); ++i) {
    picture.rgba[i] = i % 4 == 3 ? 255 : level;
  }
  return picture;
}

void setPixel(Picture& picture, int x, int y, std::uint8_t level) {
  picture.rgba[static_cast<std::size_t>(y * picture.width + x) * 4] = level;
}

class FrameJudgeTest : public testing::Test {
 protected:
  FrameJudgeTest() {
    std::filesystem::create_directories(folder_.goldens());
    case_.name = "pick";
    case_.width = case_.height = 32;
    case_.samples = 1;
    case_.line = 7;
  }

  AcceptedPicture accept(const Picture& picture, const char* key = kJudgedKey,
                         bool beside = false) {
    static int count = 0;
    AcceptedPicture accepted{key,
                             "pick" + std::to_string(++count) + ".png",
                             pictureXxh3(picture),
                             "inputs",
                             "session",
                             "ada",
                             "2026",
                             "why"};
    EXPECT_TRUE(writePng(folder_.goldens() / accepted.picture, picture).ok());
    manifest_.accept("pick", accepted, beside);
    return accepted;
  }

  JudgedFrame judge(const Picture& drawn, const CaseAreas* areas = nullptr) {
    JudgedFrame judged;
    judged.frame = {"pick", &case_, LogTime{}, ""};
    judged.tolerance = case_.tolerance;
    judged.limit_from = case_.limit_from;
    judged.key = kJudgedKey;
    judged.pixels = pictureXxh3(drawn);
    judged.drawn = drawn;
    judged.coverage = covered_;
    judgeDrawn(manifest_, folder_, areas, judged);
    applyExpectation(judged);
    return judged;
  }

  /// As a suite's line says it.
  void tolerate(const Tolerance& tolerance) {
    case_.tolerance = case_.across_keys = tolerance;
    case_.limit_from = "s.toml:9";
  }

  test::TemporaryFolder root_;
  GoldenFolder folder_{root_ / "goldens", {}};
  Manifest manifest_;
  SuiteCase case_;
  std::optional<RunCoverage> covered_;
};

TEST_F(FrameJudgeTest, WithoutAnyGoldenItIsMissing) {
  EXPECT_EQ(judge(evenPicture(10)).verdict, FrameVerdict::missing);
}

TEST_F(FrameJudgeTest, AnEqualHashReadsNoPicture) {
  const AcceptedPicture accepted = accept(evenPicture(10));
  std::filesystem::remove(folder_.goldens() / accepted.picture);
  const JudgedFrame judged = judge(evenPicture(10));
  EXPECT_EQ(judged.verdict, FrameVerdict::same);
  EXPECT_EQ(judged.rule, "equal pixel hash");
}

TEST_F(FrameJudgeTest, OnePixelOfOneStepIsDifferentInTheExactTier) {
  accept(evenPicture(10));
  Picture drawn = evenPicture(10);
  setPixel(drawn, 31, 31, 11);
  const JudgedFrame judged = judge(drawn);
  EXPECT_EQ(judged.verdict, FrameVerdict::different);
  EXPECT_EQ(judged.rule, "1 differing pixel (exact), limit from the default");
}

TEST_F(FrameJudgeTest, TheRuleNamesWhereItsLimitWasSaid) {
  accept(evenPicture(10));
  case_.tolerance = {"arm", false, 1.0, 4};
  case_.limit_from = "[tolerance.arm], s.toml:9";
  EXPECT_EQ(judge(evenPicture(11)).rule,
            "worst tile's mean 1.00 <= 1.00 and 0 <= 4 pixels over 32 (arm), limit from "
            "[tolerance.arm], s.toml:9");
  EXPECT_EQ(judge(evenPicture(12)).rule,
            "worst tile's mean 2.00 > 1.00 (arm), limit from [tolerance.arm], s.toml:9");
}

TEST_F(FrameJudgeTest, AnotherShapeIsIncomparable) {
  accept(evenPicture(10, 16));
  const JudgedFrame judged = judge(evenPicture(10));
  EXPECT_EQ(judged.verdict, FrameVerdict::incomparable);
  EXPECT_THAT(judged.rule, HasSubstr("32x32"));
}

TEST_F(FrameJudgeTest, AnotherRenderersGoldenJudgesOnlyWithATolerance) {
  accept(evenPicture(10), kOtherKey);
  const JudgedFrame exact = judge(evenPicture(12));
  EXPECT_EQ(exact.verdict, FrameVerdict::incomparable);
  EXPECT_EQ(
      exact.rule,
      "no golden of this renderer (llvmpipe 32x32 1x); against older: largest difference 2 > 1 "
      "(rounding), limit from the default; run on that renderer, approve here too (both are "
      "kept), or set a tolerance");
  for (const Tolerance& named : {Tolerance::cpu(), Tolerance::rounding()}) {
    SCOPED_TRACE(named.name);
    tolerate(named);
    Picture near = evenPicture(10);
    setPixel(near, 3, 3, 11);
    EXPECT_EQ(judge(near).verdict, FrameVerdict::same);
    EXPECT_THAT(judge(near).rule, HasSubstr(", golden of older, limit from s.toml:9"));
    EXPECT_EQ(judge(evenPicture(60)).verdict, FrameVerdict::different);
    EXPECT_THAT(judge(evenPicture(60)).rule, HasSubstr(", golden of older, limit from s.toml:9"));
  }
}

TEST_F(FrameJudgeTest, EqualPixelsAreTheSameUnderAnyKey) {
  const AcceptedPicture accepted = accept(evenPicture(10), kOtherKey);
  std::filesystem::remove(folder_.goldens() / accepted.picture);  // nothing is decoded
  tolerate(Tolerance::exactly());
  const JudgedFrame judged = judge(evenPicture(10));
  EXPECT_EQ(judged.verdict, FrameVerdict::same);
  EXPECT_EQ(judged.rule, "equal pixel hash, golden of older");
  EXPECT_EQ(judged.golden, accepted);
  EXPECT_EQ(judged.tolerance.name, "exact");
  // Of its own key too: that one is named.
  accept(evenPicture(10));
  EXPECT_EQ(judge(evenPicture(10)).rule, "equal pixel hash");
}

TEST_F(FrameJudgeTest, EqualPixelsAreTheSameThoughTheOwnKeysGoldenDiffers) {
  accept(evenPicture(90));
  accept(evenPicture(10), kOtherKey);
  EXPECT_EQ(judge(evenPicture(10)).rule, "equal pixel hash, golden of older");
}

TEST_F(FrameJudgeTest, EqualPixelsOfOtherSamplesAreTheSameAndTheWholeKeyIsNamed) {
  accept(evenPicture(10), "llvmpipe 32x32 4x");
  EXPECT_EQ(judge(evenPicture(10)).rule, "equal pixel hash, golden of llvmpipe 32x32 4x");
  // Compared, other samples are another picture.
  Picture near = evenPicture(10);
  setPixel(near, 3, 3, 11);
  EXPECT_EQ(judge(near).verdict, FrameVerdict::incomparable);
  EXPECT_EQ(judge(near).rule,
            "no golden of this size and samples for llvmpipe 32x32 1x (have 32x32 4x); approve "
            "one");
}

TEST_F(FrameJudgeTest, AcrossKeysRoundingIsTheSameAndNothingBeyond) {
  accept(evenPicture(10), kOtherKey);
  Picture drawn = evenPicture(10);
  for (int i = 0; i < 20; ++i) setPixel(drawn, i, i, 11);  // of 1,024: 2 % are 20.48
  const JudgedFrame rounded = judge(drawn);
  EXPECT_EQ(rounded.verdict, FrameVerdict::same);
  EXPECT_EQ(rounded.rule,
            "20 of 1024 pixels differ (<= 2 %), by at most 1 (rounding), golden of older, limit "
            "from the default");
  EXPECT_EQ(rounded.tolerance.name, "rounding");
  setPixel(drawn, 0, 31, 9);
  const JudgedFrame beyond = judge(drawn);
  EXPECT_EQ(beyond.verdict, FrameVerdict::incomparable);
  EXPECT_THAT(beyond.rule, HasSubstr("against older: 21 of 1024 pixels differ (> 2 %), by at "
                                     "most 1 (rounding), limit from the default; run on"));
  // Why is found out with these.
  EXPECT_TRUE(beyond.drawn && beyond.accepted && beyond.golden);
  EXPECT_EQ(beyond.comparison.differing, 21);
}

TEST_F(FrameJudgeTest, WithinAKeyOneLevelIsADifferenceWhateverOtherKeysHold) {
  accept(evenPicture(10));
  Picture drawn = evenPicture(10);
  setPixel(drawn, 3, 3, 11);
  Picture other = drawn;
  setPixel(other, 4, 4, 11);  // one pixel from what is drawn
  accept(other, kOtherKey);
  const JudgedFrame judged = judge(drawn);
  EXPECT_EQ(judged.verdict, FrameVerdict::different);
  EXPECT_EQ(judged.rule, "1 differing pixel (exact), limit from the default");
  EXPECT_EQ(judged.tolerance.name, "exact");
}

TEST_F(FrameJudgeTest, AWrittenExactWantsEqualPixelsAcrossKeys) {
  accept(evenPicture(10), kOtherKey);
  tolerate(Tolerance::exactly());
  EXPECT_EQ(judge(evenPicture(10)).verdict, FrameVerdict::same);
  Picture drawn = evenPicture(10);
  setPixel(drawn, 3, 3, 11);
  const JudgedFrame judged = judge(drawn);
  EXPECT_EQ(judged.verdict, FrameVerdict::incomparable);
  EXPECT_EQ(judged.rule,
            "no golden of this renderer (llvmpipe 32x32 1x); against older: 1 differing pixel "
            "(exact), limit from s.toml:9; run on that renderer, approve here too (both are kept), "
            "or set a tolerance");
}

TEST_F(FrameJudgeTest, OfSeveralKeysTheNearestGoldenIsTold) {
  Picture drawn = evenPicture(10);
  for (int i = 0; i < 9; ++i) setPixel(drawn, i, 0, 11);
  accept(evenPicture(10), "a 32x32 1x");  // nine pixels away
  Picture nearer = drawn;
  setPixel(nearer, 0, 0, 10);
  accept(nearer, "b 32x32 1x");           // one
  accept(evenPicture(60), "c 32x32 1x");  // another picture
  EXPECT_EQ(judge(drawn).verdict, FrameVerdict::same);
  EXPECT_THAT(judge(drawn).rule, HasSubstr("1 of 1024 pixels differ"));
  EXPECT_THAT(judge(drawn).rule, HasSubstr("golden of b,"));
  // One that passes goes before one with fewer pixels that does not.
  Picture spoiled = drawn;
  setPixel(spoiled, 0, 0, 200);
  manifest_.accept("pick", accept(spoiled, "b 32x32 1x"));
  EXPECT_EQ(judge(drawn).verdict, FrameVerdict::same);
  EXPECT_THAT(judge(drawn).rule, HasSubstr("golden of a,"));
  // And of those that do not, the nearest.
  EXPECT_THAT(judge(evenPicture(50)).rule, HasSubstr("; against a: "));
  EXPECT_EQ(judge(evenPicture(50)).verdict, FrameVerdict::incomparable);
}

TEST_F(FrameJudgeTest, AForeignGoldenThatCannotBeReadJudgesNothing) {
  const AcceptedPicture accepted = accept(evenPicture(10), kOtherKey);
  std::filesystem::remove(folder_.goldens() / accepted.picture);
  const JudgedFrame judged = judge(evenPicture(11));
  EXPECT_EQ(judged.verdict, FrameVerdict::incomparable);
  EXPECT_THAT(judged.rule,
              HasSubstr("no golden of this renderer (llvmpipe 32x32 1x); against older: golden "));
  EXPECT_THAT(judged.rule, HasSubstr("is missing"));
  // Another one that can be read judges.
  Picture near = evenPicture(11);
  setPixel(near, 3, 3, 12);
  accept(near, "zeta 32x32 1x");
  EXPECT_EQ(judge(evenPicture(11)).verdict, FrameVerdict::same);
}

TEST_F(FrameJudgeTest, MasksHideAcrossKeysToo) {
  accept(evenPicture(10), kOtherKey);
  case_.mask = {{MaskRectangle{0, 0, 32, 31}, "", 0}};  // a row is left: no pixel of it may differ
  const CaseAreas areas = findAreas(case_, nullptr);
  Picture drawn = evenPicture(10);
  for (int x = 0; x < 32; ++x) setPixel(drawn, x, 5, 99);
  EXPECT_EQ(judge(drawn, &areas).rule, "equal pixels, golden of older");
  setPixel(drawn, 0, 31, 11);
  const JudgedFrame judged = judge(drawn, &areas);
  EXPECT_EQ(judged.verdict, FrameVerdict::incomparable);
  EXPECT_THAT(judged.rule, HasSubstr("1 of 32 pixels differ (> 2 %)"));
}

TEST_F(FrameJudgeTest, ACaseThatExpectsADifferenceIsNotMetByRounding) {
  accept(evenPicture(10), kOtherKey);
  case_.expect_different = true;
  case_.reason = "new gripper";
  Picture drawn = evenPicture(10);
  setPixel(drawn, 3, 3, 11);
  EXPECT_EQ(judge(drawn).verdict, FrameVerdict::unexpected);
  EXPECT_EQ(judge(evenPicture(60)).verdict, FrameVerdict::incomparable);
}

TEST_F(FrameJudgeTest, AGoldenOfAnotherSizeIsNotAnotherRenderers) {
  accept(evenPicture(10, 16), "llvmpipe 16x16 1x");
  EXPECT_EQ(judge(evenPicture(10)).rule,
            "no golden of this size and samples for llvmpipe 32x32 1x (have 16x16 1x); approve "
            "one");
}

TEST_F(FrameJudgeTest, OfSeveralAcceptedPicturesOneIsEnoughAndTheNearestIsTold) {
  accept(evenPicture(10));
  Picture near = evenPicture(50);
  setPixel(near, 3, 4, 90);
  const AcceptedPicture second = accept(near, kJudgedKey, true);
  EXPECT_EQ(judge(evenPicture(10)).verdict, FrameVerdict::same);
  EXPECT_EQ(judge(near).verdict, FrameVerdict::same);
  const JudgedFrame judged = judge(evenPicture(50));
  EXPECT_EQ(judged.verdict, FrameVerdict::different);
  EXPECT_EQ(judged.golden, second);
  EXPECT_EQ(judged.comparison.differing, 1);
}

TEST_F(FrameJudgeTest, APictureThatNobodyAcceptedJudgesNothing) {
  const AcceptedPicture accepted = accept(evenPicture(10));
  ASSERT_TRUE(writePng(folder_.goldens() / accepted.picture, evenPicture(20)).ok());
  case_.tolerance = Tolerance::loose();
  const JudgedFrame judged = judge(evenPicture(20));
  EXPECT_EQ(judged.verdict, FrameVerdict::incomparable);
  EXPECT_THAT(judged.rule, HasSubstr("is not the picture that the manifest lists"));
}

TEST_F(FrameJudgeTest, MasksHideTheirPixelsAndNoOthers) {
  accept(evenPicture(10));
  case_.mask = {{MaskRectangle{0, 0, 8, 8}, "", 0}};
  const CaseAreas areas = findAreas(case_, nullptr);
  Picture drawn = evenPicture(10);
  setPixel(drawn, 7, 7, 99);
  EXPECT_EQ(judge(drawn, &areas).verdict, FrameVerdict::same);
  setPixel(drawn, 8, 7, 99);
  const JudgedFrame judged = judge(drawn, &areas);
  EXPECT_EQ(judged.verdict, FrameVerdict::different);
  EXPECT_EQ(judged.comparison.differing, 1);
  ASSERT_EQ(judged.masks.size(), 1U);
  EXPECT_EQ(judged.masks[0].pixels, 64);
}

TEST_F(FrameJudgeTest, MasksThatHideEverythingJudgeNothing) {
  accept(evenPicture(10));
  case_.mask = {{MaskRectangle{0, 0, 32, 32}, "", 0}};
  const CaseAreas areas = findAreas(case_, nullptr);
  EXPECT_EQ(judge(evenPicture(90), &areas).verdict, FrameVerdict::incomparable);
}

/// The arm fills columns `left` to `left` + 4 of every row.
SceneIdentity armAt(int left) {
  SceneIdentity identity;
  identity.frame = {32, 32, std::vector<std::uint32_t>(32 * 32), {{"arm", "link6"}}};
  identity.layers = {std::vector<std::string>{"robots"}};
  for (int y = 0; y < 32; ++y) {
    for (int x = left; x < left + 4; ++x) {
      identity.frame.ids[static_cast<std::size_t>(y * 32 + x)] = 1;
    }
  }
  return identity;
}

TEST_F(FrameJudgeTest, APartThatMovedIsMaskedWhereItStoodToo) {
  case_.mask = {{{}, "arm/link6", 0}};
  Picture then = evenPicture(10);
  for (int y = 0; y < 32; ++y) setPixel(then, 5, y, 200);
  AcceptedPicture accepted = accept(then);
  const SceneIdentity old_identity = armAt(4);
  const Picture old_areas = areasPicture(case_, findAreas(case_, &old_identity));
  ASSERT_TRUE(writePng(folder_.goldens() / "areas.png", old_areas).ok());
  Picture now = evenPicture(10);
  for (int y = 0; y < 32; ++y) setPixel(now, 21, y, 200);
  const SceneIdentity identity = armAt(20);
  const CaseAreas areas = findAreas(case_, &identity);
  EXPECT_EQ(judge(now, &areas).verdict, FrameVerdict::different);  // an old golden without areas
  accepted.areas = "areas.png";
  accepted.areas_pixels = pictureXxh3(old_areas);
  manifest_.accept("pick", accepted);
  EXPECT_EQ(judge(now, &areas).verdict, FrameVerdict::same);
}

TEST_F(FrameJudgeTest, JudgeOnlyLooksWhereThePartIsAndWhereItWas) {
  case_.judge_only = {{{}, "layer/robots", 0}};
  const SceneIdentity old_identity = armAt(4);
  const Picture old_areas = areasPicture(case_, findAreas(case_, &old_identity));
  ASSERT_TRUE(writePng(folder_.goldens() / "areas.png", old_areas).ok());
  AcceptedPicture accepted = accept(evenPicture(10));
  accepted.areas = "areas.png";
  accepted.areas_pixels = pictureXxh3(old_areas);
  manifest_.accept("pick", accepted);
  const SceneIdentity identity = armAt(20);
  const CaseAreas areas = findAreas(case_, &identity);
  Picture elsewhere = evenPicture(10);
  setPixel(elsewhere, 14, 3, 99);
  EXPECT_EQ(judge(elsewhere, &areas).verdict, FrameVerdict::same);
  Picture now = evenPicture(10);
  setPixel(now, 21, 3, 99);
  EXPECT_EQ(judge(now, &areas).verdict, FrameVerdict::different);
  Picture then = evenPicture(10);
  setPixel(then, 5, 3, 99);
  EXPECT_EQ(judge(then, &areas).verdict, FrameVerdict::different);
}

TEST_F(FrameJudgeTest, FewerDevicesThanAcceptedIsDifferentWhateverThePixelsAre) {
  AcceptedPicture accepted = accept(evenPicture(10));
  accepted.coverage = {"arm", "lamp"};
  manifest_.accept("pick", accepted);
  covered_.emplace().judged = {"arm", "lamp", "more"};
  EXPECT_EQ(judge(evenPicture(10)).verdict, FrameVerdict::same);
  covered_->judged = {"arm"};
  covered_->left_out.leaveOut({.kind = "device", .name = "lamp", .reason = "the cell is dark"});
  const JudgedFrame equal = judge(evenPicture(10));
  EXPECT_EQ(equal.verdict, FrameVerdict::different);
  EXPECT_EQ(equal.rule,
            "lamp: not judged, since the cell is dark, though accepted; equal pixel hash");
  EXPECT_EQ(equal.coverage->lost, std::set<std::string>{"lamp"});
  EXPECT_EQ(equal.accepted, equal.drawn);  // for the report
  tolerate(Tolerance::loose());
  EXPECT_EQ(judge(evenPicture(11)).verdict, FrameVerdict::different);
  EXPECT_THAT(judge(evenPicture(90)).rule, HasSubstr("though accepted; worst tile's mean"));
  // A renderer that draws other pixels excuses nothing.
  accepted.key = kOtherKey;
  manifest_.cases.clear();
  manifest_.accept("pick", accepted);
  tolerate(Tolerance::exactly());
  EXPECT_EQ(judge(evenPicture(12)).verdict, FrameVerdict::different);
  covered_->masked = {"lamp"};
  EXPECT_EQ(judge(evenPicture(12)).verdict, FrameVerdict::incomparable);
  EXPECT_EQ(judge(evenPicture(10)).verdict, FrameVerdict::same);
}

TEST_F(FrameJudgeTest, OfSeveralEqualGoldensOneWithoutTheDeviceIsEnough) {
  AcceptedPicture accepted = accept(evenPicture(10));
  accepted.coverage = {"arm", "lamp"};
  manifest_.accept("pick", accepted);
  accepted.key = kOtherKey;
  accepted.coverage = {"arm"};
  manifest_.accept("pick", accepted);
  covered_.emplace().judged = {"arm"};
  EXPECT_EQ(judge(evenPicture(10)).verdict, FrameVerdict::same);
  tolerate(Tolerance::loose());
  accept(evenPicture(12), kJudgedKey, true);  // without coverage, and further away
  EXPECT_EQ(judge(evenPicture(11)).verdict, FrameVerdict::same);
}

TEST(PathNames, TakesDevicesLinksLayersAndDrawings) {
  const IdentityName link{"arm", "link6"};
  for (const char* path : {"arm", "arm/link6", "arm/*", "a*", "layer/robots", "layer/*"}) {
    EXPECT_TRUE(pathNames(path, link, {"cells", "robots"})) << path;
  }
  for (const char* path : {"ar", "arm/link", "link6", "layer/robot", "drawing/*", "layer/"}) {
    EXPECT_FALSE(pathNames(path, link, {"cells", "robots"})) << path;
  }
  EXPECT_FALSE(pathNames("layer/*", link, {}));  // in no layer
  const IdentityName label{"drawing", "planner/goal"};
  EXPECT_TRUE(pathNames("drawing/planner/*", label, {"labels"}));
  EXPECT_TRUE(pathNames("layer/labels", label, {"labels"}));
  EXPECT_FALSE(pathNames("layer/lines", label, {"labels"}));
}

TEST_F(FrameJudgeTest, AnExpectedDifferenceIsFineAndItsAbsenceIsNot) {
  accept(evenPicture(10));
  case_.expect_different = true;
  case_.reason = "new gripper";
  const JudgedFrame differs = judge(evenPicture(60));
  EXPECT_EQ(differs.verdict, FrameVerdict::expected);
  EXPECT_THAT(differs.rule, HasSubstr("expected: new gripper"));
  EXPECT_TRUE(isFine(differs.verdict));
  const JudgedFrame same = judge(evenPicture(10));
  EXPECT_EQ(same.verdict, FrameVerdict::unexpected);
  EXPECT_FALSE(isFine(same.verdict));
  EXPECT_EQ(same.rule, "equal pixel hash, though line 7 expects a difference: new gripper");
}

TEST(Stability, ThreeEqualDrawingsAreStable) {
  EXPECT_FALSE(findInstability(evenPicture(1), evenPicture(1), evenPicture(1)));
}

TEST(Stability, SaysWhichDrawingDiffersAndWhere) {
  Picture other = evenPicture(1);
  setPixel(other, 3, 5, 9);
  setPixel(other, 4, 6, 9);
  const auto after = findInstability(evenPicture(1), other, evenPicture(1));
  ASSERT_TRUE(after);
  EXPECT_EQ(instabilityRule(*after, nullptr),
            "drawn again, 2 pixels differ at 3,5,2x2; after another frame, not in a fresh context; "
            "likely cause: state left by another frame");
  const auto fresh = findInstability(evenPicture(1), evenPicture(1), other);
  ASSERT_TRUE(fresh);
  EXPECT_THAT(
      instabilityRule(*fresh, nullptr),
      HasSubstr("in a fresh context, not after another frame; likely cause: uninitialised"));
}

TEST(Stability, BlamesSurfacesThatMeetWhereThePixelsLie) {
  SceneIdentity identity = armAt(4);
  identity.frame.names.push_back({"table", "top"});
  for (int y = 0; y < 32; ++y) {
    for (int x = 8; x < 32; ++x) identity.frame.ids[static_cast<std::size_t>(y * 32 + x)] = 2;
  }
  Picture other = evenPicture(1);
  for (int y = 4; y < 20; ++y) setPixel(other, 8, y, 77);
  const auto found = findInstability(evenPicture(1), other, other);
  ASSERT_TRUE(found);
  EXPECT_EQ(instabilityRule(*found, &identity),
            "drawn again, 16 pixels differ at 8,4,1x16, 16 of them at the border of arm/link6 "
            "and table/top; both after another frame and in a fresh context; likely cause: "
            "coplanar surfaces");
}

TEST_F(FrameJudgeTest, PassesBetweenProcessesWhole) {
  AcceptedPicture accepted = accept(evenPicture(10));
  accepted.coverage = {"arm", "lamp"};
  manifest_.accept("pick", accepted);
  covered_.emplace().judged = {"arm"};
  covered_->masked = {"hood"};
  covered_->unstated = {"arm/elbow"};
  covered_->left_out.leaveOut({.kind = "value", .name = "lamp", .reason = "dark", .count = 3});
  Picture drawn = evenPicture(10);
  setPixel(drawn, 3, 3, 99);
  case_.mask = {{MaskRectangle{20, 20, 4, 4}, "", 0}};
  const CaseAreas areas = findAreas(case_, nullptr);
  case_.tolerance = {"arm", false, 0.01, 0, 7, 60};
  const JudgedFrame sent = judge(drawn, &areas);
  const Bytes bytes = wireBytes(sent);
  JudgedFrame received;
  ASSERT_TRUE(readWire(bytes, received).ok());
  EXPECT_EQ(received.verdict, sent.verdict);
  EXPECT_EQ(received.rule, sent.rule);
  EXPECT_EQ(received.tolerance.name, "arm");
  EXPECT_EQ(received.tolerance.level, 7);
  EXPECT_EQ(received.golden, sent.golden);
  EXPECT_EQ(received.coverage->judged, sent.coverage->judged);
  EXPECT_EQ(received.coverage->lost, std::set<std::string>{"lamp"});
  EXPECT_EQ(received.coverage->masked, sent.coverage->masked);
  EXPECT_EQ(received.coverage->unstated, sent.coverage->unstated);
  EXPECT_EQ(received.limit_from, sent.limit_from);
  EXPECT_EQ(received.own_masks, sent.own_masks);
  EXPECT_EQ(accountLines(received.coverage->left_out), accountLines(sent.coverage->left_out));
  EXPECT_EQ(received.drawn, sent.drawn);
  EXPECT_EQ(received.accepted, sent.accepted);
  EXPECT_EQ(received.comparison.worst_frame, sent.comparison.worst_frame);
  EXPECT_EQ(received.comparison.over_32, 1);
  EXPECT_EQ(received.masks.size(), 1U);
  EXPECT_EQ(wireBytes(received), bytes);
  // Cut anywhere, it is refused, never believed.
  for (std::size_t length = 0; length < bytes.size(); length += length < 600 ? 1 : 997) {
    JudgedFrame cut;
    const Bytes piece(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length));
    EXPECT_FALSE(readWire(piece, cut).ok()) << length;
  }
}

}  // namespace
}  // namespace rocinante
