#include "viewer/ui/program/request_handler.h"

#include <fmt/format.h>

#include <chrono>
#include <thread>

#include "core/cli/program.h"
#include "viewer/ui/program/legibility.h"
#include "viewer/ui/program/save_camera.h"
#include "viewer/ui/program/save_pose.h"

namespace rocinante {

Status RequestHandler::apply(const ViewerRequests& requests, const WindowSize& size,
                             SteadyTime now) {
  if (requests.close) parts_.window.requestClose();
  if (auto looked = look(requests, size, now); !looked) return looked;
  if (requests.mark) {
    const auto marked = parts_.model.addMark(*requests.mark);
    say(marked ? fmt::format("marked: {}", *requests.mark) : marked.error().text(), !marked, now);
  }
  parts_.detail.apply(requests);
  openFiles(requests.open, now);
  if (requests.beside) tellRefusal(parts_.opening.showBeside(*requests.beside), now);
  tellRefusal(connect(requests), now);
  if (std::string& ended = parts_.model.viewer.panels.open.ended; !ended.empty()) {
    say(std::exchange(ended, {}), false, now);
  }
  if (requests.notice) say(*requests.notice, false, now);
  if (requests.fault) say(*requests.fault, true, now);
  if (auto made = makeFiles(requests, size, now); !made) return made;
  tellNews(now);
  return {};
}

/// Clicks on the picture, and where it is seen from.
Status RequestHandler::look(const ViewerRequests& requests, const WindowSize& size,
                            SteadyTime now) {
  if (requests.click) {
    if (auto clicked = parts_.picture.click(*requests.click); !clicked) return clicked;
  }
  if (requests.point) {
    if (auto pointed = parts_.picture.point(*requests.point); !pointed) return pointed;
  }
  if (requests.measure_scene) {
    const Bounds all =
        parts_.picture.renderer().visibleBounds(parts_.model.scene(), parts_.model.choice());
    parts_.model.viewer.fly.setSceneSize(all.empty() ? 0 : lengthOf(all.max - all.min));
  }
  if (requests.reset) parts_.model.resetCamera();
  if (requests.fit || (requests.reset && parts_.model.cameraName().empty())) {
    parts_.model.fit(parts_.picture.corners(false), size.width, size.height);
  }
  if (const auto& name = requests.built_in_camera) {
    const auto view = parts_.picture.builtIn(*name, size.width, size.height);
    if (!view.ok() && scripted_) return view.error();
    view.ok() ? parts_.model.useBuiltInCamera(*name, *view) : say(view.error().text(), true, now);
  }
  if (requests.fit_selected)
    parts_.model.fit(parts_.picture.corners(true), size.width, size.height);
  return {};
}

Status RequestHandler::makeFiles(const ViewerRequests& requests, const WindowSize& size,
                                 SteadyTime now) {
  if (auto made = makeEvidence(requests, size, now); !made) return made;
  if (requests.save_camera) {
    if (auto added = addCamera(*requests.save_camera, now); !added) return added;
  }
  if (requests.save_pose) {
    const auto saved = savePoses(parts_.model, parts_.shown.cell, *requests.save_pose);
    if (scripted_ && !saved.ok()) return saved.error();
    say(saved.ok() ? *saved : saved.error().text(), !saved.ok(), now);
  }
  if (requests.legibility) {
    if (auto written = writeLegibility(*requests.legibility, parts_.model); !written)
      return written;
  }
  if (requests.screenshot) screenshots_.push_back(*requests.screenshot);
  if (!requests.save_live && !requests.save_file) return {};
  return saveLive(requests.save_file.value_or(""), now);
}

/// By child programs.
Status RequestHandler::makeEvidence(const ViewerRequests& requests, const WindowSize& size,
                                    SteadyTime now) {
  EvidenceFiles& evidence = parts_.evidence;
  if (requests.evidence) evidence.ask(parts_.model, size, now);
  if (requests.evidence_file && scripted_) {
    if (auto made = evidence.make(parts_.model, size, *requests.evidence_file); !made) return made;
  } else if (requests.evidence_file) {
    evidence.ask(parts_.model, size, now, *requests.evidence_file);
  }
  Status made;
  if (requests.video) {
    made = evidence.makeVideo(parts_.model, size, *requests.video, now, scripted_);
  } else if (requests.golden_case) {
    const auto& [name, suite] = *requests.golden_case;
    made = evidence.addCase(parts_.model, size, name, suite, now, scripted_);
  }
  if (scripted_ || made) return made;
  say(made.error().text(), true, now);
  return {};
}

Status RequestHandler::addCamera(const std::string& name, SteadyTime now) {
  parts_.preview.pause();  // the cell changes
  const Status saved = saveCamera(parts_.model, parts_.shown.cell, name);
  if (scripted_ && !saved) return saved;
  parts_.picture.changed();
  say(saved ? "camera " + name + " added to " + parts_.shown.cell.string() : saved.error().text(),
      !saved, now);
  return {};
}

Status RequestHandler::saveLive(const std::filesystem::path& file, SteadyTime now) {
  if (scripted_) {
    const auto made = saving_.make(parts_.model, file);
    if (!made.ok()) return made.error();
    say(made->text, made->is_fault, now);
    return {};
  }
  const Status begun = saving_.ask(parts_.model, file);
  say(begun ? "the live session is being saved ..." : begun.error().text(), !begun, now);
  return {};
}

/// Says what became of work that was begun earlier.
void RequestHandler::tellNews(SteadyTime now) {
  if (LogStudy* const study = parts_.model.session() != nullptr ? parts_.model.study() : nullptr) {
    if (const auto table = study->takeTable()) {
      say(table->ok() ? **table : table->error().text(), !table->ok(), now);
    }
  }
  if (const auto news = saving_.look(parts_.model)) say(news->text, news->is_fault, now);
  parts_.evidence.look(now);
}

void RequestHandler::finish(SteadyTime now) {
  using Clock = std::chrono::steady_clock;
  const auto isMaking = [this] { return parts_.evidence.isMaking() || isSaving(); };
  if (!isMaking()) return;
  const Clock::time_point tell_at = Clock::now() + std::chrono::seconds(1);
  bool is_reported = false;
  while (isMaking() && !cli::stopRequested()) {
    tellNews(now);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    if (is_reported || Clock::now() < tell_at) continue;
    cli::warn("the window is closed; what was asked for is still being made (Ctrl-C ends it)");
    is_reported = true;
  }
  if (parts_.evidence.noticeIsFault())
    parts_.model.viewer.panels.doubts.push_back(parts_.evidence.notice());
}

Status RequestHandler::connect(const ViewerRequests& requests) {
  if (!requests.connect.empty()) return parts_.opening.connect(requests.connect);
  if (requests.to_live) return parts_.opening.goBack();
  return requests.disconnect ? parts_.opening.disconnect(*requests.disconnect) : Status();
}

/// What cannot be shown.
void RequestHandler::tellRefusal(const Status& begun, SteadyTime now) {
  if (begun) return;
  if (begun.error().kind == ErrorKind::refused) return say(begun.error().text(), true, now);
  parts_.model.viewer.panels.notes.push_back(
      {begun.error().text(), true, PictureNote::Of::failure});
}

}  // namespace rocinante
