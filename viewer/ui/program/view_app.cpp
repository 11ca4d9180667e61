#include "viewer/ui/program/view_app.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <optional>

#include "core/cli/program.h"
#include "viewer/detail/governor.h"
#include "viewer/render/fitted_cameras.h"
#include "viewer/render/scaled_view.h"
#include "viewer/ui/model/view_insets.h"
#include "viewer/ui/panels/panels.h"
#include "viewer/ui/program/evidence_desk.h"
#include "viewer/ui/program/script_runner.h"
#include "viewer/ui/program/user_input.h"
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
  static Result<std::unique_ptr<ViewApp>> open(ViewModel& model, const ViewOptions& options);
  Status run();

 private:
  ViewApp(ViewModel& model, const ViewOptions& options, std::unique_ptr<Window> window,
          Renderer renderer)
      : model_(model),
        options_(options),
        window_(std::move(window)),
        interface_(options.script.empty() ? window_.get() : nullptr),
        renderer_(std::move(renderer)),
        fitted_(model.cell(), renderer_),
        governor_({1000 / options.target_fps, kCoarsestRung}),
        evidence_(options),
        script_(options.script, options.script_name) {}

  bool scripted() const { return !options_.script.empty(); }
  SteadyTime now() const {
    return scripted() ? scripted_now_ : SteadyTime(std::chrono::steady_clock::now());
  }
  std::vector<Vec3> fittedCorners() const;
  std::vector<Vec3> selectedCorners() const;
  Status prepareView();
  void prepareDetail();
  void useRung(int rung);
  SceneFrame shownFrame(const RenderStyle& style);
  Result<DrawCounts> drawScene();
  Status drawFrame(double app_ms);
  void applyRequests(const ViewerRequests& requests);
  Status clickAt(const PictureClick& click);
  Status runScript();
  void waitForNews(bool changed);
  WindowSize size() const { return {width_, height_, interface_.scale()}; }

  ViewModel& model_;
  const ViewOptions& options_;
  std::unique_ptr<Window> window_;
  InterfaceContext interface_;
  Renderer renderer_;
  FittedCameras fitted_;
  StateDamage fit_damage_;  ///< until reported
  ScaledView view_;
  std::optional<ImguiPainter> painter_;
  Governor governor_;
  EvidenceDesk evidence_;
  ScriptRunner script_;
  SettlingFrames settling_;
  SteadyTime scripted_now_{};
  ViewerStatus status_;
  CoveredEdges covered_;
  std::vector<FrameInset> insets_;  ///< of the last frame, in the window's pixels
  int width_ = 1, height_ = 1;
};

Result<std::unique_ptr<ViewApp>> ViewApp::open(ViewModel& model, const ViewOptions& options) {
  auto window = Window::open("Rocinante: " + model.cell().file, options.width, options.height,
                             options.script.empty());
  if (!window.ok()) return window.error();
  auto renderer = Renderer::create(**window, model.cell(), options.profile);
  if (!renderer.ok()) return renderer.error();
  for (const std::string& warning : renderer->warnings()) {
    cli::warn(model.cell().shown(warning));
  }
  std::unique_ptr<ViewApp> app(
      new ViewApp(model, options, std::move(*window), std::move(*renderer)));
  auto painter = ImguiPainter::create(app->renderer_.gl());
  if (!painter.ok()) return painter.error();
  app->painter_ = std::move(*painter);
  // Before the first state is queried, which is only valid until the next query.
  if (auto ready = app->fitted_.prepare(model.session(), app->fit_damage_); !ready)
    return ready.error();
  app->window_->setPaced(!app->scripted());
  ViewerStatus& status = app->status_;
  status.renderer = app->renderer_.key().renderer;
  status.target_fps = options.target_fps;
  status.tells_times = !app->scripted();
  status.may_govern = !app->scripted() && options.profile == Profile::fast;
  status.rung_fixed = options.detail.has_value() || !status.may_govern;
  app->useRung(options.detail.value_or(0));
  return app;
}

