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

}  // namespace
}  // namespace rocinante
