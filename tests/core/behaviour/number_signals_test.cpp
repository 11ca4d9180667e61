// Numbers of signals in a run: judged beside the accepted ones by limits of their own.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "core/behaviour/limit_suggestion.h"
#include "core/behaviour/number_recorder.h"
#include "core/behaviour/run_coverage.h"
#include "core/behaviour/run_judge.h"
#include "core/packet/decoder.h"
#include "core/session/message_folder.h"
#include "tests/core/behaviour/run_test.h"

namespace rocinante {
namespace {

using test::kDemo;
using test::SaidSession;
using test::textOfFindings;

constexpr double kSeconds = 6;

using Curve = std::function<double(double at_s)>;

/// What a joint's drive says of a motion that lifts and sets down.
double torque(double at_s) { return 20 * std::sin(1.3 * at_s) + 6 * std::sin(4.1 * at_s + 1); }

/// `arm` stands still; its elbow's torque is said with its packets.
SaidSession drive(const Curve& curve, double rate_hz = 125, double phase_s = 0) {
  SaidSession session;
  std::size_t count = 0;
  for (double at = 0; at < kSeconds; at = phase_s + static_cast<double>(count) / rate_hz) {
    const std::string said = count == 0
                                 ? fmt::format("signal arm elbow.effort {:.17g} N.m", curve(at))
                                 : fmt::format("signals arm elbow.effort={:.17g}", curve(at));
    session.packets.push_back({at, "arm", fmt::format("RK1 arm@0a {} -", count),
                               "joints arm 0 0 0 0 0 0\n" + said + "\n"});
    ++count;
  }
  return session;
}

SaidSession withNoise(double deviation, unsigned seed, const Curve& curve = torque) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, deviation);
  return drive([&](double at_s) { return curve(at_s) + noise(random); });
}

class NumberSignals : public test::RunTest {
 protected:
  SessionTrack need(const SaidSession& session) {
    auto track = trackOf(cell_, session);
    EXPECT_TRUE(track.ok()) << (track.ok() ? "" : track.error().text());
    return track.ok() ? std::move(*track) : SessionTrack{};
  }
  RunJudgement judged(const SaidSession& accepted, const SaidSession& run, RunSpec spec = {}) {
    spec.align = RunAlign::origin;
    const SessionTrack first = need(accepted);
    return judgeRun(spec, {&first}, need(run));
  }

  const Cell cell_ = test::cellAt(kDemo / "demo.cell.toml");
};

TEST_F(NumberSignals, ATorqueTwiceAsHighForFiftyMillisecondsIsNamed) {
  const auto spike = [](double at_s) {
    return torque(at_s) * (at_s >= 3.1 && at_s < 3.15 ? 2 : 1);
  };
  const RunJudgement found = judged(drive(torque), drive(spike, 125, 0.003));
  ASSERT_EQ(found.findings.size(), 1U) << textOfFindings(found);
  const RunFinding& finding = found.findings.front();
  EXPECT_EQ(finding.kind, RunFinding::Kind::signal);
  EXPECT_EQ(finding.item, "signal arm elbow.effort");
  EXPECT_EQ(finding.unit, "N.m");
  EXPECT_NEAR(secondsOf(finding.first_run), 3.1, 0.02);
  EXPECT_NEAR(secondsOf(finding.until_accepted), 3.15, 0.02);
  // Where it is 15 N.m, so much too much; the motion about there is allowed for.
  EXPECT_NEAR(*finding.largest, std::abs(torque(3.13)), 4) << finding.what;
  EXPECT_NE(finding.what.find("N.m beyond what was accepted"), std::string::npos) << finding.what;
  EXPECT_TRUE(found.coverage.judged.contains("signal arm elbow.effort"));
  EXPECT_FALSE(finding.curve.value.empty());
}

