#include <gtest/gtest.h>

#include "core/base/atomic_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"
#include "viewer/ui/commands/command.h"

namespace rocinante {
namespace {

using test::sessionTime;

class TimeCommands : public testing::Test {
 protected:
  void SetUp() override {
    test::writeText(folder_ / "arm.urdf", test::kArmUrdf);
    test::writeSession(folder_ / "s.mcap", {{0, "joints arm 0\n"},
                                            {500, "joints stranger 1\n"},
                                            {1000, "joints arm 1\n"},
                                            {4000, "joints arm 2\n"}});
    show("s.mcap");
  }
  void show(const char* log) {
    model_.reset();
    auto cell = loadCell(folder_ / "arm.urdf", {});
    auto session = Timeline::open(folder_ / log);
    ASSERT_TRUE(cell.ok() && session.ok());
    auto model = ViewModel::make(std::move(*cell), std::move(*session), std::nullopt, {}, {});
    ASSERT_TRUE(model.ok());
    model_.emplace(std::move(*model));
    model_->study_waits = true;
    model_->viewer.findings_wanted = false;
    ASSERT_TRUE(model_->update(SteadyTime{}).ok());
  }
  /// The sentence of what went wrong, or nothing.
  std::string run(const std::string& line) {
    std::vector<std::string> words = splitWords(line);
    const std::string name = words.front();
    words.erase(words.begin());
    const CommandStage stage{*model_, SteadyTime{}, 480, requests_};
    const Status done = runCommand(name, words, stage);
    return done ? std::string() : done.error().text();
  }

