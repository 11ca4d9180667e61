// Motion judged at every packet (docs/decisions/041): a spike of one packet is found at any rate,
// what is late by less than event_ms never is, whatever its texture.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/behaviour/link_tracks.h"
#include "core/behaviour/run_judge.h"
#include "core/kinematics/kinematics.h"
#include "core/math/transform.h"
#include "tests/core/behaviour/demo_regressions.h"
#include "tests/core/behaviour/run_test.h"

namespace rocinante {
namespace {

using test::demoRegressions;
using test::kDegree;
using test::kDemo;
using test::plus;
using test::Regression;
using test::SaidSession;
using test::textOfFindings;

/// What a hand does: no speed is above 40 degrees a second, and nothing is regular.
double handMotion(double at_s, std::size_t joint) {
  const double phase = static_cast<double>(joint);
  return kDegree * (12 * std::sin(1.9 * at_s + phase) + 1.1 * std::sin(9.7 * at_s + 2 * phase) +
                    0.15 * std::sin(37 * at_s + 3 * phase));
}

using Motion = std::function<double(double at_s, std::size_t joint)>;

SaidSession armSession(double rate_hz, double seconds, double phase_s, const Motion& motion) {
  SaidSession session;
  // Both begin at once, so that they are aligned by their first packets.
  std::size_t count = 0;
  for (double at = 0; at < seconds; at = phase_s + static_cast<double>(count) / rate_hz) {
    std::string body = "joints arm";
    for (std::size_t joint = 0; joint < 6; ++joint) {
      body += fmt::format(" {:.9f}", motion(at, joint));
    }
    session.packets.push_back({at, "arm", fmt::format("RK1 arm@0a {} -", count), body + "\n"});
    ++count;
  }
  return session;
}

class PacketMotion : public test::RunTest {
 protected:
  SessionTrack need(const SaidSession& session) {
    auto track = trackOf(cell_, session);
    EXPECT_TRUE(track.ok()) << (track.ok() ? "" : track.error().text());
    return track.ok() ? std::move(*track) : SessionTrack{};
  }
  RunJudgement judged(const SaidSession& accepted, const SaidSession& run, RunSpec spec = {}) {
    const SessionTrack first = need(accepted);
    return judgeRun(spec, {&first}, need(run));
  }
  static RunSpec byOrigin() {
    RunSpec spec;
    spec.align = RunAlign::origin;
    return spec;
  }

