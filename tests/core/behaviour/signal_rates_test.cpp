// A signal that is stated regularly and then no more, or the other way round, is told; one that is
// stated when it changes is not.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <string>

#include "tests/core/behaviour/run_test.h"

namespace rocinante {
namespace {

using test::SaidSession;
using test::textOfFindings;

/// Whether a packet at a time says a signal.
using Says = std::function<bool(double at_s)>;

bool always(double /*at_s*/) { return true; }
bool never(double /*at_s*/) { return false; }
bool until5(double at_s) { return at_s < 5.0; }

class SignalRates : public test::RunTest {
 protected:
  /// 20 s at 100 Hz, with joints, so that the device is never silent.
  static SaidSession session(const Says& says, const std::string& said, double hz = 100) {
    SaidSession made;
    for (int i = 0; i < 20 * hz; ++i) {
      const double at = i / hz;
      std::string body = "joints arm 0 0 0 0 0 0\n";
      if (i == 0 || says(at)) body += said + "\n";
      made.packets.push_back({at, "plc", fmt::format("RK1 plc@0a {} -", i), body});
    }
    return made;
  }
  RunJudgement judged(const SaidSession& accepted, const SaidSession& run, RunSpec spec = {}) {
    spec.align = RunAlign::origin;
    auto first = trackOf(cell_, accepted);
    auto second = trackOf(cell_, run);
    EXPECT_TRUE(first.ok() && second.ok());
    return judgeRun(spec, {&*first}, *second);
  }

  const Cell cell_ = test::cellAt(test::kDemo / "demo.cell.toml");
};

TEST_F(SignalRates, OneThatIsStatedNoMoreIsTold) {
  for (const char* said : {"signal arm force 5 N", "signal arm clamp true",
                           "signal arm mode \"auto\"", "signal - estop false"}) {
    const RunJudgement found = judged(session(always, said), session(until5, said));
    ASSERT_EQ(found.findings.size(), 1U) << textOfFindings(found);
    const RunFinding& finding = found.findings.front();
    EXPECT_EQ(finding.kind, RunFinding::Kind::rate);
    EXPECT_NE(finding.what.find("stated 0.0 times a second, accepted 100.0, since 5.000 s"),
              std::string::npos)
        << finding.what;
    EXPECT_NEAR(secondsOf(finding.until_accepted), 20, 1.1);
    RunSpec spec;
    spec.masks = {{finding.item}};
    expectSilent("masked", judged(session(always, said), session(until5, said), spec));
  }
}

TEST_F(SignalRates, OneThatWasAcceptedAsSilentIsTold) {
  const char* const said = "signal arm clamp true";
  const RunJudgement found = judged(session(until5, said), session(always, said));
  ASSERT_EQ(found.findings.size(), 1U) << textOfFindings(found);
  EXPECT_NE(found.findings.front().what.find("stated 100.0 times a second, accepted 0.0, since 5."),
            std::string::npos)
      << found.findings.front().what;
}

TEST_F(SignalRates, APauseOrAnotherRateIsTold) {
  const char* const said = "signal arm force 5 N";
  const auto pause = [](double at_s) { return at_s < 8.23 || at_s >= 9.63; };
  RunJudgement found = judged(session(always, said), session(pause, said));
  ASSERT_EQ(found.findings.size(), 1U) << textOfFindings(found);
  EXPECT_NEAR(secondsOf(found.findings.front().first_accepted), 8.3, 0.2);
  const auto once = [](double at_s) { return std::fmod(at_s + 1e-6, 1) < 0.005; };
  found = judged(session(always, said), session(once, said));
  ASSERT_EQ(found.findings.size(), 1U) << textOfFindings(found);
  EXPECT_NE(found.findings.front().what.find("stated 1.0 times a second, accepted 100.0"),
            std::string::npos)
      << found.findings.front().what;
  // Itself once a second, and then no more.
  const auto once_until_5 = [&](double at_s) { return once(at_s) && at_s < 4.5; };
  found = judged(session(once, said), session(once_until_5, said));
  ASSERT_EQ(found.findings.size(), 1U) << textOfFindings(found);
  EXPECT_NEAR(secondsOf(found.findings.front().first_accepted), 5, 1.1);
  expectSilent("half a second",
               judged(session(always, said),
                      session([](double at_s) { return at_s < 8 || at_s >= 8.5; }, said)));
}

TEST_F(SignalRates, OneThatIsStatedWhenItChangesMayNotChange) {
  const char* const said = "signal arm force 5 N";
  for (unsigned seed = 0; seed < 30; ++seed) {
    // What dithers by its last digit, and is said when it does.
    const auto changes = [&](double share) {
      return [share, dice = std::make_shared<std::mt19937>(seed)](double) {
        return std::uniform_real_distribution<double>(0, 1)(*dice) < share;
      };
    };
    for (const double share : {0.002, 0.02, 0.2, 0.4}) {
      const RunJudgement found = judged(session(changes(share), said), session(never, said));
      expectSilent("it does not change", found);
      expectSilent("it changes", judged(session(never, said), session(changes(share), said)));
    }
  }
  // Four changes, and fewer and more of them.
  SaidSession few = session(never, said);
  for (const double at : {2.0, 6.0, 6.5, 13.0}) few.say("io", at, "signal arm lamp true");
  SaidSession one = session(never, said);
  one.say("io", 2.0, "signal arm lamp true");
  expectSilent("stated once", judged(few, one));
  expectSilent("stated more often", judged(one, few));
}

TEST_F(SignalRates, WhatIsRestatedForOthersOrAfterTheEndDoesNotCount) {
  const char* const said = "signal arm clamp true";
  SaidSession restated = session(until5, said);
  for (int i = 50; i < 200; ++i) {
    restated.packets.push_back(
        {i / 10.0 + 0.003, "plc", "RK1 plc@0a 0 - restated", "signal arm clamp true\n"});
  }
  EXPECT_EQ(judged(session(always, said), restated).findings.size(), 1U);
  SaidSession shorter = session(always, said);
  std::erase_if(shorter.packets, [](const SaidSession::Said& its) { return its.at_s > 17; });
  for (const RunFinding& finding : judged(session(always, said), shorter).findings) {
    EXPECT_FALSE(finding.item.starts_with("signal")) << finding.what;
  }
}

TEST_F(SignalRates, ADevicesSilenceTellsOfItsSignals) {
  const char* const said = "signal arm clamp true";
  SaidSession silent = session(always, said);
  std::erase_if(silent.packets,
                [](const SaidSession::Said& its) { return its.at_s > 5 && its.at_s < 12; });
  const RunJudgement found = judged(session(always, said), silent);
  ASSERT_EQ(found.findings.size(), 1U) << textOfFindings(found);
  EXPECT_EQ(found.findings.front().item, "arm");
}

TEST_F(SignalRates, JitterIsNoDifference) {
  const char* const said = "signal arm force 5 N";
  for (unsigned seed = 0; seed < 10; ++seed) {
    const auto jittered = [&](unsigned turn) {
      std::mt19937 dice(seed * 2 + turn);
      SaidSession made = session(always, said);
      made.times("", [&](double at_s) {
        return at_s + std::uniform_real_distribution<double>(0, 0.015)(dice);
      });
      return made;
    };
    expectSilent("jitter", judged(jittered(0), jittered(1)));
    const auto lossy = [dice = std::make_shared<std::mt19937>(seed)](double) {
      return (*dice)() % 10 != 0;
    };
    expectSilent("one in ten lost", judged(session(always, said), session(lossy, said)));
  }
}

}  // namespace
}  // namespace rocinante
