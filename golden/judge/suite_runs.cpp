#include "golden/judge/suite_runs.h"

#include <fmt/format.h>

#include <algorithm>

#include "golden/run/run_judge.h"
#include "golden/run/session_track.h"

namespace rocinante {
namespace {

class SuiteRunJudge {
 public:
  SuiteRunJudge(const SuiteSession& session, const RunOptions& options)
      : session_(session), options_(options) {}

  Result<JudgedRun> judge(const SuiteRun& run) {
    JudgedRun judged;
    judged.name = run.name;
    judged.tags = run.tags;
    judged.line = run.line;
    judged.align = nameOf(run.spec.align);
    judged.place = static_cast<std::size_t>(&run - session_.suite().runs.data());
    const double started = options_.now_ms ? options_.now_ms() : 0;
    if (Status done = judgeInto(run, judged); !done) return done.error();
    judged.judge_ms = (options_.now_ms ? options_.now_ms() : 0) - started;
    return judged;
  }

 private:
  Status judgeInto(const SuiteRun& run, JudgedRun& judged) {
    const OpenedRecording* const log = session_.logOf(run);
    if (log == nullptr) {
      judged.rule = fmt::format("no log under test: --log {}=FILE names it", run.name);
      return {};
    }
    judged.log = log->recording.string();
    const auto& accepted = session_.manifest().runsOf(run.name);
    if (accepted.empty()) {
      judged.verdict = FrameVerdict::missing;
      judged.rule = "no log was accepted yet";
      return {};
    }
    std::vector<std::filesystem::path> logs{log->log};
    for (const AcceptedRun& one : accepted) {
      logs.push_back(session_.folder().fileOf(one));
      judged.accepted.push_back(one.log);
      if (Status there = session_.folder().verify(one); !there) {
        judged.rule = there.error().text();
        return {};
      }
    }
    const Nanoseconds step = trackStep(session_.cell(), logs);
    std::vector<SessionTrack> tracks;
    for (std::size_t i = 0; i < logs.size(); ++i) {
      if (options_.stop && options_.stop()) {
        return Error{ErrorKind::refused, "interrupted: nothing was judged",
                     session_.suite().file.string()};
      }
      auto track =
          i == 0 ? trackSession(session_.cell(), logs[i], step)
                 : options_.cache.track(session_.cell(), logs[i], accepted[i - 1].bytes, step);
      if (!track.ok()) {
        judged.rule = log->named(track.error()).text();
        return {};
      }
      tracks.push_back(std::move(*track));
    }
    std::vector<const SessionTrack*> others;
    for (std::size_t i = 1; i < tracks.size(); ++i) others.push_back(&tracks[i]);
    judged.judgement = judgeRun(run.spec, others, tracks.front());
    judged.rule = judged.judgement.rule;
    if (!judged.judgement.comparable) return {};
    judged.verdict =
        judged.judgement.findings.empty() ? FrameVerdict::same : FrameVerdict::different;
    return {};
  }

  const SuiteSession& session_;
  const RunOptions& options_;
};

}  // namespace

Result<std::vector<JudgedRun>> judgeRuns(const SuiteSession& session, const RunOptions& options) {
  std::vector<JudgedRun> judged;
  SuiteRunJudge judge(session, options);
  for (const SuiteRun* run : session.runs()) {
    auto one = judge.judge(*run);
    if (!one.ok()) return one.error();
    judged.push_back(std::move(*one));
  }
  return judged;
}

}  // namespace rocinante
