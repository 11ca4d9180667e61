// Deliberate changes of real sessions: the judge of runs names each regression with its item and
// time, and is silent about what differs between two recordings of one motion.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "core/cell/cell.h"
#include "golden/run/run_judge.h"
#include "tests/golden/run/said_session.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

using test::SaidSession;
using Kind = RunFinding::Kind;

constexpr double kDegree = M_PI / 180;
constexpr Nanoseconds kStep = std::chrono::milliseconds(20);

struct Regression {
  const char* what;
  Kind kind;
  const char* item;
  double from_s, until_s;  ///< where the judge must see it begin, in the accepted session
  std::function<void(SaidSession&)> change;
  const char* said = "";  ///< in the sentence
  RunAlign align = RunAlign::events;
};

std::function<double(double, double)> plus(double by) {
  return [by](double value, double) { return value + by; };
}

/// What a joint of a device had a time ago, for as long as the change lasts.
void delay(SaidSession& session, const std::string& device, std::size_t number, double by_s,
           double from = 0, double until = 1e9) {
  std::vector<std::pair<double, double>> before;
  SaidSession copy = session;
  copy.joint(device, number, 0, 1e9, [&](double value, double at) {
    before.emplace_back(at, value);
    return value;
  });
  session.joint(device, number, from, until, [&](double value, double at) {
    const auto after =
        std::ranges::upper_bound(before, at - by_s, {}, [](auto& one) { return one.first; });
    return after == before.begin() ? value : std::prev(after)->second;
  });
}

