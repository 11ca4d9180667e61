#include "viewer/ui/window/frame_input.h"

#include <imgui.h>
#include <imgui_internal.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cfloat>

namespace rocinante {
namespace {

/// A key of lines and lists that Dear ImGui asks for.
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
/// Keys that it asks for only while they are held, and takes from the window system.
constexpr std::array kOtherKeys {
  EditingKey{GLFW_KEY_TAB, ImGuiKey_Tab}, EditingKey{GLFW_KEY_PAGE_UP, ImGuiKey_PageUp},
      EditingKey{GLFW_KEY_PAGE_DOWN, ImGuiKey_PageDown},
      EditingKey{GLFW_KEY_INSERT, ImGuiKey_Insert}, EditingKey{GLFW_KEY_SPACE, ImGuiKey_Space},
#if IMGUI_VERSION_NUM >= 18700
      EditingKey{GLFW_KEY_KP_ENTER, ImGuiKey_KeypadEnter},
#else
      EditingKey{GLFW_KEY_KP_ENTER, ImGuiKey_KeyPadEnter},
#endif
      EditingKey{GLFW_KEY_A, ImGuiKey_A}, EditingKey{GLFW_KEY_C, ImGuiKey_C},
      EditingKey{GLFW_KEY_V, ImGuiKey_V}, EditingKey{GLFW_KEY_X, ImGuiKey_X},
      EditingKey{GLFW_KEY_Y, ImGuiKey_Y}, EditingKey{GLFW_KEY_Z, ImGuiKey_Z},
};
/// Keys that it does not ask for: with A they fly while the right mouse button is held. Before
/// Dear ImGui 1.87 they have no names there.
constexpr std::array kFlyKeys {
#if IMGUI_VERSION_NUM >= 18700
  EditingKey{GLFW_KEY_W, ImGuiKey_W}, EditingKey{GLFW_KEY_S, ImGuiKey_S},
      EditingKey{GLFW_KEY_D, ImGuiKey_D}, EditingKey{GLFW_KEY_Q, ImGuiKey_Q},
      EditingKey{GLFW_KEY_E, ImGuiKey_E},
#else
  EditingKey{GLFW_KEY_W, ImGuiKey_COUNT}, EditingKey{GLFW_KEY_S, ImGuiKey_COUNT},
      EditingKey{GLFW_KEY_D, ImGuiKey_COUNT}, EditingKey{GLFW_KEY_Q, ImGuiKey_COUNT},
      EditingKey{GLFW_KEY_E, ImGuiKey_COUNT},
#endif
};

/// Held keys that change what others and the mouse mean.
struct ModifierKey {
  int glfw;
  bool ImGuiIO::*held;
};
constexpr std::array kModifiers{
    ModifierKey{GLFW_KEY_LEFT_SHIFT, &ImGuiIO::KeyShift},
    ModifierKey{GLFW_KEY_LEFT_CONTROL, &ImGuiIO::KeyCtrl},
    ModifierKey{GLFW_KEY_LEFT_ALT, &ImGuiIO::KeyAlt},
    ModifierKey{GLFW_KEY_LEFT_SUPER, &ImGuiIO::KeySuper},
};

template <typename Keys>
const EditingKey* findKey(const Keys& keys, int glfw) {
  const auto found = std::ranges::find(keys, glfw, &EditingKey::glfw);
  return found == keys.end() ? nullptr : &*found;
}

bool isDown([[maybe_unused]] const ImGuiIO& io, const EditingKey& key) {
#if IMGUI_VERSION_NUM >= 18700
  return ImGui::IsKeyDown(key.key);
#else
  return io.KeysDown[key.glfw];
#endif
}

void setDown(ImGuiIO& io, const EditingKey& key, bool down) {
#if IMGUI_VERSION_NUM >= 18700
  io.AddKeyEvent(key.key, down);
#else
  io.KeysDown[key.glfw] = down;
#endif
}

/// `place`: in kModifiers.
void setModifier(ImGuiIO& io, std::size_t place, bool held) {
#if IMGUI_VERSION_NUM >= 18900
  constexpr std::array kModifierKeys{ImGuiMod_Shift, ImGuiMod_Ctrl, ImGuiMod_Alt, ImGuiMod_Super};
  io.AddKeyEvent(kModifierKeys[place], held);
#elif IMGUI_VERSION_NUM >= 18700
  constexpr std::array kModifierKeys{ImGuiKey_ModShift, ImGuiKey_ModCtrl, ImGuiKey_ModAlt,
                                     ImGuiKey_ModSuper};
  io.AddKeyEvent(kModifierKeys[place], held);
#else
  io.*kModifiers[place].held = held;
#endif
}

}  // namespace

void FrameInput::endFrame() {
  again = false;
  wheel = wheel_across = 0;
  presses.clear();
  typed.clear();
  pasted.reset();
}

FrameInput seenInput() {
  const ImGuiIO& io = ImGui::GetIO();
  FrameInput seen;
  if (ImGui::IsMousePosValid()) seen.mouse = {io.MousePos.x, io.MousePos.y};
  std::copy(std::begin(io.MouseDown), std::end(io.MouseDown), seen.down.begin());
  seen.wheel = io.MouseWheel;
  seen.wheel_across = io.MouseWheelH;
  const auto take = [&](const EditingKey& key) {
    if (isDown(io, key)) seen.held.push_back(key.glfw);
  };
  std::ranges::for_each(kEditingKeys, take);
  std::ranges::for_each(kOtherKeys, take);
  std::ranges::for_each(kFlyKeys, take);
  for (const ModifierKey& modifier : kModifiers) {
    if (io.*modifier.held) seen.held.push_back(modifier.glfw);
  }
  std::ranges::sort(seen.held);
  for (const ImWchar letter : io.InputQueueCharacters) {
    std::array<char, 5> bytes{};  // ends in a zero; what the function returns differs by version
    ImTextCharToUtf8(bytes.data(), letter);
    seen.typed += bytes.data();
  }
  return seen;
}

void tellInput(ImGuiIO& io, const FrameInput& input) {
  tellMouse(io, input.down, input.mouse);
  tellDoubleClick(io, input.again, ImGuiIO().MouseDoubleClickTime);
#if IMGUI_VERSION_NUM >= 18700
  if (input.wheel != 0 || input.wheel_across != 0) {
    io.AddMouseWheelEvent(static_cast<float>(input.wheel_across), static_cast<float>(input.wheel));
  }
#else
  io.MouseWheel = static_cast<float>(input.wheel);
  io.MouseWheelH = static_cast<float>(input.wheel_across);
#endif
  // A key that went down in this frame is down in it, also one that changes what others mean.
  const auto is_down = [&](int key) {
    return std::ranges::binary_search(input.held, key) ||
           std::ranges::find(input.presses, key, &KeyPress::key) != input.presses.end();
  };
  const auto tell = [&](const EditingKey& key) { setDown(io, key, is_down(key.glfw)); };
  std::ranges::for_each(kEditingKeys, tell);
  std::ranges::for_each(kOtherKeys, tell);
  std::ranges::for_each(kFlyKeys, tell);
  for (std::size_t i = 0; i < kModifiers.size(); ++i) {
    setModifier(io, i, is_down(kModifiers[i].glfw));
  }
  if (input.pasted) ImGui::SetClipboardText(input.pasted->c_str());
  if (!input.typed.empty()) io.AddInputCharactersUTF8(input.typed.c_str());
}

void nameKeys([[maybe_unused]] ImGuiIO& io) {
#if IMGUI_VERSION_NUM < 18700
  for (const EditingKey& key : kEditingKeys) io.KeyMap[key.key] = key.glfw;
  for (const EditingKey& key : kOtherKeys) io.KeyMap[key.key] = key.glfw;
#endif
}

void tellMouse(ImGuiIO& io, const std::array<bool, 5>& down,
               const std::optional<std::pair<double, double>>& at) {
  ImVec2 place(-FLT_MAX, -FLT_MAX);
  if (at) place = ImVec2(static_cast<float>(at->first), static_cast<float>(at->second));
#if IMGUI_VERSION_NUM >= 18700
  // Since ImGui 1.87 these events are queued after the backend's, and the last one counts.
  io.AddMousePosEvent(place.x, place.y);
  for (int button = 0; button < ImGuiMouseButton_COUNT; ++button) {
    io.AddMouseButtonEvent(button, down[static_cast<std::size_t>(button)]);
  }
#else
  std::ranges::copy(down, io.MouseDown);
  io.MousePos = place;
#endif
}

void tellDoubleClick(ImGuiIO& io, bool again, float otherwise_s) {
  constexpr float kHoweverLate = 1e9F;
  io.MouseDoubleClickTime = again ? kHoweverLate : otherwise_s;
}

bool tellKey(ImGuiIO& io, int glfw, bool down) {
  const EditingKey* const known = findKey(kEditingKeys, glfw);
  if (known != nullptr) setDown(io, *known, down);
  return known != nullptr;
}

bool tellShortcut(ImGuiIO& io, int glfw, bool down, bool control) {
  const EditingKey* const known = findKey(kOtherKeys, glfw);
  if (known == nullptr) return false;
  setDown(io, *known, down);
  constexpr std::size_t kControl = 1;
  setModifier(io, kControl, control);
  return true;
}

bool isPasting(const KeyPress& press) {
  return (press.key == GLFW_KEY_V && press.control && !press.shift) ||
         (press.key == GLFW_KEY_INSERT && press.shift && !press.control);
}

bool isKeyHeld(int glfw) {
  const ImGuiIO& io = ImGui::GetIO();
  for (const EditingKey* const key :
       {findKey(kEditingKeys, glfw), findKey(kOtherKeys, glfw), findKey(kFlyKeys, glfw)}) {
    if (key != nullptr) return isDown(io, *key);
  }
  return false;
}

bool isHeldKey(int glfw) {
  return findKey(kEditingKeys, glfw) != nullptr || findKey(kOtherKeys, glfw) != nullptr ||
         findKey(kFlyKeys, glfw) != nullptr ||
         std::ranges::find(kModifiers, glfw, &ModifierKey::glfw) != kModifiers.end();
}

}  // namespace rocinante
