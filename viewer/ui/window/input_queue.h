#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <vector>

namespace rocinante {

/// A key that went down, or that repeats while it is held.
struct KeyPress {
  int key = 0;  ///< GLFW's number
  bool shift = false;
  bool repeated = false;
};

struct InputEvent {
  enum class Kind { move, press, release, key };
  Kind kind = Kind::move;
  std::size_t button = 0;  ///< of a press or release: 0 is the left one
  double x = 0, y = 0;     ///< where the pointer was then, in the window's own units
  KeyPress pressed{};      ///< of a key
};

struct InputState {
  double x = 0, y = 0;
  std::array<bool, 5> down{};
  std::vector<KeyPress> keys;  ///< of this frame, in order
  bool anyDown() const;
};

/// Mouse and keys as frames see them, from events in their order. A frame sees the pointer where it
/// was when a button changed, and one change at most: however late a frame is, a click is a press
/// and a release at its own place, a jump of the pointer behind it is the next frame's, and keys
/// come neither before the clicks that they followed nor after those that followed them. Plain
/// values.
class InputQueue {
 public:
  void add(const InputEvent& event);
  /// What the next frame sees; valid until the next call.
  const InputState& nextFrame();
  /// What nextFrame() answered last.
  const InputState& thisFrame() const { return state_; }
  /// Something is left for another frame.
  bool pending() const { return !events_.empty(); }

 private:
  std::deque<InputEvent> events_;
  InputState state_;
};

/// How many frames are drawn at once after something happened, before the window waits again: a
/// press shows in the frame that sees it, its effect on panels in the next one, and a panel that
/// fits itself is one later still.
class SettlingFrames {
 public:
  static constexpr int kFrames = 3;
  void drawn(bool anything_happened) { left_ = anything_happened ? kFrames : left_ - (left_ > 0); }
  bool settled() const { return left_ == 0; }

 private:
  int left_ = kFrames;
};

}  // namespace rocinante