std::vector<Regression> demoRegressions() {
  std::vector<Regression> all;
  for (std::size_t joint = 0; joint < 6; ++joint) {
    static const char* const kNames[] = {"arm/joint1", "arm/joint2", "arm/joint3",
                                         "arm/joint4", "arm/joint5", "arm/joint6"};
    all.push_back({"a joint is 0.1 degrees off", Kind::joint, kNames[joint], 0, 0.1,
                   [joint](SaidSession& s) { s.joint("arm", joint, 0, 1e9, plus(0.1 * kDegree)); },
                   "offset by +0.10°"});
    all.push_back({"a joint is 0.5 degrees off from a moment on", Kind::joint, kNames[joint], 5.9,
                   6.1,
                   [joint](SaidSession& s) { s.joint("arm", joint, 6, 1e9, plus(-0.5 * kDegree)); },
                   "offset by -0.50°"});
    all.push_back({"a joint is frozen", Kind::joint, kNames[joint], 13, 15.5,
                   [joint](SaidSession& s) {
                     double held = NAN;
                     s.joint("arm", joint, 13, 17.5, [held](double value, double) mutable {
                       if (std::isnan(held)) held = value;
                       return held;
                     });
                   },
                   "frozen at"});
  }
  const auto add = [&](Regression regression) { all.push_back(std::move(regression)); };
  add({"a joint's sign is flipped", Kind::joint, "arm/joint1", 0.9, 2.2,
       [](SaidSession& s) {
         s.joint("arm", 0, 0, 1e9, [](double value, double) { return -value; });
       },
       "its sign is flipped"});
  add({"a joint's sign is flipped for two seconds", Kind::joint, "arm/joint4", 12.9, 13.9,
       [](SaidSession& s) {
         s.joint("arm", 3, 13, 15, [](double value, double) { return -value; });
       },
       "its sign is flipped"});
  add({"a joint is 50 ms late", Kind::joint, "arm/joint2", 1, 2.2,
       [](SaidSession& s) { delay(s, "arm", 1, 0.05); }, "ms late"});
  add({"another one is 50 ms late", Kind::joint, "arm/joint5", 1, 3,
       [](SaidSession& s) { delay(s, "arm", 4, 0.05); }, "ms late"});
  add({"a device is 50 ms late", Kind::joint, "gantry/x", 0, 2,
       [](SaidSession& s) { s.times("gantry", [](double at) { return at + 0.05; }); }, "ms late",
       RunAlign::origin});
  add({"a device is 50 ms late beside events in time", Kind::joint, "gantry/y", 0, 2,
       [](SaidSession& s) {
         s.times("gantry", [](double at) { return at < 0.01 ? at : at + 0.05; });
       },
       "ms late"});
  add({"the gantry stops 2 mm short", Kind::joint, "gantry/x", 1, 3,
       [](SaidSession& s) { s.joint("gantry", 0, 2, 6, plus(0.002)); }, "offset by +2.00 mm"});
  add({"the hoist is 1 mm off", Kind::joint, "gantry/z", 9.9, 11,
       [](SaidSession& s) { s.joint("gantry", 2, 10, 12, plus(-0.001)); }, ""});
  add({"the gripper does not close", Kind::joint, "gantry/grip", 4, 5,
       [](SaidSession& s) {
         s.joint("gantry", 3, 0, 1e9, [](double, double) { return 0.0; });
         s.replace("grip=0.06", "grip=0");
       },
       "frozen at"});
  add({"two joints are swapped", Kind::joint, "arm/joint2", 0, 0.1, [](SaidSession& s) {
         for (auto& said : s.packets) {
           std::vector<double> values;
           SaidSession::changedJoints(said.body, "arm", [&](double value, std::size_t) {
             values.push_back(value);
             return value;
           });
           said.body =
               SaidSession::changedJoints(said.body, "arm", [&](double value, std::size_t i) {
                 return i == 1 ? values[2] : i == 2 ? values[1] : value;
               });
         }
       }});
  add({"a value leaps for 40 ms", Kind::joint, "arm/joint3", 7.9, 8.1,
       [](SaidSession& s) { s.joint("arm", 2, 8, 8.04, plus(0.2)); }});
  add({"a value leaps for one packet", Kind::joint, "arm/joint3", 7.9, 8.1,
       [](SaidSession& s) { s.joint("arm", 2, 8.015, 8.025, plus(0.2)); }});
  add({"a motion overshoots", Kind::joint, "arm/joint1", 3.4, 4.6, [](SaidSession& s) {
         s.joint("arm", 0, 3.5, 5, [](double value, double at) {
           return value + 0.02 * std::sin((at - 3.5) / 1.5 * M_PI);
         });
       }});
  add({"a motion trembles", Kind::joint, "arm/joint6", 6.9, 7.2, [](SaidSession& s) {
         s.joint("arm", 5, 7, 9, [](double value, double at) {
           return value + 0.004 * std::sin(at * 2 * M_PI * 4);
         });
       }});
  add({"a joint drifts", Kind::joint, "arm/joint1", 4.5, 12, [](SaidSession& s) {
         s.joint("arm", 0, 4, 1e9, [](double value, double at) { return value + (at - 4) * 2e-4; });
       }});
  add({"a motion is 10 % too small", Kind::joint, "arm/joint2", 0, 3, [](SaidSession& s) {
         s.joint("arm", 1, 0, 1e9, [](double value, double) { return -0.8 + 0.9 * (value + 0.8); });
       }});
  add({"an event is missing", Kind::event, "event/placed", 11, 11.2,
       [](SaidSession& s) { s.replace("event \"placed\"\n", ""); }, "is missing"});
  add({"another event is missing", Kind::event, "event/picked", 4.5, 4.7,
       [](SaidSession& s) { s.replace("event \"picked\"\n", ""); }, "is missing"});
  add({"an event is renamed", Kind::event, "event/dropped", 11, 11.2,
       [](SaidSession& s) { s.replace("\"placed\"", "\"dropped\""); }, "was never accepted"});
  add({"an event too many", Kind::event, "event/collision", 7.9, 8.1,
       [](SaidSession& s) { s.say("arm", 8, "event \"collision\""); }, "was never accepted"});
  add({"two events are swapped", Kind::event, "event/p", 4.5, 11.2,
       [](SaidSession& s) {
         s.replace("\"picked\"", "\"x\"")
             .replace("\"placed\"", "\"picked\"")
             .replace("\"x\"", "\"placed\"");
       },
       "is out of order"});
  add({"an event is 50 ms late", Kind::event, "event/placed", 11, 11.2,
       [](SaidSession& s) {
         s.replace("event \"placed\"\n", "").say("planner", 11.154, "event \"placed\"");
         s.packets.back().source = "planner";
         s.packets.back().header = "RK1 planner@fccb779dc2 0 -";
       },
       "50 ms late"});
  add({"a pause is 300 ms longer", Kind::event, "event/placed", 11, 11.2,
       [](SaidSession& s) { s.times("", [](double at) { return at < 8 ? at : at + 0.3; }); },
       "300 ms late"});
  add({"everything after a moment is 100 ms late", Kind::event, "event/placed", 11, 11.2,
       [](SaidSession& s) { s.times("", [](double at) { return at < 6.5 ? at : at + 0.1; }); },
       "late", RunAlign::origin});
  add({"a rate is halved", Kind::rate, "arm", 0, 1.1,
       [](SaidSession& s) {
         std::size_t count = 0;
         std::erase_if(s.packets,
                       [&](const auto& said) { return said.source == "arm" && count++ % 2 == 1; });
       },
       "times a second"});
  add({"a rate is halved for five seconds", Kind::rate, "gantry", 8.5, 10.5, [](SaidSession& s) {
         std::size_t count = 0;
         std::erase_if(s.packets, [&](const auto& said) {
           return said.source == "gantry" && said.at_s > 9 && said.at_s < 14 && count++ % 2 == 1;
         });
       }});
  add({"a source falls silent for a second while it moves", Kind::joint, "gantry/x", 6.9, 7.6,
       [](SaidSession& s) { s.erase("gantry", 7, 8.5); }});
  add({"a session ends early", Kind::joint, "arm/joint2", 17.4, 19, [](SaidSession& s) {
         std::erase_if(s.packets, [](const auto& said) { return said.at_s > 17.5; });
       }});
  add({"a device never speaks", Kind::joint, "arm/joint1", 0, 0.1,
       [](SaidSession& s) { s.erase("arm", 0, 1e9); }, "no value"});
  add({"a canister stands elsewhere", Kind::pose, "canister", 0, 0.1, [](SaidSession& s) {
         s.replace("pose canister -2.4 -1 0.25", "pose canister -2.4 -1.002 0.25");
       }});
  add({"a canister is not picked up", Kind::fact, "canister", 4.4, 5, [](SaidSession& s) {
         for (auto& said : s.packets) {
           if (said.body.find("in gantry/gripper") == std::string::npos) continue;
           const std::size_t at = said.body.find("pose canister ");
           if (at != std::string::npos) said.body.erase(at, said.body.find('\n', at) - at + 1);
         }
       }});
  add({"a drawing is missing", Kind::drawing, "drawing/planner/stops", 0.2, 0.5,
       [](SaidSession& s) { s.replace("points stops", "points other"); }});
  add({"a drawing has another colour", Kind::drawing, "drawing/planner/carry", 0.2, 0.5,
       [](SaidSession& s) { s.replace("line carry #00b7ffe0", "line carry #00b700e0"); }});
  add({"a drawing is 5 mm elsewhere", Kind::drawing, "drawing/planner/stops", 0.2, 0.5,
       [](SaidSession& s) { s.replace("1.25 -1 0.55\n", "1.255 -1 0.55\n"); }});
  add({"a label says something else", Kind::drawing, "drawing/planner/load", 4.4, 4.8,
       [](SaidSession& s) { s.replace("32 kg", "33 kg"); }});
  add({"a device is hidden", Kind::fact, "arm", 8.9, 9.2,
       [](SaidSession& s) { s.say("viewer", 9, "hide arm"); }});
  add({"a device that nobody knows is added", Kind::fact, "canister_9", 8.9, 9.2,
       [](SaidSession& s) { s.say("planner", 9, "add canister_9 canister"); }});
  return all;
}

