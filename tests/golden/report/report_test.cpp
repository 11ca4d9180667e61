#include "golden/report/report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "golden/report/cause_groups.h"
#include "golden/report/report_formats.h"
#include "golden/report/report_pictures.h"
#include "golden/report/report_reader.h"
#include "golden/why/frame_why.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

using testing::HasSubstr;
using testing::Not;

Picture plain(std::uint8_t level) {
  return {16, 16, std::vector<std::uint8_t>(16 * 16 * 4, level)};
}

class ReportTest : public testing::Test {
 protected:
  ReportTest() {
    suite_case_.name = "pick";
    report_.suite = "s.toml";
    report_.cell = "a<b&c.toml";
    report_.renderer = "llvmpipe";
  }

  void add(FrameVerdict verdict) {
    JudgedFrame judged;
    judged.frame = {"pick", &suite_case_, LogTime(Nanoseconds(5)), ""};
    judged.verdict = verdict;
    judged.rule = "a rule with <angle> & \"quotes\"";
    if (verdict == FrameVerdict::different) {
      judged.drawn = plain(10);
      judged.accepted = plain(90);
      judged.comparison = compare(*judged.drawn, *judged.accepted, Tolerance::exactly());
    }
    report_.frames.push_back(std::move(judged));
  }

  SuiteCase suite_case_;
  SuiteReport report_;
};

TEST_F(ReportTest, OneDifferentFrameMakesTheAnswerNo) {
  EXPECT_EQ(report_.verdict(), Verdict::incomparable);  // nothing judged is never yes
  add(FrameVerdict::same);
  EXPECT_EQ(report_.verdict(), Verdict::same);
  add(FrameVerdict::incomparable);
  EXPECT_EQ(report_.verdict(), Verdict::incomparable);
  add(FrameVerdict::missing);
  EXPECT_EQ(report_.verdict(), Verdict::different);
}

TEST_F(ReportTest, OnePictureHoldsAllDifferences) {
  EXPECT_FALSE(differenceSheet(report_)) << "nothing differs";
  add(FrameVerdict::same);
  EXPECT_FALSE(differenceSheet(report_));
  add(FrameVerdict::different);
  add(FrameVerdict::missing);  // not drawn
  report_.frames.back().frame.name = "gone";
  add(FrameVerdict::missing);
  report_.frames.back().frame.name = "new";
  report_.frames.back().drawn =
      Picture{480, 960, std::vector<std::uint8_t>(std::size_t{480} * 960 * 4, 77)};
  const auto sheet = differenceSheet(report_);
  ASSERT_TRUE(sheet);
  EXPECT_THAT(sheet->rows, testing::ElementsAre(&report_.frames[1], &report_.frames[3]));
  const Picture picture = sheetPicture(*sheet);
  // Gaps of 8, tiles 240 wide; 16x16 pixels stay as they are, 480x960 become 240x480.
  EXPECT_EQ(picture.width, 752);
  EXPECT_EQ(picture.height, 8 + 16 + 8 + 480 + 8);
  const auto at = [&](int x, int y) {
    return int{picture.rgba[static_cast<std::size_t>(y * 752 + x) * 4]};
  };
  EXPECT_EQ(at(128, 16), 10) << "the frame, in the middle of its tile";
  EXPECT_EQ(at(128 + 248, 16), 90) << "its golden";
  EXPECT_EQ(at(100, 200), 77);
  EXPECT_EQ(at(100 + 248, 200), 0xD8) << "no golden";
  const std::string text = reportMarkdown(report_, "out put/index.html");
  EXPECT_THAT(text, HasSubstr("[differences.png](out%20put/differences.png); rows from the top: "
                              "pick, new."));
  EXPECT_THAT(reportMarkdown(report_, ""), Not(HasSubstr("differences.png")));
}

TEST_F(ReportTest, TheSheetOfDifferencesIsBoundedAndGoesWithThem) {
  for (int i = 0; i < 50; ++i) {
    add(FrameVerdict::different);
    report_.frames.back().frame.name = "tour-" + std::to_string(i);
  }
  const auto sheet = differenceSheet(report_);
  ASSERT_TRUE(sheet);
  EXPECT_EQ(sheet->rows.size(), 40U);
  EXPECT_EQ(sheet->left_out, 10U);
  EXPECT_THAT(reportMarkdown(report_, "r/index.html"), HasSubstr("; 10 more are left out"));
  const test::TemporaryFolder folder;
  ASSERT_TRUE(writeReport(report_, folder.path()).ok());
  EXPECT_EQ(readPng(folder / "differences.png").value(), sheetPicture(*sheet));
  report_.frames.clear();
  add(FrameVerdict::same);
  ASSERT_TRUE(writeReport(report_, folder.path()).ok());
  EXPECT_FALSE(std::filesystem::exists(folder / "differences.png"));
}

