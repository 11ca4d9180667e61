#include "viewer/ui/program/evidence_desk.h"

#include <fmt/format.h>

#include "core/base/duration_text.h"
#include "viewer/ui/model/view_insets.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr Nanoseconds kNoticeStays = std::chrono::seconds(6);

/// With all nanoseconds, for the exact moment.
std::string sinceOrigin(const ViewModel& model) {
  return secondsText(model.shownTime() - model.origin(), 9);
}

}  // namespace

Result<EvidenceRequest> EvidenceDesk::requestOf(ViewModel& model, const WindowSize& size) const {
  if (model.isLive()) {
    return Error{ErrorKind::bad_argument,
                 "an evidence picture needs a log: record the session, then view the log",
                 {}};
  }
  EvidenceRequest request;
  request.cell = options_.cell;
  request.log = options_.log;
  if (model.session() != nullptr) request.at = sinceOrigin(model);
  request.camera = model.cameraName();
  request.view = model.cameraView();
  request.width = size.width;
  request.height = size.height;
  request.scale = size.scale;
  // The sample counts of llvmpipe, which draws it.
  request.samples = options_.samples > 1 ? 4 : 1;
  request.hide = model.hiddenPaths();
  request.show = model.shownPaths();
  request.insets = insetWords(model);
  request.style = model.frameStyle();
  static_cast<ModelSearch&>(request) = options_.where;
  return request;
}

void EvidenceDesk::ask(ViewModel& model, const WindowSize& size, SteadyTime now) {
  if (running_) return say("the last picture is still being drawn", true, now);
  auto request = requestOf(model, size);
  if (!request.ok()) return say(request.error().text(), true, now);
  std::error_code ignored;
  const std::string stem = (options_.log.empty() ? options_.cell : options_.log).stem().string();
  const std::string moment =
      model.session() == nullptr ? "" : secondsText(model.shownTime() - model.origin(), 3);
  request->output = freeEvidenceName(fs::current_path(ignored), stem, moment);
  auto run = EvidenceRun::start(*request);
  if (!run.ok()) return say(run.error().text(), true, now);
  running_.emplace(std::move(*run));
  say("rocinante render draws the picture ...", false, now);
}

Status EvidenceDesk::make(ViewModel& model, const WindowSize& size, const fs::path& file) {
  auto request = requestOf(model, size);
  if (!request.ok()) return request.error();
  request->output = file;
  auto run = EvidenceRun::start(*request);
  if (!run.ok()) return run.error();
  const auto made = run->wait();
  if (!made.ok()) return made.error();
  if (!made->doubt.empty()) model.doubts.push_back(made->file.string() + ": " + made->doubt);
  return {};
}

void EvidenceDesk::look(SteadyTime now) {
  if (running_) {
    if (const auto ended = running_->poll()) {
      running_.reset();
      if (ended->ok()) {
        const EvidenceMade& made = **ended;
        const std::string doubt = made.doubt.empty() ? "" : "; " + made.doubt;
        say("evidence: " + made.file.string() + doubt, !doubt.empty(), now);
      } else {
        say("no evidence picture: " + ended->error().text(), true, now);
      }
    }
  } else if (notice_until_ && now > *notice_until_) {
    notice_.clear();
    notice_until_.reset();
  }
}

void EvidenceDesk::say(std::string text, bool fault, SteadyTime now) {
  notice_ = std::move(text);
  notice_is_fault_ = fault;
  notice_until_ = now + kNoticeStays;
}

}  // namespace rocinante
