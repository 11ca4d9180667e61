#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "viewer/ui/window/input_queue.h"

struct ImGuiIO;

namespace rocinante {

/// What one frame of the window sees of mouse and keyboard. Plain values.
struct FrameInput {
  /// In pixels of the picture, from its top left; empty: outside the window.
  std::optional<std::pair<double, double>> mouse;
  std::array<bool, 5> down{};  ///< mouse buttons; 0 is the left one
  bool again = false;          ///< the button that goes down is the second one of a double click
  double wheel = 0, wheel_across = 0;
  std::vector<KeyPress> presses;  ///< that came since the last frame, in order
  /// Keys that are down, by GLFW's numbers, as far as lines of text, drags and flying ask for them;
  /// sorted.
  std::vector<int> held;
  std::string typed;  ///< UTF-8, since the last frame
  /// What a key of this frame pastes from other programs; UTF-8.
  std::optional<std::string> pasted;
  int width = 0, height = 0;  ///< of the picture, in pixels; 0: the window's
  double scale = 1;           ///< of text and panels, where the size is said

  /// What belongs to one frame is over; what is down stays down.
  void endFrame();
};

/// The same of this frame as Dear ImGui has it, after NewFrame(); without presses.
FrameInput seenInput();
/// Gives it to Dear ImGui, before NewFrame(). A key that was pressed is down in this frame.
void tellInput(ImGuiIO& io, const FrameInput& input);
/// Names the keys that lines of text need, where no window system does it.
void nameKeys(ImGuiIO& io);

/// Sets the mouse of the coming frame, overriding what the window system said.
void tellMouse(ImGuiIO& io, const std::array<bool, 5>& down,
               const std::optional<std::pair<double, double>>& at);
/// Whether the button that goes down in the coming frame is the second one of a double click: then
/// it is, however late its frame. Otherwise it is where both went down less than that apart.
void tellDoubleClick(ImGuiIO& io, bool again, float otherwise_s);
/// The same of a key; false when Dear ImGui does not ask for it.
bool tellKey(ImGuiIO& io, int glfw, bool down);
/// The same of a key that does something to a line of text while Ctrl is held, and of Ctrl.
bool tellShortcut(ImGuiIO& io, int glfw, bool down, bool control);
/// Whether the key pastes into a line of text.
bool isPasting(const KeyPress& press);
/// Whether this key, of those that seenInput() tells of, is down in this frame; modifiers never.
bool isKeyHeld(int glfw);
/// Whether seenInput() tells of this key.
bool isHeldKey(int glfw);

}  // namespace rocinante
