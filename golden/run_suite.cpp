#include "golden/run_suite.h"

#include <fmt/format.h>

#include <utility>

#include "core/atomic_file.h"
#include "core/bundle/attached_cell.h"
#include "core/log/log_reader.h"
#include "core/model/glob.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxFramesPerCase = 100'000;
constexpr int kThumbnailPixels = 320;

std::string momentText(Nanoseconds since_origin) {
  const std::int64_t ms = since_origin.count() / 1'000'000;
  return fmt::format("{:05}.{:03}s", ms / 1000, ms % 1000);
}

/// The moments of one case against a session.
Status addFrames(const SuiteCase& made, Timeline* session, std::vector<SuiteFrame>& frames) {
  if (session == nullptr) {
    const bool wants_time = made.moment.at || made.moment.event || made.moment.every;
    frames.push_back({made.name, &made, wants_time ? std::nullopt : std::optional(LogTime{}),
                      wants_time ? "the case names a moment, but the suite has no log" : ""});
    return {};
  }
  if (made.moment.event) {
    const auto events = session->events();
    if (!events) return events.error();
    for (const Event& event : **events) {
      if (event.text != *made.moment.event) continue;
      frames.push_back({made.name, &made, event.time + made.moment.after, ""});
      return {};
    }
    frames.push_back({made.name, &made, std::nullopt,
                      fmt::format("the log has no event \"{}\"", *made.moment.event)});
    return {};
  }
  if (made.moment.every) {
    LogTime moment = session->origin();
    for (std::size_t i = 0; moment <= session->end() && i < kMaxFramesPerCase; ++i) {
      frames.push_back(
          {made.name + "-" + momentText(moment - session->origin()), &made, moment, ""});
      moment += *made.moment.every;
    }
    return {};
  }
  if (!made.moment.at) {
    frames.push_back(
        {made.name, &made, std::nullopt, "a case over a log has one of `at`, `event` and `every`"});
    return {};
  }
  const auto moment = parseSessionTime(*made.moment.at, session->origin(), session->end());
  if (!moment.ok()) return moment.error();
  frames.push_back({made.name, &made, *moment, ""});
  return {};
}

/// Nothing judged is never yes: a moment outside the log is no moment.
void refuseMomentsOutside(const Timeline& session, std::vector<SuiteFrame>& frames) {
  for (SuiteFrame& frame : frames) {
    if (!frame.time || (*frame.time >= session.start() && *frame.time <= session.end())) continue;
    frame.why = fmt::format("its moment lies outside the log, at {:.3f} s of {:.3f} s",
                            static_cast<double>((*frame.time - session.origin()).count()) * 1e-9,
                            static_cast<double>((session.end() - session.origin()).count()) * 1e-9);
    frame.time.reset();
  }
}

}  // namespace

std::string_view nameOf(FrameVerdict verdict) {
  switch (verdict) {
    case FrameVerdict::same:
      return "same";
    case FrameVerdict::different:
      return "different";
    case FrameVerdict::missing:
      return "missing";
    case FrameVerdict::unstable:
      return "unstable";
    case FrameVerdict::incomparable:
      return "incomparable";
    case FrameVerdict::expected:
      return "expected";
    case FrameVerdict::unexpected:
      return "unexpected";
  }
  return "incomparable";
}

bool isFine(FrameVerdict verdict) {
  return verdict == FrameVerdict::same || verdict == FrameVerdict::expected;
}

SuiteSession::SuiteSession(Suite suite, Manifest manifest, FrameMaker maker, std::string session,
                           SuiteOptions options)
    : suite_(std::move(suite)),
      manifest_(std::move(manifest)),
      maker_(std::move(maker)),
      session_(std::move(session)),
      options_(std::move(options)) {}

