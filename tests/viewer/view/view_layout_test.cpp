#include "viewer/view/view_layout.h"

#include <gtest/gtest.h>

#include <span>

#include "core/base/atomic_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/layout_text.h"

namespace rocinante {
namespace {

TEST(ViewLayouts, AreWrittenAndReadAgain) {
  const auto read = ViewLayout::parse(test::kLayoutText, "l.layout.toml");
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_EQ(read->text(), test::kLayoutText);
}

TEST(ViewLayouts, AreRefusedWithTheirPlace) {
  const auto fault = [](const char* text) {
    const auto read = ViewLayout::parse(text, "l.layout.toml");
    return read.ok() ? "" : read.error().text();
  };
  EXPECT_EQ(fault(""), "the format is not 1 (l.layout.toml:1:1)");
  EXPECT_EQ(fault("format = 1\ntheme = \"blue\"\n"),
            "the theme is neither dark nor light (l.layout.toml:2:9)");
  std::string many = "format = 1\nplots = [";
  for (int i = 0; i < 65; ++i) many += "\"a.b\", ";
  EXPECT_EQ(fault((many + "]\n").c_str()), "there are more than 64 plots (l.layout.toml:2:9)");
  EXPECT_NE(fault("format = 1\nplot = []\n").find("plot"), std::string::npos);
}

TEST(ViewLayouts, ReplaceLayoutsAlone) {
  const test::TemporaryFolder folder;
  const std::string_view cell = "format = 1\n[[device]]\n";
  ASSERT_TRUE(writeFileWhole(folder / "cell.toml", std::as_bytes(std::span(cell)), false));
  ViewLayout layout;
  layout.plots = ViewLayout::Plots{{"arm.turn"}};
  ASSERT_TRUE(layout.save(folder / "a.layout.toml"));
  ASSERT_TRUE(layout.save(folder / "a.layout.toml"));
  const auto read = ViewLayout::load(folder / "a.layout.toml");
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_EQ(read->text(), layout.text());
  const Status refused = layout.save(folder / "cell.toml");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::refused);
  EXPECT_NE(readFile(folder / "cell.toml", 4096)->find("[[device]]"), std::string::npos);
}

}  // namespace
}  // namespace rocinante
