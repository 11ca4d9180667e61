#include "core/behaviour/limit_suggestion.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/core/behaviour/run_test.h"

namespace rocinante {
namespace {

using test::kDemo;
using test::SaidSession;

class LimitSuggestionTest : public test::RunTest {
 protected:
  /// The demo's session with a sensor's noise, degrees, and a pause that differs, seconds.
  SessionTrack recorded(unsigned seed, double noise_deg, double pause_s) {
    std::mt19937 random(seed);
    // Of a width above zero: a distribution has no other.
    std::normal_distribution<double> noise(0, std::max(noise_deg, 1e-12) * std::numbers::pi / 180);
    const double pause = std::uniform_real_distribution<double>(0, pause_s)(random);
    SaidSession session = session_;
    for (std::size_t joint = 0; joint < 6; ++joint) {
      session.joint("arm", joint, 0, 1e9,
                    [&](double value, double) { return value + noise(random); });
    }
    session.times("", [&](double at) { return at < 8 ? at : at + pause; });
    auto track = trackOf(cell_, session);
    EXPECT_TRUE(track.ok());
    return track.ok() ? std::move(*track) : SessionTrack{};
  }

  /// How many of `fresh` further recordings differ from the first five.
  std::size_t alarms(const RunSpec& spec, const std::vector<const SessionTrack*>& accepted,
                     double noise_deg, double pause_s, unsigned fresh) {
    std::size_t count = 0;
    for (unsigned seed = 100; seed < 100 + fresh; ++seed) {
      const RunJudgement judged = judgeRun(spec, accepted, recorded(seed, noise_deg, pause_s));
      count += judged.findings.empty() ? 0 : 1;
    }
    return count;
  }

  const Cell cell_ = test::cellAt(kDemo / "demo.cell.toml");
  const SaidSession session_ = SaidSession::read(kDemo / "session.mcap");
};

TEST_F(LimitSuggestionTest, FurtherRecordingsAreTheSameWithWhatIsSuggested) {
  for (const auto& [noise_deg, pause_s] : {std::pair(0.02, 0.0), std::pair(0.005, 0.03)}) {
    std::vector<SessionTrack> tracks;
    for (unsigned seed = 1; seed <= 5; ++seed) {
      tracks.push_back(recorded(seed, noise_deg, pause_s));
    }
    std::vector<const SessionTrack*> sessions;
    for (const SessionTrack& track : tracks) sessions.push_back(&track);
    const LimitSuggestion found = suggestLimits({}, sessions);
    EXPECT_EQ(found.recordings, 5U);
    EXPECT_TRUE(found.beyond.empty()) << *found.beyond.begin();
    EXPECT_LE(alarms(found.appliedTo({}), sessions, noise_deg, pause_s, 8), 1U) << found.toml({});
    // It widens no more than it must.
    for (const auto& [item, limits] : found.own_limits) {
      EXPECT_LE(limits.joint_deg.value_or(0), 0.15) << item;
    }
  }
}

TEST_F(LimitSuggestionTest, EqualRecordingsNeedNoWiderLimit) {
  const SessionTrack track = recorded(1, 0, 0);
  const LimitSuggestion found = suggestLimits({}, {&track, &track, &track});
  EXPECT_EQ(found.toml({}), "");
  EXPECT_EQ(found.alarms_before, 0U);
  EXPECT_EQ(found.alarms, 0U);
  EXPECT_EQ(found.wanted(), 15U);
}

TEST_F(LimitSuggestionTest, WhatTheSuiteWritesStays) {
  RunSpec spec;
  spec.limits.joint_deg = 0.2;
  spec.own_limits["arm/joint1"].joint_deg = 0.4;
  LimitSuggestion found;
  found.event_ms = 36;
  found.own_limits["arm/joint1"].joint_deg = 0.3;
  found.own_limits["arm/joint2"].joint_deg = 0.3;
  EXPECT_EQ(found.toml(spec),
            "limits = { joint_deg = 0.2, event_ms = 36, \"arm/joint1\" = { joint_deg = 0.4 }, "
            "\"arm/joint2\" = { joint_deg = 0.3 } }");
}

TEST_F(LimitSuggestionTest, ThePoseOfADeviceHasItsOwnLimit) {
  std::vector<SessionTrack> tracks;
  for (const double x : {2.3, 2.302, 2.304}) {
    SaidSession session = session_;
    for (int i = 0; i < 20; ++i) {
      session.say("placer", i, fmt::format("pose arm {} -1 0.1 0 0 1 0", x));
    }
    auto track = trackOf(cell_, session);
    ASSERT_TRUE(track.ok());
    tracks.push_back(std::move(*track));
  }
  const LimitSuggestion found = suggestLimits({}, {&tracks[0], &tracks[1], &tracks[2]});
  EXPECT_EQ(found.toml({}), "limits = { \"arm\" = { pose_mm = 4 } }");
  EXPECT_EQ(found.alarms_before, 2U) << "the middle one is between the others";
}

TEST_F(LimitSuggestionTest, WhatNoLimitAcceptsIsNamed) {
  const SessionTrack track = recorded(1, 0, 0);
  SaidSession changed = session_;
  changed.replace("event \"placed\"\n", "");
  const auto other = trackOf(cell_, changed);
  ASSERT_TRUE(other.ok());
  const LimitSuggestion found = suggestLimits({}, {&track, &track, &*other});
  ASSERT_FALSE(found.beyond.empty());
  EXPECT_NE(found.beyond.begin()->find("placed"), std::string::npos);
}

}  // namespace
}  // namespace rocinante
