// Judging does not depend on how many threads do it.
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "core/behaviour/limit_suggestion.h"
#include "core/behaviour/motion_judge.h"
#include "tests/core/behaviour/demo_regressions.h"
#include "tests/core/behaviour/run_test.h"

namespace rocinante {
namespace {

using test::cellAt;
using test::kDemo;
using test::plus;
using test::SaidSession;
using test::textOfFindings;

/// Four, also on a machine of one core.
void byThreads(std::size_t count, const std::function<void(std::size_t)>& task) {
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) task(i);
  };
  std::vector<std::jthread> threads;
  for (int i = 0; i < 4; ++i) threads.emplace_back(work);
}

class RunThreads : public test::RunTest {};

TEST_F(RunThreads, ManyJudgeAsOneDoes) {
  const Cell cell = cellAt(kDemo / "demo.cell.toml");
  const SaidSession session = SaidSession::read(kDemo / "session.mcap");
  SaidSession changed = session;
  changed.joint("arm", 1, 3, 6, plus(0.1)).joint("gantry", 0, 8, 1e9, plus(0.05));
  changed.say("planner", 7, "event \"collision\"");
  const std::vector<const SaidSession*> sessions{&session, &session, &changed};
  std::vector<std::filesystem::path> logs;
  for (std::size_t i = 0; i < sessions.size(); ++i) {
    logs.push_back(folder_ / (std::to_string(i) + ".mcap"));
    sessions[i]->write(logs.back());
  }
  std::vector<SessionTrack> one_by_one(logs.size()), together(logs.size());
  const auto trackInto = [&](std::vector<SessionTrack>& tracks) {
    return [&](std::size_t i) {
      auto track = trackSession(cell, logs[i]);
      ASSERT_TRUE(track.ok()) << track.error().text();
      tracks[i] = std::move(*track);
    };
  };
  forEachIndex({}, logs.size(), trackInto(one_by_one));
  forEachIndex(byThreads, logs.size(), trackInto(together));

  RunSpec spec;
  spec.limits.link_positions = true;
  const RunJudgement alone = judgeRun(spec, {&one_by_one[0], &one_by_one[1]}, one_by_one[2]);
  const RunJudgement many = judgeRun(spec, {&together[0], &together[1]}, together[2], byThreads);
  EXPECT_GE(alone.findings.size(), 3U);
  EXPECT_EQ(textOfFindings(many), textOfFindings(alone));
  EXPECT_EQ(many.notes, alone.notes);
  EXPECT_EQ(many.items, alone.items);
  EXPECT_EQ(many.values, alone.values);

  const std::vector<const SessionTrack*> recordings{&together[0], &together[1], &together[2]};
  EXPECT_EQ(suggestLimits(spec, recordings, byThreads).toml(spec),
            suggestLimits(spec, recordings).toml(spec));
}

/// However few packets are judged together, all of them are.
TEST_F(RunThreads, EveryBatchIsJudged) {
  const Cell cell = cellAt(kDemo / "demo.cell.toml");
  const SaidSession session = SaidSession::read(kDemo / "session.mcap");
  SaidSession changed = session;
  changed.joint("arm", 1, 3, 6, plus(0.1)).joint("gantry", 0, 8, 1e9, plus(0.05));
  const auto accepted = trackOf(cell, session);
  const auto run = trackOf(cell, changed);
  ASSERT_TRUE(accepted.ok() && run.ok());
  const RunSpec spec;
  const std::vector<const SessionTrack*> tracks{&*accepted};
  const TimeMap same{{{accepted->start, accepted->start}}};
  const RunTimes times{spec, tracks, *run, {same}, same};
  RunJudgement whole, by_one;
  const FastMotion fastest = judgeDevices(times, {}, whole);
  EXPECT_EQ(judgeDevices(times, {}, by_one, 1).item, fastest.item);
  EXPECT_EQ(textOfFindings(by_one), textOfFindings(whole));
  EXPECT_EQ(by_one.items, whole.items);
  EXPECT_EQ(by_one.values, whole.values);
  EXPECT_GE(whole.findings.size(), 2U);
}

}  // namespace
}  // namespace rocinante
