#include "golden/session/session_comparison.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>
#include <set>

#include "core/base/plain_text.h"
#include "core/behaviour/link_tracks.h"
#include "core/behaviour/run_judge.h"
#include "core/behaviour/session_track.h"
#include "core/behaviour/track_cache.h"
#include "core/bundle/attached_cell.h"
#include "core/log/log_reader.h"
#include "golden/judge/model_findings.h"
#include "golden/session/bisect.h"
#include "golden/why/explain_pictures.h"
#include "golden/why/run_pictures.h"

namespace rocinante {
namespace {

/// Largest numbers of pictures: of worst items, of events, and of moments between them.
constexpr std::size_t kMaxWorst = 6;
constexpr std::size_t kMaxEvents = 24;
constexpr int kBetween = 3;
constexpr int kSmallPicturePixels = 320;
/// Most moments of the other session that are compared within the slack.
constexpr std::size_t kMaxInSlack = 256;

std::string frameNameOf(const std::string& text) {
  std::string name;
  for (const char c : text) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                          (c >= '0' && c <= '9') || c == '_' || c == '.' || c == '-';
    name += is_plain ? c : '-';
  }
  return name.substr(0, 80);
}

/// What to draw of both.
struct Moment {
  std::string name;
  LogTime a{}, b{};
  bool is_worst = false;
};

/// Moments with unique names, within what both sessions have.
class MomentList {
 public:
  MomentList(LogTime from, LogTime until) : from_(from), until_(until) {}

  void add(Moment moment) {
    if (moment.a < from_ || moment.a > until_ || !times_.insert(moment.a).second) return;
    const std::string name = moment.name;
    for (int turn = 2; !names_.insert(moment.name).second; ++turn) {
      moment.name = name + "-" + std::to_string(turn);
    }
    moments_.push_back(std::move(moment));
  }
  std::vector<Moment> inOrder() {
    std::ranges::sort(moments_, {}, &Moment::a);
    return std::move(moments_);
  }

 private:
  LogTime from_, until_;
  std::set<LogTime> times_;
  std::set<std::string> names_;
  std::vector<Moment> moments_;
};

std::vector<Moment> momentsToDraw(const SessionComparison& comparison, LogTime from,
                                  LogTime until) {
  const RunJudgement& judged = comparison.run().judgement;
  MomentList moments(from, until);
  std::vector<RunFinding> worst = judged.findings;
  // That a log ends is nothing to be seen at a moment that both have.
  std::erase_if(worst, [](const RunFinding& finding) { return finding.item == "session"; });
  std::ranges::stable_sort(worst, std::greater(), severityOf);
  worst.resize(std::min(worst.size(), kMaxWorst));
  for (const RunFinding& finding : worst) {
    moments.add({"worst-" + frameNameOf(finding.item), comparison.origin_a + finding.at_accepted,
                 comparison.origin_b + finding.at_run, true});
  }
  const auto& events = comparison.events.matched;
  const std::size_t count = std::min(events.size(), kMaxEvents);
  for (std::size_t i = 0; i < count; ++i) {
    const MatchedEvent& event = events[i * events.size() / count];
    moments.add({"event-" + frameNameOf(event.text), event.a, event.b});
  }
  const auto add = [&](const std::string& name, LogTime a) {
    moments.add({name, a, judged.times.inRun(a)});
  };
  add("start", from);
  for (int i = 1; i <= kBetween; ++i) {
    add("between-" + std::to_string(i), from + (until - from) / (kBetween + 1) * i);
  }
  add("end", until);
  return moments.inOrder();
}

/// The maker of frames of one session.
Result<FrameMaker> makerOf(const std::filesystem::path& cell, const CellOptions& options,
                           Timeline session) {
  auto loaded = loadCellOrLog(cell, options);
  if (!loaded.ok()) return loaded.error();
  return FrameMaker::open(std::move(*loaded), std::move(session), Profile::reproducible);
}

/// Chooses the moment of b to compare with a moment of a. Packets arrive slightly earlier or later,
/// so during motion pictures of one moment differ although the sessions do not.
class SlackMoments {
 public:
  SlackMoments(const SessionQuestion& question, FrameMaker& a, FrameMaker& b)
      : question_(question), a_(a), b_(b) {}

  /// The moment of b within the slack around `in_b` whose state is nearest to that of a at `in_a`.
  Result<LogTime> nearest(LogTime in_a, LogTime in_b) {
    Timeline& b = *b_.session();
    if (changes_.empty()) {
      auto changes = changesOf(question_.b);
      if (!changes.ok()) return changes.error();
      changes_ = std::move(*changes);
    }
    const Nanoseconds moment = in_b - b.origin();
    const Nanoseconds slack = Nanoseconds(std::llround(question_.spec.limits.event_ms * 1e6));
    const auto from = std::ranges::lower_bound(changes_, moment - slack);
    const auto until = std::ranges::upper_bound(changes_, moment + slack);
    const auto count = static_cast<std::size_t>(until - from);
    std::vector<LogTime> candidates{in_b};
    const std::size_t taken = std::min(count, kMaxInSlack);
    for (std::size_t i = 0; i < taken; ++i) {
      candidates.push_back(b.origin() + from[static_cast<std::ptrdiff_t>(i * count / taken)]);
    }
    std::ranges::sort(candidates);
    return nearestMoment(a_.cell(), *a_.session(), in_a, b, in_b, candidates,
                         question_.spec.limits);
  }