TEST_F(ReportTest, JsonHoldsTheFigures) {
  add(FrameVerdict::different);
  const auto root = nlohmann::json::parse(reportJson(report_));
  EXPECT_EQ(root["format"], 1);
  EXPECT_EQ(root["verdict"], "different");
  EXPECT_EQ(root["counts"]["different"], 1);
  EXPECT_EQ(root["frames"][0]["max"], 80);
  EXPECT_EQ(root["frames"][0]["pixels_over"]["32"], 256);
  EXPECT_EQ(root["frames"][0]["log_time_ns"], 5);
}

TEST_F(ReportTest, PageTellsHowManyOfEach) {
  add(FrameVerdict::same);
  add(FrameVerdict::different);
  JudgedRun run;
  run.name = "swing";
  run.verdict = FrameVerdict::same;
  report_.runs.push_back(run);
  const std::string page = reportHtml(report_);
  EXPECT_THAT(page,
              HasSubstr("<p>different: 1 of 2 frames as accepted, 1 of 1 run as accepted.</p>"));
  EXPECT_THAT(page, HasSubstr(R"("run_counts":{"different":0,)"));
}

TEST_F(ReportTest, JunitTellsFailuresFromErrors) {
  add(FrameVerdict::same);
  add(FrameVerdict::unstable);
  add(FrameVerdict::incomparable);
  const std::string xml = reportJunit(report_);
  EXPECT_THAT(xml, HasSubstr("tests=\"3\" failures=\"1\" errors=\"1\""));
  EXPECT_THAT(xml, HasSubstr("<failure message=\"unstable: a rule with &lt;angle&gt; &amp;"));
  EXPECT_THAT(xml, HasSubstr("<error message=\"incomparable:"));
}

TEST_F(ReportTest, MarkdownTellsWhatIsNotFineAndEscapesIt) {
  add(FrameVerdict::same);
  add(FrameVerdict::different);
  report_.frames.back().rule = "a | b <img src=x> `c` [d](e)";
  FrameWhy why;
  why.files = {"arm.urdf: *changed*"};
  report_.frames.back().why = std::make_shared<const FrameWhy>(why);
  report_.run_command = "rocinante golden run 's`s.toml'";
  const std::string text = reportMarkdown(report_, "out/index.html");
  EXPECT_THAT(text, HasSubstr("1 of 2 frames as accepted\n"));
  EXPECT_THAT(text, HasSubstr("| different | a \\| b &lt;img src=x> \\`c\\` \\[d\\]\\(e\\) |\n"));
  EXPECT_THAT(text, HasSubstr("- arm.urdf: \\*changed\\*\n"));
  EXPECT_THAT(text, HasSubstr("Repeat: `` rocinante golden run 's`s.toml' ``\n"));
  EXPECT_THAT(text, HasSubstr("; pictures in `out/index.html`.\n"));
  EXPECT_THAT(reportMarkdown(SuiteReport{}, ""), HasSubstr("0 of 0 frames as accepted"));
}

TEST_F(ReportTest, EveryFormatSaysWhichKeyAndTierJudged) {
  for (const FrameVerdict verdict : {FrameVerdict::same, FrameVerdict::incomparable}) {
    add(verdict);
    JudgedFrame& judged = report_.frames.back();
    judged.key = "newer 8x8 1x";
    judged.golden.emplace().key = "older <8x8> 1x";
    judged.tolerance = Tolerance::rounding();
  }
  EXPECT_THAT(reportJunit(report_),
              HasSubstr("    <properties>\n"
                        "      <property name=\"key\" value=\"newer 8x8 1x\"/>\n"
                        "      <property name=\"golden key\" value=\"older &lt;8x8&gt; 1x\"/>\n"
                        "      <property name=\"tier\" value=\"rounding\"/>\n"
                        "    </properties>\n"
                        "  </testcase>\n"));
  const auto root = nlohmann::json::parse(reportJson(report_));
  EXPECT_EQ(root["frames"][0]["golden"]["key"], "older <8x8> 1x");
  EXPECT_EQ(root["frames"][0]["tolerance"], "rounding");
  EXPECT_EQ(root["frames"][0]["limits"], (nlohmann::json{{"level", 1}, {"percent", 2}}));
  const auto sarif = nlohmann::json::parse(reportSarif(report_));
  EXPECT_EQ(sarif["runs"][0]["results"][0]["properties"],
            (nlohmann::json{
                {"key", "newer 8x8 1x"}, {"golden_key", "older <8x8> 1x"}, {"tier", "rounding"}}));
  const std::string page = reportHtml(report_);
  EXPECT_THAT(page, HasSubstr(R"(["golden of","older \u003c8x8> 1x"])"));
  EXPECT_THAT(page, HasSubstr("rounding: 1 of 255 in 2 % of the pixels"));
  // What is merged later says the same.
  const auto read = parseReport(reportJson(report_), "report.json");
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_EQ(read->frames[0].golden->key, "older <8x8> 1x");
  EXPECT_EQ(read->frames[0].tolerance.name, "rounding");
  EXPECT_TRUE(read->frames[0].tolerance.limitsPixels());
  EXPECT_EQ(reportJson(*read), reportJson(report_));
}