/// Points of the shown moment for `fit`.
std::vector<Vec3> ViewApp::fittedCorners() const {
  const DeviceNames movable = fitted_.movable(model_.scene());
  Bounds bounds = renderer_.visibleBounds(model_.scene(), model_.choice(), &movable);
  if (bounds.empty()) bounds = renderer_.visibleBounds(model_.scene(), model_.choice());
  if (bounds.empty()) return {};
  return {bounds.min, bounds.max};
}

std::vector<Vec3> ViewApp::selectedCorners() const {
  if (model_.selected.device.empty()) return fittedCorners();
  const auto alone = ViewChoice::make({"*"}, {model_.selected.path()});
  if (!alone.ok()) return {};
  const Bounds bounds = renderer_.visibleBounds(model_.scene(), *alone);
  if (bounds.empty()) return {};
  return {bounds.min, bounds.max};
}

/// Starts coarser meshes when first needed, or at once if the governor may need them. A level
/// chosen by number waits for its meshes before the first frame.
void ViewApp::prepareDetail() {
  const DetailRung& rung = kDetailRungs[static_cast<std::size_t>(status_.rung)];
  const bool wanted = rung.level.geometry_error_px > 0;
  if (!wanted && status_.rung_fixed) return;
  renderer_.prepareDetail(DetailCache::ofUser(), kDetailThreads);
  if (renderer_.takeReadyDetail(wanted && status_.rung_fixed)) governor_.forget();
  status_.coarse_ready = renderer_.detailReady();
}

void ViewApp::useRung(int rung) { status_.rung = std::clamp(rung, 0, kCoarsestRung); }