 private:
  const SessionQuestion& question_;
  FrameMaker& a_;
  FrameMaker& b_;
  std::vector<Nanoseconds> changes_;
};

/// `time_b` is set to the time at which b was drawn.
Result<JudgedFrame> judgeMoment(FrameMaker& maker_a, FrameMaker& maker_b, LogTime time_a,
                                LogTime& time_b, const SessionQuestion& question,
                                SlackMoments* slack_moments) {
  FrameRequest request;
  static_cast<PictureTerms&>(request) = question.picture;
  request.camera = question.camera;
  request.time = time_a;
  FrameRequest request_b = request;
  // Rounding at the ends must not leave the log.
  request_b.time = std::clamp(time_b, maker_b.session()->start(), maker_b.session()->end());
  time_b = request_b.time;
  JudgedFrame judged;
  judged.frame.time = time_a;
  judged.frame.camera = question.camera;
  judged.tolerance = question.tolerance;
  StateDamage damage;
  auto golden = maker_a.frame(request, &damage);
  if (!golden.ok()) return golden.error();
  auto frame = maker_b.frame(request_b, &damage);
  if (!frame.ok()) return frame.error();
  if (!damage.empty()) {
    judged.rule = damage.text();
    return judged;
  }
  judged.comparison = compare(*frame, *golden, question.tolerance);
  if (slack_moments != nullptr && judged.comparison.verdict != Verdict::same) {
    const auto nearest = slack_moments->nearest(time_a, request_b.time);
    if (!nearest.ok()) return nearest.error();
    FrameRequest beside = request_b;
    beside.time = *nearest;
    auto frame_beside = maker_b.frame(beside);
    if (!frame_beside.ok()) return frame_beside.error();
    Comparison found = compare(*frame_beside, *golden, question.tolerance);
    // The slack can only make pictures equal. If they still differ, show the exact moment: at
    // another one moving parts would differ too, and the fault would stand out less.
    if (found.verdict == Verdict::same) {
      judged.comparison = std::move(found);
      time_b = *nearest;
      frame = std::move(frame_beside);
    }
  }
  judged.rule = judged.comparison.rule;
  judged.pixels = pictureXxh3(*frame);
  judged.verdict =
      judged.comparison.verdict == Verdict::same ? FrameVerdict::same : FrameVerdict::different;
  if (judged.verdict == FrameVerdict::same) {
    judged.thumbnail = reducedPicture(*frame, kSmallPicturePixels);
    return judged;
  }
  SceneDrawer drawer_a(maker_a), drawer_b(maker_b);
  auto why = explainBoth(*golden, {drawer_a, request}, *frame, {drawer_b, request_b});
  if (!why.ok()) return why.error();
  judged.why = std::make_shared<const FrameWhy>(std::move(*why));
  judged.drawn = std::move(*frame);
  judged.accepted = std::move(*golden);
  return judged;
}

/// b as a run that accepted a and `more_accepted`.
JudgedRun judgeBehaviour(const Cell& cell, const Cell* cell_of_b, const SessionQuestion& question,
                         const ParallelFor& parallel, SessionComparison& comparison) {
  JudgedRun run;
  run.name = "session";
  run.log = question.b.string();
  std::vector<std::filesystem::path> logs{question.a};
  logs.insert(logs.end(), question.more_accepted.begin(), question.more_accepted.end());
  for (const std::filesystem::path& log : logs) run.accepted.push_back(log.string());
  logs.push_back(question.b);
  RunSpec spec = question.spec;
  if (spec.align == RunAlign::events && comparison.events.matched.empty()) {
    spec.align = RunAlign::origin;
    run.judgement.notes.emplace_back("no event is in both; aligned at the first packets");
  }
  run.align = nameOf(spec.align);
  const std::vector<std::string> links = linksToJudge(spec, cell);
  std::vector<std::optional<Result<SessionTrack>>> made(logs.size());
  forEachIndex(parallel, logs.size(), [&](std::size_t i) {
    const bool is_b = i + 1 == logs.size() && cell_of_b != nullptr;
    made[i] = trackSession(is_b ? *cell_of_b : cell, logs[i], links);
  });
  std::vector<SessionTrack> tracks;
  for (auto& one : made) {
    Result<SessionTrack>& track = *one;
    if (!track.ok()) {
      run.rule = track.error().text();
      return run;
    }
    tracks.push_back(std::move(*track));
  }
  std::vector<const SessionTrack*> accepted;
  for (std::size_t i = 0; i + 1 < tracks.size(); ++i) accepted.push_back(&tracks[i]);
  RunJudgement judged = judgeRun(spec, accepted, tracks.back(), parallel);
  tellToolEffects(cell_of_b == nullptr ? cell : *cell_of_b, tracks.back(), judged);
  if (cell_of_b != nullptr) addModelFindings(cell, *cell_of_b, judged);
  std::ranges::move(judged.notes, std::back_inserter(run.judgement.notes));
  judged.notes = std::move(run.judgement.notes);
  run.judgement = std::move(judged);
  run.rule = run.judgement.rule;
  run.verdict = !run.judgement.comparable        ? FrameVerdict::incomparable
                : run.judgement.findings.empty() ? FrameVerdict::same
                                                 : FrameVerdict::different;
  return run;
}

/// Draws and judges the moments of both.
Status judgePictures(const SessionQuestion& question, FrameMaker& maker_a, FrameMaker& maker_b,
                     const std::function<void(const std::string&)>& tell,
                     SessionComparison& comparison) {
  Timeline& a = *maker_a.session();
  Timeline& b = *maker_b.session();
  const TimeMap& times = comparison.run().judgement.times;
  const LogTime from = std::max(a.start(), times.inAccepted(b.start()));
  const LogTime until = std::min(a.end(), times.inAccepted(b.end()));
  if (until < from) {
    return Error{ErrorKind::not_found, "the sessions have no time in common", b.log().name()};
  }
  SlackMoments slack_moments(question, maker_a, maker_b);
  maker_b.fitLike(maker_a);
  FrameRequest asked;
  asked.camera = question.camera;
  if (maker_a.asksFit(asked)) {
    comparison.report.notes.push_back("`fit` and `map` are fitted to " +
                                      plainText(question.a.string()) + " in both");
  }
  for (const Moment& moment : momentsToDraw(comparison, from, until)) {
    tell("picture " + moment.name);
    // The worst moments are beyond the slack and drawn exactly.
    SlackMoments* const slack = moment.is_worst ? nullptr : &slack_moments;
    LogTime time_b = moment.b;
    auto judged = judgeMoment(maker_a, maker_b, moment.a, time_b, question, slack);
    if (!judged.ok()) return judged.error();
    comparison.times_b.push_back(time_b);
    judged->frame.name = moment.name;
    judged->frame.case_name = moment.name;
    comparison.report.frames.push_back(std::move(*judged));
  }
  return {};
}

}  // namespace