TEST_F(ReportTest, AReportWithoutGoldensKeysMeansTheFramesOwn) {
  add(FrameVerdict::same);
  report_.frames.back().key = "newer 8x8 1x";
  report_.frames.back().golden.emplace().key = "newer 8x8 1x";
  auto root = nlohmann::json::parse(reportJson(report_));
  root["frames"][0]["golden"].erase("key");
  const auto read = parseReport(root.dump(), "report.json");
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_EQ(read->frames[0].golden->key, "newer 8x8 1x");
}

TEST_F(ReportTest, ThePageEscapesWhatItShowsAndNeedsNoNetwork) {
  add(FrameVerdict::different);
  const std::string page = reportHtml(report_);
  EXPECT_THAT(page, HasSubstr("a\\u003cb&c.toml"));
  EXPECT_THAT(page, HasSubstr("id=\"picture-0\">iVBOR"));
  EXPECT_THAT(page, Not(HasSubstr("http:")));
  EXPECT_THAT(page, Not(HasSubstr("https:")));
  EXPECT_THAT(page, Not(HasSubstr("<angle>")));
  // Before anything that could be loaded: a name that is markup fetches nothing.
  const std::size_t policy =
      page.find("<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none';");
  ASSERT_NE(policy, std::string::npos);
  EXPECT_LT(policy, page.find("<link"));
}

TEST_F(ReportTest, APictureLiesInThePageOnce) {
  add(FrameVerdict::different);
  add(FrameVerdict::different);
  const std::string page = reportHtml(report_);
  EXPECT_THAT(page, HasSubstr("id=\"picture-1\""));
  EXPECT_THAT(page, Not(HasSubstr("id=\"picture-3\"")));
}

TEST_F(ReportTest, WhyStandsInEveryFormat) {
  add(FrameVerdict::different);
  FrameWhy why;
  why.basis = GoldenBasis::redrawn;
  why.blame.differing = 256;
  why.blame.changes = {{{"arm", "hand"}, ChangeKind::moved, 200, {{3.1, -0.4}}, {}}};
  why.state = {{"arm/turn", "arm/turn: 23.61° -> 24.12°", 0.009, true}};
  why.files = {"arm.obj: the mesh has changed"};
  report_.frames[0].why = std::make_shared<const FrameWhy>(why);
  const char* const line = "arm/hand: 200 of 256 differing pixels, moved by (3.1, -0.4) px";
  EXPECT_THAT(reportJunit(report_), HasSubstr(line));
  const auto root = nlohmann::json::parse(reportJson(report_));
  EXPECT_EQ(root["frames"][0]["why"]["links"][0]["text"], line);
  EXPECT_EQ(root["frames"][0]["why"]["state"][0]["item"], "arm/turn");
  EXPECT_THAT(reportHtml(report_), HasSubstr("arm.obj: the mesh has changed"));
}

TEST_F(ReportTest, OnlyWhatWasSeenAndIsSteadyCanBeApproved) {
  add(FrameVerdict::different);
  EXPECT_FALSE(canApprove(report_.frames[0]));  // its pixels have no hash
  report_.frames[0].pixels = "0123";
  EXPECT_TRUE(canApprove(report_.frames[0]));
  report_.frames[0].verdict = FrameVerdict::unstable;
  EXPECT_FALSE(canApprove(report_.frames[0]));
  report_.frames[0].verdict = FrameVerdict::incomparable;
  EXPECT_FALSE(canApprove(report_.frames[0]));
}