Result<SuiteSession> SuiteSession::open(const std::filesystem::path& suite_file,
                                        const SuiteOptions& options) {
  auto suite = readSuite(suite_file);
  if (!suite.ok()) return suite.error();
  if (options.cell) suite->cell = *options.cell;
  if (options.log) suite->log = options.log;
  // A log that carries its cell is named once.
  if (suite->cell.empty() && suite->log) suite->cell = *suite->log;
  if (!suite->log && isLog(suite->cell)) suite->log = suite->cell;
  auto manifest = Manifest::read(suite->goldens);
  if (!manifest.ok()) return manifest.error();

  CellOptions cell_options;
  cell_options.search = options.search;
  cell_options.search_environment = options.search_environment;
  auto cell = loadCellOrLog(suite->cell, cell_options);
  if (!cell.ok()) return cell.error();

  std::optional<Timeline> session;
  std::string session_hash;
  if (suite->log) {
    auto reader = LogReader::open(*suite->log);
    if (!reader.ok()) return reader.error();
    auto hash = contentSha256(*reader);
    if (!hash.ok()) return hash.error();
    session_hash = *hash;
    auto timeline = Timeline::open(*suite->log);
    if (!timeline.ok()) return timeline.error();
    session = std::move(*timeline);
  }
  auto maker = FrameMaker::open(std::move(*cell), std::move(session), Profile::reproducible);
  if (!maker.ok()) return maker.error();

  SuiteSession opened(std::move(*suite), std::move(*manifest), std::move(*maker),
                      std::move(session_hash), options);
  if (auto selected = opened.selectFrames(); !selected) return selected.error();
  return opened;
}

Status SuiteSession::selectFrames() {
  for (const SuiteCase& made : suite_.cases) {
    if (auto added = addFrames(made, maker_.session(), frames_); !added) {
      return Error{added.error().kind, added.error().what,
                   fmt::format("{}:{}, case {}", suite_.file.string(), made.line, made.name)};
    }
  }
  if (maker_.session() != nullptr) refuseMomentsOutside(*maker_.session(), frames_);
  if (!options_.only.empty()) {
    std::erase_if(frames_, [&](const SuiteFrame& frame) {
      return !globMatches(options_.only, frame.name) &&
             !globMatches(options_.only, frame.suite_case->name);
    });
  }
  if (frames_.empty()) {
    return Error{ErrorKind::bad_argument, "no case is selected: nothing would be judged",
                 suite_.file.string()};
  }
  return {};
}

std::string SuiteSession::keyText(const SuiteCase& suite_case) const {
  return maker_.key().text() + " " +
         shapeText(suite_case.width, suite_case.height, suite_case.samples);
}

Result<Picture> SuiteSession::draw(const SuiteFrame& frame) {
  const SuiteCase& made = *frame.suite_case;
  FrameRequest request;
  request.time = *frame.time;
  request.camera = made.camera;
  request.width = made.width;
  request.height = made.height;
  request.samples = made.samples;
  request.hide = made.hide;
  request.show = made.show;
  return maker_.frame(request);
}

void SuiteSession::judgeAgainst(const std::vector<const AcceptedPicture*>& goldens,
                                JudgedFrame& judged) {
  for (const AcceptedPicture* golden : goldens) {
    if (golden->pixels != judged.pixels) continue;
    judged.verdict = FrameVerdict::same;
    judged.rule = "equal pixel hash";
    judged.golden = *golden;
    judged.comparison.verdict = Verdict::same;
    judged.comparison.rule = judged.rule;
    judged.thumbnail = reducedPicture(*std::exchange(judged.drawn, std::nullopt), kThumbnailPixels);
    return;
  }
  bool first = true;
  for (const AcceptedPicture* golden : goldens) {
    const auto accepted = readPng(suite_.goldens / golden->picture);
    if (!accepted.ok() || pictureXxh3(*accepted) != golden->pixels) {
      // A golden that nobody accepted must judge nothing.
      if (first) {
        judged.golden = *golden;
        judged.rule = accepted.ok()
                          ? fmt::format("golden {} is not the picture that the manifest accepted",
                                        (suite_.goldens / golden->picture).string())
                          : "the golden cannot be read: " + accepted.error().text();
      }
      continue;
    }
    const Comparison found = compare(*judged.drawn, *accepted, judged.frame.suite_case->tolerance);
    const FrameVerdict verdict = found.verdict == Verdict::same        ? FrameVerdict::same
                                 : found.verdict == Verdict::different ? FrameVerdict::different
                                                                       : FrameVerdict::incomparable;
    if (first || verdict == FrameVerdict::same) {
      judged.verdict = verdict;
      judged.rule = found.rule;
      judged.comparison = found;
      judged.golden = *golden;
      judged.accepted = *accepted;
    }
    first = false;
    if (verdict == FrameVerdict::same) return;
  }
}