Verdict SessionComparison::verdict() const {
  return damage.empty() ? report.verdict() : Verdict::incomparable;
}

Result<SessionComparison> judgeSessions(const std::filesystem::path& cell,
                                        const CellOptions& options, const SessionQuestion& question,
                                        const std::function<void(const std::string&)>& progress) {
  const auto tell = [&](const std::string& what) {
    if (progress) progress(what);
  };
  SessionComparison comparison;
  CellOptions kinematics = options;
  kinematics.geometry = false;
  const auto loaded = loadCellOrLog(cell, kinematics);
  if (!loaded.ok()) return loaded.error();
  auto a = Timeline::open(question.a);
  if (!a.ok()) return a.error();
  auto b = Timeline::open(question.b);
  if (!b.ok()) return b.error();
  for (const Timeline* session : {&*a, &*b}) {
    if (session->log().summary().messages == 0) {
      return Error{ErrorKind::not_found, "the log holds no message, so nothing can be compared",
                   session->log().name()};
    }
  }
  tell("events");
  const auto events_a = a->events(&comparison.damage);
  if (!events_a.ok()) return events_a.error();
  const auto events_b = b->events(&comparison.damage);
  if (!events_b.ok()) return events_b.error();
  comparison.origin_a = a->origin();
  comparison.origin_b = b->origin();
  comparison.events = alignEvents(**events_a, **events_b, a->start(), b->start());
  SuiteReport& report = comparison.report;
  report.suite = question.a.string() + " against " + question.b.string();
  report.cell = cell.string();
  report.log = question.b.string();
  tell("behaviour");
  // Where no cell is named, each is judged as its own has it.
  std::optional<Cell> own;
  if (cell == question.a && carriesCell(b->log())) {
    auto of_b = loadCellOrLog(question.b, kinematics);
    if (!of_b.ok()) return of_b.error();
    if (trackCellHash(*of_b) != trackCellHash(*loaded)) own = std::move(*of_b);
  }
  report.runs.push_back(
      judgeBehaviour(*loaded, own ? &*own : nullptr, question, options.parallel, comparison));
  const RunJudgement& judged = comparison.run().judgement;
  if (!question.pictures || !judged.comparable) return comparison;
  if (!question.more_accepted.empty() && judged.findings.empty()) {
    // Within the band a picture may differ from that of each accepted recording.
    report.notes.emplace_back("no picture was drawn: all is within the accepted recordings");
    return comparison;
  }
  auto maker_a = makerOf(cell, options, std::move(*a));
  if (!maker_a.ok()) return maker_a.error();
  auto maker_b = makerOf(cell, options, std::move(*b));
  if (!maker_b.ok()) return maker_b.error();
  report.renderer = maker_a->key().text();
  if (Status drawn = judgePictures(question, *maker_a, *maker_b, tell, comparison); !drawn) {
    return drawn.error();
  }
  drawRunPictures(maker_a->cell(), question.b, question.a, report.runs.front());
  return comparison;
}

}  // namespace rocinante