TEST_F(NumberSignals, TheLimitThatAFindingNamesAcceptsIt) {
  const auto off = [](double at_s) { return torque(at_s) + 7; };
  const RunJudgement found = judged(drive(torque), drive(off));
  ASSERT_EQ(found.findings.size(), 1U) << textOfFindings(found);
  const std::string& accept = found.findings.front().accept;
  const std::string before = R"("signal arm elbow.effort" = { signal = )";
  ASSERT_TRUE(accept.starts_with(before)) << accept;
  RunSpec spec;
  spec.own_limits["signal arm elbow.effort"].signal = std::stod(accept.substr(before.size()));
  EXPECT_NEAR(*spec.own_limits["signal arm elbow.effort"].signal, 7, 0.5);
  expectSilent("with its limit", judged(drive(torque), drive(off), spec));
  spec.own_limits["signal arm elbow.effort"].signal = 5;
  EXPECT_EQ(judged(drive(torque), drive(off), spec).findings.size(), 1U);
  // Of the range, 52 N.m.
  spec.own_limits["signal arm elbow.effort"] = {};
  spec.own_limits["arm"].signal_share = 0.2;
  expectSilent("a fifth of the range", judged(drive(torque), drive(off), spec));
  spec.limits.signal_share = 0.2;
  spec.own_limits["arm"].signal_share = 0.1;
  EXPECT_EQ(judged(drive(torque), drive(off), spec).findings.size(), 1U);
}

TEST_F(NumberSignals, WhatIsLateOrFreshlyNoisyIsTheSame) {
  for (int late_ms = 1; late_ms < 20; ++late_ms) {
    const double late_s = late_ms / 1e3;
    expectSilent("late", judged(drive(torque), drive([&](double at_s) {
                                  return torque(std::max(0.0, at_s - late_s));
                                })));
  }
  for (const double rate_hz : {31.0, 60.0, 500.0}) {
    const RunJudgement found = judged(drive(torque), drive(torque, rate_hz, 0.001));
    const bool is_named = std::ranges::any_of(found.findings, [](const RunFinding& finding) {
      return finding.kind == RunFinding::Kind::signal;
    });
    EXPECT_FALSE(is_named) << textOfFindings(found);
  }
  const SaidSession accepted = withNoise(1.5, 1);
  for (unsigned seed = 2; seed < 22; ++seed) {
    expectSilent("noise", judged(accepted, withNoise(1.5, seed)));
  }
  const SaidSession resting = withNoise(0.3, 1, [](double) { return 4; });
  for (unsigned seed = 2; seed < 22; ++seed) {
    expectSilent("nothing but noise",
                 judged(resting, withNoise(0.3, seed, [](double) { return 4; })));
  }
  const RunJudgement louder = judged(accepted, withNoise(15, 3));
  EXPECT_EQ(louder.findings.size(), 1U) << "ten times the noise is not the same";
  // A sensor that is read once a second.
  const auto reading = [](unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0, 0.05);
    SaidSession session = drive(torque);
    for (int i = 0; i < 60; ++i) {
      session.say("battery", 0.05 + i / 10.0,
                  fmt::format("signal - voltage {:.4f} V", 24 + noise(random)));
    }
    session.times("", [](double at_s) { return at_s * 10; });
    return session;
  };
  for (unsigned seed = 2; seed < 12; ++seed) {
    expectSilent("a slow sensor", judged(reading(1), reading(seed)));
  }
}

TEST_F(NumberSignals, ASetPointThatIsSentWhenItChangesMayBeLateAndNotDifferent) {
  const auto steps = [](double late_s, double second) {
    SaidSession session = drive([](double) { return 1; });
    session.say("cell", 1 + late_s, "signal arm target 0.2 m");
    session.say("cell", 2 + late_s, "signals arm target=0.35");
    session.say("cell", 4 + late_s, fmt::format("signals arm target={}", second));
    return session;
  };
  expectSilent("15 ms later", judged(steps(0, 0.1), steps(0.015, 0.1)));
  const RunJudgement other = judged(steps(0, 0.1), steps(0, 0.14));
  ASSERT_EQ(other.findings.size(), 1U) << textOfFindings(other);
  EXPECT_NEAR(secondsOf(other.findings.front().first_run), 4, 0.03);
  EXPECT_EQ(judged(steps(0, 0.1), steps(0.1, 0.1)).findings.size(), 1U) << "100 ms late";
  const auto one = [](double at_s) {
    SaidSession session = drive([](double) { return 1; });
    session.say("cell", 1, "signal arm target 0.2 m");
    session.say("cell", at_s, "signals arm target=0.35");
    return session;
  };
  for (const auto& [at_s, how] :
       {std::pair(3.4, "; 400 ms late"), std::pair(2.5, "; 501 ms early")}) {
    const RunJudgement moved = judged(one(3), one(at_s));
    EXPECT_TRUE(moved.rule.ends_with(how)) << textOfFindings(moved);
  }
  // Another value for as long is an offset.
  SaidSession away = one(3);
  away.say("cell", 4, "signals arm target=0.55");
  away.say("cell", 4.4, "signals arm target=0.35");
  const RunJudgement offset = judged(one(3), away);
  EXPECT_TRUE(offset.rule.ends_with("; offset by +0.20 m")) << textOfFindings(offset);
}

