#include "golden/judge/suite_runs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>

#include "core/behaviour/link_tracks.h"
#include "core/behaviour/run_judge.h"
#include "core/behaviour/session_track.h"
#include "golden/judge/model_findings.h"

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
    AcceptedCell newest;
    bool is_accepted_today = false;                    // with today's kinematics
    std::vector<const Cell*> cells{&session_.cell()};  // of the log under test, then the accepted
    for (const AcceptedRun& one : accepted) {
      judged.accepted.push_back(one.log);
      newest = options_.cell_of ? options_.cell_of(one) : AcceptedCell();
      is_accepted_today = is_accepted_today || (newest.cell == nullptr && newest.unknown.empty());
      cells.push_back(newest.cell == nullptr ? &session_.cell() : newest.cell);
    }
    const std::vector<std::string> links = linksToJudge(run.spec, session_.cell());
    std::vector<std::optional<Result<SessionTrack>>> made(cells.size());
    forEachIndex(options_.parallel, cells.size(), [&](std::size_t i) {
      if (options_.stop && options_.stop()) return;
      made[i] = i == 0 ? trackSession(*cells[i], log->log, links)
                       : trackAccepted(*cells[i], accepted[i - 1], links);
    });
    std::vector<SessionTrack> tracks;
    for (auto& track : made) {
      if (!track) {
        return Error{ErrorKind::refused, "interrupted: nothing was judged",
                     session_.suite().file.string()};
      }
      if (!track->ok()) {
        judged.rule = log->named(track->error()).text();
        return {};
      }
      tracks.push_back(std::move(**track));
    }
    std::vector<const SessionTrack*> others;
    for (std::size_t i = 1; i < tracks.size(); ++i) others.push_back(&tracks[i]);
    if (Status named = checkNames(run, tracks); !named) {
      judged.rule = named.error().what;
      return {};
    }
    RunJudgement& judgement = judged.judgement =
        judgeRun(run.spec, others, tracks.front(), options_.parallel);
    tellToolEffects(session_.cell(), tracks.front(), judgement);
    addMaskNotes(run, accepted.back(), judgement);
    if (!is_accepted_today && newest.cell != nullptr) {
      addModelFindings(*newest.cell, session_.cell(), judgement);
    } else if (!is_accepted_today) {
      addUnknownModel(newest.unknown, judgement);
    }
    judged.rule = judgement.rule;
    if (!judged.judgement.comparable) return {};
    judged.verdict =
        judged.judgement.findings.empty() ? FrameVerdict::same : FrameVerdict::different;
    return {};
  }

  Result<SessionTrack> trackAccepted(const Cell& cell, const AcceptedRun& accepted,
                                     const std::vector<std::string>& links) const {
    if (Status there = session_.folder().verify(accepted); !there) return there.error();
    return options_.cache.track(cell, session_.folder().fileOf(accepted), accepted.bytes, links);
  }

  /// Masks and limits of names that nothing has switch nothing off, or the wrong thing; nor do
  /// limits of another kind than their item.
  Status checkNames(const SuiteRun& run, const std::vector<SessionTrack>& tracks) const {
    std::set<std::string> items, numbers;
    for (const SessionTrack& track : tracks) {
      items.merge(itemsOf(track));
      for (const auto& [item, series] : track.numbers) numbers.insert(item);
    }
    std::vector<std::string> complaints = namesThatMatchNothing(run.spec, session_.cell(), items);
    std::ranges::move(limitsThatNothingTakes(run.spec, session_.cell(), items, numbers),
                      std::back_inserter(complaints));
    if (complaints.empty()) return {};
    return Error{ErrorKind::bad_argument, fmt::format("{}", fmt::join(complaints, "; ")), run.name};
  }

  static void addMaskNotes(const SuiteRun& run, const AcceptedRun& newest, RunJudgement& judged) {
    if (newest.kinematics.empty()) return;  // accepted before masks were kept
    for (const RunMask& mask : run.spec.masks) {
      const std::string text = maskText(mask);
      if (std::ranges::find(newest.masks, text) != newest.masks.end()) continue;
      judged.notes.push_back(
          fmt::format("mask `{}` was added since the last log was accepted", text));
    }
  }

  const SuiteSession& session_;
  const RunOptions& options_;
};

}  // namespace

Result<JudgedRun> judgeOneRun(const SuiteSession& session, const SuiteRun& run,
                              const RunOptions& options) {
  return SuiteRunJudge(session, options).judge(run);
}

Result<std::string> judgeAlone(const SuiteSession& session, const SuiteRun& run) {
  const std::filesystem::path& log = session.logOf(run)->log;
  const auto track = trackSession(session.cell(), log, linksToJudge(run.spec, session.cell()));
  if (!track.ok()) return track.error();
  const RunJudgement judged = judgeRun(run.spec, {&*track}, *track);
  return judged.comparable ? std::string() : judged.rule;
}

Result<std::vector<JudgedRun>> judgeRuns(const SuiteSession& session,
                                         const std::vector<const SuiteRun*>& runs,
                                         const RunOptions& options) {
  std::vector<JudgedRun> judged;
  SuiteRunJudge judge(session, options);
  for (const SuiteRun* run : runs) {
    auto one = judge.judge(*run);
    if (!one.ok()) return one.error();
    judged.push_back(std::move(*one));
  }
  return judged;
}

}  // namespace rocinante
