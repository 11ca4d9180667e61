#include "viewer/ui/interface_context.h"

#include <imgui.h>
#include <imgui_impl_glfw.h>

#include <algorithm>
#include <cmath>

#include "viewer/render/embedded_font.h"
#include "viewer/ui/panels.h"

namespace rocinante {

InterfaceContext::InterfaceContext(Window* window) : window_(window) {
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  // ImguiPainter can: else a panel of more than 65,535 corners would end the program.
  ImGui::GetIO().BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
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
    const bool outside = !ImGui::IsMousePosValid(&io.MousePos) && !window_->input().pending();
    const InputState& seen = window_->input().nextFrame();
    std::ranges::copy(seen.down, io.MouseDown);
    if (!outside || seen.anyDown()) {
      io.MousePos = ImVec2(static_cast<float>(seen.x), static_cast<float>(seen.y));
    }
    // The backend speaks of the window's units.
    if (io.DisplaySize.x > 0 && io.DisplaySize.y > 0 && ImGui::IsMousePosValid(&io.MousePos)) {
      io.MousePos.x *= pixels.x / io.DisplaySize.x;
      io.MousePos.y *= pixels.y / io.DisplaySize.y;
    }
  } else {
    io.DeltaTime = 1.0F / 60.0F;
  }
  io.DisplaySize = pixels;
  io.DisplayFramebufferScale = ImVec2(1, 1);
  ImGui::NewFrame();
}

}  // namespace rocinante