TEST_F(NumberSignals, AConstantIsJudgedToTheBitThatCounts) {
  const auto constant = [](double value) { return [value](double) { return value; }; };
  expectSilent("rounded otherwise", judged(drive(constant(0.3)), drive(constant(0.1 + 0.2))));
  EXPECT_EQ(judged(drive(constant(0.3)), drive(constant(0.301))).findings.size(), 1U);
  EXPECT_EQ(judged(drive(constant(0)), drive(constant(1e-9))).findings.size(), 1U);
  EXPECT_EQ(judged(drive(constant(1e300)), drive(constant(-1e300))).findings.size(), 1U);
  const auto step = [](double low, double high) {
    return [low, high](double at_s) { return at_s < 3 ? low : high; };
  };
  for (const double unit : {1e-200, 1e-12, 1.0, 1e200}) {
    const RunJudgement found = judged(drive(step(unit, 9 * unit)), drive(step(9 * unit, unit)));
    ASSERT_EQ(found.findings.size(), 1U) << unit;
    EXPECT_NEAR(*found.findings.front().largest / unit, 8, 0.1) << unit;
  }
  EXPECT_EQ(judged(drive(step(1e11, 1e11 + 50)), drive(step(1e11 + 25, 1e11 + 50))).findings.size(),
            1U)
      << "a large offset is no noise";
}

TEST_F(NumberSignals, WhatOneWildValueOrNoiseAloneHidesIsNamed) {
  const auto wild = [](double at_s) { return at_s >= 3 && at_s < 3.01 ? 3.4e38 : torque(at_s); };
  const auto off = [](double at_s) { return torque(at_s) + 30; };
  EXPECT_EQ(judged(drive(wild), drive(off)).findings.size(), 1U) << "one value is no range";
  // A heartbeat: nothing in its range is different, and that is said.
  int count = 0;
  const SaidSession beat = drive([&](double) { return ++count % 2; });
  const RunJudgement found = judged(beat, drive([](double) { return 0; }));
  EXPECT_NE(accountSentence(found.coverage.left_out).find("its limit is as large as its range"),
            std::string::npos)
      << textOfFindings(found);
  RunSpec wide;
  wide.own_limits["signal arm elbow.effort"].signal = 60;
  EXPECT_NE(accountSentence(judged(drive(torque), drive(torque), wide).coverage.left_out)
                .find("its limit is as large as its range"),
            std::string::npos)
      << "the suite's own";
  wide.own_limits["signal arm elbow.effort"].signal = 40;
  EXPECT_TRUE(judged(drive(torque), drive(torque), wide).coverage.left_out.empty());
  const auto huge = [](double at_s) { return 1e43 * std::sin(3 * at_s); };
  const auto doubled = [&](double at_s) { return 2 * huge(at_s); };
  EXPECT_EQ(judged(drive(huge), drive(doubled)).findings.size(), 1U);
  const RunJudgement most =
      judged(drive([](double) { return -1.7e308; }), drive([](double) { return 1.7e308; }));
  ASSERT_EQ(most.findings.size(), 1U);
  EXPECT_EQ(most.findings.front().accept.find("nan"), std::string::npos);
}

