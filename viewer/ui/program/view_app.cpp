#include "viewer/ui/program/view_app.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <thread>

#include "core/cli/program.h"
#include "viewer/detail/governor.h"
#include "viewer/render/fitted_cameras.h"
#include "viewer/ui/model/camera_append.h"
#include "viewer/ui/model/view_insets.h"
#include "viewer/ui/panels/panels.h"
#include "viewer/ui/program/evidence_desk.h"
#include "viewer/ui/program/fit_corners.h"
#include "viewer/ui/program/save_desk.h"
#include "viewer/ui/program/scene_view.h"
#include "viewer/ui/program/script_runner.h"
#include "viewer/ui/program/user_input.h"
#include "viewer/ui/window/frame_due.h"
#include "viewer/ui/window/imgui_painter.h"
#include "viewer/ui/window/interface_context.h"
#include "viewer/ui/window/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace rocinante {
namespace {

constexpr Nanoseconds kScriptedFrame{1'000'000'000 / 60};
/// Threads that make coarser meshes; the others are left to drawing.
constexpr int kDetailThreads = 1;

double millisecondsSince(SteadyTime start) {
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
  return took.count();
}

class ViewApp {
 public:
  static Result<std::unique_ptr<ViewApp>> open(ViewContent& content, Window& window,
                                               const ViewOptions& options, ContentLoader& loader);
  /// What to show next; null: nothing, the window closes.
  Result<std::unique_ptr<ViewContent>> run();

 private:
  ViewApp(ViewContent& content, Window& window, const ViewOptions& options, ContentLoader& loader,
          Renderer renderer)
      : shown_(content.request),
        model_(*content.model),
        options_(options),
        loader_(loader),
        window_(&window),
        interface_(options.script.empty() ? window_ : nullptr),
        renderer_(std::move(renderer)),
        fitted_(model_.cell(), renderer_),
        governor_({1000 / options.target_fps, kCoarsestRung}),
        evidence_(content.request, options.samples),
        saving_(content.request),
        script_(options.script, options.script_name) {}

  bool scripted() const { return !options_.script.empty(); }
  SteadyTime now() const {
    return scripted() ? scripted_now_ : SteadyTime(std::chrono::steady_clock::now());
  }
  void prepareView();
  void prepareDetail();
  void useRung(int rung);
  SceneFrame shownFrame(const RenderStyle& style);
  ShownScene shownScene(const RenderStyle& style) const;
  Result<std::optional<DrawCounts>> drawScene();
  Status drawFrame(double app_ms);
  Status refine();
  void compose();
  bool frameDue(bool changed) const;
  Nanoseconds panelsChangeEvery() const;
  Status applyRequests(const ViewerRequests& requests);
  Status makeEvidence(const std::filesystem::path& file);
  void writeScreenshot();
  Status saveCamera(const std::string& name);
  Status clickAt(const PictureClick& click);
  Status runScript();
  void openFiles(const std::vector<std::filesystem::path>& files);
  Result<std::unique_ptr<ViewContent>> takeLoaded();
  void tellLoading();
  void waitForNews();
  Status saveLive(const std::filesystem::path& file);
  WindowSize size() const { return {width_, height_, interface_.scale()}; }

  const ContentRequest& shown_;
  ViewModel& model_;
  const ViewOptions& options_;
  ContentLoader& loader_;
  Window* window_;
  InterfaceContext interface_;
  Renderer renderer_;
  FittedCameras fitted_;
  StateDamage fit_damage_;  ///< until reported
  SceneView view_;
  std::uint64_t scene_version_ = 0;
  std::optional<ImguiPainter> painter_;
  Governor governor_;
  EvidenceDesk evidence_;
  SaveDesk saving_;
  ScriptRunner script_;
  std::optional<std::filesystem::path> screenshot_;  ///< a user's, of the coming frame
  FrameDue frame_due_;
  SteadyTime scripted_now_{};
  ViewerStatus status_;
  CoveredEdges covered_;
  std::vector<FrameInset> insets_;  ///< of the last frame, in the window's pixels
  int width_ = 1, height_ = 1;
};

Result<std::unique_ptr<ViewApp>> ViewApp::open(ViewContent& content, Window& window,
                                               const ViewOptions& options, ContentLoader& loader) {
  ViewModel& model = *content.model;
  auto renderer = Renderer::create(window, model.cell(), options.profile);
  if (!renderer.ok()) return renderer.error();
  for (const std::string& warning : renderer->warnings()) {
    cli::warn(model.cell().shown(warning));
  }
  std::unique_ptr<ViewApp> app(new ViewApp(content, window, options, loader, std::move(*renderer)));
  auto painter = ImguiPainter::create(app->renderer_.gl());
  if (!painter.ok()) return painter.error();
  app->painter_ = std::move(*painter);
  // Before the first state is queried, which is only valid until the next query.
  if (auto ready = app->fitted_.prepare(model.session(), app->fit_damage_); !ready)
    return ready.error();
  app->window_->setPaced(!app->scripted());
  model.study_waits = app->scripted();
  if (app->scripted()) model.findings_wanted = false;  // until the script asks
  ViewerStatus& status = app->status_;
  status.renderer = app->renderer_.key().renderer;
  status.target_fps = options.target_fps;
  status.tells_times = !app->scripted();
  status.may_govern = !app->scripted() && options.profile == Profile::fast;
  status.rung_fixed = options.detail.has_value() || !status.may_govern;
  app->useRung(options.detail.value_or(0));
  if (!app->scripted() && !options.notice.empty()) {
    app->evidence_.say(options.notice, false, app->now());
  }
  return app;
}

/// Starts coarser meshes when first needed, or at once if the governor may need them. A level
/// chosen by number waits for its meshes before the first frame.
void ViewApp::prepareDetail() {
  const DetailRung& rung = kDetailRungs[static_cast<std::size_t>(status_.rung)];
  const bool wanted = rung.level.geometry_error_px > 0;
  if (!wanted && status_.rung_fixed) return;
  renderer_.prepareDetail(DetailCache::ofUser(), kDetailThreads);
  if (renderer_.takeReadyDetail(wanted && status_.rung_fixed)) {
    governor_.forget();
    ++scene_version_;
  }
  status_.coarse_ready = renderer_.detailReady();
}

void ViewApp::useRung(int rung) { status_.rung = std::clamp(rung, 0, kCoarsestRung); }

void ViewApp::prepareView() {
  const int width = std::max(1, window_->framebufferWidth());
  const int height = std::max(1, window_->framebufferHeight());
  if (width != width_ || height != height_) governor_.forget();
  width_ = width;
  height_ = height;
  const float screen_scale = scripted() ? 1 : window_->contentScale();
  const float scale = options_.scale ? static_cast<float>(*options_.scale) : screen_scale;
  if (interface_.useScale(scale)) painter_->refreshFont();
  interface_.useTheme(model_.is_light);
  prepareDetail();
}

SceneFrame ViewApp::shownFrame(const RenderStyle& style) {
  SceneFrame frame;
  frame.scene = &model_.scene();
  frame.camera = model_.cameraView();
  frame.choice = &model_.choice();
  frame.style = &style;
  frame.extras = &model_.extras();
  frame.insets = insets_;
  frame.raised_px = covered_.bottom;
  frame.scale = interface_.scale();
  return frame;
}

ShownScene ViewApp::shownScene(const RenderStyle& style) const {
  ShownScene shown;
  shown.version = scene_version_;
  shown.camera = model_.cameraView();
  shown.style = style;
  shown.insets = insets_;
  shown.hide = model_.hiddenPaths();
  shown.show = model_.shownPaths();
  shown.raised_px = covered_.bottom;
  shown.scale = interface_.scale();
  shown.width = width_;
  shown.height = height_;
  shown.samples = options_.samples;
  shown.rung = status_.rung;
  return shown;
}

Result<std::optional<DrawCounts>> ViewApp::drawScene() {
  const RenderStyle style = model_.frameStyle();
  insets_ = frameInsets(model_, fitted_, width_, height_, interface_.scale(), covered_);
  const bool shows_fitted = std::ranges::any_of(model_.insets, [](const InsetChoice& choice) {
    return choice.shown && FittedCameras::knows(choice.inset.camera);
  });
  if (shows_fitted && !fit_damage_.empty()) {
    model_.doubts.push_back("a fitted camera may miss movement: " + fit_damage_.text());
    fit_damage_ = {};
  }
  return view_.draw(renderer_, shownFrame(style), shownScene(style), now());
}

/// Draws a slice of the picture at rest. A rung that the user chose stays as it is.
Status ViewApp::refine() {
  if (scripted() || status_.rung_fixed) return {};
  const RenderStyle style = model_.frameStyle();
  const auto whole = view_.refine(renderer_, shownFrame(style), now());
  if (!whole.ok()) return whole.error();
  // Shown by a frame of its own.
  if (*whole) frame_due_.happened(now());
  return {};
}

/// Copies the picture to the window, with the interface over it. A script's screenshots are read
/// from the picture itself, whose pixels do not depend on the window system.
void ViewApp::compose() {
  const bool over_window = !scripted() && !screenshot_;
  if (over_window) {
    view_.picture().blitTo(0);
    renderer_.gl().BindFramebuffer(GL_FRAMEBUFFER, 0);
  } else if (screenshot_) {
    // The picture may be of an earlier frame: make it the target again.
    view_.picture().resolve();
  }
  painter_->draw(*ImGui::GetDrawData(), width_, height_);
  if (over_window) renderer_.gl().Finish();
}

Status ViewApp::drawFrame(double app_ms) {
  FrameTimes times;
  times.app = app_ms;
  const SteadyTime began = std::chrono::steady_clock::now();
  interface_.beginFrame(width_, height_);
  ViewerRequests requests;
  covered_ = drawPanels(model_, status_, now(), requests);
  if (!scripted()) {
    requests.click = applyUserInput(model_, now(), width_, height_, requests, *window_);
  }
  ImGui::Render();
  if (auto applied = applyRequests(requests); !applied) return applied;
  times.ui = millisecondsSince(began);

  const SteadyTime scene_began = std::chrono::steady_clock::now();
  const auto drawn = drawScene();
  if (!drawn.ok()) return drawn.error();
  if (*drawn && !scripted()) renderer_.gl().Finish();
  times.draw = millisecondsSince(scene_began);
  const SteadyTime ui_began = std::chrono::steady_clock::now();
  compose();
  times.ui += millisecondsSince(ui_began);
  frame_due_.drawn(now());
  status_.refined = view_.refined();
  if (!*drawn) return {};
  const auto part = [&](const StageTime& stage) {
    const double ms = std::min(static_cast<double>(stage.wall_ns) / 1e6, times.draw);
    times.draw -= ms;
    return ms;
  };
  times.app += part((*drawn)->times.app);
  times.cull = part((*drawn)->times.cull);
  status_.triangles = (*drawn)->triangles;
  status_.draws = (*drawn)->draws;
  status_.times.add(times);
  if (!status_.rung_fixed) useRung(governor_.frameDrawn(times.total()));
  return {};
}

Status ViewApp::saveCamera(const std::string& name) {
  const CameraView view = model_.cameraView();
  CellCamera camera;
  camera.name = name;
  camera.eye = view.eye;
  camera.target = view.target;
  camera.up = view.up;
  camera.fov_deg = view.fov_deg;
  camera.ortho_height_m = view.ortho_height_m;
  if (auto appended = appendCamera(shown_.cell, camera); !appended) return appended;
  model_.addCamera(std::move(camera));
  ++scene_version_;
  return {};
}

/// Its panels are over the picture, which the next frame therefore draws again.
void ViewApp::writeScreenshot() {
  const std::filesystem::path file = *std::exchange(screenshot_, std::nullopt);
  const Status written = writePng(file, view_.picture().read());
  evidence_.say(written ? "written: " + file.string() : written.error().text(), !written, now());
  view_.picture().blitTo(0);
  ++scene_version_;
  frame_due_.happened(now());
}

Status ViewApp::clickAt(const PictureClick& click) {
  // On the clicked frame, with its insets, looks and choices.
  const RenderStyle style = model_.frameStyle();
  const auto met = renderer_.pick(shownFrame(style), width_, height_, click.x, click.y);
  if (!met) return met.error();
  if (model_.picking.active()) {
    if (*met) model_.pickPoint({(*met)->name.device, (*met)->name.link}, (*met)->point);
    return {};
  }
  if (!*met) {
    if (!click.twice) model_.selected = {};
    return {};
  }
  const IdentityName& name = (*met)->name;
  const PosedDevice* device = model_.scene().findDevice(name.device);
  // For a device with a single link, select the device.
  const bool jointed =
      device != nullptr && device->model != nullptr && device->model->links.size() > 1;
  model_.selected = {name.device, jointed ? name.link : std::string()};
  if (click.twice) model_.holdCamera().aimAt((*met)->point);
  return {};
}

Status ViewApp::applyRequests(const ViewerRequests& requests) {
  if (requests.close) window_->requestClose();
  if (requests.click) {
    if (auto clicked = clickAt(*requests.click); !clicked) return clicked;
  }
  if (requests.reset) model_.resetCamera();
  if (requests.fit || (requests.reset && model_.cameraName().empty())) {
    model_.fit(cornersToFit(model_, renderer_, fitted_), width_, height_);
  }
  if (requests.fit_selected)
    model_.fit(selectedCorners(model_, renderer_, fitted_), width_, height_);
  if (requests.mark) {
    const auto marked = model_.addMark(*requests.mark);
    evidence_.say(marked ? fmt::format("marked: {}", *requests.mark) : marked.error().text(),
                  !marked, now());
  }
  if (LogStudy* const study = model_.session() != nullptr ? model_.study() : nullptr) {
    if (const auto table = study->takeTable()) {
      evidence_.say(table->ok() ? **table : table->error().text(), !table->ok(), now());
    }
  }
  if (requests.target_fps) {
    status_.target_fps = *requests.target_fps;
    governor_.setTarget(1000 / *requests.target_fps);
  }
  if (requests.rung) {
    status_.rung_fixed = *requests.rung >= 0;
    useRung(status_.rung_fixed ? *requests.rung : governor_.rung());
    governor_.forget();
  }
  openFiles(requests.open);
  if (requests.fault) evidence_.say(*requests.fault, true, now());
  if (requests.evidence) evidence_.ask(model_, size(), now());
  if (requests.evidence_file) {
    if (auto made = makeEvidence(*requests.evidence_file); !made) return made;
  }
  if (requests.save_camera) {
    const Status saved = saveCamera(*requests.save_camera);
    if (scripted() && !saved) return saved;
    evidence_.say(saved ? "camera " + *requests.save_camera + " added to " + shown_.cell.string()
                        : saved.error().text(),
                  !saved, now());
  }
  if (requests.screenshot) screenshot_ = requests.screenshot;
  if (requests.save_live || requests.save_file) {
    if (auto saved = saveLive(requests.save_file.value_or("")); !saved) return saved;
  }
  if (const auto news = saving_.look(model_)) evidence_.say(news->text, news->is_fault, now());
  evidence_.look(now());
  status_.notice = evidence_.notice();
  status_.notice_is_fault = evidence_.noticeIsFault();
  return {};
}

/// Under a script its frame waits for the picture and a fault ends it; a user reads it.
Status ViewApp::makeEvidence(const std::filesystem::path& file) {
  if (scripted()) return evidence_.make(model_, size(), file);
  evidence_.ask(model_, size(), now(), file);
  return {};
}

/// Under a script its frame waits for the file and a fault ends it; a user reads it, and goes on.
Status ViewApp::saveLive(const std::filesystem::path& file) {
  if (scripted()) return saving_.make(model_, file);
  const Status begun = saving_.ask(model_, file);
  evidence_.say(begun ? "the live session is being saved ..." : begun.error().text(), !begun,
                now());
  return {};
}

/// How often panels change by themselves: a notice goes, a caret blinks, and live figures tell how
/// long ago something came.
Nanoseconds ViewApp::panelsChangeEvery() const {
  using namespace std::chrono_literals;
  if (model_.packet.searching()) return 16ms;
  if (loader_.busy()) return 50ms;
  if (evidence_.active() || saving_.active() || ImGui::GetIO().WantTextInput) return 200ms;
  return model_.isLive() ? Nanoseconds(1s) : Nanoseconds::max();
}

bool ViewApp::frameDue(bool changed) const {
  const TimelineCursor* cursor = model_.cursor();
  return scripted() || changed ||
         (cursor != nullptr && cursor->playing() && !cursor->following()) ||
         frame_due_.at(now(), panelsChangeEvery());
}

void ViewApp::waitForNews() {
  if (scripted()) {
    glfwPollEvents();
    return;
  }
  const TimelineCursor* const cursor = model_.cursor();
  const bool refines =
      !status_.rung_fixed && view_.refinesAt().value_or(SteadyTime::max()) <= now();
  if (refines || frameDue(false)) {
    glfwPollEvents();
  } else {
    // Nothing moves: look at mouse, network and background now and then.
    const bool goes_on = cursor != nullptr && cursor->following();
    const bool is_busy =
        model_.isLive() || goes_on || model_.isStudyBusy() || model_.hand.driving() != nullptr;
    glfwWaitEventsTimeout(is_busy ? 0.016 : 0.05);
  }
  if (model_.hasStudyNews()) frame_due_.drawSoon();
  if (window_->takeNews() || window_->input().pending()) frame_due_.happened(now());
}

Status ViewApp::runScript() {
  const ScriptStage stage{model_, now(), height_, [this](const ViewerRequests& requests) {
                            return applyRequests(requests);
                          }};
  return script_.beforeFrame(stage);
}

/// Starts to load what was opened or dropped.
void ViewApp::openFiles(const std::vector<std::filesystem::path>& files) {
  if (files.empty()) return;
  if (loader_.busy()) {
    return evidence_.say("wait until " + loader_.name() + " is loaded", true, now());
  }
  model_.open.used = true;
  auto request = requestOf(files, shown_);
  if (!request.ok()) return evidence_.say(request.error().text(), true, now());
  loader_.start(std::move(*request));
}

/// What the loader has read. What it could not read is named, unless it was all that was asked for.
Result<std::unique_ptr<ViewContent>> ViewApp::takeLoaded() {
  std::unique_ptr<ViewContent> next;
  auto loaded = loader_.poll();
  if (!loaded) return next;
  frame_due_.happened(now());
  if (loaded->ok()) {
    next = std::make_unique<ViewContent>(std::move(**loaded));
  } else if (model_.is_empty && !model_.open.used) {
    return loaded->error();
  } else {
    evidence_.say(loaded->error().text(), true, now());
  }
  return next;
}

void ViewApp::tellLoading() {
  status_.loading.reset();
  if (loader_.busy()) status_.loading = LoadingStatus{loader_.name(), loader_.progress()};
}

Result<std::unique_ptr<ViewContent>> ViewApp::run() {
  std::unique_ptr<ViewContent> next;
  if (model_.cameraName().empty()) {
    if (auto updated = model_.update(now()); !updated.ok()) return updated.error();
    model_.fit(cornersToFit(model_, renderer_, fitted_), window_->framebufferWidth(),
               window_->framebufferHeight());
  }
  while (!window_->closeRequested() && !cli::stopRequested()) {
    openFiles(window_->takeDropped());
    auto loaded = takeLoaded();
    if (!loaded.ok() || *loaded != nullptr) return loaded;
    const SteadyTime began = std::chrono::steady_clock::now();
    const auto changed = model_.update(now());
    if (!changed.ok()) return changed.error();
    const double app_ms = millisecondsSince(began);
    model_.hand.sendDue(model_.scene(), model_.state(), now(), std::chrono::system_clock::now());
    if (*changed) ++scene_version_;
    if (!frameDue(*changed)) {
      if (auto refined = refine(); !refined) return refined.error();
      waitForNews();
      continue;
    }
    prepareView();
    if (scripted()) {
      if (auto stepped = runScript(); !stepped) return stepped.error();
      if (script_.finished()) return next;
      // The script's changes must show in this frame.
      if (auto updated = model_.update(now()); !updated.ok()) return updated.error();
      prepareView();
      ++scene_version_;
    }
    tellLoading();
    if (auto drawn = drawFrame(app_ms); !drawn) return drawn.error();
    if (scripted()) {
      if (auto kept = script_.afterFrame([this] { return view_.picture().read(); }); !kept) {
        return kept.error();
      }
      scripted_now_ += kScriptedFrame;
    }
    if (screenshot_) writeScreenshot();
    if (scripted()) view_.picture().blitTo(0);
    window_->swap();
    waitForNews();
  }
  return next;
}

}  // namespace

Result<std::unique_ptr<ViewContent>> showContent(ViewContent& content, Window& window,
                                                 const ViewOptions& options,
                                                 ContentLoader& loader) {
  auto app = ViewApp::open(content, window, options, loader);
  if (!app.ok()) return app.error();
  return (*app)->run();
}

}  // namespace rocinante
