#include "viewer/page/page_layout.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/recording/session_writer.h"
#include "tests/support/temporary_folder.h"

namespace rocinante::test {
namespace {

constexpr const char* kPagedLift = R"(<robot name="lift"><link name="base"/><link name="tool"/>
  <joint name="j" type="continuous"><parent link="base"/><child link="tool"/></joint></robot>)";
constexpr const char* kPagedLiftCell =
    "format = 1\n[[device]]\nname = \"lift\"\nmodel = \"lift.urdf\"\n"
    "[[camera]]\nname = \"over\"\neye = [4, -4, 3]\ntarget = [0, 0, 0]\n";

class PageLayoutTest : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(folder_ / "lift.urdf") << kPagedLift;
    std::ofstream(folder_ / "lift.cell.toml") << kPagedLiftCell;
    auto log = LogWriter::create(folder_ / "s.mcap", {}, "session-1");
    ASSERT_TRUE(log.ok());
    SessionWriter session(std::move(*log), {});
    const auto channel = session.addChannel("/udp/1/a", "rk1", {});
    for (std::uint32_t i = 0; i < 20; ++i) {
      const std::string number = std::to_string(i);
      const std::string text = "RK1 a " + number + " -\njoint lift j=0." + number +
                               "\nsignal lift load " + number + " kg\nsignal - mode \"auto\"\n";
      ASSERT_TRUE(session.write(*channel, i, at(i + 1), 0, bytesOf(text)).ok());
    }
    ASSERT_TRUE(session.log().close("done").ok());
  }

  static LogTime at(std::uint32_t seconds) { return LogTime(std::chrono::seconds(seconds)); }

  PageLayout made(const std::string& text) const {
    const auto layout = ViewLayout::parse("format = 1\n" + text, "l.layout.toml");
    auto cell = loadCell(folder_ / "lift.cell.toml", {});
    auto log = LogReader::open(folder_ / "s.mcap");
    if (!layout.ok() || !cell.ok() || !log.ok()) return {"not read", {}};
    auto page = pageLayout(*layout, *cell, std::move(*log));
    return page.ok() ? *std::move(page) : PageLayout{page.error().text(), {}};
  }

  TemporaryFolder folder_;
};

TEST_F(PageLayoutTest, APageBeginsWithWhatItHas) {
  const PageLayout page = made(
      "theme = \"dark\"\ncamera = \"over\"\nplots = [\"lift.j\", \"signal lift load\", "
      "\"lift/tool:qz\", \"d/dt lift.j\"]\nplots_height = 240.0\nplots_hidden = true\n"
      "insets = [\"map:top-left\", \"over\"]\n");
  EXPECT_EQ(page.json,
            "{\"camera\":\"over\",\"insets\":[\"map:top-left\",\"over\"],"
            "\"plots\":[\"lift.j\",\"signal lift load\",\"lift/tool:qz\",\"d/dt lift.j\"],"
            "\"plots_height\":240.0,\"plots_hidden\":true}");
  EXPECT_EQ(accountSentence(page.left_out), "");
}

TEST_F(PageLayoutTest, APageFitsCamerasToDevices) {
  const PageLayout page =
      made("camera = \"fit:lift\"\ninsets = [\"fit:lift:top-left\", \"fit:leg\"]\n");
  EXPECT_EQ(page.json, "{\"camera\":\"fit:lift\",\"insets\":[\"fit:lift:top-left\"]}");
  EXPECT_EQ(accountSentence(page.left_out),
            "left out: 1 inset `fit:leg` (the cell has no such device)");
  EXPECT_EQ(accountSentence(made("camera = \"fit:leg\"\n").left_out),
            "left out: 1 camera `fit:leg` (the cell has no such device)");
}

TEST_F(PageLayoutTest, WhatAPageHasNotIsNamed) {
  const PageLayout page = made(
      "camera = \"none\"\nplots = [\"lift.j over lift/tool:x\", \"rate\", \"?\", \"lift.k\", "
      "\"leg.j\", \"signal - mode\"]\ninsets = [\"none:top-left\", \"\"]\n"
      "[[panel]]\nname = \"left\"\ncollapsed = true\n");
  EXPECT_EQ(page.json,
            "{\"insets\":[],\"plots\":[],\"plots_height\":200.0,\"plots_hidden\":false}");
  std::string said;
  for (const LeftOut& one : page.left_out.leftOut()) said += one.text() + "\n";
  EXPECT_EQ(said,
            "1 camera `none` (the cell has no such camera)\n"
            "1 inset `none:top-left` (the cell has no such camera)\n"
            "1 inset (it is no inset)\n"
            "1 plot `lift.j over lift/tool:x` (a page draws no value over another)\n"
            "1 plot `rate` (a page draws no counts of packets)\n"
            "1 plot `?` (no value is named so)\n"
            "1 plot `lift.k` (no packet of the log states it)\n"
            "1 plot `leg.j` (no packet of the log states it)\n"
            "1 plot `signal - mode` (it is a text, of which a page draws no curve)\n"
            "1 panel `left` (a page has places of its own)\n");
}

TEST_F(PageLayoutTest, WhatALayoutDoesNotSayIsNotInThePage) {
  EXPECT_EQ(made("theme = \"light\"\n").json, "{}");
}

}  // namespace
}  // namespace rocinante::test
