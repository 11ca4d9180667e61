// Booleans and texts of signals that come late, early or never: how late, since when and how long.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "tests/core/behaviour/run_test.h"

namespace rocinante {
namespace {

using test::SaidSession;
using test::textOfFindings;

class SignalStates : public test::RunTest {
 protected:
  /// 5 s at 100 Hz, each packet `jitter_s` later than the one 10 ms before would have it.
  static SaidSession session(const std::function<std::string(double at_s)>& state,
                             double jitter_s = 0) {
    SaidSession made;
    for (int i = 0; i < 500; ++i) {
      const double at = i / 100.0;
      const double late = i % 100 == 0 ? 2e-6 : i % 100 == 99 ? jitter_s : 0;
      made.packets.push_back({at + late, "plc", fmt::format("RK1 plc@0a {} -", i),
                              "joints arm 0 0 0 0 0 0\nsignal arm clamp " + state(at) + "\n"});
    }
    return made;
  }
  static SaidSession closing(double at_s) {
    return session([at_s](double at) { return at >= at_s ? "true" : "false"; });
  }
  RunFinding judged(const SaidSession& accepted, const SaidSession& run) {
    RunSpec spec;
    spec.align = RunAlign::origin;
    auto first = trackOf(cell_, accepted);
    auto second = trackOf(cell_, run);
    EXPECT_TRUE(first.ok() && second.ok());
    const RunJudgement found = judgeRun(spec, {&*first}, *second);
    EXPECT_EQ(found.findings.size(), 1U) << textOfFindings(found);
    return found.findings.empty() ? RunFinding{} : found.findings.front();
  }

  const Cell cell_ = test::cellAt(test::kDemo / "demo.cell.toml");
};

TEST_F(SignalStates, SayHowLateTheyAre) {
  const RunFinding late = judged(closing(2), closing(2.4));
  EXPECT_EQ(late.what,
            "signal arm clamp: \"false\", accepted \"true\", since 2.000 s "
            "(accepted 2.000 s); 400 ms late");
  EXPECT_NEAR(secondsOf(late.first_accepted), 2, 1e-3);
  EXPECT_NEAR(secondsOf(late.until_accepted), 2.4, 1e-3);
  const RunFinding early = judged(closing(2.4), closing(2));
  EXPECT_NE(early.what.find("; 400 ms early"), std::string::npos) << early.what;
  EXPECT_NEAR(secondsOf(early.first_accepted), 2, 1e-3);
  EXPECT_NEAR(secondsOf(early.until_accepted), 2.4, 1e-3);
}

TEST_F(SignalStates, SayThatTheyNeverCome) {
  const RunFinding never = judged(closing(2), closing(9));
  EXPECT_EQ(never.what,
            "signal arm clamp: \"false\", accepted \"true\", since 2.000 s "
            "(accepted 2.000 s); it does not come until the end");
  EXPECT_NEAR(secondsOf(never.until_accepted), 4.99, 1e-3);
  const RunFinding again = judged(session([](double at) { return at < 2 ? "true" : "false"; }),
                                  session([](double) { return "true"; }));
  EXPECT_NE(again.what.find("; it does not come until the end"), std::string::npos) << again.what;
}

TEST_F(SignalStates, APulseThatIsMissedIsNotTheNextOneLate) {
  const auto pulses = [](bool has_first) {
    return session([has_first](double at) {
      const bool is_first = at >= 1 && at < 1.5;
      return (is_first && has_first) || (at >= 3 && at < 3.5) ? "true" : "false";
    });
  };
  const RunFinding missed = judged(pulses(true), pulses(false));
  EXPECT_EQ(missed.what.find("late"), std::string::npos) << missed.what;
  EXPECT_EQ(missed.what.find("until the end"), std::string::npos) << missed.what;
  EXPECT_NEAR(secondsOf(missed.until_accepted), 1.5, 1e-3);
  const RunFinding extra = judged(pulses(false), pulses(true));
  EXPECT_EQ(extra.what.find("early"), std::string::npos) << extra.what;
  EXPECT_NEAR(secondsOf(extra.until_accepted), 1.5, 1e-3);
}

/// Of a live recording, packets are less than 10 ms apart now and then.
TEST_F(SignalStates, BeginWithThePacketThatSaysThem) {
  const auto text = [](double from) {
    return session([from](double at) { return at >= from ? "\"done\"" : "\"work\""; }, 0.0005);
  };
  const auto track = trackOf(cell_, text(2));
  ASSERT_TRUE(track.ok());
  const auto& changes = track->facts.at("signal arm clamp");
  ASSERT_EQ(changes.size(), 2U);
  EXPECT_EQ(changes[1].at - track->origin, Nanoseconds(2'000'000'000));
  EXPECT_NEAR(secondsOf(judged(text(2), text(2.5)).first_accepted), 2.0, 1e-6);
}

}  // namespace
}  // namespace rocinante
