#include "viewer/ui/program/evidence_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/duration_text.h"
#include "core/kinematics/joint_values.h"
#include "viewer/ui/model/view_insets.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr Nanoseconds kNoticeStays = std::chrono::seconds(6);

/// With all nanoseconds, for the exact moment.
std::string sinceOrigin(const ViewModel& model) {
  return secondsText(model.shownTime() - model.origin(), 9);
}

bool showsBackdrop(const ViewModel& model) {
  const std::string& camera = model.backdrop->camera;
  return hasBackdrop(model.cameraName(), camera) ||
         std::ranges::any_of(model.viewer.insets, [&](const InsetChoice& choice) {
           return choice.shown && hasBackdrop(choice.inset.camera, camera);
         });
}

/// That of the picture in the window, or of its shape.
void setSize(PictureTerms& terms, const std::optional<int>& width, const WindowSize& seen) {
  terms.width = width.value_or(seen.width);
  const double larger = static_cast<double>(terms.width) / seen.width;
  terms.height = std::max(1, static_cast<int>(std::lround(seen.height * larger)));
  terms.scale = std::clamp(seen.scale * larger, kLeastScale, kLargestScale);
}

}  // namespace

Result<EvidenceRequest> EvidenceFiles::requestOf(ViewModel& model, const WindowSize& size) const {
  if (shown_.cell.empty()) {
    const std::string what = shown_.log.empty() ? "no cell is open" : "this log carries no cell";
    return Error{ErrorKind::bad_argument, what + ": a picture of it needs one", {}};
  }
  EvidenceRequest request;
  request.cell = shown_.cell;
  request.log = shown_.log;
  if (model.isLive()) {
    auto log = model.logOfShownMoment();
    if (!log.ok()) return log.error();
    request.log = std::move(*log);
  }
  if (model.session() != nullptr) request.at = sinceOrigin(model);
  if (model.beside_shown) {
    request.beside = shown_.beside;
    request.align = shown_.align;
  }
  // A built-in camera in numbers: it was fitted to this size, and to what was known then.
  if (!model.hasBuiltInCamera()) request.camera = model.cameraName();
  if (model.backdrop && model.backdrop->shown && showsBackdrop(model)) {
    request.backdrop = backdropText(shown_.backdrop, model.backdrop->camera);
    request.backdrop_offset = secondsText(model.backdrop->offset, 0);
    request.backdrop_opacity = model.backdrop->opacity;
  }
  request.view = model.cameraView();
  setSize(request, model.viewer.made_width, size);
  setTerms(model, request);
  if (model.hasBuiltInCamera()) {
    // An inset that would show the same is not shown.
    std::vector<CellInset> insets = request.insets.value_or(model.cell().insets);
    std::erase_if(insets,
                  [&](const CellInset& inset) { return inset.camera == model.cameraName(); });
    request.insets = std::move(insets);
  }
  // The sample counts of llvmpipe, which draws it.
  request.samples = samples_ > 1 ? 4 : 1;
  if (!model.moves.unsaved().empty()) {
    return Error{ErrorKind::bad_argument,
                 "poses are set by hand and not in the cell; save-pose or put-back first",
                 {}};
  }
  if (model.hand.drawn()) {
    if (model.session() != nullptr) {
      return Error{ErrorKind::bad_argument,
                   "joints are set by hand and not in the log; reset them first",
                   {}};
    }
    for (const auto& [name, values] : model.hand.joints().devices()) {
      const PosedDevice* const device = model.scene().findDevice(name);
      if (device == nullptr || device->model == nullptr) continue;
      const JointVector joints = jointsOf(*device->model, model.state().findDevice(name));
      request.joints.push_back(
          jointsText(model.cell(), name, positionalValues(*device->model, joints)));
    }
  }
  static_cast<ModelSearch&>(request) = shown_.where;
  return request;
}

void EvidenceFiles::ask(ViewModel& model, const WindowSize& size, SteadyTime now,
                        const fs::path& file) {
  if (running_) return say("the last picture is still being drawn", true, now);
  auto request = requestOf(model, size);
  if (!request.ok()) return say(request.error().text(), true, now);
  std::error_code ignored;
  const std::string stem =
      model.isLive() ? "live" : (shown_.log.empty() ? shown_.cell : shown_.log).stem().string();
  const std::string moment =
      model.session() == nullptr ? "" : secondsText(model.shownTime() - model.origin(), 3);
  request->output = file.empty() ? freeEvidenceName(fs::current_path(ignored), stem, moment) : file;
  auto run = EvidenceRun::start(*request);
  if (!run.ok()) return say(run.error().text(), true, now);
  running_.emplace(std::move(*run));
  what_ = "evidence";
  say("rocinante render draws the picture ...", false, now);
}

