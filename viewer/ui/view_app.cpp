#include "viewer/ui/view_app.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_impl_glfw.h>

#include <chrono>
#include <optional>

#include "core/cli/program.h"
#include "viewer/render/embedded_font.h"
#include "viewer/ui/imgui_painter.h"
#include "viewer/ui/panels.h"
#include "viewer/ui/script_runner.h"
#include "viewer/ui/user_input.h"
#include "viewer/ui/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace rocinante {
namespace {

constexpr Nanoseconds kScriptedFrame{1'000'000'000 / 60};
constexpr float kFontPixels = 15;

/// Dear ImGui's context, with the font whose bytes are fixed at build time.
class InterfaceContext {
 public:
  explicit InterfaceContext(GLFWwindow* window) : window_(window) {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    const ByteView font = embeddedFont();
    ImFontConfig config;
    config.FontDataOwnedByAtlas = false;
    io.Fonts->AddFontFromMemoryTTF(const_cast<std::byte*>(font.data()),
                                   static_cast<int>(font.size()), kFontPixels, &config);
    stylePanels();
    if (window_ != nullptr) ImGui_ImplGlfw_InitForOpenGL(window_, true);
  }
  ~InterfaceContext() {
    if (window_ != nullptr) ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
  }
  InterfaceContext(const InterfaceContext&) = delete;
  InterfaceContext& operator=(const InterfaceContext&) = delete;

  void beginFrame(int width, int height) {
    if (window_ != nullptr) {
      ImGui_ImplGlfw_NewFrame();
    } else {
      ImGuiIO& io = ImGui::GetIO();
      io.DisplaySize = ImVec2(static_cast<float>(width), static_cast<float>(height));
      io.DeltaTime = 1.0F / 60.0F;
    }
    ImGui::NewFrame();
  }

 private:
  GLFWwindow* window_;  ///< null: scripted, no mouse and no keyboard
};

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
        interface_(options.script.empty() ? window_->handle() : nullptr),
        renderer_(std::move(renderer)),
        script_(options.script, options.script_name) {}

  bool scripted() const { return !options_.script.empty(); }
  SteadyTime now() const {
    return scripted() ? scripted_now_ : SteadyTime(std::chrono::steady_clock::now());
  }
  std::vector<Vec3> visibleCorners() const;
  Status drawFrame();
  Status ensureFrameBuffer();
  void waitForNews(bool changed);

  ViewModel& model_;
  const ViewOptions& options_;
  std::unique_ptr<Window> window_;
  InterfaceContext interface_;
  Renderer renderer_;
  std::optional<FrameBuffer> frame_buffer_;
  std::optional<ImguiPainter> painter_;
  ScriptRunner script_;
  SteadyTime scripted_now_{};
  FrameFigures figures_;
};

Result<std::unique_ptr<ViewApp>> ViewApp::open(ViewModel& model, const ViewOptions& options) {
  auto window = Window::open("Rocinante: " + model.cell().file, options.width, options.height);
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
  app->figures_.renderer = app->renderer_.key().renderer;
  app->window_->setPaced(!app->scripted());
  return app;
}

std::vector<Vec3> ViewApp::visibleCorners() const {
  const Bounds bounds = renderer_.visibleBounds(model_.scene(), model_.choice());
  if (bounds.empty()) return {};
  return {bounds.min, bounds.max};
}

Status ViewApp::ensureFrameBuffer() {
  const int width = std::max(1, window_->framebufferWidth());
  const int height = std::max(1, window_->framebufferHeight());
  if (frame_buffer_ && frame_buffer_->width() == width && frame_buffer_->height() == height) {
    return {};
  }
  frame_buffer_.reset();
  auto made = FrameBuffer::create(renderer_.gl(), width, height, options_.samples);
  if (!made.ok()) return made.error();
  frame_buffer_ = std::move(*made);
  return {};
}

Status ViewApp::drawFrame() {
  const auto started = std::chrono::steady_clock::now();
  const int width = frame_buffer_->width();
  const int height = frame_buffer_->height();
  interface_.beginFrame(width, height);
  bool fit_requested = false;
  drawPanels(model_, figures_, now(), fit_requested);
  if (!scripted()) applyUserInput(model_, now(), height, fit_requested, *window_);
  ImGui::Render();
  if (fit_requested) model_.fit(visibleCorners(), width, height);

  const SceneFrame frame{&model_.scene(), model_.cameraView(), &model_.choice()};
  const auto drawn = renderer_.draw(frame, *frame_buffer_);
  if (!drawn.ok()) return drawn.error();
  frame_buffer_->resolve();
  painter_->draw(*ImGui::GetDrawData(), width, height);
  figures_.triangles = drawn->triangles;
  if (!scripted()) {
    renderer_.gl().Finish();
    const std::chrono::duration<double, std::milli> took =
        std::chrono::steady_clock::now() - started;
    // Smoothed, so that it can be read.
    figures_.frame_ms += (took.count() - figures_.frame_ms) * 0.1;
  }
  return {};
}

void ViewApp::waitForNews(bool changed) {
  if (scripted()) {
    glfwPollEvents();
    return;
  }
  const Transport* transport = model_.transport();
  const bool moving = changed || (transport != nullptr && transport->playing());
  if (moving) {
    glfwPollEvents();
  } else {
    // Nothing moves: look at the mouse and the network now and then, and leave the machine alone.
    glfwWaitEventsTimeout(model_.isLive() ? 0.016 : 0.1);
  }
}

Status ViewApp::run() {
  if (model_.cameraName().empty()) {
    if (auto updated = model_.update(now()); !updated.ok()) return updated.error();
    model_.fit(visibleCorners(), options_.width, options_.height);
  }
  while (!window_->closeRequested() && !cli::stopRequested()) {
    const auto changed = model_.update(now());
    if (!changed.ok()) return changed.error();
    if (auto ready = ensureFrameBuffer(); !ready) return ready;
    if (scripted()) {
      ScriptStage stage{model_, now(), frame_buffer_->width(), frame_buffer_->height(),
                        [this] { return visibleCorners(); }};
      if (auto stepped = script_.beforeFrame(stage); !stepped) return stepped;
      if (script_.finished()) return {};
      // What the script moved must be seen in this very frame.
      if (auto updated = model_.update(now()); !updated.ok()) return updated.error();
    }
    if (auto drawn = drawFrame(); !drawn) return drawn;
    if (scripted()) {
      if (auto kept = script_.afterFrame([this] { return frame_buffer_->read(); }); !kept) {
        return kept;
      }
      scripted_now_ += kScriptedFrame;
    }
    frame_buffer_->blitTo(0);
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