std::string textOfFindings(const RunJudgement& judged) {
  std::string text = judged.rule + "\n";
  for (const RunFinding& finding : judged.findings) {
    text += fmt::format("  {} [{}] {}\n", nameOf(finding.kind), finding.item, finding.what);
  }
  return text;
}

class RunRegressions : public testing::Test {
 protected:
  Result<SessionTrack> trackOf(const Cell& cell, const SaidSession& session) {
    session.write(folder_ / "run.mcap");
    return trackSession(cell, folder_ / "run.mcap", kStep);
  }

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

  static void expectSilent(const char* what, const RunJudgement& judged) {
    EXPECT_TRUE(judged.comparable && judged.findings.empty()) << what << "\n"
                                                              << textOfFindings(judged);
  }

  test::TemporaryFolder folder_;
};

Cell cellAt(const std::filesystem::path& path) {
  CellOptions options;
  options.geometry = false;
  auto cell = loadCell(path, options);
  EXPECT_TRUE(cell.ok());
  return cell.ok() ? std::move(*cell) : Cell{};
}

const std::filesystem::path kDemo = std::filesystem::path(ROCINANTE_SOURCE_DIR) / "examples/demo";

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
            judged.findings.end());
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
  const std::vector<Regression> regressions = {
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
  };
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

}  // namespace
}  // namespace rocinante