Result<JudgedFrame> SuiteSession::judge(const SuiteFrame& frame) {
  JudgedFrame judged;
  judged.frame = frame;
  judged.tolerance = frame.suite_case->tolerance;
  judged.key = keyText(*frame.suite_case);
  judged.inputs = maker_.inputsHash();
  judged.session = session_;
  if (!frame.time) {
    judged.rule = frame.why;
    return judged;
  }
  const double started = options_.now_ms();
  auto drawn = draw(frame);
  const double rendered = options_.now_ms();
  judged.render_ms = rendered - started;
  if (!drawn.ok()) {
    // A camera that is not there is the suite's fault, not the renderer's: others go on.
    judged.rule = drawn.error().text();
    return judged;
  }
  judged.pixels = pictureXxh3(*drawn);
  judged.drawn = std::move(*drawn);

  std::vector<const AcceptedPicture*> goldens = manifest_.find(frame.name, judged.key);
  const SuiteCase& made = *frame.suite_case;
  if (goldens.empty() && !made.tolerance.exact) {
    const auto* near =
        manifest_.findAnyOfShape(frame.name, shapeText(made.width, made.height, made.samples));
    if (near != nullptr) goldens.push_back(near);
  }
  if (!goldens.empty()) {
    judgeAgainst(goldens, judged);
  } else if (manifest_.cases.contains(frame.name)) {
    judged.rule = fmt::format(
        "no golden for this renderer; wanted: {} (approve one here, or name a tolerance)",
        judged.key);
  } else {
    judged.verdict = FrameVerdict::missing;
    judged.rule = "no golden was ever approved for this case";
  }
  if (judged.verdict == FrameVerdict::different) {
    auto again = draw(frame);
    if (!again.ok()) return again.error();
    if (*again != *judged.drawn) {
      judged.verdict = FrameVerdict::unstable;
      judged.rule = "drawn twice, the frame differs from itself";
    }
  }
  judged.judge_ms = options_.now_ms() - rendered;
  return judged;
}

Status SuiteSession::approve(const SuiteFrame& frame, std::string by, std::string at,
                             std::string reason) {
  const auto refuse = [&](std::string why) {
    return Error{ErrorKind::refused, std::move(why), "case " + frame.name};
  };
  if (!frame.time) return refuse(frame.why);
  const auto first = draw(frame);
  if (!first.ok()) return first.error();
  const auto second = draw(frame);
  if (!second.ok()) return second.error();
  if (*first != *second) return refuse("drawn twice, the frame differs from itself: not approved");

  AcceptedPicture accepted;
  accepted.key = keyText(*frame.suite_case);
  accepted.picture = goldenFileName(frame.name, accepted.key);
  accepted.pixels = pictureXxh3(*first);
  accepted.inputs = maker_.inputsHash();
  accepted.session = session_;
  accepted.accepted_by = std::move(by);
  accepted.accepted_at = std::move(at);
  accepted.reason = std::move(reason);
  for (const AcceptedPicture* old : manifest_.find(frame.name, accepted.key)) {
    std::error_code ignored;
    // Nothing changed: who accepted it first stays.
    if (old->pixels == accepted.pixels &&
        std::filesystem::exists(suite_.goldens / old->picture, ignored)) {
      return {};
    }
  }
  std::error_code fault;
  std::filesystem::create_directories(suite_.goldens, fault);
  if (fault) {
    return Error{ErrorKind::unreadable, "cannot create: " + fault.message(),
                 suite_.goldens.string()};
  }
  if (auto written = writePng(suite_.goldens / accepted.picture, *first); !written) return written;
  manifest_.accept(frame.name, std::move(accepted));
  return {};
}

Status SuiteSession::finishApproval() { return manifest_.write(suite_.goldens); }

}  // namespace rocinante