TEST_F(NumberSignals, ADeviceThatIsCalledLikeASignalIsNone) {
  SessionTrack accepted = need(drive(torque));
  SessionTrack run = accepted;
  run.facts["visibility of signal tower/lamp"] = {
      {run.start + std::chrono::seconds(3), "hide", {}, false}};
  RunSpec spec;
  spec.align = RunAlign::origin;
  EXPECT_EQ(judgeRun(spec, {&accepted}, run).findings.size(), 1U);
  EXPECT_EQ(deviceOfItem("signal tower/lamp"), "signal tower");
}

TEST_F(NumberSignals, AnotherUnitAnotherKindAndSilenceAreNamed) {
  const SaidSession accepted = drive(torque);
  SaidSession unit = accepted;
  unit.replace("N.m", "mN.m");
  RunJudgement found = judged(accepted, unit);
  ASSERT_EQ(found.findings.size(), 1U) << textOfFindings(found);
  EXPECT_NE(found.findings.front().what.find(
                R"(unit of signal arm elbow.effort: "mN.m", accepted "N.m")"),
            std::string::npos)
      << found.findings.front().what;

  SaidSession cancelled = accepted;
  for (auto& said : cancelled.packets) {
    if (said.at_s < 3) continue;
    said.body = said.body.substr(0, said.body.find("signals"));
  }
  cancelled.say("arm", 3.001, "signal arm elbow.effort default");
  found = judged(accepted, cancelled);
  ASSERT_FALSE(found.findings.empty());
  EXPECT_NE(textOfFindings(found).find("signal arm elbow.effort: no value from 3.0"),
            std::string::npos)
      << textOfFindings(found);

  SaidSession text = accepted;
  for (auto& said : text.packets) {
    if (said.at_s < 3) continue;
    said.body = "joints arm 0 0 0 0 0 0\nsignal arm elbow.effort \"overload\"\n";
  }
  found = judged(accepted, text);
  EXPECT_NE(textOfFindings(found).find("overload"), std::string::npos) << textOfFindings(found);
}

TEST_F(NumberSignals, LostAndNewOnesAreNamed) {
  const SaidSession accepted = drive(torque);
  SaidSession without = accepted;
  for (auto& said : without.packets) said.body = "joints arm 0 0 0 0 0 0\n";
  RunJudgement found = judged(accepted, without);
  ASSERT_EQ(found.findings.size(), 1U) << textOfFindings(found);
  EXPECT_EQ(found.findings.front().what,
            "signal arm elbow.effort: not judged, since the session states no number of it");
  EXPECT_TRUE(found.coverage.lost.contains("signal arm elbow.effort"));
  found = judged(without, accepted);
  ASSERT_EQ(found.findings.size(), 1U) << textOfFindings(found);
  EXPECT_EQ(found.findings.front().what,
            "signal arm elbow.effort: no accepted session states a number of it; this one does");

  // Of an import it may be a newer one that makes more of the same bag.
  const SessionTrack first = need(without);
  SaidSession with_state = accepted;
  with_state.say("arm", 1, "signal - mode \"auto\"");
  SessionTrack run = need(with_state);
  run.is_imported = true;
  RunSpec spec;
  spec.align = RunAlign::origin;
  found = judgeRun(spec, {&first}, run);
  expectSilent("imported", found);
  EXPECT_EQ(accountSentence(found.coverage.left_out),
            "left out: 1 signal `signal arm elbow.effort` (no accepted session states it), "
            "1 signal `signal - mode` (no accepted session states it)");
  EXPECT_EQ(found.notes.size(), 1U);
}

