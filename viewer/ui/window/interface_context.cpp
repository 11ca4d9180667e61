#include "viewer/ui/window/interface_context.h"

#include <imgui.h>
#include <imgui_impl_glfw.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>

#include "viewer/overlay/embedded_font.h"
#include "viewer/ui/window/panel_style.h"

namespace rocinante {
namespace {

/// Sets the mouse of the coming frame, overriding the backend.
void tellMouse(ImGuiIO& io, const InputState& seen, ImVec2 at) {
#if IMGUI_VERSION_NUM >= 18700
  // Since ImGui 1.87 these events are queued after the backend's, and the last one counts.
  io.AddMousePosEvent(at.x, at.y);
  for (int button = 0; button < ImGuiMouseButton_COUNT; ++button) {
    io.AddMouseButtonEvent(button, seen.down[static_cast<std::size_t>(button)]);
  }
#else
  std::ranges::copy(seen.down, io.MouseDown);
  io.MousePos = at;
#endif
}

/// The keys of lines and lists that Dear ImGui asks for.
struct EditingKey {
  int glfw;
  ImGuiKey key;
};
constexpr std::array kEditingKeys{
    EditingKey{GLFW_KEY_ENTER, ImGuiKey_Enter},
    EditingKey{GLFW_KEY_ESCAPE, ImGuiKey_Escape},
    EditingKey{GLFW_KEY_BACKSPACE, ImGuiKey_Backspace},
    EditingKey{GLFW_KEY_DELETE, ImGuiKey_Delete},
    EditingKey{GLFW_KEY_LEFT, ImGuiKey_LeftArrow},
    EditingKey{GLFW_KEY_RIGHT, ImGuiKey_RightArrow},
    EditingKey{GLFW_KEY_UP, ImGuiKey_UpArrow},
    EditingKey{GLFW_KEY_DOWN, ImGuiKey_DownArrow},
    EditingKey{GLFW_KEY_HOME, ImGuiKey_Home},
    EditingKey{GLFW_KEY_END, ImGuiKey_End},
};

bool tellKey(ImGuiIO& io, int glfw, bool down) {
  const auto* const known = std::ranges::find(kEditingKeys, glfw, &EditingKey::glfw);
  if (known == kEditingKeys.end()) return false;
#if IMGUI_VERSION_NUM >= 18700
  io.AddKeyEvent(known->key, down);
#else
  io.KeysDown[glfw] = down;
#endif
  return true;
}

}  // namespace

InterfaceContext::InterfaceContext(Window* window) : window_(window) {
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  // ImguiPainter supports it: otherwise a panel of more than 65,535 vertices would abort the
  // program.
  ImGui::GetIO().BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
#if IMGUI_VERSION_NUM >= 18700
  // Our InputQueue spreads changes over frames.
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
  // In quarters: a screen's scale may be any number, and each needs new glyphs.
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
  restyle();
  return true;
}

void InterfaceContext::useTheme(bool light) {
  if (light == light_) return;
  light_ = light;
  restyle();
}

void InterfaceContext::restyle() {
  ImGui::GetStyle() = ImGuiStyle();
  stylePanels(light_);
  ImGui::GetStyle().ScaleAllSizes(scale_);
}

/// A key that went down and up between two frames was down in this one.
void InterfaceContext::tellKeys(const std::vector<KeyPress>& presses) {
  ImGuiIO& io = ImGui::GetIO();
  for (const int key : told_keys_)
    tellKey(io, key, glfwGetKey(window_->handle(), key) == GLFW_PRESS);
  told_keys_.clear();
  for (const KeyPress& press : presses) {
    if (tellKey(io, press.key, true)) told_keys_.push_back(press.key);
  }
}

void InterfaceContext::beginFrame(int width, int height) {
  ImGuiIO& io = ImGui::GetIO();
  const ImVec2 pixels(static_cast<float>(width), static_cast<float>(height));
  if (window_ != nullptr) {
    ImGui_ImplGlfw_NewFrame();
    // The backend reads the present mouse and buttons: for a click between two frames it would
    // report the wrong place, and the release one frame late.
    const bool outside = !window_->followsPointer() && !window_->input().pending();
    const InputState& seen = window_->input().nextFrame();
    ImVec2 at(-FLT_MAX, -FLT_MAX);
    // GLFW uses window units.
    if ((!outside || seen.anyDown()) && io.DisplaySize.x > 0 && io.DisplaySize.y > 0) {
      at = ImVec2(static_cast<float>(seen.x) * pixels.x / io.DisplaySize.x,
                  static_cast<float>(seen.y) * pixels.y / io.DisplaySize.y);
    }
    tellMouse(io, seen, at);
    tellKeys(seen.keys);
  } else {
    io.DeltaTime = 1.0F / 60.0F;
  }
  io.DisplaySize = pixels;
  io.DisplayFramebufferScale = ImVec2(1, 1);
  ImGui::NewFrame();
}

}  // namespace rocinante
