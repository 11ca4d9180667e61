// What is not judged is never the same, and is named.
#include "core/behaviour/run_coverage.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "tests/core/behaviour/demo_regressions.h"
#include "tests/core/behaviour/run_test.h"
#include "tests/support/write_file.h"

namespace rocinante {
namespace {

using test::cellAt;
using test::kDemo;
using test::plus;
using test::SaidSession;
using test::textOfFindings;

class RunCoverageTest : public test::RunTest {};

/// No verdict without its coverage (docs/decisions/040).
TEST_F(RunCoverageTest, WhatIsNotJudgedIsNeverTheSame) {
  const Cell cell = cellAt(kDemo / "demo.cell.toml");
  const SaidSession session = SaidSession::read(kDemo / "session.mcap");
  const auto accepted = trackOf(cell, session);
  ASSERT_TRUE(accepted.ok());
  EXPECT_TRUE(accepted->left_out.empty()) << accountSentence(accepted->left_out);
  const RunJudgement whole = judgeRun({}, {&*accepted}, *accepted);
  EXPECT_TRUE(whole.coverage.judged.contains("arm/joint2"));
  EXPECT_TRUE(whole.coverage.judged.contains("event/" + accepted->events.front().text));
  EXPECT_TRUE(whole.coverage.lost.empty() && whole.coverage.masked.empty());

  // A seventh value: the model takes none of them.
  SaidSession changed = session;
  for (auto& said : changed.packets) {
    std::size_t at = said.body.find("joints arm ");
    if (at == std::string::npos) continue;
    at = said.body.find('\n', at);
    said.body.insert(at, " 0");
  }
  const auto unfit = trackOf(cell, changed);
  ASSERT_TRUE(unfit.ok());
  const RunJudgement judged = judgeRun({}, {&*accepted}, *unfit);
  ASSERT_FALSE(judged.findings.empty());
  EXPECT_NE(judged.rule.find("arm: not judged, since it states 7 values"), std::string::npos)
      << textOfFindings(judged);
  EXPECT_NE(whyLeftOut(judged.coverage.left_out, "arm").find("it states 7 values"),
            std::string::npos);
  // Accepted so, nothing of the joints is judged, and nobody takes it for more.
  const RunJudgement both = judgeRun({}, {&*unfit}, *unfit);
  EXPECT_FALSE(both.notes.empty());

  // A cell that has none of the devices.
  const Cell empty;
  SaidSession silent;
  for (auto said : session.packets) {
    const std::size_t joints = said.body.find("joints arm ");
    if (joints == std::string::npos) continue;
    said.body = said.body.substr(joints, said.body.find('\n', joints) + 1 - joints);
    silent.packets.push_back(said);
  }
  const auto nothing = trackOf(empty, silent);
  ASSERT_TRUE(nothing.ok());
  RunSpec by_origin;
  by_origin.align = RunAlign::origin;
  const RunJudgement none = judgeRun(by_origin, {&*nothing}, *nothing);
  EXPECT_FALSE(none.comparable) << none.rule;
  EXPECT_NE(none.rule.find("nothing was judged"), std::string::npos) << none.rule;
  EXPECT_NE(none.rule.find("`arm`"), std::string::npos) << none.rule;
}

/// A value that rests where the model has it is as good as any other.
TEST_F(RunCoverageTest, AValueIsJudgedWhereItIsStatedAndAPoseTheSame) {
  const Cell cell = cellAt(kDemo / "demo.cell.toml");
  const auto saying = [&](const std::string& body) {
    SaidSession session;
    for (int i = 0; i < 200; ++i) {
      session.packets.push_back({i * 0.01, "s", "RK1 s 0 -", body});
    }
    const auto track = trackOf(cell, session);
    EXPECT_TRUE(track.ok());
    return *track;
  };
  const SessionTrack both =
      saying("joint arm joint1=0.5\njoint arm joint2=0\npose gantry 0 0 0 0 0 0 1\n");
  const SessionTrack one = saying("joint arm joint1=0.5\n");
  RunSpec spec;
  spec.align = RunAlign::origin;
  const RunJudgement less = judgeRun(spec, {&both}, one);
  const std::string lost = textOfFindings(less);
  EXPECT_NE(lost.find("arm/joint2: not judged"), std::string::npos) << lost;
  EXPECT_NE(lost.find("gantry: not judged"), std::string::npos) << lost;
  EXPECT_EQ(less.coverage.lost, (std::set<std::string>{"arm/joint2", "gantry"}));
  const std::string more = textOfFindings(judgeRun(spec, {&one}, both));
  EXPECT_NE(more.find("arm/joint2: no accepted session states this value"), std::string::npos)
      << more;
  EXPECT_NE(more.find("gantry: no accepted session has this device"), std::string::npos) << more;
  const SessionTrack posed = saying("joint arm joint1=0.5\npose arm 0 0 0 0 0 0 1\n");
  const std::string pose = textOfFindings(judgeRun(spec, {&one}, posed));
  EXPECT_NE(pose.find("arm: no accepted session states its pose"), std::string::npos) << pose;
  expectSilent("itself", judgeRun(spec, {&both}, both));
  // What some accepted session does without may be absent.
  expectSilent("either", judgeRun(spec, {&both, &one}, both));
  const RunJudgement absent = judgeRun(spec, {&both, &one}, one);
  expectSilent("the other", absent);
  EXPECT_TRUE(absent.coverage.lost.empty());
  EXPECT_FALSE(absent.coverage.judged.contains("arm/joint2")) << "nothing of it was compared";
  expectSilent("the other first", judgeRun(spec, {&one, &both}, one));

  // A fact of the same name does not stand for the pose.
  const SessionTrack placed = saying("color gantry #808080ff\npose gantry 1 2 3 0 0 0 1\n");
  const SessionTrack coloured = saying("color gantry #808080ff\n");
  const RunJudgement fact = judgeRun(spec, {&placed}, coloured);
  EXPECT_EQ(fact.coverage.lost, std::set<std::string>{"gantry"}) << textOfFindings(fact);
  EXPECT_FALSE(fact.findings.empty());

  // Values that the model does not take state nothing.
  const SessionTrack unfit = saying("joints arm 0 0\njoint arm joint1=0.5\n");
  const std::string refused = textOfFindings(judgeRun(spec, {&both}, unfit));
  EXPECT_NE(refused.find("arm/joint2: not judged"), std::string::npos) << refused;
}

TEST_F(RunCoverageTest, ADeviceOfAnyAcceptedSessionIsJudged) {
  const Cell cell = cellAt(kDemo / "demo.cell.toml");
  const SaidSession session = SaidSession::read(kDemo / "session.mcap");
  SaidSession without = session;
  without.erase("gantry", 0, 1e9);
  const auto whole = trackOf(cell, session);
  const auto part = trackOf(cell, without);
  ASSERT_TRUE(whole.ok() && part.ok());
  RunSpec spec;
  spec.align = RunAlign::origin;
  // Absent is accepted, and so is what the other one does.
  expectSilent("with", judgeRun(spec, {&*part, &*whole}, *whole));
  SaidSession changed = session;
  changed.joint("gantry", 0, 5, 6, plus(0.1));
  const auto run = trackOf(cell, changed);
  ASSERT_TRUE(run.ok());
  const RunJudgement judged = judgeRun(spec, {&*part, &*whole}, *run);
  EXPECT_FALSE(judged.findings.empty()) << "only the second accepted session has the gantry";
}

TEST_F(RunCoverageTest, ADeviceWhoseModelIsNotThereIsNeverTheSame) {
  std::ofstream(folder_ / "arm.urdf")
      << "<robot name='arm'> <link name='a'/> <link name='b'/> <joint name='j' type='revolute'> "
         "<parent "
         "link='a'/> <child link='b'/> <axis xyz='0 0 1'/> <limit lower='-3' upper='3' effort='1' "
         "velocity='3'/> </joint> </robot>";
  std::ofstream(folder_ / "c.cell.toml")
      << "format = 1\n[[device]]\nname = \"one\"\nmodel = \"arm.urdf\"\n"
         "[[device]]\nname = \"two\"\nmodel = \"gone.urdf\"\n";
  const Cell cell = cellAt(folder_ / "c.cell.toml");
  SaidSession session;
  for (int i = 0; i < 100; ++i) {
    session.packets.push_back({i * 0.01, "s", "RK1 s 0 -", "joints one 0.1\njoints two 0.2\n"});
  }
  const auto track = trackOf(cell, session);
  ASSERT_TRUE(track.ok());
  RunSpec spec;
  spec.align = RunAlign::origin;
  const RunJudgement judged = judgeRun(spec, {&*track}, *track);
  ASSERT_EQ(judged.findings.size(), 1U) << textOfFindings(judged);
  EXPECT_EQ(judged.rule, "two: not judged, since its model could not be read");
  spec.masks.push_back({"two"});
  expectSilent("masked", judgeRun(spec, {&*track}, *track));
}

/// Which of two sources is heard first, nobody can say; in which order one speaks, everybody.
TEST_F(RunCoverageTest, EventsOfTwoSourcesMayChangePlacesWithinTheLimit) {
  const Cell cell = cellAt(kDemo / "demo.cell.toml");
  const auto with = [&](double a, double b, const char* other) {
    SaidSession session = SaidSession::read(kDemo / "session.mcap");
    session.say("planner", a, "event \"one\"");
    session.say(other, b, "event \"two\"");
    const auto track = trackOf(cell, session);
    EXPECT_TRUE(track.ok());
    return *track;
  };
  const SessionTrack first = with(6.000, 6.005, "arm");
  expectSilent("of two sources", judgeRun({}, {&first}, with(6.005, 6.000, "arm")));
  const std::string far = textOfFindings(judgeRun({}, {&first}, with(6.4, 6.0, "arm")));
  EXPECT_NE(far.find("out of order"), std::string::npos) << far;
  const SessionTrack alone = with(6.000, 6.005, "planner");
  for (const RunAlign align : {RunAlign::events, RunAlign::origin}) {
    RunSpec spec;
    spec.align = align;
    const std::string same =
        textOfFindings(judgeRun(spec, {&alone}, with(6.003, 5.995, "planner")));
    EXPECT_NE(same.find("out of order"), std::string::npos) << same;
  }
  // Two in one packet keep their order.
  const auto twice = [&](double a, double b) {
    SaidSession session = SaidSession::read(kDemo / "session.mcap");
    session.say("planner", a, "event \"one\"\nevent \"two\"");
    session.say("arm", b, "event \"three\"\nevent \"four\"");
    const auto track = trackOf(cell, session);
    EXPECT_TRUE(track.ok());
    return *track;
  };
  const SessionTrack pairs = twice(6.000, 6.005);
  expectSilent("two a packet", judgeRun({}, {&pairs}, twice(6.006, 6.005)));
}

TEST_F(RunCoverageTest, TheEndOfALogComesBeforeWhatItCauses) {
  const Cell cell = cellAt(kDemo / "demo.cell.toml");
  const SaidSession session = SaidSession::read(kDemo / "session.mcap");
  const auto accepted = trackOf(cell, session);
  SaidSession cut = session;
  std::erase_if(cut.packets, [](const SaidSession::Said& said) { return said.at_s > 13; });
  const auto run = trackOf(cell, cut);
  ASSERT_TRUE(accepted.ok() && run.ok());
  const RunJudgement judged = judgeRun({}, {&*accepted}, *run);
  EXPECT_TRUE(judged.rule.starts_with("the log ends 7.0 s before the accepted one"))
      << textOfFindings(judged);
  // What was different before it comes before it.
  cut.joint("gantry", 0, 5, 6, plus(0.1));
  const auto moved = trackOf(cell, cut);
  ASSERT_TRUE(moved.ok());
  EXPECT_TRUE(judgeRun({}, {&*accepted}, *moved).rule.starts_with("gantry/x: "));
  // However short what is missing is: an event that is not there any more.
  SaidSession last = SaidSession::read(kDemo / "session.mcap");
  last.say("arm", 19.85, "event \"parked\"");
  cut = last;
  std::erase_if(cut.packets, [](const SaidSession::Said& said) { return said.at_s > 19.7; });
  const auto parked = trackOf(cell, last);
  const auto early = trackOf(cell, cut);
  ASSERT_TRUE(parked.ok() && early.ok());
  const RunJudgement ended = judgeRun({}, {&*parked}, *early);
  EXPECT_TRUE(ended.rule.starts_with("the log ends 290 ms before the accepted one"))
      << textOfFindings(ended);
}

/// The joints of a device that is named as events are.
TEST_F(RunCoverageTest, ItemsAreThoseOfTheCoverageButForEvents) {
  test::writeFile(folder_ / "swing.urdf", R"(<robot name="r"><link name="a"/><link name="b"/>
<joint name="turn" type="continuous"><parent link="a"/><child link="b"/></joint></robot>)");
  test::writeFile(folder_ / "cell.toml",
                  "format = 1\n[[device]]\nname = \"event\"\nmodel = \"swing.urdf\"\n");
  const Cell cell = cellAt(folder_ / "cell.toml");
  SaidSession session;
  session.packets = {{0, "event", "RK1 event@0a 0 -", "joints event 0\n"},
                     {1, "event", "RK1 event@0a 1 -", "event \"done\"\n"}};
  const auto track = trackOf(cell, session);
  ASSERT_TRUE(track.ok()) << track.error().text();
  RunSpec spec;
  const RunJudgement judged = judgeRun(spec, {&*track}, *track);
  EXPECT_EQ(judged.items, 1U) << textOfFindings(judged);
  EXPECT_EQ(judged.coverage.judged.size(), 2U);
  // How often it is stated is left.
  spec.align = RunAlign::origin;
  spec.masks = {{"event/*"}};
  const RunJudgement masked = judgeRun(spec, {&*track}, *track);
  EXPECT_TRUE(masked.comparable) << masked.rule;
  EXPECT_EQ(masked.items, 0U);
}

/// Each layer is a fact and an item of its own.
TEST_F(RunCoverageTest, LayersAreTakenForThemselves) {
  const Cell cell = cellAt(kDemo / "demo.cell.toml");
  SaidSession session = SaidSession::read(kDemo / "session.mcap");
  SaidSession changed = session;
  session.say("arm", 6, "hide layer/tanks");
  changed.say("arm", 6, "hide layer/robots");
  const auto accepted = trackOf(cell, session);
  const auto run = trackOf(cell, changed);
  ASSERT_TRUE(accepted.ok() && run.ok());
  RunSpec spec;
  const std::string found = textOfFindings(judgeRun(spec, {&*accepted}, *run));
  EXPECT_NE(found.find("[layer/tanks] visibility of layer/tanks"), std::string::npos) << found;
  EXPECT_NE(found.find("[layer/robots] visibility of layer/robots"), std::string::npos) << found;
  spec.masks = {{"layer/tanks"}, {"layer/robots"}};
  expectSilent("masked", judgeRun(spec, {&*accepted}, *run));
}

TEST_F(RunCoverageTest, ASecondOfSilenceIsFoundWhereverItBegins) {
  const Cell cell = cellAt(kDemo / "demo.cell.toml");
  const SaidSession session = SaidSession::read(kDemo / "session.mcap");
  const auto accepted = trackOf(cell, session);
  ASSERT_TRUE(accepted.ok());
  for (const double from : {6.0, 6.35, 6.66, 6.9, 18.4}) {
    SaidSession changed = session;
    changed.erase("arm", from, from + 1.2);
    const auto run = trackOf(cell, changed);
    ASSERT_TRUE(run.ok());
    const std::string found = textOfFindings(judgeRun({}, {&*accepted}, *run));
    EXPECT_NE(found.find("arm: stated "), std::string::npos) << from << found;
  }
}

TEST_F(RunCoverageTest, ARecorderThatBeganLaterIsTheSameUnderAWarp) {
  const Cell cell = cellAt(kDemo / "demo.cell.toml");
  const SaidSession session = SaidSession::read(kDemo / "session.mcap");
  const auto accepted = trackOf(cell, session);
  ASSERT_TRUE(accepted.ok());
  RunSpec spec;
  spec.align = RunAlign::warp;
  for (const double later : {0.5, 1.0, 3.0}) {
    SaidSession changed = session;
    std::erase_if(changed.packets, [&](const auto& said) { return said.at_s < later; });
    const auto run = trackOf(cell, changed);
    ASSERT_TRUE(run.ok());
    expectSilent("later", judgeRun(spec, {&*accepted}, *run));
  }
}

TEST_F(RunCoverageTest, AnEventBeforeTheLogBeganIsNotMissing) {
  const Cell cell = cellAt(kDemo / "demo.cell.toml");
  const SaidSession session = SaidSession::read(kDemo / "session.mcap");
  const auto accepted = trackOf(cell, session);
  ASSERT_TRUE(accepted.ok());
  const double picked = secondsOf(accepted->events.front().time - accepted->origin);
  for (const double later : {0.01, 0.3, 2.0}) {
    SaidSession changed = session;
    std::erase_if(changed.packets, [&](const auto& said) { return said.at_s < picked + later; });
    const auto run = trackOf(cell, changed);
    ASSERT_TRUE(run.ok());
    const std::string found = textOfFindings(judgeRun({}, {&*accepted}, *run));
    EXPECT_EQ(found.find("is missing"), std::string::npos) << later << found;
  }
}

TEST(RunNames, NamesThatMatchNothingAreNamed) {
  const Cell cell = cellAt(kDemo / "demo.cell.toml");
  RunSpec spec;
  spec.masks.push_back({"drawing/planner/*"});
  spec.masks.push_back({"gantri"});
  spec.own_limits["arm/joint9"].joint_deg = 1;
  spec.own_limits["arm"].joint_deg = 1;
  const auto complaints = namesThatMatchNothing(spec, cell, {"drawing/planner/path"});
  ASSERT_EQ(complaints.size(), 2U);
  EXPECT_NE(complaints[0].find("did you mean `gantry`"), std::string::npos) << complaints[0];
  EXPECT_NE(complaints[1].find("`arm/joint9`"), std::string::npos) << complaints[1];
}

TEST(RunNames, LimitsOfAnotherKindAreNamed) {
  const Cell cell = cellAt(kDemo / "demo.cell.toml");
  const std::set<std::string> items = {"arm/joint1",          "gantry/x",     "signal arm load",
                                       "signal arm mode",     "event/picked", "signal - speed",
                                       "drawing/planner/path"};
  const auto complaintsAt = [&](const std::string& name, const OwnLimits& limits) {
    RunSpec spec;
    spec.own_limits[name] = limits;
    return fmt::format(
        "{}",
        fmt::join(limitsThatNothingTakes(spec, cell, items, {"signal arm load", "signal - speed"}),
                  "; "));
  };
  OwnLimits angle, length, late, share, number;
  angle.joint_deg = length.position_mm = late.event_ms = share.signal_share = number.signal = 30;
  for (const char* const name :
       {"arm", "arm/joint1", "gantry/x", "signal arm load", "signal arm mode", "event/picked", "-",
        "drawing/planner/path", "tanks"}) {
    EXPECT_EQ(complaintsAt(name, late), "");
  }
  EXPECT_EQ(complaintsAt("arm", angle), "");
  EXPECT_EQ(complaintsAt("arm", share), "");
  EXPECT_EQ(complaintsAt("-", share), "");
  EXPECT_EQ(complaintsAt("gantry/x", length), "");
  EXPECT_EQ(complaintsAt("signal arm load", number), "");
  EXPECT_EQ(complaintsAt("nobody", angle), "") << "its name is complained of";
  EXPECT_EQ(complaintsAt("gantry/x", angle),
            "limits of `gantry/x`: nothing takes its joint_deg; it takes event_ms, position_mm");
  EXPECT_EQ(complaintsAt("arm/joint1", length),
            "limits of `arm/joint1`: nothing takes its position_mm; it takes event_ms, joint_deg");
  EXPECT_EQ(complaintsAt("signal arm load", angle),
            "limits of `signal arm load`: nothing takes its joint_deg; it takes event_ms, signal, "
            "signal_share");
  EXPECT_EQ(complaintsAt("signal arm mode", number),
            "limits of `signal arm mode`: nothing takes its signal; it takes event_ms");
  EXPECT_NE(complaintsAt("gantry", angle), "") << "all of its joints slide";
  EXPECT_NE(complaintsAt("gantry", share), "") << "it has no signal";
  EXPECT_NE(complaintsAt("event/picked", length), "");
  EXPECT_NE(complaintsAt("drawing/planner/path", angle), "");
}

}  // namespace
}  // namespace rocinante