TEST_F(NumberSignals, AMaskOfTheDeviceOrOfTheSignalCoversIt) {
  const SaidSession accepted = drive(torque);
  const SaidSession run = drive([](double at_s) { return torque(at_s) + 30; });
  for (const char* item : {"arm", "signal arm *", "signal * elbow.effort", "signal *"}) {
    RunSpec spec;
    spec.masks = {{item}};
    const RunJudgement found = judged(accepted, run, spec);
    EXPECT_TRUE(found.findings.empty()) << item << "\n" << textOfFindings(found);
    EXPECT_TRUE(found.coverage.masked.contains("signal arm elbow.effort")) << item;
  }
  RunSpec spec;
  spec.masks = {{"hand"}, {"signal hand *"}};
  EXPECT_EQ(judged(accepted, run, spec).findings.size(), 1U);
  EXPECT_EQ(deviceOfItem("signal arm/tool0 force"), "arm");
  EXPECT_EQ(deviceOfItem("signal - estop"), "-");
  EXPECT_EQ(deviceOfItem("signal my%20arm/tool0 load"), "my arm");
  EXPECT_EQ(deviceOfItem("arm/elbow"), "arm");
}

TEST(NumberRecorder, KeepsWhatWasFoldedAndNothingElse) {
  NumberRecorder::Numbers numbers;
  NumberRecorder::Rhythms rhythms;
  SampleStore store;
  NumberRecorder recorder(numbers, rhythms, store);
  SessionState state;
  recorder.begin({}, LogTime());
  const auto decoder = makeDecoder("rk1");
  const auto say = [&](const std::string& body, bool is_folded) {
    const std::string text = "RK1 a - -" + body;
    const Packet* const packet = decoder->decode(bytesOf(text));
    for (const Statement& statement : packet->statements) recorder.read(statement);
    const LogTime time(std::chrono::seconds(1));
    if (is_folded && foldPacket(state, time, *packet) == Applied::yes) {
      return recorder.keep(state, time);
    }
    recorder.drop();
    return false;
  };
  EXPECT_TRUE(say("\nsignal arm load 5 kg\n", true)) << "it is a number now";
  EXPECT_FALSE(say("\nsignals arm load=6 \n", true)) << "and stays one";
  EXPECT_FALSE(say("\nsignal arm load \"heavy\"\n", false)) << "a packet behind newer ones";
  EXPECT_FALSE(say("\nsignal arm load 7 kg\n", true));
  EXPECT_TRUE(say("\nsignal arm load 7 g\n", true)) << "another unit";
  EXPECT_TRUE(say("\nsignal arm load \"heavy\"\n", true));
  EXPECT_TRUE(say("\nsignals arm load=8\n", true));
  EXPECT_TRUE(say("\nremove arm\n", true));
  EXPECT_FALSE(say("\nremove other\n", true));
  EXPECT_FALSE(say("\nremove arm\nremove arm\n", true)) << "it has nothing left";
  EXPECT_TRUE(say("\nsignal arm load 9 kg\nsignal arm mode \"up\"\n", true));
  EXPECT_TRUE(say(" restated part=a:1/1\nsignal arm mode \"up\"\n", true))
      << "a whole restatement forgets the load";
  Account left_out;
  recorder.finish(left_out);
  EXPECT_TRUE(left_out.empty());
  ASSERT_EQ(numbers.size(), 1U);
  // 5, 6, 7, 7, none, 8, none, 9, none.
  EXPECT_EQ(numbers.at("signal arm load").rows, 9U);
}

TEST_F(NumberSignals, LimitsAreSuggestedFromRecordings) {
  std::vector<SessionTrack> tracks;
  for (int i = 0; i < 5; ++i) {
    tracks.push_back(need(drive([&](double at_s) { return torque(at_s) + 4 * i; })));
  }
  std::vector<const SessionTrack*> sessions;
  for (const SessionTrack& track : tracks) sessions.push_back(&track);
  RunSpec spec;
  spec.align = RunAlign::origin;
  spec.limits.signal_share = 0.02;
  const LimitSuggestion found = suggestLimits(spec, sessions);
  ASSERT_TRUE(found.own_limits.contains("signal arm elbow.effort"));
  EXPECT_NEAR(*found.own_limits.at("signal arm elbow.effort").signal, 8, 1);
  EXPECT_NE(found.toml(spec).find(R"("signal arm elbow.effort" = { signal = )"), std::string::npos)
      << found.toml(spec);
  expectSilent("with them", judgeRun(found.appliedTo(spec), {sessions[0], sessions[1]}, tracks[2]));
}

}  // namespace
}  // namespace rocinante
