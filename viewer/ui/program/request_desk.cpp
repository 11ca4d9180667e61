#include "viewer/ui/program/request_desk.h"

#include <fmt/format.h>

#include <chrono>
#include <thread>

#include "core/cli/program.h"
#include "viewer/ui/program/legibility.h"
#include "viewer/ui/program/save_camera.h"
#include "viewer/ui/program/save_pose.h"

namespace rocinante {

Status RequestDesk::apply(const ViewerRequests& requests, const WindowSize& size, SteadyTime now) {
  if (requests.close) my_.window.requestClose();
  if (auto looked = look(requests, size, now); !looked) return looked;
  if (requests.mark) {
    const auto marked = my_.model.addMark(*requests.mark);
    say(marked ? fmt::format("marked: {}", *requests.mark) : marked.error().text(), !marked, now);
  }
  my_.detail.apply(requests);
  openFiles(requests.open, now);
  if (requests.beside) tellRefusal(my_.opening.showBeside(*requests.beside), now);
  tellRefusal(connect(requests), now);
  if (std::string& ended = my_.model.viewer.panels.open.ended; !ended.empty()) {
    say(std::exchange(ended, {}), false, now);
  }
  if (requests.notice) say(*requests.notice, false, now);
  if (requests.fault) say(*requests.fault, true, now);
  if (auto made = makeFiles(requests, size, now); !made) return made;
  tellNews(now);
  return {};
}

/// Clicks on the picture, and where it is seen from.
Status RequestDesk::look(const ViewerRequests& requests, const WindowSize& size, SteadyTime now) {
  if (requests.click) {
    if (auto clicked = my_.picture.click(*requests.click); !clicked) return clicked;
  }
  if (requests.point) {
    if (auto pointed = my_.picture.point(*requests.point); !pointed) return pointed;
  }
  if (requests.measure_scene) {
    const Bounds all = my_.picture.renderer().visibleBounds(my_.model.scene(), my_.model.choice());
    my_.model.viewer.fly.setSceneSize(all.empty() ? 0 : lengthOf(all.max - all.min));
  }
  if (requests.reset) my_.model.resetCamera();
  if (requests.fit || (requests.reset && my_.model.cameraName().empty())) {
    my_.model.fit(my_.picture.corners(false), size.width, size.height);
  }
  if (const auto& name = requests.built_in_camera) {
    const auto view = my_.picture.builtIn(*name, size.width, size.height);
    if (!view.ok() && scripted_) return view.error();
    view.ok() ? my_.model.useBuiltInCamera(*name, *view) : say(view.error().text(), true, now);
  }
  if (requests.fit_selected) my_.model.fit(my_.picture.corners(true), size.width, size.height);
  return {};
}

Status RequestDesk::makeFiles(const ViewerRequests& requests, const WindowSize& size,
                              SteadyTime now) {
  if (auto made = makeEvidence(requests, size, now); !made) return made;
  if (requests.save_camera) {
    if (auto added = addCamera(*requests.save_camera, now); !added) return added;
  }
  if (requests.save_pose) {
    const auto saved = savePoses(my_.model, my_.shown.cell, *requests.save_pose);
    if (scripted_ && !saved.ok()) return saved.error();
    say(saved.ok() ? *saved : saved.error().text(), !saved.ok(), now);
  }
  if (requests.legibility) {
    if (auto told = writeLegibility(*requests.legibility, my_.model); !told) return told;
  }
  if (requests.screenshot) screenshots_.push_back(*requests.screenshot);
  if (!requests.save_live && !requests.save_file) return {};
  return saveLive(requests.save_file.value_or(""), now);
}

/// By child programs.
Status RequestDesk::makeEvidence(const ViewerRequests& requests, const WindowSize& size,
                                 SteadyTime now) {
  EvidenceDesk& evidence = my_.evidence;
  if (requests.evidence) evidence.ask(my_.model, size, now);
  if (requests.evidence_file && scripted_) {
    if (auto made = evidence.make(my_.model, size, *requests.evidence_file); !made) return made;
  } else if (requests.evidence_file) {
    evidence.ask(my_.model, size, now, *requests.evidence_file);
  }
  Status made;
  if (requests.video) {
    made = evidence.makeVideo(my_.model, size, *requests.video, now, scripted_);
  } else if (requests.golden_case) {
    const auto& [name, suite] = *requests.golden_case;
    made = evidence.addCase(my_.model, size, name, suite, now, scripted_);
  }
  if (scripted_ || made) return made;
  say(made.error().text(), true, now);
  return {};
}

Status RequestDesk::addCamera(const std::string& name, SteadyTime now) {
  my_.preview.pause();  // the cell changes
  const Status saved = saveCamera(my_.model, my_.shown.cell, name);
  if (scripted_ && !saved) return saved;
  my_.picture.changed();
  say(saved ? "camera " + name + " added to " + my_.shown.cell.string() : saved.error().text(),
      !saved, now);
  return {};
}

Status RequestDesk::saveLive(const std::filesystem::path& file, SteadyTime now) {
  if (scripted_) {
    const auto made = saving_.make(my_.model, file);
    if (!made.ok()) return made.error();
    say(made->text, made->is_fault, now);
    return {};
  }
  const Status begun = saving_.ask(my_.model, file);
  say(begun ? "the live session is being saved ..." : begun.error().text(), !begun, now);
  return {};
}

/// Says what became of work that was begun earlier.
void RequestDesk::tellNews(SteadyTime now) {
  if (LogStudy* const study = my_.model.session() != nullptr ? my_.model.study() : nullptr) {
    if (const auto table = study->takeTable()) {
      say(table->ok() ? **table : table->error().text(), !table->ok(), now);
    }
  }
  if (const auto news = saving_.look(my_.model)) say(news->text, news->is_fault, now);
  my_.evidence.look(now);
}

void RequestDesk::finish(SteadyTime now) {
  using Clock = std::chrono::steady_clock;
  const auto isMaking = [this] { return my_.evidence.isMaking() || isSaving(); };
  if (!isMaking()) return;
  const Clock::time_point tell_at = Clock::now() + std::chrono::seconds(1);
  bool told = false;
  while (isMaking() && !cli::stopRequested()) {
    tellNews(now);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    if (told || Clock::now() < tell_at) continue;
    cli::warn("the window is closed; what was asked for is still being made (Ctrl-C ends it)");
    told = true;
  }
  if (my_.evidence.noticeIsFault()) my_.model.viewer.panels.doubts.push_back(my_.evidence.notice());
}

Status RequestDesk::connect(const ViewerRequests& requests) {
  if (!requests.connect.empty()) return my_.opening.connect(requests.connect);
  if (requests.to_live) return my_.opening.goBack();
  return requests.disconnect ? my_.opening.disconnect(*requests.disconnect) : Status();
}

/// What cannot be shown.
void RequestDesk::tellRefusal(const Status& begun, SteadyTime now) {
  if (begun) return;
  if (begun.error().kind == ErrorKind::refused) return say(begun.error().text(), true, now);
  my_.model.viewer.panels.notes.push_back({begun.error().text(), true, PictureNote::Of::failure});
}

}  // namespace rocinante