Status ViewApp::prepareView() {
  const int width = std::max(1, window_->framebufferWidth());
  const int height = std::max(1, window_->framebufferHeight());
  if (width != width_ || height != height_) governor_.forget();
  width_ = width;
  height_ = height;
  const float screen_scale = scripted() ? 1 : window_->contentScale();
  const float scale = options_.scale ? static_cast<float>(*options_.scale) : screen_scale;
  if (interface_.useScale(scale)) painter_->refreshFont();
  prepareDetail();
  return view_.prepare(renderer_.gl(), width, height, options_.samples,
                       kDetailRungs[static_cast<std::size_t>(status_.rung)]);
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

Result<DrawCounts> ViewApp::drawScene() {
  const RenderStyle style = model_.frameStyle();
  insets_ = frameInsets(model_, fitted_, width_, height_, interface_.scale(), covered_);
  const bool shows_fitted = std::ranges::any_of(model_.insets, [](const InsetChoice& choice) {
    return choice.shown && FittedCameras::knows(choice.inset.camera);
  });
  if (shows_fitted && !fit_damage_.empty()) {
    model_.doubts.push_back("a fitted camera may miss movement: " + fit_damage_.text());
    fit_damage_ = {};
  }
  return view_.draw(renderer_, shownFrame(style));
}

Status ViewApp::drawFrame(double app_ms) {
  FrameTimes times;
  times.app = app_ms;
  const SteadyTime began = std::chrono::steady_clock::now();
  interface_.beginFrame(width_, height_);
  ViewerRequests requests;
  covered_ = drawPanels(model_, status_, now(), requests);
  std::optional<PictureClick> click;
  if (!scripted()) click = applyUserInput(model_, now(), width_, height_, requests, *window_);
  ImGui::Render();
  if (click) {
    if (auto clicked = clickAt(*click); !clicked) return clicked;
  }
  applyRequests(requests);
  times.ui = millisecondsSince(began);

  const SteadyTime scene_began = std::chrono::steady_clock::now();
  const auto drawn = drawScene();
  if (!drawn.ok()) return drawn.error();
  if (!scripted()) renderer_.gl().Finish();
  times.draw = millisecondsSince(scene_began);
  const auto part = [&](const StageTime& stage) {
    const double ms = std::min(static_cast<double>(stage.wall_ns) / 1e6, times.draw);
    times.draw -= ms;
    return ms;
  };
  times.app += part(drawn->times.app);
  times.cull = part(drawn->times.cull);

  const SteadyTime ui_began = std::chrono::steady_clock::now();
  painter_->draw(*ImGui::GetDrawData(), width_, height_);
  if (!scripted()) renderer_.gl().Finish();
  times.ui += millisecondsSince(ui_began);

  status_.triangles = drawn->triangles;
  status_.draws = drawn->draws;
  status_.times.add(times);
  if (!status_.rung_fixed) useRung(governor_.frameDrawn(times.total()));
  return {};
}

Status ViewApp::clickAt(const PictureClick& click) {
  // On the clicked frame, with its insets, looks and choices.
  const RenderStyle style = model_.frameStyle();
  const auto met = renderer_.pick(shownFrame(style), width_, height_, click.x, click.y);
  if (!met) return met.error();
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

void ViewApp::applyRequests(const ViewerRequests& requests) {
  if (requests.close) window_->requestClose();
  if (requests.reset) model_.resetCamera();
  if (requests.fit || (requests.reset && model_.cameraName().empty())) {
    model_.fit(fittedCorners(), width_, height_);
  }
  if (requests.fit_selected) model_.fit(selectedCorners(), width_, height_);
  if (requests.mark) {
    const auto marked = model_.addMark(*requests.mark);
    evidence_.say(marked ? fmt::format("marked: {}", *requests.mark) : marked.error().text(),
                  !marked, now());
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
  if (requests.evidence) evidence_.ask(model_, size(), now());
  evidence_.look(now());
  status_.notice = evidence_.notice();
  status_.notice_is_fault = evidence_.noticeIsFault();
}

void ViewApp::waitForNews(bool changed) {
  if (scripted()) {
    glfwPollEvents();
    return;
  }
  const TimelineCursor* cursor = model_.cursor();
  const bool moving = changed || (cursor != nullptr && cursor->playing());
  settling_.drawn(window_->takeNews() || window_->input().pending());
  if (moving || !settling_.settled()) {
    glfwPollEvents();
  } else {
    // Nothing moves: poll mouse and network rarely, to save CPU time.
    glfwWaitEventsTimeout(model_.isLive() ? 0.016 : 0.1);
  }
}

Status ViewApp::runScript() {
  ScriptStage stage{
      model_,
      now(),
      width_,
      height_,
      [this] { return fittedCorners(); },
      [this](const PictureClick& click) { return clickAt(click); },
      [this](const ViewerRequests& requests) { applyRequests(requests); },
      [this](const std::filesystem::path& file) { return evidence_.make(model_, size(), file); }};
  return script_.beforeFrame(stage);
}

Status ViewApp::run() {
  if (model_.cameraName().empty()) {
    if (auto updated = model_.update(now()); !updated.ok()) return updated.error();
    model_.fit(fittedCorners(), options_.width, options_.height);
  }
  while (!window_->closeRequested() && !cli::stopRequested()) {
    const SteadyTime began = std::chrono::steady_clock::now();
    const auto changed = model_.update(now());
    if (!changed.ok()) return changed.error();
    const double app_ms = millisecondsSince(began);
    if (auto ready = prepareView(); !ready) return ready;
    if (scripted()) {
      if (auto stepped = runScript(); !stepped) return stepped;
      if (script_.finished()) return {};
      // The script's changes must show in this frame.
      if (auto updated = model_.update(now()); !updated.ok()) return updated.error();
      if (auto ready = prepareView(); !ready) return ready;
    }
    if (auto drawn = drawFrame(app_ms); !drawn) return drawn;
    if (scripted()) {
      if (auto kept = script_.afterFrame([this] { return view_.picture().read(); }); !kept) {
        return kept;
      }
      scripted_now_ += kScriptedFrame;
    }
    view_.picture().blitTo(0);
    window_->swap();
    waitForNews(*changed);
  }
  return {};
}

}  // namespace

Status runViewer(ViewModel& model, const ViewOptions& options) {
  auto app = ViewApp::open(model, options);
  if (!app.ok()) return app.error();
  return (*app)->run();
}

}  // namespace rocinante
