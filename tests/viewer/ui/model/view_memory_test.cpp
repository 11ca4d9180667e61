#include "viewer/ui/model/view_memory.h"

#include <gtest/gtest.h>

#include "tests/support/environment.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

ViewMemory fullMemory() {
  ViewMemory memory;
  memory.theme = Theme::light;
  memory.wall_clock = true;
  memory.width = 1600;
  memory.height = 900;
  memory.shown({"/cells/a \"b\"\n.cell.toml", {}});
  memory.shown({"/cells/demo.cell.toml", "/logs/s.mcap"});
  PanelPlace right;
  right.moved = right.from_right = true;
  right.across = 10;
  right.down = 20.5F;
  PanelPlace shut;
  shut.collapsed = true;
  shut.width = 320;
  memory.keepPanels("/cells/demo.cell.toml", {{"Scene", shut}, {"figures", right}});
  return memory;
}

constexpr char kFullText[] = R"(# What rocinante view remembers; --fresh ignores it.
format = 1
theme = "light"
clock = "day"
size = [1600, 900]

[[recent]]
cell = "/cells/demo.cell.toml"
log = "/logs/s.mcap"

[[recent]]
cell = "/cells/a \"b\"\u000A.cell.toml"

[[cell]]
file = "/cells/demo.cell.toml"
[[cell.panel]]
name = "Scene"
width = 320.0
collapsed = true
[[cell.panel]]
name = "figures"
right = 10.0
top = 20.5
)";

TEST(ViewMemory, IsWrittenAndReadAgain) {
  EXPECT_EQ(fullMemory().text(), kFullText);
  const auto read = ViewMemory::parse(kFullText, "view.toml");
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_EQ(read->text(), kFullText);
  ASSERT_NE(read->panelsOf("/cells/demo.cell.toml"), nullptr);
  EXPECT_EQ(*read->panelsOf("/cells/demo.cell.toml"),
            *fullMemory().panelsOf("/cells/demo.cell.toml"));
  EXPECT_EQ(read->panelsOf("/cells/other.cell.toml"), nullptr);
}

TEST(ViewMemory, ALogWithoutACellIsRemembered) {
  ViewMemory memory;
  memory.shown({{}, "/logs/bag"});
  memory.keepPanels({}, {{"Scene", {}}});
  const auto read = ViewMemory::parse(memory.text(), "view.toml");
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_EQ(read->recent, memory.recent);
  EXPECT_TRUE(read->cells.empty());
  // As it was once written.
  const auto old = ViewMemory::parse(
      "format = 1\n[[recent]]\ncell = \"\"\nlog = \"/logs/bag\"\n[[recent]]\ncell = \"\"\n"
      "[[cell]]\nfile = \"\"\n",
      "view.toml");
  ASSERT_TRUE(old.ok()) << old.error().text();
  EXPECT_EQ(old->recent, memory.recent);
  EXPECT_TRUE(old->cells.empty());
}

TEST(ViewMemory, CutAnywhereIsReadOrRefused) {
  const std::string whole = kFullText;
  for (std::size_t length = 0; length <= whole.size(); ++length) {
    const std::string cut(whole.data(), length);
    const auto read = ViewMemory::parse(cut, "view.toml");
    EXPECT_TRUE(read.ok() || !read.error().where.empty()) << length;
  }
}

TEST(ViewMemory, RefusesWhatItDoesNotKnow) {
  const auto fault = [](std::string_view text) {
    const auto read = ViewMemory::parse(text, "view.toml");
    return read.ok() ? std::string("read") : read.error().text();
  };
  EXPECT_EQ(fault("format = 2\n"), "the format is not 1 (view.toml:1:10)");
  EXPECT_EQ(fault("format = 1\ntheme = \"pink\"\n"),
            "the theme is neither dark nor light (view.toml:2:9)");
  EXPECT_NE(fault("format = 1\ntheme = 3\n"), "read");
  EXPECT_EQ(fault("format = 1\nclock = \"night\"\n"),
            "the clock is neither session nor day (view.toml:2:9)");
  EXPECT_NE(fault("format = 1\n[[recent]]\ncell = 3\n"), "read");
  EXPECT_NE(fault("format = 1\ncolour = 1\n"), "read");
  EXPECT_NE(fault("nonsense"), "read");
  EXPECT_EQ(fault("format = 1\nsize = [1e300, -5]\n"), "read");
}

TEST(ViewMemory, KeepsTheNewestOnly) {
  ViewMemory memory;
  for (int i = 0; i < 40; ++i) memory.shown({"/" + std::to_string(i), {}});
  memory.shown({"/35", {}});
  ASSERT_EQ(memory.recent.size(), ViewMemory::kMaxRecent);
  EXPECT_EQ(memory.recent[0].cell, "/35");
  EXPECT_EQ(memory.recent[1].cell, "/39");
  for (int i = 0; i < 90; ++i) memory.keepPanels("/" + std::to_string(i), {{"Scene", {}}});
  EXPECT_EQ(memory.cells.size(), ViewMemory::kMaxCells);
  memory.keepPanels("/89", {});
  EXPECT_EQ(memory.panelsOf("/89"), nullptr);
}

TEST(ViewMemory, LiesInTheFolderOfTheUser) {
  {
    const test::Environment set({{"XDG_CONFIG_HOME", "/somewhere"}, {"HOME", "/home/dora"}});
    EXPECT_EQ(ViewMemory::fileOfUser(), "/somewhere/rocinante/view.toml");
  }
  {
    // A relative one is to be ignored, says the specification.
    const test::Environment set({{"XDG_CONFIG_HOME", "here"}, {"HOME", "/home/dora"}});
    EXPECT_EQ(ViewMemory::fileOfUser(), "/home/dora/.config/rocinante/view.toml");
  }
  const test::Environment set({{"XDG_CONFIG_HOME", ""}, {"HOME", ""}});
  EXPECT_TRUE(ViewMemory::fileOfUser().empty());
}

TEST(ViewMemory, IsSavedInAFolderThatItMakes) {
  const test::TemporaryFolder folder;
  const auto file = folder / "config/rocinante/view.toml";
  EXPECT_EQ(ViewMemory::load(file)->text(), ViewMemory().text());
  ASSERT_TRUE(fullMemory().save(file));
  EXPECT_EQ(ViewMemory::load(file)->text(), kFullText);
  // Where a file stands in the way of the folder there is a sentence.
  const Status refused = fullMemory().save(file / "below/view.toml");
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().what.find("cannot make the folder"), std::string::npos);
}

}  // namespace
}  // namespace rocinante
