#include "golden/judge/manifest_diff.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rocinante {
namespace {

using testing::ElementsAre;

Picture greyPicture(std::uint8_t level) {
  return {4, 4, std::vector<std::uint8_t>(4 * 4 * 4, level)};
}

AcceptedPicture acceptedAs(const std::string& file, const Picture& picture) {
  return {"k 4x4 1x", file, pictureXxh3(picture), "inputs", "session", "ada", "today", "why"};
}

TEST(ManifestChanges, TellsReplacedNewAndRemoved) {
  Manifest then;
  Manifest now;
  then.accept("kept", acceptedAs("kept.png", greyPicture(1)));
  now.accept("kept", acceptedAs("kept.png", greyPicture(1)));
  then.accept("replaced", acceptedAs("replaced.png", greyPicture(2)));
  now.accept("replaced", acceptedAs("replaced.png", greyPicture(3)));
  then.accept("removed", acceptedAs("removed.png", greyPicture(4)));
  now.accept("new", acceptedAs("new.png", greyPicture(5)));
  now.accept("../up", acceptedAs("up.png", greyPicture(6)));
  const auto read = [](const AcceptedPicture& accepted) -> Result<Picture> {
    for (std::uint8_t level = 1; level < 6; ++level) {
      if (accepted.pixels == pictureXxh3(greyPicture(level))) return greyPicture(level);
    }
    return Error{ErrorKind::not_found, "there is none", accepted.picture};
  };
  std::vector<std::string> lines;
  for (const JudgedFrame& judged : manifestChanges(then, read, now, read, "v1")) {
    lines.push_back(std::string(nameOf(judged.verdict)) + " " + judged.frame.name + ": " +
                    judged.rule);
  }
  EXPECT_THAT(lines, ElementsAre("incomparable _.._up: there is none (up.png)",
                                 "same kept: equal pixel hash",
                                 "missing new: new since v1, accepted by ada on today: why",
                                 "missing removed: removed since v1",
                                 "different replaced: 16 differing pixels (exact) since v1, "
                                 "accepted by ada on today: why"));
}

TEST(ManifestChanges, APictureThatJudgesFewerDevicesIsDifferent) {
  Manifest then, now;
  AcceptedPicture accepted = acceptedAs("kept.png", greyPicture(1));
  accepted.coverage = {"arm"};
  now.accept("more", acceptedAs("more.png", greyPicture(2)));
  then.accept("more", acceptedAs("more.png", greyPicture(2)));
  now.cases["more"].front().coverage = {"arm"};
  then.accept("kept", accepted);
  accepted.coverage.reset();
  now.accept("kept", accepted);
  const auto read = [](const AcceptedPicture&) -> Result<Picture> { return greyPicture(1); };
  const auto changes = manifestChanges(then, read, now, read, "v1");
  ASSERT_EQ(changes.size(), 2U);
  EXPECT_EQ(changes.front().verdict, FrameVerdict::different);
  EXPECT_EQ(changes.front().rule,
            "arm is no longer judged; equal pixel hash since v1, accepted by ada on today: why");
  EXPECT_EQ(changes.back().verdict, FrameVerdict::same);
}

TEST(ManifestChanges, APictureThatJudgesFewerJointsIsDifferent) {
  const auto read = [](const AcceptedPicture&) -> Result<Picture> { return greyPicture(1); };
  const auto ruleOf = [&](std::vector<std::string> before, std::vector<std::string> after) {
    Manifest then, now;
    AcceptedPicture accepted = acceptedAs("kept.png", greyPicture(1));
    accepted.coverage = std::move(before);
    then.accept("kept", accepted);
    accepted.coverage = std::move(after);
    now.accept("kept", accepted);
    const auto changes = manifestChanges(then, read, now, read, "v1");
    const std::string& rule = changes.front().rule;
    return rule.substr(0, rule.find("; "));
  };
  EXPECT_EQ(ruleOf({"arm", "arm/a", "arm/b"}, {"arm", "arm/b"}), "arm/a is no longer judged");
  EXPECT_EQ(ruleOf({"arm", "arm/*"}, {"arm", "arm/b"}), "arm (its joints) is no longer judged");
  EXPECT_EQ(ruleOf({"arm", "arm/b"}, {"arm", "arm/*"}), "equal pixel hash");
  EXPECT_EQ(ruleOf({"arm"}, {"arm", "arm/*"}), "equal pixel hash");
}

}  // namespace
}  // namespace rocinante
