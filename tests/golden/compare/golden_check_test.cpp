#include "golden/compare/golden_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>

#include "golden/compare/matches_golden.h"
#include "tests/golden/compare/test_pictures.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class GoldenCheck : public ::testing::Test {
 protected:
  GoldenAnswer check(const Picture& picture, const Tolerance& tolerance = {}) {
    return checkGolden(viewOf(picture), "gauge", tolerance, place_);
  }
  void accept(const Picture& picture) {
    place_.approve = true;
    EXPECT_TRUE(check(picture).passes);
    place_.approve = false;
  }
  static bool exists(const std::filesystem::path& path) { return std::filesystem::exists(path); }

  test::TemporaryFolder folder_;
  GoldenPlace place_{folder_ / "goldens", folder_ / "results", false};
};

TEST_F(GoldenCheck, AMissingGoldenFailsAndLeavesTheFrame) {
  const GoldenAnswer answer = check(noisePicture(30, 20, 1));
  EXPECT_FALSE(answer.passes);
  EXPECT_THAT(answer.text, HasSubstr("no golden was accepted yet: "));
  EXPECT_THAT(answer.text, HasSubstr("ROCINANTE_APPROVE=1"));
  EXPECT_TRUE(exists(folder_ / "results" / "gauge.frame.png"));
  EXPECT_FALSE(exists(folder_ / "goldens"));
}

TEST_F(GoldenCheck, WhatWasAcceptedPassesAndNothingIsWritten) {
  accept(noisePicture(30, 20, 1));
  EXPECT_TRUE(exists(folder_ / "goldens" / "gauge.png"));
  const GoldenAnswer answer = check(noisePicture(30, 20, 1));
  EXPECT_TRUE(answer.passes) << answer.text;
  EXPECT_EQ(answer.text, "equal pixels");
  EXPECT_FALSE(exists(folder_ / "results"));
}

TEST_F(GoldenCheck, ADifferentFrameFailsWithFiguresAMapAndFiles) {
  accept(plainPicture(30, 20, 10, 20, 30));
  Picture frame = plainPicture(30, 20, 10, 20, 30);
  pixelAt(frame, 3, 4)[1] = 120;
  const GoldenAnswer answer = check(frame);
  EXPECT_FALSE(answer.passes);
  EXPECT_THAT(answer.text, HasSubstr("different: 1 differing pixel (exact)\n"));
  EXPECT_THAT(answer.text, HasSubstr("largest difference: 100 at (3, 4)"));
  EXPECT_THAT(answer.text, HasSubstr("|   #"));
  EXPECT_THAT(answer.text, HasSubstr("gauge.frame.png"));
  EXPECT_TRUE(exists(folder_ / "results" / "gauge.frame.png"));
  EXPECT_TRUE(exists(folder_ / "results" / "gauge.difference.png"));
  EXPECT_TRUE(check(frame, Tolerance::cpu()).passes);
}

TEST_F(GoldenCheck, ACroppedFrameNeverPasses) {
  accept(noisePicture(30, 20, 1));
  const GoldenAnswer answer = check(noisePicture(30, 19, 1), Tolerance::loose());
  EXPECT_FALSE(answer.passes);
  EXPECT_THAT(answer.text, HasSubstr("incomparable: the frame is 30x19, the golden 30x20"));
  EXPECT_FALSE(exists(folder_ / "results" / "gauge.difference.png"));
}

TEST_F(GoldenCheck, ADamagedGoldenFails) {
  std::filesystem::create_directories(folder_ / "goldens");
  std::ofstream(folder_ / "goldens" / "gauge.png") << "\x89PNG\r\n\x1A\n and no more";
  const GoldenAnswer answer = check(noisePicture(30, 20, 1), Tolerance::loose());
  EXPECT_FALSE(answer.passes);
  EXPECT_THAT(answer.text, HasSubstr("the golden cannot be read: is not a valid PNG"));
}

TEST_F(GoldenCheck, ApprovingReplacesAndSaysSoOnlyWhenSomethingChanged) {
  accept(noisePicture(30, 20, 1));
  const auto first = std::filesystem::last_write_time(folder_ / "goldens" / "gauge.png");
  accept(noisePicture(30, 20, 1));
  EXPECT_EQ(std::filesystem::last_write_time(folder_ / "goldens" / "gauge.png"), first);
  accept(noisePicture(30, 20, 2));
  EXPECT_TRUE(check(noisePicture(30, 20, 2)).passes);
  EXPECT_FALSE(check(noisePicture(30, 20, 1)).passes);
}

TEST_F(GoldenCheck, ReadsPaddedRowsAndRowsFromBottomToTop) {
  const Picture picture = noisePicture(5, 4, 1);
  accept(picture);
  std::vector<std::uint8_t> padded;
  std::vector<std::uint8_t> upside_down;
  for (int y = 0; y < 4; ++y) {
    const auto row = picture.rgba.begin() + y * 20;
    padded.insert(padded.end(), row, row + 20);
    padded.insert(padded.end(), 12, 77);
    upside_down.insert(upside_down.begin(), row, row + 20);
  }
  EXPECT_TRUE(checkGolden({5, 4, 32, padded.data()}, "gauge", {}, place_).passes);
  EXPECT_TRUE(checkGolden({5, 4, -20, upside_down.data() + 60}, "gauge", {}, place_).passes);
  EXPECT_FALSE(checkGolden({5, 4, 20, upside_down.data()}, "gauge", {}, place_).passes);
}

