// Deliberate changes of real sessions: the judge of runs names each regression with its item and
// time, and is silent about what differs between two recordings of one motion.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "core/behaviour/run_judge.h"
#include "core/cell/cell.h"
#include "tests/core/behaviour/demo_regressions.h"
#include "tests/core/behaviour/run_test.h"
#include "tests/support/shared_data.h"

namespace rocinante {
namespace {

using test::cellAt;
using test::delay;
using test::demoRegressions;
using test::kDegree;
using test::kDemo;
using test::plus;
using test::Regression;
using test::SaidSession;
using test::textOfFindings;
using Kind = RunFinding::Kind;

class RunRegressions : public test::RunTest {
 protected:
  /// `judged` names the regression, at its time.
  static void expectNamed(const Regression& regression, const RunJudgement& judged) {
    SCOPED_TRACE(
        fmt::format("{} ({})\n{}", regression.what, regression.item, textOfFindings(judged)));
    ASSERT_TRUE(judged.comparable);
    const auto found = std::ranges::find_if(judged.findings, [&](const RunFinding& finding) {
      return finding.kind == regression.kind && finding.item.starts_with(regression.item) &&
             finding.what.find(regression.said) != std::string::npos;
    });
    ASSERT_NE(found, judged.findings.end()) << "it is not named";
    EXPECT_GE(secondsOf(found->first_accepted), regression.from_s);
    EXPECT_LE(secondsOf(found->first_accepted), regression.until_s);
  }
};

TEST_F(RunRegressions, EachChangeOfTheDemoIsNamedWithItsItemAndTime) {
  const Cell cell = cellAt(kDemo / "demo.cell.toml");
  const SaidSession session = SaidSession::read(kDemo / "session.mcap");
  const auto accepted = trackOf(cell, session);
  ASSERT_TRUE(accepted.ok()) << accepted.error().text();
  const std::vector<Regression> regressions = demoRegressions();
  EXPECT_GE(regressions.size(), 40U);
  for (const Regression& regression : regressions) {
    SaidSession changed = session;
    regression.change(changed);
    const auto run = trackOf(cell, changed);
    ASSERT_TRUE(run.ok()) << regression.what << ": " << run.error().text();
    RunSpec spec;
    spec.align = regression.align;
    expectNamed(regression, judgeRun(spec, {&*accepted}, *run));
  }
}

/// What differs between recordings of one motion.
std::vector<std::pair<const char*, std::function<void(SaidSession&)>>> benignChanges() {
  return {
      {"the same session", [](SaidSession&) {}},
      {"noise of an encoder",
       [](SaidSession& s) {
         std::mt19937 random(7);
         std::normal_distribution<double> noise(0, 0.005 * kDegree);
         for (std::size_t joint = 0; joint < 6; ++joint) {
           s.joint("arm", joint, 0, 1e9,
                   [&](double value, double) { return value + noise(random); });
         }
         std::normal_distribution<double> noise_m(0, 0.00005);
         for (std::size_t joint = 0; joint < 4; ++joint) {
           s.joint("gantry", joint, 0, 1e9,
                   [&](double value, double) { return value + noise_m(random); });
         }
       }},
      {"a clock 200 ppm fast",
       [](SaidSession& s) { s.times("", [](double at) { return at * 1.0002; }); }},
      {"a clock 200 ppm slow",
       [](SaidSession& s) { s.times("", [](double at) { return at * 0.9998; }); }},
      {"arrivals that jitter by 3 ms",
       [](SaidSession& s) {
         std::mt19937 random(11);
         std::uniform_real_distribution<double> late(0, 0.003);
         s.times("", [&](double at) { return at + late(random); });
       }},
      {"one source 8 ms behind the others",
       [](SaidSession& s) { s.times("arm", [](double at) { return at + 0.008; }); }},
      {"one packet in fifty lost",
       [](SaidSession& s) {
         std::size_t count = 0;
         std::erase_if(s.packets, [&](const auto& said) {
           return said.source != "planner" && ++count % 50 == 0;
         });
       }},
      {"values in fewer digits",
       [](SaidSession& s) {
         for (std::size_t joint = 0; joint < 6; ++joint) {
           s.joint("arm", joint, 0, 1e9,
                   [](double value, double) { return std::round(value * 1e4) / 1e4; });
         }
       }},
  };
}

TEST_F(RunRegressions, WhatDiffersBetweenRecordingsOfOneMotionIsSilent) {
  const Cell cell = cellAt(kDemo / "demo.cell.toml");
  const SaidSession session = SaidSession::read(kDemo / "session.mcap");
  const auto accepted = trackOf(cell, session);
  ASSERT_TRUE(accepted.ok());
  for (const auto& [what, change] : benignChanges()) {
    SaidSession changed = session;
    change(changed);
    const auto run = trackOf(cell, changed);
    ASSERT_TRUE(run.ok());
    for (const RunAlign align : {RunAlign::events, RunAlign::origin}) {
      RunSpec spec;
      spec.align = align;
      expectSilent(what, judgeRun(spec, {&*accepted}, *run));
    }
  }
}

TEST_F(RunRegressions, AnotherStartIsSilentWhenAlignedByEvents) {
  const Cell cell = cellAt(kDemo / "demo.cell.toml");
  const SaidSession session = SaidSession::read(kDemo / "session.mcap");
  const auto accepted = trackOf(cell, session);
  ASSERT_TRUE(accepted.ok());
  // The sources began 1.7 s earlier: what they say at rest is said for longer.
  SaidSession earlier;
  for (const auto& said : session.packets) {
    if (said.at_s > 0.25) continue;
    for (int i = 0; i < 6; ++i) {
      auto copy = said;
      copy.at_s = said.at_s + 0.25 * i;
      earlier.packets.push_back(copy);
    }
  }
  for (auto said : session.packets) {
    said.at_s += 1.7;
    earlier.packets.push_back(said);
  }
  const auto run = trackOf(cell, earlier);
  ASSERT_TRUE(run.ok());
  expectSilent("an earlier start", judgeRun({}, {&*accepted}, *run));
}

/// What one log states as it begins may have been stated before the other one, for 2 s: not for
/// ever.
TEST_F(RunRegressions, WhatIsStatedAtTheBeginningAndNeverInTheRunIsFound) {
  const Cell cell = cellAt(kDemo / "demo.cell.toml");
  const SaidSession session = SaidSession::read(kDemo / "session.mcap");
  const auto plain = trackOf(cell, session);
  for (const double until_s : {9.0, 1e9}) {
    SaidSession colored = session;
    colored.say("painter", session.packets.front().at_s + 0.01, "color gantry #ff000080");
    colored.say("my%20plan", session.packets.front().at_s + 0.01,
                "line one #ff0000 0 0 0 1 0 0\nline two #ff0000 0 0 0 1 0 0");
    if (until_s < 1e9) colored.say("painter", until_s, "color gantry default");
    if (until_s < 1e9) colored.say("my%20plan", until_s, "erase *");
    const auto with = trackOf(cell, colored);
    ASSERT_TRUE(plain.ok() && with.ok());
    for (const auto& [accepted, run] : {std::pair(&*plain, &*with), std::pair(&*with, &*plain)}) {
      const std::string found = textOfFindings(judgeRun({}, {accepted}, *run));
      for (const char* fact :
           {"color of gantry", "drawing/my plan-extra/one", "drawing/my plan-extra/two"}) {
        EXPECT_NE(found.find(fact), std::string::npos)
            << fact << " until " << until_s << ": " << found;
      }
    }
  }
}

/// What was carried, drawn or hidden before a recorder began, and ends before its source restates
/// it, is unknown to it.
TEST_F(RunRegressions, ARecorderThatBeginsLateKnowsNothingOfWhatEndsSoon) {
  const Cell cell = cellAt(kDemo / "demo.cell.toml");
  SaidSession session = SaidSession::read(kDemo / "session.mcap");
  session.say("planner", 9, "hide arm/link3\ncolor gantry #00ff00");
  session.say("planner", 11, "show arm/link3 default\ncolor gantry default");
  const auto accepted = trackOf(cell, session);
  // The canister is let go at 11.1 s, and what was drawn for it erased.
  for (const double from_s : {10.05, 10.4, 10.9, 11.05}) {
    SaidSession later = session;
    std::erase_if(later.packets, [&](const auto& said) { return said.at_s < from_s; });
    const auto run = trackOf(cell, later);
    ASSERT_TRUE(accepted.ok() && run.ok());
    // Half of the accepted time is missing, and is named by itself.
    RunJudgement judged = judgeRun({}, {&*accepted}, *run);
    std::erase_if(judged.findings, [](const auto& found) { return found.item == "session"; });
    expectSilent("a late beginning", judged);
    expectSilent("an early beginning", judgeRun({}, {&*run}, *accepted));
  }
  // What is stated once the log has begun counts at once.
  SaidSession hidden = session;
  hidden.say("planner", 9.5, "hide gantry/hook");
  hidden.say("planner", 10.5, "show gantry/hook default");
  std::erase_if(session.packets, [](const auto& said) { return said.at_s < 9.2; });
  const auto with = trackOf(cell, hidden), without = trackOf(cell, session);
  ASSERT_TRUE(with.ok() && without.ok());
  const RunJudgement judged = judgeRun({}, {&*with}, *without);
  EXPECT_NE(textOfFindings(judged).find("visibility of gantry/hook"), std::string::npos)
      << textOfFindings(judged);
}

/// The parts of a drawing come in packets of their own, each of them earlier or later.
TEST_F(RunRegressions, PartsOfADrawingMayComeApart) {
  const Cell cell = cellAt(kDemo / "demo.cell.toml");
  SaidSession session = SaidSession::read(kDemo / "session.mcap");
  for (int step = 0; step < 20; ++step) {
    for (int part = 1; part <= 3; ++part) {
      session.say("planner", 6 + 0.1 * step + 0.0001 * part,
                  fmt::format("line trace:{}/3 #ff0000 {} 0 {} 1 1 {}", part, step, part, part));
    }
  }
  const auto accepted = trackOf(cell, session);
  ASSERT_TRUE(accepted.ok());
  const auto apart = [&](const char* part, double by_s) {
    SaidSession changed = session;
    for (auto& said : changed.packets) {
      if (said.body.starts_with(part)) said.at_s += by_s;
    }
    return *trackOf(cell, changed);
  };
  for (const char* part : {"line trace:1/3", "line trace:2/3", "line trace:3/3"}) {
    for (const double by_s : {-0.015, -0.011, 0.011, 0.015}) {
      const SessionTrack run = apart(part, by_s);
      expectSilent(part, judgeRun({}, {&*accepted}, run));
      expectSilent(part, judgeRun({}, {&run}, *accepted));
    }
    const RunJudgement late = judgeRun({}, {&*accepted}, apart(part, 0.04));
    ASSERT_EQ(late.findings.size(), 1U) << textOfFindings(late);
    EXPECT_EQ(late.findings.front().item, "drawing/planner-extra/trace");
  }
  // All parts differ at once: one finding, of the first.
  SaidSession moved = session;
  moved.replace("1 1 ", "1 1.01 ", 6.5);
  const RunJudgement judged = judgeRun({}, {&*accepted}, *trackOf(cell, moved));
  ASSERT_EQ(judged.findings.size(), 1U) << textOfFindings(judged);
  EXPECT_TRUE(judged.findings.front().what.starts_with("drawing/planner-extra/trace: moved by"))
      << judged.findings.front().what;
  // A part that is missing.
  std::erase_if(moved.packets,
                [](const auto& said) { return said.body.starts_with("line trace:2/3"); });
  const RunJudgement gap = judgeRun({}, {&*accepted}, *trackOf(cell, moved));
  EXPECT_NE(textOfFindings(gap).find("drawing/planner-extra/trace part 2: nothing"),
            std::string::npos)
      << textOfFindings(gap);
}

/// With a warp a delay may begin after the last event, as anywhere else, and go on to the end.
TEST_F(RunRegressions, AWarpForgivesADelayUpToItsMostAlsoAtTheTail) {
  const Cell cell = cellAt(kDemo / "demo.cell.toml");
  SaidSession session = SaidSession::read(kDemo / "session.mcap");
  std::erase_if(session.packets, [](const auto& said) { return said.at_s > 16.5; });
  RunSpec spec;
  spec.align = RunAlign::warp;
  const auto accepted = trackOf(cell, session);
  ASSERT_TRUE(accepted.ok());
  for (const double from_s : {12.0, 14.0, 15.9}) {
    // Within 0.4 s.
    const auto delayed = [&](double by_s) {
      SaidSession later = session;
      later.times("",
                  [&](double at) { return at + by_s * std::clamp((at - from_s) / 0.4, 0.0, 1.0); });
      return *trackOf(cell, later);
    };
    for (const double by_s : {0.05, 0.12, 0.18}) {
      SCOPED_TRACE(fmt::format("{} s late from {} s on", by_s, from_s));
      expectSilent("late", judgeRun(spec, {&*accepted}, delayed(by_s)));
    }
    const RunJudgement late = judgeRun(spec, {&*accepted}, delayed(0.4));
    EXPECT_FALSE(late.findings.empty()) << "0.4 s late from " << from_s << " s on";
  }
}

TEST_F(RunRegressions, AWarpForgivesAPaceAndNotAJoint) {
  const Cell cell = cellAt(kDemo / "demo.cell.toml");
  const SaidSession session = SaidSession::read(kDemo / "session.mcap");
  const auto accepted = trackOf(cell, session);
  SaidSession uneven = session;
  // Between the events everything comes up to 120 ms later.
  uneven.times("", [](double at) {
    return at < 12 || at > 18 ? at : at + 0.12 * std::sin((at - 12) / 6 * M_PI);
  });
  const auto run = trackOf(cell, uneven);
  delay(uneven, "arm", 1, 0.1, 12, 18);
  const auto lagging = trackOf(cell, uneven);
  ASSERT_TRUE(accepted.ok() && run.ok() && lagging.ok());
  RunSpec spec;
  EXPECT_FALSE(judgeRun(spec, {&*accepted}, *run).findings.empty());
  spec.align = RunAlign::warp;
  expectSilent("an uneven pace", judgeRun(spec, {&*accepted}, *run));
  const RunJudgement judged = judgeRun(spec, {&*accepted}, *lagging);
  const auto joint = std::ranges::find(judged.findings, "arm/joint2", &RunFinding::item);
  ASSERT_NE(joint, judged.findings.end()) << textOfFindings(judged);
  EXPECT_EQ(std::ranges::find(judged.findings, "arm/joint3", &RunFinding::item),
            judged.findings.end())
      << textOfFindings(judged);
}

TEST_F(RunRegressions, ABandOfAcceptedRunsAllowsWhatLiesBetween) {
  const Cell cell = cellAt(kDemo / "demo.cell.toml");
  const SaidSession session = SaidSession::read(kDemo / "session.mcap");
  const auto with = [&](double degrees) {
    SaidSession changed = session;
    changed.joint("arm", 1, 0, 1e9, plus(degrees * kDegree));
    return *trackOf(cell, changed);
  };
  const SessionTrack low = with(-0.5), high = with(0.5);
  expectSilent("between", judgeRun({}, {&low, &high}, with(0.3)));
  const RunJudgement beyond = judgeRun({}, {&low, &high}, with(0.9));
  ASSERT_FALSE(beyond.findings.empty());
  const auto joint = std::ranges::find(beyond.findings, "arm/joint2", &RunFinding::item);
  ASSERT_NE(joint, beyond.findings.end());
  EXPECT_NEAR(*joint->largest, 0.4, 0.02);
}

TEST_F(RunRegressions, MasksAndOwnLimitsAreHeeded) {
  const Cell cell = cellAt(kDemo / "demo.cell.toml");
  const SaidSession session = SaidSession::read(kDemo / "session.mcap");
  const auto accepted = trackOf(cell, session);
  SaidSession changed = session;
  changed.joint("arm", 5, 14, 15, plus(0.4 * kDegree));
  const auto run = trackOf(cell, changed);
  ASSERT_TRUE(accepted.ok() && run.ok());
  RunSpec spec;
  EXPECT_FALSE(judgeRun(spec, {&*accepted}, *run).findings.empty());
  spec.masks = {{"arm", std::chrono::seconds(13), std::chrono::seconds(16)}};
  expectSilent("a masked span", judgeRun(spec, {&*accepted}, *run));
  spec.masks = {{"arm/joint6"}, {"arm/tip"}};
  expectSilent("a masked joint", judgeRun(spec, {&*accepted}, *run));
  spec.masks.clear();
  spec.own_limits["arm"].joint_deg = 0.5;
  spec.own_limits["arm"].turn_deg = 0.5;
  spec.own_limits["arm"].position_mm = 5;
  expectSilent("a wider limit", judgeRun(spec, {&*accepted}, *run));
}

/// Real hardware: an arm of seven joints, about 1,000 samples a second with its own jitter.
TEST_F(RunRegressions, ChangesOfARealRecordingAreNamed) {
  ROCINANTE_NEEDS_SHARED_DATA("recordings/panda_exciting_trajectory/panda_joints.csv");
  const Cell cell = cellAt(test::sharedData("robots/franka_panda/panda.urdf"));
  SaidSession session;
  std::ifstream csv(test::sharedData("recordings/panda_exciting_trajectory/panda_joints.csv"));
  std::string line;
  std::getline(csv, line);
  while (std::getline(csv, line)) {
    std::ranges::replace(line, ',', ' ');
    std::istringstream words(line);
    double at = 0;
    words >> at;
    std::string body = "joints panda";
    double value = 0;
    while (words >> value) body += fmt::format(" {}", value);
    body += " 0\n";  // the fingers
    session.packets.push_back({at, "panda", "RK1 panda 0 -", body});
  }
  ASSERT_GT(session.packets.size(), 20'000U);
  session.packets.front().body += "event \"begin\"\n";
  session.packets.back().body += "event \"end\"\n";
  const auto accepted = trackOf(cell, session);
  ASSERT_TRUE(accepted.ok()) << accepted.error().text();
  std::vector<Regression> regressions = {
      {"0.1 degrees", Kind::joint, "panda/panda_joint4", 0, 0.1,
       [](SaidSession& s) { s.joint("panda", 3, 0, 1e9, plus(0.1 * kDegree)); }, "beyond"},
      {"0.5 degrees for a second", Kind::joint, "panda/panda_joint2", 9.9, 10.1,
       [](SaidSession& s) { s.joint("panda", 1, 10, 11, plus(0.5 * kDegree)); }},
      {"50 ms late", Kind::joint, "panda/panda_joint1", 0, 3,
       [](SaidSession& s) { delay(s, "panda", 0, 0.05); }, "late"},
      {"frozen", Kind::joint, "panda/panda_joint6", 7.9, 8.4,
       [](SaidSession& s) {
         double held = NAN;
         s.joint("panda", 5, 8, 9.5, [held](double value, double) mutable {
           if (std::isnan(held)) held = value;
           return held;
         });
       },
       "frozen at"},
      {"its sign is flipped", Kind::joint, "panda/panda_joint7", 0, 0.1,
       [](SaidSession& s) {
         s.joint("panda", 6, 0, 1e9, [](double value, double) { return -value; });
       },
       "its sign is flipped"},
      {"its rate is halved", Kind::rate, "panda", 0, 1.5,
       [](SaidSession& s) {
         std::size_t count = 0;
         std::erase_if(s.packets, [&](const auto&) { return count++ % 2 == 1; });
       }},
      {"nothing is said for half a second", Kind::joint, "panda/panda_joint", 4.9, 5.3,
       [](SaidSession& s) { s.erase("panda", 5, 5.5); }},
      {"it ends early", Kind::event, "event/end", 20.4, 20.6,
       [](SaidSession& s) {
         std::erase_if(s.packets, [](const auto& said) { return said.at_s > 20.5; });
         s.say("panda", 20.5, "event \"end\"");
       }},
  };
  for (std::size_t joint = 0; joint < 7; ++joint) {
    static const char* const kNames[] = {
        "panda/panda_joint1", "panda/panda_joint2", "panda/panda_joint3", "panda/panda_joint4",
        "panda/panda_joint5", "panda/panda_joint6", "panda/panda_joint7"};
    regressions.push_back({"a joint lags from a moment on", Kind::joint, kNames[joint], 11.9, 15,
                           [joint](SaidSession& s) { delay(s, "panda", joint, 0.08, 12); }});
  }
  for (const Regression& regression : regressions) {
    SaidSession changed = session;
    regression.change(changed);
    if (changed.packets.back().body.find("event") == std::string::npos) {
      changed.packets.back().body += "event \"end\"\n";
    }
    const auto run = trackOf(cell, changed);
    ASSERT_TRUE(run.ok());
    expectNamed(regression, judgeRun({}, {&*accepted}, *run));
  }
  SaidSession noisy = session;
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 0.004 * kDegree);
  for (std::size_t joint = 0; joint < 7; ++joint) {
    noisy.joint("panda", joint, 0, 1e9,
                [&](double value, double) { return value + noise(random); });
  }
  noisy.times("", [](double at) { return at * 1.0002 + 0.5; });
  const auto run = trackOf(cell, noisy);
  ASSERT_TRUE(run.ok());
  expectSilent("noise, another start and a clock 200 ppm off", judgeRun({}, {&*accepted}, *run));
}

/// An arm that reaches for a block: a simulator's session, with a body whose pose is stated. Events
/// of our own mark its ends.
TEST_F(RunRegressions, ChangesOfARecordedGraspAreNamed) {
  ROCINANTE_NEEDS_SHARED_DATA("recordings/kuka_block_grasp/block_grasp_log.csv");
  std::ofstream(folder_ / "block.urdf") << "<robot name=\"block\"><link name=\"body\"/></robot>";
  std::ofstream(folder_ / "cell.toml") << fmt::format(
      "format = 1\nsearch = [\"{0}\"]\n[[device]]\nname = \"kuka\"\nmodel = "
      "\"{0}/model.urdf\"\n[[device]]\nname = \"block\"\nmodel = \"block.urdf\"\n",
      test::sharedData("robots/kuka_iiwa").string());
  const Cell cell = cellAt(folder_ / "cell.toml");
  SaidSession session;
  std::ifstream csv(test::sharedData("recordings/kuka_block_grasp/block_grasp_log.csv"));
  std::string line;
  std::getline(csv, line);
  while (std::getline(csv, line)) {
    std::vector<std::string> fields;
    std::istringstream words(line);
    for (std::string field; std::getline(words, field, ',');) fields.push_back(field);
    ASSERT_GE(fields.size(), 10U);
    const auto listed = [&](std::size_t first, std::size_t count) {
      std::string text;
      for (std::size_t i = first; i < first + count; ++i) text += " " + fields[i];
      return text + "\n";
    };
    const double at = std::stod(fields[1]);
    if (fields[2] == "0") {
      session.packets.push_back({at, "arm", "RK1 arm 0 -", "joints kuka" + listed(10, 7)});
    } else if (fields[2] == "2") {
      session.packets.push_back({at, "block", "RK1 block 0 -", "pose block" + listed(3, 7)});
    }
  }
  ASSERT_GT(session.packets.size(), 4'000U);
  session.say("arm", 0, "event \"begin\"").say("arm", 4.2, "event \"end\"");
  const auto accepted = trackOf(cell, session);
  ASSERT_TRUE(accepted.ok()) << accepted.error().text();
  /// Changes the block's numbers from a moment on.
  const auto moved = [](std::size_t number, double by, double from) {
    return [number, by, from](SaidSession& s) {
      for (auto& said : s.packets) {
        if (said.source != "block" || said.at_s < from) continue;
        std::istringstream words(said.body);
        std::string text, word;
        for (std::size_t i = 0; words >> word; ++i) {
          text += (i == 0 ? "" : " ") +
                  (i == number + 2 ? fmt::format("{:.9f}", std::stod(word) + by) : word);
        }
        said.body = text + "\n";
      }
    };
  };
  const std::vector<Regression> regressions = {
      {"0.1 degrees", Kind::joint, "kuka/lbr_iiwa_joint_2", 0, 0.1,
       [](SaidSession& s) { s.joint("kuka", 1, 0, 1e9, plus(0.1 * kDegree)); }, "beyond"},
      {"0.5 degrees from a moment on", Kind::joint, "kuka/lbr_iiwa_joint_6", 1.4, 1.6,
       [](SaidSession& s) { s.joint("kuka", 5, 1.5, 1e9, plus(0.5 * kDegree)); }},
      {"late", Kind::joint, "kuka/lbr_iiwa_joint_1", 0.5, 1.5,
       [](SaidSession& s) { delay(s, "kuka", 0, 0.06); }},
      {"its sign is flipped", Kind::joint, "kuka/lbr_iiwa_joint_4", 0, 0.1,
       [](SaidSession& s) {
         s.joint("kuka", 3, 0, 1e9, [](double value, double) { return -value; });
       },
       "its sign is flipped"},
      {"frozen", Kind::joint, "kuka/lbr_iiwa_joint_7", 0.9, 1.3,
       [](SaidSession& s) {
         double held = NAN;
         s.joint("kuka", 6, 1, 2, [held](double value, double) mutable {
           if (std::isnan(held)) held = value;
           return held;
         });
       },
       "frozen at"},
      {"the block lies 1 mm lower", Kind::pose, "block", 0, 0.1, moved(2, -1e-3, 0)},
      {"the block is pushed 2 mm", Kind::pose, "block", 1.9, 2.1, moved(0, 2e-3, 2)},
      {"the block is turned", Kind::pose, "block", 2.9, 3.1, moved(5, 0.01, 3)},
      {"the block is said half as often", Kind::rate, "block", 0, 1.5,
       [](SaidSession& s) {
         std::size_t count = 0;
         std::erase_if(s.packets, [&](const auto& said) {
           return said.source == "block" && count++ % 2 == 1;
         });
       }},
      {"the block is hidden", Kind::fact, "block", 1.9, 2.1,
       [](SaidSession& s) { s.say("arm", 2, "hide block"); }},
  };
  for (const Regression& regression : regressions) {
    SaidSession changed = session;
    regression.change(changed);
    const auto run = trackOf(cell, changed);
    ASSERT_TRUE(run.ok());
    expectNamed(regression, judgeRun({}, {&*accepted}, *run));
  }
  SaidSession again = session;
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 0.004 * kDegree);
  for (std::size_t joint = 0; joint < 7; ++joint) {
    again.joint("kuka", joint, 0, 1e9, [&](double value, double) { return value + noise(random); });
  }
  again.times("", [](double at) { return at * 0.9998 + 0.3; });
  const auto run = trackOf(cell, again);
  ASSERT_TRUE(run.ok());
  expectSilent("noise, another start and a clock 200 ppm off", judgeRun({}, {&*accepted}, *run));
}

}  // namespace
}  // namespace rocinante
