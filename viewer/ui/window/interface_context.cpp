#include "viewer/ui/window/interface_context.h"

#include <imgui.h>
#include <imgui_impl_glfw.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>

#include "viewer/overlay/embedded_font.h"
#include "viewer/overlay/text_atlas.h"
#include "viewer/ui/window/panel_style.h"

namespace rocinante {
namespace {

/// What panels have glyphs for: the characters of pictures. By itself Dear ImGui has those of
/// Western Europe alone, and a question mark for any other.
const ImWchar* panelCharacters() {
  static const std::vector<ImWchar> ranges = [] {
    std::vector<ImWchar> ends;
    for (const auto& [first, last] : drawnCharacters()) {
      ends.insert(ends.end(), {static_cast<ImWchar>(first), static_cast<ImWchar>(last)});
    }
    ends.push_back(0);
    return ends;
  }();
  return ranges.data();
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
  if (window_ != nullptr) {
    ImGui_ImplGlfw_InitForOpenGL(window_->handle(), true);
    window_->takeLetters();
  } else {
    nameKeys(ImGui::GetIO());
  }
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
  config.GlyphRanges = panelCharacters();
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
  const auto is_down = [this](int key) { return glfwGetKey(window_->handle(), key) == GLFW_PRESS; };
  const bool control = is_down(GLFW_KEY_LEFT_CONTROL) || is_down(GLFW_KEY_RIGHT_CONTROL);
  for (const int key : reported_keys_) {
    if (!tellKey(io, key, is_down(key))) tellShortcut(io, key, is_down(key), control);
  }
  reported_keys_.clear();
  for (const KeyPress& press : presses) {
    if (tellKey(io, press.key, true) ||
        (press.control && tellShortcut(io, press.key, true, true))) {
      reported_keys_.push_back(press.key);
    }
  }
  // Dear ImGui's own callbacks say that a key is down while its press still waits for a frame.
  for (const int key : window_->input().waitingKeys()) {
    if (std::ranges::find(presses, key, &KeyPress::key) != presses.end()) continue;
    if (!tellKey(io, key, false)) tellShortcut(io, key, false, control);
  }
}

/// The backend reads the present mouse and buttons: for a click between two frames it would report
/// the wrong place, and the release one frame late.
void InterfaceContext::tellWindow(double width, double height, KeyTaker taker) {
  ImGuiIO& io = ImGui::GetIO();
  const bool outside = !window_->followsPointer() && !window_->input().pending();
  const InputState& seen = window_->input().nextFrame(taker);
  std::optional<std::pair<double, double>> at;
  // GLFW uses window units.
  if ((!outside || seen.anyDown()) && io.DisplaySize.x > 0 && io.DisplaySize.y > 0) {
    const auto x = static_cast<float>(seen.x), y = static_cast<float>(seen.y);
    at = {x * static_cast<float>(width) / io.DisplaySize.x,
          y * static_cast<float>(height) / io.DisplaySize.y};
  }
  tellMouse(io, seen.down, at);
  tellDoubleClick(io, seen.again, 0);
  tellKeys(seen.keys);
  for (const unsigned letter : seen.letters) io.AddInputCharacter(letter);
  presses_ = seen.keys;
}

void InterfaceContext::beginFrame(int width, int height, const FrameInput* scripted,
                                  std::optional<float> seconds, KeyTaker taker) {
  ImGuiIO& io = ImGui::GetIO();
  if (window_ != nullptr) {
    ImGui_ImplGlfw_NewFrame();
    tellWindow(width, height, taker);
  } else {
    io.DeltaTime = kScriptedSeconds;
    if (scripted != nullptr) tellInput(io, *scripted);
    presses_ = scripted != nullptr ? scripted->presses : std::vector<KeyPress>();
  }
  if (seconds) io.DeltaTime = *seconds;
  io.DisplaySize = ImVec2(static_cast<float>(width), static_cast<float>(height));
  io.DisplayFramebufferScale = ImVec2(1, 1);
  ImGui::NewFrame();
}

FrameInput InterfaceContext::seen() const {
  FrameInput input = seenInput();
  input.presses = presses_;
  input.again = window_ != nullptr && window_->input().thisFrame().again;
  // Only what goes into a line of text is anybody's business.
  if (ImGui::GetIO().WantTextInput && std::ranges::any_of(presses_, isPasting)) {
    const char* const text = ImGui::GetClipboardText();
    input.pasted = text == nullptr ? std::string() : std::string(text);
  }
  return input;
}

}  // namespace rocinante