TEST_F(GoldenCheck, RefusesNamesThatLeadElsewhereAndFramesWithoutPixels) {
  const Picture picture = noisePicture(5, 4, 1);
  for (const char* name : {"", "../gauge", "a/b", ".hidden", "a b", "a\n"}) {
    EXPECT_THAT(checkGolden(viewOf(picture), name, {}, place_).text,
                HasSubstr("not a valid golden name"));
  }
  for (const PictureView& view :
       {PictureView{}, PictureView{0, 4, 20, picture.rgba.data()},
        PictureView{5, -4, 20, picture.rgba.data()}, PictureView{5, 4, 20, nullptr},
        PictureView{5, 4, 16, picture.rgba.data()}}) {
    EXPECT_EQ(checkGolden(view, "gauge", {}, place_).text, "the frame has no pixels");
  }
}

/// Sets environment variables, and puts back what was.
class Environment {
 public:
  ~Environment() {
    for (const auto& [name, value] : before_) {
      value ? ::setenv(name.c_str(), value->c_str(), 1) : ::unsetenv(name.c_str());
    }
  }
  void set(const std::string& name, const char* value) {
    const char* now = std::getenv(name.c_str());
    before_.emplace(name, now != nullptr ? std::optional<std::string>(now) : std::nullopt);
    value != nullptr ? ::setenv(name.c_str(), value, 1) : ::unsetenv(name.c_str());
  }

 private:
  std::map<std::string, std::optional<std::string>> before_;
};

TEST(GoldenPlace, ComesFromTheEnvironmentFirst) {
  Environment environment;
  environment.set("CI", nullptr);
  environment.set("ROCINANTE_APPROVE", nullptr);
  environment.set("ROCINANTE_GOLDEN_DIR", nullptr);
  environment.set("ROCINANTE_GOLDEN_RESULTS", nullptr);
  EXPECT_FALSE(GoldenPlace::fromEnvironment(nullptr).ok());
  auto place = GoldenPlace::fromEnvironment("compiled");
  ASSERT_TRUE(place.ok());
  EXPECT_EQ(place->goldens, "compiled");
  EXPECT_EQ(place->results, "golden-results");
  EXPECT_FALSE(place->approve);
  environment.set("ROCINANTE_GOLDEN_DIR", "named");
  environment.set("ROCINANTE_GOLDEN_RESULTS", "out");
  environment.set("ROCINANTE_APPROVE", "1");
  place = GoldenPlace::fromEnvironment("compiled");
  ASSERT_TRUE(place.ok());
  EXPECT_EQ(place->goldens, "named");
  EXPECT_EQ(place->results, "out");
  EXPECT_TRUE(place->approve);
}

TEST(GoldenPlace, NothingIsApprovedWhereCiIsSet) {
  Environment environment;
  environment.set("CI", "true");
  environment.set("ROCINANTE_APPROVE", "1");
  const auto place = GoldenPlace::fromEnvironment("compiled");
  ASSERT_FALSE(place.ok());
  EXPECT_THAT(place.error().what, HasSubstr("refused where CI is set"));
  environment.set("ROCINANTE_APPROVE", "0");
  EXPECT_TRUE(GoldenPlace::fromEnvironment("compiled").ok());
  environment.set("CI", "false");
  environment.set("ROCINANTE_APPROVE", "1");
  EXPECT_TRUE(GoldenPlace::fromEnvironment("compiled").ok());
}

TEST_F(GoldenCheck, TheMatcherJudgesPicturesAndViews) {
  Environment environment;
  environment.set("ROCINANTE_APPROVE", nullptr);
  environment.set("ROCINANTE_GOLDEN_DIR", place_.goldens.c_str());
  environment.set("ROCINANTE_GOLDEN_RESULTS", place_.results.c_str());
  const Picture picture = noisePicture(30, 20, 1);
  accept(picture);
  EXPECT_THAT(picture, MatchesGolden("gauge"));
  EXPECT_THAT(viewOf(picture), MatchesGolden("gauge", Tolerance::cpu()));
  Picture other = picture;
  pixelAt(other, 0, 0)[0] ^= 1U;
  EXPECT_THAT(other, Not(MatchesGolden("gauge")));
  EXPECT_THAT(other, MatchesGolden("gauge", Tolerance::cpu()));
  EXPECT_EQ(::testing::PrintToString(viewOf(picture)), "a picture of 30x20 pixels");
  ::testing::StringMatchResultListener listener;
  EXPECT_FALSE(::testing::ExplainMatchResult(MatchesGolden("gauge"), viewOf(other), &listener));
  EXPECT_THAT(listener.str(), HasSubstr("different: 1 differing pixel (exact)"));
}

}  // namespace
}  // namespace rocinante
