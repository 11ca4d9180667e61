#include "golden/judge/suite_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/plain_text.h"
#include "core/bundle/attached_cell.h"
#include "core/check/log_account.h"
#include "core/cli/opened_session.h"
#include "core/cli/program.h"
#include "core/log/log_reader.h"
#include "core/session/log_pieces.h"
#include "golden/judge/frame_coverage.h"
#include "golden/judge/frame_judge.h"
#include "golden/judge/stability.h"
#include "viewer/view/missing_meshes.h"
#include "viewer/view/view_choice.h"

namespace rocinante {
namespace {

constexpr int kThumbnailPixels = 320;

/// Frees the pictures of `same` frames, except a thumbnail.
void keepWhatReportsNeed(JudgedFrame& judged) {
  if (!isFine(judged.verdict) || judged.verdict == FrameVerdict::expected || !judged.drawn) return;
  judged.thumbnail = reducedPicture(*std::exchange(judged.drawn, std::nullopt), kThumbnailPixels);
  judged.accepted.reset();
  judged.unmasked.reset();
}

/// Sorts `--log` arguments: NAME=FILE where NAME is a run of the suite, otherwise the suite's log.
Status readLogArguments(const std::vector<std::string>& arguments, Suite& suite,
                        std::map<std::string, std::filesystem::path, std::less<>>& run_logs) {
  for (const std::string& argument : arguments) {
    const std::size_t equals = argument.find('=');
    const std::string name = argument.substr(0, equals);
    if (equals != std::string::npos &&
        std::ranges::find(suite.runs, name, &SuiteRun::name) != suite.runs.end()) {
      run_logs[name] = argument.substr(equals + 1);
      continue;
    }
    std::error_code ignored;
    if (equals != std::string::npos && !std::filesystem::exists(argument, ignored)) {
      return Error{ErrorKind::bad_argument, fmt::format("the suite has no run `{}`", name),
                   "--log " + argument};
    }
    suite.log = argument;
  }
  return {};
}

/// What no packet of the log moves, what of it became none, and that it is not the whole recording.
void tellAccount(const OpenedRecording& recording, const Cell& cell) {
  if (const auto log = LogReader::open(recording.log); log.ok() && NextPiece::missing(*log)) {
    cli::warn(kGoesOn);
  }
  const auto account = logAccount(recording.log, &cell);
  const std::string note = account.ok() ? account->note() : std::string();
  if (!note.empty()) cli::warn(note);
}

}  // namespace

const OpenedRecording* SuiteSession::logOf(const SuiteRun& run) const {
  if (const auto own = run_logs_.find(run.name); own != run_logs_.end()) return &own->second;
  return log_ ? &*log_ : nullptr;
}

std::optional<SuiteOptions> SuiteSession::optionsOf(const SuiteRun& run,
                                                    const SuiteOptions& options) const {
  const auto own = run_logs_.find(run.name);
  if (has_own_cell_ || own == run_logs_.end()) return std::nullopt;
  const auto reader = LogReader::open(own->second.log);
  if (!reader.ok() || !carriesCell(*reader)) return std::nullopt;
  SuiteOptions its = options;
  its.logs = {own->second.recording.string()};
  its.selection = {};
  its.selection.only = {run.name};
  return its;
}

Result<SuiteSession> SuiteSession::open(const std::filesystem::path& suite_file,
                                        const SuiteOptions& options) {
  auto suite = readSuite(suite_file);
  if (!suite.ok()) return suite.error();
  SuiteSession made;
  std::map<std::string, std::filesystem::path, std::less<>> run_logs;
  made.suite_ = std::make_unique<Suite>(std::move(*suite));
  Suite& the_suite = *made.suite_;
  if (options.cell) the_suite.cell = *options.cell;
  if (Status given = readLogArguments(options.logs, the_suite, run_logs); !given) {
    return given.error();
  }
  // What another program recorded becomes a log first; the suite keeps the name that it gives.
  OpenedRecording recording;
  ModelSearch search = options;
  if (the_suite.log) {
    auto opened = cli::openSession(*the_suite.log, the_suite.cell, options);
    if (!opened.ok()) return opened.error();
    recording = std::move(*opened);
    const bool is_alone = the_suite.cell.empty() || the_suite.cell == *the_suite.log;
    if (is_alone) the_suite.cell = recording.log;
    made.has_own_cell_ = !is_alone;
    // The meshes of its own robot were looked for when it was imported.
    if (is_alone && recording.imported) search = {};
  }
  for (const auto& [run, log] : run_logs) {
    auto opened = cli::openSession(log, the_suite.cell, search);
    if (!opened.ok()) return opened.error();
    made.run_logs_.emplace(run, std::move(*opened));
  }
  // Only pictures need meshes.
  const bool draws = !the_suite.cases.empty();
  auto manifest = Manifest::read(the_suite.goldens);
  if (!manifest.ok()) return manifest.error();
  made.manifest_ = std::move(*manifest);
  auto folder = GoldenFolder::of(the_suite);
  if (!folder.ok()) return folder.error();
  made.folder_ = std::move(*folder);
  made.now_ms_ = options.now_ms;

  CellOptions cell_options;
  static_cast<ModelSearch&>(cell_options) = search;
  cell_options.parallel = options.parallel;
  cell_options.geometry = draws || options.run_pictures;
  auto cell = loadCellOrLog(the_suite.cell, cell_options);
  if (!cell.ok()) return cell.error();
  if (recording.folder) {
    // A temporary log lasts as long as the session.
    cell->keeps_files = std::make_shared<
        const std::pair<std::shared_ptr<const void>, std::shared_ptr<const PrivateFolder>>>(
        cell->keeps_files, recording.folder);
  }
  made.cell_ = std::move(*cell);
  if (the_suite.log) tellAccount(recording, made.cell_);
  for (const SuiteRun& run : the_suite.runs) {
    const auto log = made.run_logs_.find(run.name);
    const bool is_here = log != made.run_logs_.end() && !made.optionsOf(run, options);
    if (is_here) tellAccount(log->second, made.cell_);
  }
  if (draws && !options.incomplete) made.incomplete_ = incompleteText(made.cell_);

  std::optional<Timeline> session;
  if (the_suite.log && draws) {
    auto reader = LogReader::open(recording.log);
    if (!reader.ok()) return reader.error();
    auto hashes = sessionHashes(*reader);
    if (!hashes.ok()) return hashes.error();
    made.session_hashes_ = std::move(*hashes);
    session = Timeline::of(std::move(*reader));
    made.origin_ = session->origin();
  }
  auto frames = planFrames(the_suite, session ? &*session : nullptr);
  if (!frames.ok()) return frames.error();
  made.all_frames_ = *frames;
  made.runs_ = selectRuns(the_suite, *frames, options.selection);
  auto selected = selectFrames(std::move(*frames), options.selection, the_suite);
  if (!selected.ok() && made.runs_.empty()) return selected.error();
  if (selected.ok()) made.frames_ = std::move(*selected);
  std::optional<std::filesystem::path> drawn_log;
  if (the_suite.log) {
    drawn_log = recording.log;
    made.log_ = std::move(recording);
  }
  made.make_drawer_ = options.drawers ? options.drawers : sceneDrawers(made.cell_, drawn_log);
  return made;
}

Result<FrameDrawer*> SuiteSession::drawer() {
  if (!drawer_) {
    auto drawer = make_drawer_();
    if (!drawer.ok()) return drawer.error();
    drawer_ = std::move(*drawer);
  }
  return drawer_.get();
}

FrameRequest SuiteSession::request(const SuiteFrame& frame) const {
  const SuiteCase& made = *frame.suite_case;
  FrameRequest request;
  request.time = *frame.time;
  request.camera = frame.camera;
  static_cast<PictureTerms&>(request) = made;
  if (made.layers) chooseLayers(*made.layers, request.hide, request.show);
  return request;
}

Result<std::string> SuiteSession::key(const SuiteCase& suite_case) {
  const auto draws = drawer();
  if (!draws.ok()) return draws.error();
  return (*draws)->renderer() + " " +
         shapeText(suite_case.width, suite_case.height, suite_case.samples);
}

Result<std::optional<CaseAreas>> SuiteSession::areas(const SuiteFrame& frame) {
  const SuiteCase& made = *frame.suite_case;
  if (made.mask.empty() && made.judge_only.empty()) return std::optional<CaseAreas>();
  if (!needsIdentity(made)) return std::optional(findAreas(made, nullptr));
  const auto draws = drawer();
  if (!draws.ok()) return draws.error();
  const auto identity = (*draws)->identity(request(frame));
  if (!identity.ok()) return identity.error();
  return std::optional(findAreas(made, &*identity));
}

Result<RunCoverage> SuiteSession::coverage(const SuiteFrame& frame) {
  const auto draws = drawer();
  if (!draws.ok()) return draws.error();
  const auto state = (*draws)->state(request(frame));
  if (!state.ok()) return state.error();
  return frameCoverage(*frame.suite_case, (*draws)->cell(), *state, origin_.value_or(LogTime{}));
}

Result<std::string> SuiteSession::instability(const SuiteFrame& frame, const Picture& drawn) {
  const auto draws = drawer();
  if (!draws.ok()) return draws.error();
  const FrameRequest wanted = request(frame);
  // As different as possible, so that leftover state shows.
  FrameRequest other = wanted;
  other.width = std::max(16, wanted.width / 2);
  other.height = std::max(16, wanted.height / 3);
  other.samples = wanted.samples == 1 ? 4 : 1;
  other.style = {};
  other.hide = {"layer/grid"};
  other.show.clear();
  if (auto another = (*draws)->frame(other); !another.ok()) return another.error();
  const auto again = (*draws)->frame(wanted);
  if (!again.ok()) return again.error();
  auto fresh_drawer = freshDrawer();
  if (!fresh_drawer.ok()) return fresh_drawer.error();
  const auto fresh = (*fresh_drawer)->frame(wanted);
  if (!fresh.ok()) return fresh.error();
  const auto found = findInstability(drawn, *again, *fresh);
  if (!found) return std::string();
  // The identity only improves the message, so an error is ignored.
  const auto identity = (*draws)->identity(wanted);
  return instabilityRule(*found, identity.ok() ? &*identity : nullptr);
}

std::vector<std::string> SuiteSession::lacks() const {
  std::vector<std::string> lacks = missingTextureTexts(cell_);
  if (!drawer_) return lacks;
  for (const std::string& warning : drawer_->warnings()) {
    lacks.push_back("a texture is not drawn: " + cell_.shown(plainText(warning)));
  }
  return lacks;
}

Result<JudgedFrame> SuiteSession::judge(const SuiteFrame& frame) {
  const SuiteCase& made = *frame.suite_case;
  const auto draws = drawer();
  if (!draws.ok()) return draws.error();
  JudgedFrame judged;
  judged.frame = frame;
  judged.tolerance = made.tolerance;
  judged.limit_from = made.limit_from;
  auto key_text = key(made);
  if (!key_text.ok()) return key_text.error();
  judged.key = std::move(*key_text);
  judged.inputs = (*draws)->inputsHash();
  judged.session = sessionHash();
  judged.decoded = decodedHash();
  if (!frame.time) {
    judged.rule = frame.why;
    return judged;
  }
  if (!incomplete_.empty()) {
    judged.rule = incomplete_;
    return judged;
  }
  const double started = now_ms_();
  auto drawn = (*draws)->frame(request(frame));
  const double rendered = now_ms_();
  judged.render_ms = rendered - started;
  if (!drawn.ok()) {
    // An unknown camera is the suite's fault, not the renderer's: other frames are still judged.
    judged.rule = drawn.error().text();
    return judged;
  }
  judged.pixels = pictureXxh3(*drawn);
  judged.drawn = std::move(*drawn);
  judged.lacks = lacks();
  auto covered = coverage(frame);
  if (!covered.ok()) return covered.error();
  judged.coverage = std::move(*covered);
  const auto case_areas = areas(frame);
  if (!case_areas.ok()) return case_areas.error();
  judgeDrawn(manifest_, folder_, *case_areas ? &**case_areas : nullptr, judged);
  applyExpectation(judged);
  if (judged.verdict != FrameVerdict::same) {
    auto rule = instability(frame, *judged.drawn);
    if (!rule.ok()) return rule.error();
    if (!rule->empty()) {
      judged.verdict = FrameVerdict::unstable;
      judged.rule = std::move(*rule);
    }
  }
  // For those who approve this picture without drawing it.
  if (*case_areas && !isFine(judged.verdict)) judged.areas = areasPicture(made, **case_areas);
  keepWhatReportsNeed(judged);
  judged.judge_ms = now_ms_() - rendered;
  return judged;
}

}  // namespace rocinante