TEST_F(ReportTest, WhatIsRefusedWithoutMoreIsNotOfferedForApproval) {
  add(FrameVerdict::different);
  report_.frames[0].pixels = "0123";
  EXPECT_THAT(reportHtml(report_), HasSubstr("\"can_approve\":true"));
  report_.frames[0].lacks = {"the texture `skin.png` is not found"};
  EXPECT_THAT(reportHtml(report_), Not(HasSubstr("\"can_approve\":true")));
  const auto root = nlohmann::json::parse(reportJson(report_));
  EXPECT_EQ(root["frames"][0]["lacks"][0], "the texture `skin.png` is not found");

  JudgedRun run;
  run.verdict = FrameVerdict::different;
  run.log_bytes = "0123";
  RunFinding& finding = run.judgement.findings.emplace_back();
  finding.largest = 0.5;
  finding.limit = 0.05;
  EXPECT_TRUE(canApproveRun(run)) << "no more than ten limits";
  finding.largest = 0.6;
  EXPECT_FALSE(canApproveRun(run));
}

TEST_F(ReportTest, PicturesLieBesideThePage) {
  add(FrameVerdict::different);
  const test::TemporaryFolder folder;
  ASSERT_TRUE(writeReport(report_, folder / "deep" / "report").ok());
  for (const char* name :
       {"index.html", "pick.frame.png", "pick.golden.png", "pick.difference.png"}) {
    EXPECT_TRUE(std::filesystem::exists(folder / "deep" / "report" / name)) << name;
  }
}

/// Frames that are different for one cause, named a, b, c ...
struct OneCause {
  explicit OneCause(std::size_t count, std::vector<std::string> also = {}) {
    FrameWhy why;
    why.causes = {"joint elbow has moved by 20 mm"};
    why.causes.insert(why.causes.end(), also.begin(), also.end());
    for (std::size_t i = 0; i < count; ++i) {
      JudgedFrame judged;
      judged.frame = {std::string(1, static_cast<char>('a' + i)), &suite_case, std::nullopt, ""};
      judged.verdict = FrameVerdict::different;
      judged.rule = "5 differing pixels (exact)";
      judged.why = std::make_shared<const FrameWhy>(why);
      frames.push_back(std::move(judged));
    }
  }
  std::vector<std::string> lines(bool all = false) const {
    return groupLines(causeGroups(frames).front(), all);
  }
  SuiteCase suite_case;
  std::vector<JudgedFrame> frames;
};

TEST(CauseGroup, ALineAFrameWhereTheyFit) {
  EXPECT_THAT(
      OneCause(2, {"link hand is gone"}).lines(),
      testing::ElementsAre("in both frames: joint elbow has moved by 20 mm",
                           "    link hand is gone", "different     a: 5 differing pixels (exact)",
                           "different     b: 5 differing pixels (exact)"));
  EXPECT_EQ(OneCause(9).lines().size(), 10U);
  EXPECT_EQ(OneCause(9).lines().back(), "different     i: 5 differing pixels (exact)");
}

TEST(CauseGroup, NamesTheFramesThatItHasNoLineFor) {
  const OneCause long_one(20);
  const std::vector<std::string> lines = long_one.lines();
  ASSERT_EQ(lines.size(), kMostGroupLines);
  EXPECT_EQ(lines[8], "different     h: 5 differing pixels (exact)");
  EXPECT_EQ(lines[9], "different     and 12 more: i, j, k, l, m, n, o, p, q, r, s, t");
  EXPECT_EQ(long_one.lines(true).size(), 21U);
}

TEST(CauseGroup, SaysHowManyCausesItHasNoLineFor) {
  const OneCause mixed(9, {"A", "B", "C", "D", "E"});
  const std::vector<std::string> lines = mixed.lines();
  ASSERT_EQ(lines.size(), kMostGroupLines);
  EXPECT_THAT(std::vector(lines.begin() + 1, lines.begin() + 4),
              testing::ElementsAre("    A", "    B", "    and 3 more"));
  EXPECT_EQ(lines.back(), "different     and 4 more: f, g, h, i");
}

TEST(CauseGroup, NamesOfTwoVerdictsAreTwoLines) {
  OneCause mixed(12);
  mixed.frames[10].verdict = mixed.frames[11].verdict = FrameVerdict::missing;
  // Missing frames have a cause only where the files or the session have changed.
  FrameWhy why = *mixed.frames[10].why;
  why.files = {"arm.urdf: the model has changed"};
  mixed.frames[10].why = mixed.frames[11].why = std::make_shared<const FrameWhy>(why);
  const std::vector<std::string> lines = mixed.lines();
  ASSERT_EQ(lines.size(), kMostGroupLines);
  EXPECT_EQ(lines[8], "different     and 3 more: h, i, j");
  EXPECT_EQ(lines[9], "missing       and 2 more: k, l");
}

}  // namespace
}  // namespace rocinante
