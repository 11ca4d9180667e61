#include "viewer/ui/window/interface_context.h"

#include <imgui.h>
#include <imgui_impl_glfw.h>

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "viewer/overlay/embedded_font.h"
#include "viewer/ui/window/panel_style.h"

namespace rocinante {
namespace {

/// What the coming frame sees of the mouse, whatever the backend found.
void tellMouse(ImGuiIO& io, const InputState& seen, ImVec2 at) {
#if IMGUI_VERSION_NUM >= 18700
  // Since 1.87 what is told waits in a queue behind what the backend told, and the last word
  // counts.
  io.AddMousePosEvent(at.x, at.y);
  for (int button = 0; button < ImGuiMouseButton_COUNT; ++button) {
    io.AddMouseButtonEvent(button, seen.down[static_cast<std::size_t>(button)]);
  }
#else
  std::ranges::copy(seen.down, io.MouseDown);
  io.MousePos = at;
#endif
}

}  // namespace

InterfaceContext::InterfaceContext(Window* window) : window_(window) {
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  // ImguiPainter can: else a panel of more than 65,535 corners would end the program.
  ImGui::GetIO().BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
#if IMGUI_VERSION_NUM >= 18700
  // Spreading changes over frames is our own InputQueue's work.
  ImGui::GetIO().ConfigInputTrickleEventQueue = false;
#endif
  useScale(1);
  if (window_ != nullptr) ImGui_ImplGlfw_InitForOpenGL(window_->handle(), true);
}

InterfaceContext::~InterfaceContext() {
  if (window_ != nullptr) ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

bool InterfaceContext::useScale(float scale) {
  // In quarters: a screen's own figure may be anything, and glyphs are made anew for each.
  scale = std::round(std::clamp(scale, 1.0F, 4.0F) * 4) / 4;
  if (scale == scale_) return false;
  scale_ = scale;
  ImGuiIO& io = ImGui::GetIO();
  io.Fonts->Clear();
  const ByteView font = embeddedFont();
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  io.Fonts->AddFontFromMemoryTTF(const_cast<std::byte*>(font.data()), static_cast<int>(font.size()),
                                 kFontPixels * scale, &config);
  ImGui::GetStyle() = ImGuiStyle();
  stylePanels();
  ImGui::GetStyle().ScaleAllSizes(scale);
  return true;
}

void InterfaceContext::beginFrame(int width, int height) {
  ImGuiIO& io = ImGui::GetIO();
  const ImVec2 pixels(static_cast<float>(width), static_cast<float>(height));
  if (window_ != nullptr) {
    ImGui_ImplGlfw_NewFrame();
    // The backend looks where mouse and buttons are by now: of a click between two frames, which
    // the pointer has left, it would tell the wrong place, and the release a frame late.
    const bool outside = !window_->followsPointer() && !window_->input().pending();
    const InputState& seen = window_->input().nextFrame();
    ImVec2 at(-FLT_MAX, -FLT_MAX);
    // GLFW speaks of the window's units.
    if ((!outside || seen.anyDown()) && io.DisplaySize.x > 0 && io.DisplaySize.y > 0) {
      at = ImVec2(static_cast<float>(seen.x) * pixels.x / io.DisplaySize.x,
                  static_cast<float>(seen.y) * pixels.y / io.DisplaySize.y);
    }
    tellMouse(io, seen, at);
  } else {
    io.DeltaTime = 1.0F / 60.0F;
  }
  io.DisplaySize = pixels;
  io.DisplayFramebufferScale = ImVec2(1, 1);
  ImGui::NewFrame();
}

}  // namespace rocinante
