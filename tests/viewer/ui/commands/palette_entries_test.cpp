#include "viewer/ui/commands/palette_entries.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"

namespace rocinante {
namespace {

TEST(FuzzyScore, WantsTheLettersInOrder) {
  EXPECT_TRUE(fuzzyScore("", "anything"));
  EXPECT_TRUE(fuzzyScore("fsl", "fit selection"));
  EXPECT_TRUE(fuzzyScore("FIT", "fit"));
  EXPECT_TRUE(fuzzyScore("f sel", "fit selection"));
  EXPECT_FALSE(fuzzyScore("tif", "fit"));
  EXPECT_FALSE(fuzzyScore("fits", "fit"));
  EXPECT_FALSE(fuzzyScore("a", ""));
}

TEST(FuzzyScore, PrefersRunsAndBeginningsOfWords) {
  EXPECT_GT(*fuzzyScore("fit", "fit"), *fuzzyScore("fit", "faint tint"));
  EXPECT_GT(*fuzzyScore("ov", "camera overview"), *fuzzyScore("ov", "move"));
  EXPECT_GT(*fuzzyScore("fs", "fit selection"), *fuzzyScore("fs", "offset"));
}

ViewModel smallModel(const test::TemporaryFolder& folder, bool with_log) {
  test::writeText(folder / "arm.urdf", test::kArmUrdf);
  std::optional<Timeline> session;
  if (with_log) {
    test::writeSession(folder / "s.mcap", {{0, "event \"begun\"\n"}});
    session = std::move(*Timeline::open(folder / "s.mcap"));
  }
  auto model = ViewModel::make(std::move(*loadCell(folder / "arm.urdf", {})), std::move(session),
                               std::nullopt, {}, {});
  EXPECT_TRUE(model->update(SteadyTime{}).ok());
  return std::move(*model);
}

std::vector<std::string> linesFor(std::string_view typed, ViewModel& model) {
  std::vector<std::string> lines;
  for (const PaletteEntry& entry : matchingEntries(typed, paletteEntries(model), 100)) {
    lines.push_back(entry.line);
  }
  return lines;
}

bool has(const std::vector<std::string>& lines, const std::string& line) {
  return std::ranges::find(lines, line) != lines.end();
}

TEST(PaletteEntries, AreWhatMakesSenseNow) {
  const test::TemporaryFolder folder;
  ViewModel without = smallModel(folder, false);
  ViewModel with = smallModel(folder, true);
  EXPECT_FALSE(has(linesFor("play", without), "play"));
  EXPECT_EQ(linesFor("play", with).front(), "play");
  EXPECT_TRUE(has(linesFor("", with), "select arm"));
  EXPECT_TRUE(has(linesFor("", with), "step -1"));
  EXPECT_FALSE(has(linesFor("frame", with), "frame N")) << "only a script draws frames";
  EXPECT_TRUE(linesFor("zzzz", with).empty());
}

TEST(PaletteEntries, EachRunsOrWantsWords) {
  const test::TemporaryFolder folder;
  ViewModel model = smallModel(folder, true);
  for (const PaletteEntry& entry : paletteEntries(model)) {
    SCOPED_TRACE(entry.line);
    model.selected.device = "arm";
    std::vector<std::string> words = splitWords(entry.line);
    const std::string name = words.front();
    words.erase(words.begin());
    EXPECT_TRUE(checkCommand(name, words.size()).ok());
    if (entry.incomplete) continue;
    ViewerRequests requests;
    const Status done = runCommand(name, words, {model, SteadyTime{}, 480, requests});
    // Without words it enters the mode again, of an endpoint that this window has not had yet.
    if (entry.line == "drive") {
      EXPECT_FALSE(done);
      continue;
    }
    EXPECT_TRUE(done) << done.error().text();
  }
}

TEST(PaletteEntries, AWholeCommandThatIsTypedComesFirst) {
  const test::TemporaryFolder folder;
  ViewModel model = smallModel(folder, true);
  EXPECT_EQ(linesFor("seek  1.5s", model).front(), "seek 1.5s");
  EXPECT_EQ(linesFor("fit selection", model).front(), "fit selection");
  EXPECT_FALSE(has(linesFor("frame 3", model), "frame 3"));
}

TEST(PaletteEntries, ShowTheirKeys) {
  const test::TemporaryFolder folder;
  ViewModel model = smallModel(folder, true);
  const auto entries = paletteEntries(model);
  const auto key = [&](std::string_view line) {
    const auto found = std::ranges::find(entries, line, &PaletteEntry::line);
    return found == entries.end() ? "none" : found->key;
  };
  EXPECT_EQ(key("fit"), "F");
  EXPECT_EQ(key("fit selection"), "Shift+F");
  EXPECT_EQ(key("step 1"), "right");
  EXPECT_EQ(key("camera-number 2"), "none");
}

}  // namespace
}  // namespace rocinante
