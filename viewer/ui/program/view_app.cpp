#include "viewer/ui/program/view_app.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <optional>

#include "core/base/plain_text.h"
#include "core/cli/program.h"
#include "viewer/ui/panels/docks.h"
#include "viewer/ui/panels/panels.h"
#include "viewer/ui/program/backdrop_loader.h"
#include "viewer/ui/program/detail_choice.h"
#include "viewer/ui/program/evidence_files.h"
#include "viewer/ui/program/frame_tally.h"
#include "viewer/ui/program/moment_preview.h"
#include "viewer/ui/program/opening.h"
#include "viewer/ui/program/panel_pace.h"
#include "viewer/ui/program/picture_rest.h"
#include "viewer/ui/program/request_handler.h"
#include "viewer/ui/program/script_runner.h"
#include "viewer/ui/program/user_input.h"
#include "viewer/ui/program/viewpoint_publisher.h"
#include "viewer/ui/program/window_picture.h"
#include "viewer/ui/window/frame_due.h"
#include "viewer/ui/window/imgui_painter.h"
#include "viewer/ui/window/interface_context.h"
#include "viewer/ui/window/window.h"
#include "viewer/ui/window/window_composer.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace rocinante {
namespace {

double millisecondsSince(SteadyTime start) {
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
  return took.count();
}

class ViewApp {
 public:
  static Result<std::unique_ptr<ViewApp>> open(ViewContent& content, Window& window,
                                               const ViewOptions& options, WindowSession& session);
  ~ViewApp() {
    if (model_.isLive()) model_.feed().onNews({});
    model_.publishing.end(now(), std::chrono::system_clock::now());
  }
  ViewApp(const ViewApp&) = delete;
  ViewApp& operator=(const ViewApp&) = delete;
  /// What to show next; null: nothing, the window closes.
  Result<std::unique_ptr<ViewContent>> run();

 private:
  ViewApp(ViewContent& content, Window& window, const ViewOptions& options, WindowSession& session,
          Renderer renderer, int samples)
      : shown_(content.request),
        model_(*content.model),
        options_(options),
        opening_(session.loader, session.left, content),
        window_(&window),
        interface_(options.script.empty() ? window_ : nullptr),
        picture_(model_, std::move(renderer), samples),
        painter_(session.painter),
        detail_(options.detail, options.script.empty() && options.profile == Profile::fast,
                options.target_fps),
        evidence_(content.request, options.samples),
        requests_({shown_, model_, window, opening_, picture_, preview_, detail_, evidence_},
                  scripted()),
        publish_(model_, picture_),
        backdrop_(content.backdrop.get(), [] { glfwPostEmptyEvent(); }),
        script_(session.script),
        record_(session.record) {}

  bool scripted() const { return !options_.script.empty(); }
  /// A person's input, at the window or from a record of it: nothing waits to be asked for.
  bool isPersonal() const { return !scripted() || script_.isTimed(); }
  /// Recorded, a frame has one time, so that it can be drawn again.
  SteadyTime now() const {
    if (scripted()) return script_.now();
    return recorded_now_.value_or(std::chrono::steady_clock::now());
  }
  std::optional<float> frameSeconds();
  bool advancePreview();
  void finishPreview();
  void beginFrame();
  void prepareView();
  Status drawFrame(double app_ms);
  Status rest();
  void endLook(const Governor::Runaway& runaway);
  Status compose(bool same_picture);
  bool frameDue(bool changed) const;
  /// The scene was not drawn for a while; a script's frames do not depend on it.
  bool isStill() const { return !scripted() && tally_.isStill(now()); }
  void writeDown();
  Status applyRequests(const ViewerRequests& requests);
  void writeScreenshot(bool now_or_never);
  void waitForNews();
  Result<std::unique_ptr<ViewContent>> takeOpened();
  bool showBackdrop();
  /// Of the picture, as the panels are now.
  WindowSize size() const {
    const PixelRectangle now = part();
    return {now.width, now.height, interface_.scale()};
  }
  PixelRectangle part() const;