Status EvidenceFiles::begin(Result<EvidenceRun> run, const std::string& what, ViewModel& model,
                            SteadyTime now, bool waits) {
  if (!run.ok()) return run.error();
  if (!waits) {
    running_.emplace(std::move(*run));
    what_ = what;
    say(what + " is being made ...", false, now);
    return {};
  }
  const auto made = run->wait();
  if (!made.ok()) return made.error();
  if (!made->doubt.empty())
    model.viewer.panels.doubts.push_back(made->file.string() + ": " + made->doubt);
  return {};
}

Status EvidenceFiles::makeVideo(ViewModel& model, const WindowSize& size, const fs::path& file,
                                SteadyTime now, bool waits) {
  if (running_) return Error{ErrorKind::refused, "the last picture is still being drawn", {}};
  const TimelineCursor* const cursor = model.cursor();
  if (cursor == nullptr || !cursor->hasPart()) {
    return Error{ErrorKind::bad_argument, "choose a part first: A is its start, B its end", {}};
  }
  auto request = requestOf(model, size);
  if (!request.ok()) return request.error();
  const auto sinceStart = [&](LogTime moment) { return secondsText(moment - model.origin(), 9); };
  request->part = {sinceStart(cursor->partStart()), sinceStart(cursor->partEnd())};
  std::error_code ignored;
  const std::string stem = model.isLive() ? "live" : shown_.log.stem().string();
  const std::string from = secondsText(cursor->partStart() - model.origin(), 3);
  request->output =
      file.empty() ? freeEvidenceName(fs::current_path(ignored), stem, from, "video.mp4") : file;
  return begin(EvidenceRun::start(*request), "video", model, now, waits);
}

Status EvidenceFiles::addCase(ViewModel& model, const WindowSize& size, const std::string& name,
                              const fs::path& suite, SteadyTime now, bool waits) {
  if (running_) return Error{ErrorKind::refused, "the last picture is still being drawn", {}};
  if (model.isLive()) {
    return Error{ErrorKind::bad_argument, "save the live session first: a case is of a log", {}};
  }
  auto request = requestOf(model, size);
  if (!request.ok()) return request.error();
  if (!request->joints.empty()) {
    return Error{ErrorKind::bad_argument, "a case has no joints set by hand: reset them first", {}};
  }
  const std::string moment =
      request->at.empty() ? "" : secondsText(model.shownTime() - model.origin(), 3);
  const std::string named = !name.empty() ? name : moment.empty() ? "rest" : "at-" + moment + "s";
  return begin(
      EvidenceRun::startProgram("rocinante-golden", caseArguments(*request, suite, named), suite),
      "case " + named, model, now, waits);
}

Status EvidenceFiles::make(ViewModel& model, const WindowSize& size, const fs::path& file) {
  auto request = requestOf(model, size);
  if (!request.ok()) return request.error();
  request->output = file;
  auto run = EvidenceRun::start(*request);
  if (!run.ok()) return run.error();
  const auto made = run->wait();
  if (!made.ok()) return made.error();
  if (!made->doubt.empty())
    model.viewer.panels.doubts.push_back(made->file.string() + ": " + made->doubt);
  return {};
}

void EvidenceFiles::look(SteadyTime now) {
  if (running_) {
    if (const auto ended = running_->poll()) {
      running_.reset();
      if (ended->ok()) {
        const EvidenceMade& made = **ended;
        const std::string doubt = made.doubt.empty() ? "" : "; " + made.doubt;
        say(what_ + ": " + made.file.string() + doubt, !doubt.empty(), now);
      } else {
        say((what_ == "evidence" ? "no evidence picture: " : "no " + what_ + ": ") +
                ended->error().text(),
            true, now);
      }
    }
  } else if (notice_until_ && now > *notice_until_) {
    notice_.clear();
    notice_until_.reset();
  }
}

void EvidenceFiles::say(std::string text, bool fault, SteadyTime now) {
  notice_ = std::move(text);
  notice_is_fault_ = fault;
  notice_until_ = now + kNoticeStays;
}

}  // namespace rocinante