  const Cell cell_ = test::cellAt(kDemo / "demo.cell.toml");
};

TEST_F(PacketMotion, ASpikeOfOnePacketIsFoundAtAnyRate) {
  std::mt19937 random(3);
  std::size_t spikes = 0;
  for (const double rate_hz : {60.0, 125.0, 500.0, 1000.0, 5000.0}) {
    const double seconds = rate_hz > 500 ? 0.6 : 2;
    const SessionTrack accepted = need(armSession(rate_hz, seconds, 0, handMotion));
    for (std::size_t i = 0; i < 20; ++i, ++spikes) {
      SaidSession run = armSession(rate_hz, seconds, 0.7 / rate_hz, handMotion);
      const std::size_t margin = run.packets.size() / 10 + 1;
      const std::size_t at = margin + random() % (run.packets.size() - 2 * margin);
      const std::size_t joint = random() % 6;
      auto& said = run.packets[at];
      const double by = (i % 2 == 0 ? 1 : -1) * kDegree;
      said.body = SaidSession::changedJoints(said.body, "arm", [&](double value, std::size_t j) {
        return j == joint ? value + by : value;
      });
      const double moment = said.at_s;
      const RunJudgement found = judgeRun(byOrigin(), {&accepted}, need(run));
      SCOPED_TRACE(fmt::format("{} Hz, joint{} at {:.4f} s\n{}", rate_hz, joint + 1, moment,
                               textOfFindings(found)));
      ASSERT_FALSE(found.findings.empty());
      EXPECT_EQ(found.findings.front().item, fmt::format("arm/joint{}", joint + 1));
      EXPECT_NEAR(secondsOf(found.findings.front().at_run), moment, 0.001 + 1 / rate_hz);
      EXPECT_NE(found.findings.front().what.find("for an instant"), std::string::npos);
    }
  }
  EXPECT_EQ(spikes, 100U);
}

TEST_F(PacketMotion, ASpikeThatIsMissingIsFound) {
  const SaidSession run = armSession(250, 2, 0, handMotion);
  SaidSession accepted = run;
  accepted.joint("arm", 2, 1.0, 1.003, plus(2 * kDegree));
  const RunJudgement found = judged(accepted, run, byOrigin());
  ASSERT_FALSE(found.findings.empty());
  EXPECT_EQ(found.findings.front().item, "arm/joint3");
}

TEST_F(PacketMotion, WhatIsLateByLessThanTheLimitIsTheSameWhateverItsTexture) {
  for (const double rate_hz : {60.0, 125.0, 1000.0}) {
    const SessionTrack accepted = need(armSession(rate_hz, 3, 0, handMotion));
    for (const double late_ms : {1.0, 4.0, 7.5, 11.0, 15.0, 19.0}) {
      for (const double sign : {1.0, -1.0}) {
        const SaidSession run = armSession(rate_hz, 3, 0, [&](double at, std::size_t joint) {
          return handMotion(at - sign * late_ms / 1000, joint);
        });
        expectSilent("late", judgeRun(byOrigin(), {&accepted}, need(run)));
      }
    }
  }
}

TEST_F(PacketMotion, LostPacketsAreNoDifference) {
  for (const double rate_hz : {60.0, 125.0, 1000.0}) {
    const SaidSession whole = armSession(rate_hz, 4, 0, handMotion);
    for (unsigned seed = 1; seed <= 4; ++seed) {
      SaidSession lossy = armSession(rate_hz, 4, 0.4 / rate_hz, handMotion);
      std::mt19937 random(seed);
      std::erase_if(lossy.packets,
                    [&](const auto& said) { return said.at_s > 0 && random() % 10 == 0; });
      expectSilent("the run lost packets", judged(whole, lossy, byOrigin()));
      expectSilent("the accepted one lost packets", judged(lossy, whole, byOrigin()));
    }
  }
}

TEST_F(PacketMotion, AClockThatIsOffIsNoDifference) {
  const SaidSession session = SaidSession::read(kDemo / "session.mcap");
  for (const double ppm : {-200.0, 200.0}) {
    SaidSession run = session;
    run.times("", [&](double at) { return at * (1 + ppm * 1e-6); });
    expectSilent("events", judged(session, run));
    expectSilent("origin", judged(session, run, byOrigin()));
  }
}

TEST_F(PacketMotion, SendersInAnotherOrderAreTheSame) {
  const SaidSession session = SaidSession::read(kDemo / "session.mcap");
  SaidSession run = session;
  run.times("arm", [](double at) { return at + 0.0007; });
  run.times("planner", [](double at) { return std::max(0.0, at - 0.0004); });
  expectSilent("order", judged(session, run));
}

/// Colours, drawings, carriers: a recorder that begins later hears them restated.
TEST_F(PacketMotion, RecordersThatBeganAtOtherTimesAreTheSame) {
  const SaidSession session = SaidSession::read(kDemo / "session.mcap");
  for (const double began_s : {0.4, 1.1, 2.3, 3.7}) {
    SaidSession later = session;
    std::erase_if(later.packets, [&](const auto& said) { return said.at_s < began_s; });
    expectSilent("the run began later", judged(session, later));
    expectSilent("the run began earlier", judged(later, session));
  }
}

/// It is unknown when between two packets an object jumped.
TEST_F(PacketMotion, AnObjectThatJumpsBetweenSlowPacketsIsTheSame) {
  const auto respawn = [](double phase_s) {
    SaidSession session = armSession(125, 4, 0, handMotion);
    for (double at = phase_s; at < 4; at += 0.1) {
      session.packets.push_back(
          {at, "objects", "RK1 objects@1 0 -",
           fmt::format("pose canister {} 0 0.25 0 0 0 1\n", at < 2.03 ? -2.4 : 1.7)});
    }
    return session;
  };
  for (const double phase_s : {0.01, 0.045, 0.07, 0.099}) {
    expectSilent("phase", judged(respawn(0.02), respawn(phase_s), byOrigin()));
  }
  SaidSession elsewhere = respawn(0.02);
  elsewhere.replace("pose canister 1.7 0", "pose canister 1.71 0");
  EXPECT_FALSE(judged(respawn(0.02), elsewhere, byOrigin()).findings.empty());
}

/// A pose that is stated once, in the first moment.
TEST_F(PacketMotion, WhatIsStatedOnceIsJudged) {
  const auto placed = [](double x) {
    SaidSession session = armSession(125, 2, 0, handMotion);
    session.packets.push_back({0.001, "objects", "RK1 objects@1 0 -",
                               fmt::format("pose canister {} 0 0.25 0 0 0 1\n", x)});
    return session;
  };
  expectSilent("the same place", judged(placed(1), placed(1.0004), byOrigin()));
  const RunJudgement found = judged(placed(1), placed(1.002), byOrigin());
  ASSERT_FALSE(found.findings.empty());
  EXPECT_EQ(found.findings.front().item, "canister");
}

TEST_F(PacketMotion, NoiseIsInsideTheBandOfFiveSessions) {
  const auto noisy = [](unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0, 0.01 * kDegree);
    return armSession(125, 4, 0.0003 * seed, [&](double at, std::size_t joint) {
      return handMotion(at, joint) + noise(random);
    });
  };
  std::vector<SessionTrack> tracks;
  for (unsigned seed = 1; seed <= 5; ++seed) tracks.push_back(need(noisy(seed)));
  std::vector<const SessionTrack*> accepted;
  for (const SessionTrack& track : tracks) accepted.push_back(&track);
  for (unsigned seed = 6; seed <= 13; ++seed) {
    expectSilent("noise", judgeRun(byOrigin(), accepted, need(noisy(seed))));
  }
}

TEST_F(PacketMotion, TheLimitThatAFindingNamesAcceptsIt) {
  const SaidSession session = SaidSession::read(kDemo / "session.mcap");
  const SessionTrack accepted = need(session);
  std::size_t tried = 0;
  for (const Regression& regression : demoRegressions()) {
    if (regression.kind != RunFinding::Kind::joint || ++tried % 4 != 0) continue;
    SaidSession changed = session;
    regression.change(changed);
    const SessionTrack run = need(changed);
    RunSpec spec;
    spec.align = regression.align;
    const RunJudgement found = judgeRun(spec, {&accepted}, run);
    for (const RunFinding& finding : found.findings) {
      if (finding.accept.empty()) continue;
      OwnLimits& limits = spec.own_limits[finding.item];
      const double limit = std::stod(finding.accept.substr(finding.accept.rfind("= ") + 2));
      (finding.unit == "mm"                     ? limits.position_mm
       : finding.kind == RunFinding::Kind::pose ? limits.turn_deg
                                                : limits.joint_deg) = limit;
    }
    for (const RunFinding& finding : judgeRun(spec, {&accepted}, run).findings) {
      EXPECT_TRUE(finding.accept.empty()) << regression.what << ": " << finding.what;
    }
  }
  EXPECT_GT(tried, 20U);
}

TEST_F(PacketMotion, TheLimitOfADevicesOwnPoseJudgesNoLink) {
  const auto sessionAt = [](double x, double yaw) {
    SaidSession session = armSession(125, 2, 0, handMotion);
    for (auto& said : session.packets) {
      said.body += fmt::format("pose arm {:.4f} -1 0.1 0 0 {:.6f} {:.6f}\n", x, std::sin(yaw / 2),
                               std::cos(yaw / 2));
    }
    return session;
  };
  const SaidSession session = sessionAt(2.3, 0), changed = sessionAt(2.305, 1.5 * kDegree);
  RunSpec spec = byOrigin();
  const RunJudgement found = judged(session, changed, spec);
  ASSERT_EQ(found.findings.size(), 2U) << textOfFindings(found);
  EXPECT_EQ(found.findings[0].accept, "\"arm\" = { pose_mm = 5.2 }");
  EXPECT_EQ(found.findings[1].accept, "\"arm\" = { pose_deg = 1.6 }");
  spec.own_limits["arm"].pose_mm = 5.2;
  spec.own_limits["arm"].pose_deg = 1.6;
  EXPECT_TRUE(linksToJudge(spec, cell_).empty());
  EXPECT_EQ(spec.limitsOf("arm/tip").position_mm, kRunFloors.position_mm);
  expectSilent("a pose within its own limit", judged(session, changed, spec));
  spec.own_limits["arm"] = {};
  spec.own_limits["arm"].position_mm = 5.2;
  spec.own_limits["arm"].turn_deg = 1.6;
  expectSilent("a pose within the limit of positions", judged(session, changed, spec));
}

TEST_F(PacketMotion, ALimitOfAJointHoldsForWhatItMoves) {
  const SaidSession session = armSession(125, 2, 0, handMotion);
  SaidSession changed = session;
  changed.joint("arm", 2, 0.5, 1.5, plus(0.5 * kDegree));
  RunSpec spec = byOrigin();
  spec.limits.joint_deg = 1;
  EXPECT_TRUE(linksToJudge(spec, cell_).empty());
  expectSilent("a wider limit of joints", judged(session, changed, spec));
  spec.limits = {};
  spec.masks = {{"arm/joint3"}};
  expectSilent("a masked joint", judged(session, changed, spec));
  // A limit of the tool is one of its own.
  spec.own_limits["arm/tip"].position_mm = 1;
  links_ = linksToJudge(spec, cell_);
  ASSERT_EQ(links_, std::vector<std::string>{"arm/tip"});
  const RunJudgement found = judged(session, changed, spec);
  ASSERT_FALSE(found.findings.empty());
  ASSERT_EQ(found.findings.size(), 1U) << "its turn is not limited";
  EXPECT_EQ(found.findings.front().item, "arm/tip");
  EXPECT_EQ(found.findings.front().unit, "mm");
  spec.masks.clear();
  const RunJudgement both = judged(session, changed, spec);
  EXPECT_EQ(both.findings.front().item, "arm/joint3") << "the cause comes first";
}

TEST_F(PacketMotion, AFindingTellsHowFarTheToolIsOff) {
  const Motion rest = [](double, std::size_t joint) {
    return 0.3 + 0.1 * static_cast<double>(joint);
  };
  const SaidSession session = armSession(125, 2, 0, rest);
  SaidSession changed = session;
  changed.joint("arm", 1, 0.5, 1.5, plus(4 * kDegree)).joint("arm", 5, 0.5, 1.5, plus(kDegree));
  const SessionTrack accepted = need(session), run = need(changed);
  RunJudgement found = judgeRun(byOrigin(), {&accepted}, run);
  ASSERT_EQ(found.findings.size(), 2U) << textOfFindings(found);
  const std::string untold = found.findings[1].what;
  tellToolEffects(cell_, run, found);

  const Model& model = *cell_.modelOf(*cell_.findDevice("arm"));
  const auto tipAt = [&](double joint2) {
    JointVector joints = zeroJoints(model);
    for (std::size_t joint = 0; joint < 6; ++joint) joints.values[joint] = rest(0, joint);
    joints.values[1] += joint2;
    joints.values[5] += kDegree;
    return poseOf(linkPoses(model, joints)[*model.findLink("tip")]).position;
  };
  const double apart_mm = 1000 * lengthOf(tipAt(4 * kDegree) - tipAt(0));
  ASSERT_GT(apart_mm, 10);
  EXPECT_TRUE(found.findings[0].what.starts_with(fmt::format(
      "arm/joint2: 4.00° ({} at tip) beyond what was accepted", figureText(apart_mm, "mm"))))
      << found.findings[0].what;
  EXPECT_TRUE(found.rule.starts_with(found.findings[0].what));
  EXPECT_EQ(found.findings[1].what, untold) << "the tip lies on the axis of the last joint";
}

TEST_F(PacketMotion, AnEventComesBeforeWhatItsDelayMoves) {
  const SaidSession session = SaidSession::read(kDemo / "session.mcap");
  SaidSession changed = session;
  changed.times("", [](double at) { return at < 8 ? at : at + 0.3; });
  const RunJudgement found = judged(session, changed);
  ASSERT_GT(found.findings.size(), 2U);
  EXPECT_EQ(found.findings.front().item, "event/placed") << textOfFindings(found);
}

TEST_F(PacketMotion, ASessionThatHasLittleOfTheAcceptedTimeIsDifferent) {
  const Motion still = [](double, std::size_t) { return 0.25; };
  const SaidSession whole = armSession(125, 4, 0, still);
  expectSilent("most of it", judged(whole, armSession(125, 3, 0, still), byOrigin()));
  const RunJudgement found = judged(whole, armSession(125, 1, 0, still), byOrigin());
  ASSERT_FALSE(found.findings.empty());
  EXPECT_EQ(found.findings.front().item, "session") << textOfFindings(found);
}

TEST_F(PacketMotion, TheReportNamesWhatMayHideInAFastMotion) {
  const SaidSession session = armSession(
      125, 2, 0, [](double at, std::size_t joint) { return joint == 4 ? std::sin(at * 3) : 0.0; });
  const RunJudgement found = judged(session, session, byOrigin());
  ASSERT_EQ(found.notes.size(), 1U);
  EXPECT_NE(found.notes.front().find("arm/joint5 moves by 2."), std::string::npos)
      << found.notes.front();
}

}  // namespace
}  // namespace rocinante