  const ContentRequest& shown_;
  ViewModel& model_;
  const ViewOptions& options_;
  Opening opening_;
  Window* window_;
  InterfaceContext interface_;
  WindowPicture picture_;
  MomentPreview preview_{model_};
  std::optional<ImguiPainter>& painter_;
  WindowComposer composer_;
  DetailChoice detail_;
  PictureRest rest_{picture_, detail_};
  EvidenceFiles evidence_;
  RequestHandler requests_;
  ViewpointPublisher publish_;
  BackdropLoader backdrop_;
  ScriptRunner& script_;
  InputRecord& record_;
  FrameDue frame_due_;
  std::optional<SteadyTime> recorded_now_;  ///< of this frame
  std::optional<SteadyTime> last_frame_;
  FrameTally tally_;
  bool swaps_ = true;            ///< something was drawn into the window
  bool screenshot_due_ = false;  ///< one was asked for before this frame
  ViewerStatus status_;
  PixelRectangle part_{0, 0, 1, 1};  ///< what the picture has of the window
  RenderStyle style_;                ///< of the last frame
  int width_ = 1, height_ = 1;
};

Result<std::unique_ptr<ViewApp>> ViewApp::open(ViewContent& content, Window& window,
                                               const ViewOptions& options, WindowSession& session) {
  ViewModel& model = *content.model;
  auto renderer = Renderer::create(window, model.cell(), options.profile);
  if (!renderer.ok()) return renderer.error();
  for (const std::string& warning : renderer->warnings()) {
    if (model.viewer.was_shown) break;
    const std::string shown = model.cell().shown(warning);
    cli::warn(shown);
    model.viewer.panels.notes.push_back({shown, false});
  }
  int samples = options.samples;
  if (samples == ViewOptions().samples) {
    samples = std::min(samples, FrameBuffer::mostSamples(renderer->gl()));
  }
  if (samples < options.samples && !std::exchange(session.samples_reported, true)) {
    cli::warn(fmt::format("this driver draws {} of the usual {} samples: edges are less smooth",
                          samples, options.samples));
  }
  std::unique_ptr<ViewApp> app(
      new ViewApp(content, window, options, session, std::move(*renderer), samples));
  if (session.painter) {
    session.painter->refreshFont();
  } else {
    auto painter = ImguiPainter::create(app->picture_.renderer().gl());
    if (!painter.ok()) return painter.error();
    session.painter = std::move(*painter);
  }
  auto journal = FrameJournal::open(options.frame_times);
  if (!journal.ok()) return journal.error();
  app->tally_ = FrameTally(std::move(*journal));
  if (auto ready = app->picture_.prepare(); !ready) return ready.error();
  app->window_->setPaced(!app->scripted());
  if (model.isLive()) model.feed().onNews([] { glfwPostEmptyEvent(); });
  model.study_waits = app->scripted();
  model.study_delayed = !app->scripted();
  if (!app->isPersonal()) model.viewer.findings_wanted = false;  // until the script asks
  ViewerStatus& status = app->status_;
  status.renderer = app->picture_.renderer().key().renderer;
  status.tells_times = !app->scripted() && !app->record_.active();
  model.viewer.panels.open.listens = status.tells_times;
  // Looks that the user did not choose may vary from frame to frame.
  if (app->isPersonal() && options.profile == Profile::fast && content.request.styles.empty() &&
      !model.viewer.was_shown) {
    model.useLooksByDefault();
  }
  app->detail_.tell(status);
  if (!app->scripted() && !options.notice.empty()) {
    app->evidence_.say(options.notice, false, app->now());
  }
  if (const auto& before = model.viewer.panels.open.before; !before.empty()) {
    const std::string name = plainText(before.filename().string());
    app->evidence_.say(name + " was shown before: Y offers it beside this", false, app->now());
  }
  return app;
}

void ViewApp::prepareView() {
  const FrameInput& input = script_.input();
  const bool has_size = input.width > 0;
  const int width = has_size ? input.width : std::max(1, window_->framebufferWidth());
  const int height = has_size ? input.height : std::max(1, window_->framebufferHeight());
  if (width != width_ || height != height_) {
    detail_.forget();
    if (has_size) window_->resize(width, height);
  }
  width_ = width;
  height_ = height;
  const float screen_scale = scripted() ? static_cast<float>(input.scale) : window_->contentScale();
  const float scale = options_.scale ? static_cast<float>(*options_.scale) : screen_scale;
  if (interface_.useScale(scale)) {
    painter_->refreshFont();
    composer_.forget();
  }
  interface_.useTheme(model_.viewer.panels.is_light);
  if (detail_.prepare(picture_.renderer())) picture_.changed();
  // What a frame cost says nothing of another look. The unit of lengths is none.
  RenderStyle style = model_.style();
  style.lengths = style_.lengths;
  if (style != style_) {
    style_ = std::move(style);
    detail_.forget();
  }
  detail_.setLooksByDefault(model_.hasLooksByDefault());
  detail_.tell(status_);
  part_ = model_.viewer.picture_part = part();
}

/// Before the panels are drawn.
PixelRectangle ViewApp::part() const {
  const auto width = static_cast<float>(width_), height = static_cast<float>(height_);
  return picturePart(dockLayoutOf(model_, width, height, interface_.scale()));
}

/// While nothing is asked. A script has no such time.
Status ViewApp::rest() {
  if (scripted()) return {};
  const auto news = rest_.step(now(), model_.viewer.is_empty, status_.refining);
  if (!news.ok()) return news.error();
  if (*news == PictureRest::News::begins) status_.refining = true;
  if (*news == PictureRest::News::whole) {
    // Shown by a frame of its own.
    composer_.forget();
    frame_due_.happened(now());
  } else if (*news != PictureRest::News::none) {
    // Without the whole picture the present rung's is better than a plain one.
    if (*news == PictureRest::News::ends && picture_.isPlain()) picture_.changed();
    frame_due_.drawSoon();
  }
  return {};
}

/// Tells once of a look that is not drawn any more.
void ViewApp::endLook(const Governor::Runaway& runaway) {
  if (runaway.with_looks) model_.dropLooksByDefault();
  const std::string text = runawayText(runaway);
  cli::warn(text);
  evidence_.say(text, true, now());
}

/// Copies the picture to the window, with the interface over it. Screenshots are read from a buffer
/// of our own, whose pixels do not depend on the window system.
Status ViewApp::compose(bool same_picture) {
  const WindowContent content{picture_.pixels(),    part_.x, part_.y, width_, height_,
                              *ImGui::GetDrawData()};
  const GlTable& gl = picture_.renderer().gl();
  swaps_ = true;
  if (!scripted() && !requests_.awaitsScreenshot()) {
    const auto shown = composer_.compose(gl, content, *painter_, same_picture);
    if (!shown.ok()) return shown.error();
    swaps_ = *shown;
    if (swaps_) gl.Finish();
    return {};
  }
  return composer_.composeAside(gl, content, *painter_);
}

/// Since the last frame, where it must not depend on when the clock is read.
std::optional<float> ViewApp::frameSeconds() {
  if (!script_.isTimed() && !record_.active()) return std::nullopt;
  const std::optional<SteadyTime> last = std::exchange(last_frame_, now());
  if (!last) return kScriptedSeconds;
  constexpr float kLeast = 1e-6F;
  return std::max(kLeast, static_cast<float>((now() - *last).count()) * 1e-9F);
}

void ViewApp::beginFrame() {
  interface_.beginFrame(width_, height_, scripted() ? &script_.input() : nullptr, frameSeconds(),
                        keyTaker(model_));
  if (!record_.active()) return;
  FrameInput seen = interface_.seen();
  seen.width = width_;
  seen.height = height_;
  seen.scale = interface_.scale();
  record_.add(seen, now());
  if (const auto fault = record_.takeFault()) {
    evidence_.say(*fault, true, now());
    model_.viewer.panels.doubts.push_back(*fault);
  }
}

Status ViewApp::drawFrame(double app_ms) {
  FrameTimes times;
  times.app = app_ms;
  const SteadyTime began = std::chrono::steady_clock::now();
  screenshot_due_ = requests_.awaitsScreenshot();
  beginFrame();
  status_.refining = status_.refining && picture_.refinesAt(now());
  status_.still = isStill();
  ViewerRequests requests;
  part_ = drawPanels(model_, status_, now(), requests);
  if (std::string& wanted = model_.viewer.built_in_wanted; !wanted.empty()) {
    requests.built_in_camera = std::exchange(wanted, {});
  }
  requests.click = applyUserInput(model_, now(), interface_.presses(), requests);
  ImGui::Render();
  if (auto applied = applyRequests(requests); !applied) return applied;
  times.ui = millisecondsSince(began);

  const SteadyTime scene_began = std::chrono::steady_clock::now();
  WindowTerms terms;
  terms.width = part_.width;
  terms.height = part_.height;
  terms.scale = interface_.scale();
  terms.rung = detail_.rung();
  terms.drops_looks = detail_.dropsLooks();
  terms.refines = !scripted() && !detail_.fixed();
  const auto drawn = picture_.draw(std::move(terms), now());
  if (!drawn.ok()) return drawn.error();
  if (*drawn && !scripted()) picture_.renderer().gl().Finish();
  times.draw = millisecondsSince(scene_began);
  const SteadyTime ui_began = std::chrono::steady_clock::now();
  if (auto composed = compose(!drawn->has_value()); !composed) return composed;
  times.ui += millisecondsSince(ui_began);
  frame_due_.drawn(now());
  status_.refined = picture_.refined();
  const auto cost_ms = tally_.drawn(*drawn, times, now(), status_);
  if (!cost_ms) return {};
  // The first picture's time is mostly that of compiling.
  if (!picture_.isPlain()) detail_.frameDrawn(*cost_ms);
  if (const auto runaway = detail_.takeRunaway()) endLook(*runaway);
  detail_.tell(status_);
  return {};
}

/// A frame that was begun when it was asked for has the line that it was typed into, and a picture
/// that is yet plain becomes better in a moment. `now_or_never`: none comes after this frame.
void ViewApp::writeScreenshot(bool now_or_never) {
  if (!requests_.awaitsScreenshot()) return;
  const bool is_better = !picture_.isPlain() || picture_.refined();
  if (!now_or_never && !(screenshot_due_ && is_better)) {
    if (!screenshot_due_) frame_due_.happened(now());
    return;
  }
  for (const std::filesystem::path& file : requests_.takeScreenshots()) {
    const Status written = writePng(file, composer_.composed().read());
    evidence_.say(written ? "written: " + file.string() : written.error().text(), !written, now());
  }
  composer_.composed().blitTo(0);
  frame_due_.happened(now());
}

Status ViewApp::applyRequests(const ViewerRequests& requests) {
  if (auto applied = requests_.apply(requests, size(), now()); !applied) return applied;
  detail_.tell(status_);
  status_.notice = evidence_.notice();
  status_.notice_is_fault = evidence_.noticeIsFault();
  return {};
}

/// The frame that was just shown, for measurements.
void ViewApp::writeDown() {
  if (!tally_.isWritten()) return;
  ShownFrame frame;
  frame.moment = model_.shownTime();
  frame.loaded = !model_.viewer.is_empty;
  frame.level = detail_.rung();
  frame.whole =
      picture_.refined() || (detail_.rung() == 0 && !status_.drops_looks && !picture_.isPlain());
  tally_.writeDown(frame);
}

bool ViewApp::frameDue(bool changed) const {
  const TimelineCursor* cursor = model_.cursor();
  const SteadyTime at = now();
  return scripted() || changed || isStill() != status_.still ||
         (cursor != nullptr && cursor->playing() && !cursor->following()) ||
         frame_due_.at(
             at, panelsChangeEvery(model_,
                                   {opening_.busy(), evidence_.active() || requests_.isSaving(),
                                    ImGui::GetIO().WantTextInput},
                                   at));
}

void ViewApp::waitForNews() {
  const bool waits = !scripted() && !rest_.isDue(now(), model_.viewer.is_empty) && !frameDue(false);
  window_->takeEvents(waits ? newsWait(model_) : 0);
  if (scripted()) return;
  if (model_.hasStudyNews()) frame_due_.drawSoon();
  const bool news = window_->takeNews();
  // The window may have been covered.
  if (news) composer_.forget();
  if (news || window_->input().pending()) frame_due_.happened(now());
}

/// The real picture of the shown moment; true when it is another one.
bool ViewApp::showBackdrop() {
  const bool changed = backdrop_.update(model_, scripted());
  if (const std::string fault = backdrop_.takeFault(); !fault.empty()) {
    evidence_.say("no backdrop here: " + fault, true, now());
  }
  return changed;
}

/// Draws the small picture of the time line, if it can be; true when it is another one.
bool ViewApp::advancePreview() {
  return preview_.advance(picture_.renderer(), part_.width, part_.height, interface_.scale(),
                          now());
}

/// A script has no idle time, in which a window draws it.
void ViewApp::finishPreview() {
  if (advancePreview()) return;
  preview_.wait();
  advancePreview();
}

/// What was opened or dropped, once it has come; a script waits for it where it says so. It takes
/// the place of what is shown when nothing is made of that any more, and unless it is an empty
/// picture in place of a good one.
Result<std::unique_ptr<ViewContent>> ViewApp::takeOpened() {
  opening_.tend(now());
  if (evidence_.isMaking() || requests_.isSaving()) return nullptr;
  auto loaded = opening_.take(scripted());
  if (!loaded.ok()) return loaded.error();
  if (!*loaded) return nullptr;
  record_.addFilesCame();
  frame_due_.happened(now());
  std::unique_ptr<ViewContent> content = std::move((*loaded)->content);
  std::vector<PictureNote>& notes = model_.viewer.panels.notes;
  if (content == nullptr && (*loaded)->fault.empty()) return nullptr;  // it is beside
  if (content == nullptr) {
    cli::warn((*loaded)->fault);
    notes.push_back({(*loaded)->fault, true, PictureNote::Of::failure});
    return nullptr;
  }
  if ((*loaded)->goes_back || model_.viewer.is_empty || isHopeless(model_.cell()) ||
      !isHopeless(content->model->cell())) {
    return content;
  }
  notes.push_back({content->request.named().string() + " is not shown: it has nothing to draw",
                   true, PictureNote::Of::failure});
  for (PictureNote& note : content->model->viewer.panels.notes) {
    notes.push_back({std::move(note.text), note.is_error, PictureNote::Of::failure});
  }
  for (const std::string& warning : content->warnings) cli::warn(warning);
  return nullptr;
}

Result<std::unique_ptr<ViewContent>> ViewApp::run() {
  std::unique_ptr<ViewContent> next;
  if (model_.cameraName().empty() && !model_.viewer.was_shown) {
    if (auto updated = model_.update(now()); !updated.ok()) return updated.error();
    prepareView();
    // The first frame has what a layout wants all the same.
    std::string wanted = model_.viewer.built_in_wanted;
    model_.fit(picture_.corners(false), part_.width, part_.height);
    model_.viewer.built_in_wanted = std::move(wanted);
  }
  while (!window_->closeRequested() && !cli::stopRequested()) {
    if (record_.active()) recorded_now_ = std::chrono::steady_clock::now();
    if (!scripted() || script_.awaitsFiles()) {
      const auto dropped = window_->takeDropped();
      record_.addDrop(dropped);
      requests_.openFiles(dropped, now());
      auto opened = takeOpened();
      // For all that was dropped; a record of input says so for each.
      const bool waits = opening_.busy() && !evidence_.isMaking() && !requests_.isSaving();
      if (script_.isTimed() || !waits) script_.takeAwaitsFiles();
      if (!opened.ok() || *opened != nullptr) {
        writeScreenshot(true);
        return opened;
      }
      if (script_.awaitsFiles()) continue;
    }
    const SteadyTime began = std::chrono::steady_clock::now();
    auto changed = model_.update(now());
    if (!changed.ok()) return changed.error();
    if (showBackdrop()) changed = true;
    const double app_ms = millisecondsSince(began);
    model_.hand.sendDue(now(), std::chrono::system_clock::now());
    if (auto published = publish_.tell(now()); !published) return published.error();
    if (*changed) picture_.changed();
    if (!frameDue(*changed)) {
      if (auto rested = rest(); !rested) return rested.error();
      if (advancePreview()) {
        composer_.forget();  // its texture has changed
        frame_due_.happened(now());
      }
      waitForNews();
      continue;
    }
    prepareView();
    if (scripted()) {
      const auto apply = [this](const ViewerRequests& asked) { return applyRequests(asked); };
      if (auto stepped = script_.beforeFrame({model_, now(), part_.height, apply}); !stepped) {
        return stepped.error();
      }
      if (script_.finished()) {
        writeScreenshot(true);
        return next;
      }
      if (script_.awaitsFiles()) continue;
      // The script's changes must show in this frame.
      auto updated = model_.update(now());
      if (!updated.ok()) return updated.error();
      if (script_.takeChanged()) updated = true;
      if (showBackdrop()) updated = true;
      if (*updated) picture_.changed();
      prepareView();
    }
    if (script_.isTimed()) finishPreview();
    status_.loading = opening_.status();
    if (status_.loading && (evidence_.isMaking() || requests_.isSaving())) {
      status_.loading->waits_for = "it is shown when what is being made of this is written";
    }
    if (auto drawn = drawFrame(app_ms); !drawn) return drawn.error();
    if (scripted()) {
      if (auto kept = script_.afterFrame([this] { return composer_.composed().read(); }); !kept) {
        return kept.error();
      }
    }
    writeScreenshot(false);
    if (scripted()) composer_.composed().blitTo(0);
    if (swaps_) window_->swap();
    writeDown();
    if (rest_.isOverdue(now(), model_.viewer.is_empty)) {
      if (auto rested = rest(); !rested) return rested.error();
    }
    if (std::exchange(model_.study_delayed, false)) frame_due_.happened(now());
    waitForNews();
  }
  writeScreenshot(true);
  // What is yet to be written and to be ended nobody has to look at.
  window_->hide();
  model_.hand.stopDriving();
  requests_.finish(now());
  return next;
}

}  // namespace

Result<std::unique_ptr<ViewContent>> showContent(ViewContent& content, Window& window,
                                                 const ViewOptions& options,
                                                 WindowSession& session) {
  auto app = ViewApp::open(content, window, options, session);
  if (!app.ok()) return app.error();
  return (*app)->run();
}

}  // namespace rocinante