  const test::TemporaryFolder folder_;
  std::optional<ViewModel> model_;
  ViewerRequests requests_;
};

TEST_F(TimeCommands, PlotsWhatThereIs) {
  EXPECT_EQ(run("plot arm.turn"), "");
  EXPECT_EQ(run("plot arm/hand:z"), "");
  EXPECT_EQ(run("plot arm:x"), "no packet of the log states `arm:x`: there are none");
  EXPECT_EQ(run("plot rate/robot"), "");
  EXPECT_EQ(model_->viewer.plots.curves().size(), 3U);
  EXPECT_EQ(run("plot arm.bend"), "`arm` has no joint value `bend`: there is only turn");
  EXPECT_EQ(run("plot leg.turn"), "no device is named `leg`: there is only arm");
  EXPECT_EQ(run("plot arm").substr(0, 25), "`arm` is not DEVICE.JOINT");
  EXPECT_EQ(run("plot arm/hand:x in arm"), "");
  EXPECT_EQ(run("unplot arm/hand:x in arm"), "");
  EXPECT_EQ(run("plot arm/hnad:x"), "`arm` has no link `hnad`: did you mean `hand`?");
  EXPECT_EQ(run("plot arm/hand:x in leg"), "no device is named `leg`: there is only arm");
  EXPECT_EQ(run("plot signal arm load"),
            "no packet of the log states `signal arm load`: there are none");
  EXPECT_EQ(run("plot mean 0.5 d/dt arm.turn"), "");
  EXPECT_EQ(run("plot arm/hand:x - arm/base:x"), "");
  EXPECT_EQ(run("plot d/dt arm.bend"), "`arm` has no joint value `bend`: there is only turn");
  EXPECT_EQ(run("unplot mean 0.5 d/dt arm.turn"), "");
  EXPECT_EQ(run("unplot arm/hand:x - arm/base:x"), "");
  EXPECT_EQ(run("plots off"), "");
  EXPECT_FALSE(model_->viewer.plots.shown());
  EXPECT_EQ(run("unplot arm/hand:z"), "");
  EXPECT_EQ(run("unplot arm/hand:z"), "`arm/hand:z` is not plotted");
  EXPECT_EQ(run("unplot all"), "");
  EXPECT_TRUE(model_->viewer.plots.curves().empty());
}

TEST_F(TimeCommands, AJointThatFollowsAnotherIsPlottedByThatOne) {
  test::writeText(folder_ / "arm.urdf", R"(<robot name="arm">
<link name="a"/><link name="b"/><link name="c"/>
<joint name="turn" type="continuous"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/></joint>
<joint name="half" type="continuous"><parent link="b"/><child link="c"/><axis xyz="0 0 1"/>
<mimic joint="turn" multiplier="0.5"/></joint></robot>)");
  show("s.mcap");
  EXPECT_EQ(run("plot arm.half"), "");
  test::writeSession(folder_ / "n.mcap", {{0, "signal - x 1\n"}, {1000, "signal - x 2\n"}});
  show("n.mcap");
  EXPECT_EQ(run("plot arm.turn"), "no packet of the log states `arm.turn`: there are none");
  EXPECT_EQ(run("plot arm.half"),
            "no packet of the log states `arm.turn`, which `arm.half` follows: there are none");
}

TEST_F(TimeCommands, ATableOfWhatIsSeen) {
  const std::string path = (folder_ / "t.csv").string();
  EXPECT_EQ(run("table " + path), "a table needs a plotted joint, pose or signal");
  run("plot arm.turn");
  run("plot rate");
  EXPECT_EQ(run("show-time 0 2s"), "");
  EXPECT_EQ(run("table " + path), "");
  EXPECT_EQ(*readFile(path), "t,arm.turn\n0,0\n1,1\n");
  EXPECT_NE(run("table " + path + "/none.csv"), "");
}

TEST_F(TimeCommands, MovesTheTimeLine) {
  EXPECT_EQ(run("show-time 1s 2s"), "");
  EXPECT_EQ(model_->viewer.time_view.span(), std::chrono::seconds(1));
  EXPECT_EQ(run("show-time all"), "");
  EXPECT_TRUE(model_->viewer.time_view.showsAll());
  EXPECT_NE(run("show-time 1s"), "");
  EXPECT_EQ(run("part 1s -1s"), "");
  EXPECT_EQ(model_->cursor()->partEnd(), sessionTime(3000));
  EXPECT_EQ(run("part all"), "");
  EXPECT_FALSE(model_->cursor()->hasPart());
  EXPECT_EQ(run("repeat to-and-fro"), "");
  EXPECT_EQ(model_->cursor()->repeat(), Repeat::there_and_back);
  EXPECT_EQ(run("repeat often"), "`often` is not once, loop or to-and-fro");
  EXPECT_EQ(run("reverse on"), "");
  EXPECT_TRUE(model_->cursor()->reversed());
}

TEST_F(TimeCommands, TheTimeOfDayIsThatOfASessionThatHasOne) {
  const bool& shown = model_->viewer.panels.wall_clock;
  EXPECT_EQ(run("clock"), "");
  EXPECT_TRUE(shown);
  EXPECT_EQ(run("clock session"), "");
  EXPECT_FALSE(shown);
  EXPECT_EQ(run("clock utc"), "`utc` is neither session nor day");
  EXPECT_EQ(run("clock day"), "");
  EXPECT_TRUE(shown);
}

TEST_F(TimeCommands, AMarkHasWords) {
  EXPECT_EQ(run("mark look at this"), "");
  EXPECT_EQ(requests_.mark, "look at this");
  EXPECT_FALSE(model_->viewer.panels.mark.shown);
  EXPECT_EQ(run("mark"), "");
  EXPECT_TRUE(model_->viewer.panels.mark.shown);
}

TEST_F(TimeCommands, AFindingIsGoneTo) {
  EXPECT_EQ(run("finding 1"), "`finding` needs `findings on` first");
  EXPECT_EQ(run("findings on"), "");
  const CheckReport* const report = model_->findings()->report();
  ASSERT_NE(report, nullptr);
  std::size_t number = 0;
  for (std::size_t i = 0; i < report->findings.size(); ++i) {
    if (report->findings[i].subject == "stranger") number = i + 1;
  }
  ASSERT_GT(number, 0U);
  EXPECT_EQ(run("finding " + std::to_string(number)), "");
  ASSERT_TRUE(model_->update(SteadyTime{}).ok());
  EXPECT_EQ(model_->shownTime(), sessionTime(500));
  EXPECT_NE(run("finding 99"), "");
  EXPECT_NE(run("finding one"), "");
}

TEST_F(TimeCommands, KeysOfTheTimeLine) {
  ASSERT_TRUE(model_->cursor() != nullptr);
  model_->cursor()->seek(sessionTime(1000), SteadyTime{});
  EXPECT_EQ(run("key A"), "");
  model_->cursor()->seek(sessionTime(2000), SteadyTime{});
  EXPECT_EQ(run("key B"), "");
  EXPECT_EQ(model_->cursor()->partStart(), sessionTime(1000));
  EXPECT_EQ(model_->cursor()->partEnd(), sessionTime(2000));
  EXPECT_EQ(run("key J"), "");
  EXPECT_TRUE(model_->cursor()->reversed());
  PanelState& panels = model_->viewer.panels;
  panels.shown = false;
  panels.places.places["bottom"].collapsed = true;
  EXPECT_EQ(run("key G"), "");
  EXPECT_TRUE(panels.time.shown && panels.time.awaitsKeyboard());
  EXPECT_TRUE(panels.shown && !panels.places.places["bottom"].collapsed) << "where it is typed";
  EXPECT_EQ(panels.places.peeked, "bottom");
}

TEST_F(TimeCommands, NothingIsDerivedOfATextOrOverNoTime) {
  test::writeSession(folder_ / "t.mcap",
                     {{0, "joints arm 0\nsignal arm mode \"auto\"\nsignal arm load 2 kg\n"},
                      {1000, "joints arm 1\nsignal arm mode \"hold\"\nsignal arm load 3 kg\n"}});
  show("t.mcap");
  EXPECT_EQ(run("plot signal arm mode"), "");
  EXPECT_EQ(run("plot d/dt signal arm load"), "");
  EXPECT_EQ(run("plot d/dt signal arm mode"),
            "`signal arm mode` is a text, and a text has no derivative");
  EXPECT_EQ(run("plot signal arm load - signal arm mode"),
            "`signal arm mode` is a text, and a text has no difference");
  EXPECT_EQ(run("plot mean nan arm.turn"),
            "SECONDS is a number from 1e-9 to 3600, not `nan`: mean SECONDS VALUE");
  EXPECT_EQ(run("plot mean 0.5 arm"),
            "`arm` has no mean: use DEVICE.JOINT, DEVICE:x, DEVICE/LINK:x, signal PATH NAME or "
            "what is derived of them");
  EXPECT_EQ(model_->viewer.plots.curves().size(), 2U);
}

TEST_F(TimeCommands, ATableHasDerivedCurvesAlone) {
  model_->viewer.time_view.showAll();
  EXPECT_EQ(run("plot d/dt arm.turn"), "");
  const std::string file = (folder_ / "t.csv").string();
  EXPECT_EQ(run("table " + file), "");
  EXPECT_EQ(*readFile(file), "t,\"d/dt arm.turn\"\n1,1\n4,0.3333333333333333\n");
}

TEST_F(TimeCommands, PlotsOneValueOverAnother) {
  EXPECT_EQ(run("plot arm/hand:y over arm/hand:x"), "");
  EXPECT_EQ(run("plot d/dt arm.turn over arm.turn"), "");
  EXPECT_TRUE(model_->viewer.plots.curves().empty());
  ASSERT_EQ(model_->viewer.plots.paths().size(), 2U);
  EXPECT_EQ(run("plot arm.turn over arm.bend"),
            "`arm` has no joint value `bend`: there is only turn");
  EXPECT_EQ(
      run("plot rate over arm.turn"),
      "`rate` counts packets: one value is plotted over another, such as joints, poses, links "
      "and signals");
  EXPECT_EQ(run("unplot arm.turn over arm/hand:x"), "`arm.turn over arm/hand:x` is not plotted");
  EXPECT_EQ(run("unplot arm/hand:y over arm/hand:x"), "");
  EXPECT_EQ(model_->viewer.plots.paths().size(), 1U);
  EXPECT_TRUE(model_->viewer.plots.shown());
  EXPECT_EQ(run("unplot all"), "");
  EXPECT_FALSE(model_->viewer.plots.shown());
  test::writeSession(folder_ / "t.mcap", {{0, "joints arm 0\nsignal arm mode \"auto\"\n"},
                                          {1000, "joints arm 1\nsignal arm mode \"hold\"\n"}});
  show("t.mcap");
  EXPECT_EQ(run("plot arm.turn over signal arm mode"),
            "`signal arm mode` is a text, and has no place on an axis");
}

}  // namespace
}  // namespace rocinante
