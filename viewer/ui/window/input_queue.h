#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "core/base/time.h"

namespace rocinante {

/// A key that went down, or that repeats while it is held.
struct KeyPress {
  int key = 0;  ///< GLFW's number
  bool shift = false;
  bool repeated = false;
  bool control = false;
};

struct InputEvent {
  enum class Kind { move, press, release, key, letter };
  Kind kind = Kind::move;
  std::size_t button = 0;   ///< of a press or release: 0 is the left one
  double x = 0, y = 0;      ///< pointer position then, in window units
  KeyPress pressed{};       ///< of a key
  unsigned letter = 0;      ///< Unicode
  SteadyTime from{}, to{};  ///< between these it came
};

struct InputState {
  double x = 0, y = 0;
  std::array<bool, 5> down{};
  /// The button that goes down in this frame may have gone down soon after it did before: both are
  /// a double click, however late their frames are.
  bool again = false;
  std::vector<KeyPress> keys;     ///< of this frame, in order
  std::vector<unsigned> letters;  ///< typed in this frame, in order; Unicode
  bool anyDown() const;
};

/// Who takes keys and letters.
enum class KeyTaker {
  /// One key in a frame, with its letter, since it may open a line that takes the next one; repeats
  /// of a held key, and keys that change what others mean, stay with it.
  commands,
  /// One editing key in a frame (erase, enter, an arrow), and only one that was up in the frame
  /// before: each gets a frame, with one between two of the same, one after enter, which may close
  /// the line, and two after Tab, until the next line has the keyboard. What is typed after one
  /// comes in a later frame, since the line takes letters first. Repeats of a held key stay
  /// together.
  line,
  /// A line that has not got the keyboard yet: they wait, but not for more than 30 frames.
  nobody
};

/// Delivers ordered mouse and key events to frames. A frame sees the pointer where it was when a
/// button changed, and at most one change: even in a late frame a click is a press and a release at
/// its own place, a later jump of the pointer belongs to the next frame, and keys and clicks keep
/// their order. A button goes down only where everything already lies as the key or click before it
/// arranged it: a frame is between them. Plain values.
class InputQueue {
 public:
  void add(const InputEvent& event);
  /// The input of the next frame; valid until the next call.
  const InputState& nextFrame(KeyTaker taker = KeyTaker::commands);
  /// The last result of nextFrame().
  const InputState& thisFrame() const { return state_; }
  /// Keys that went down, which no frame has seen so far.
  std::vector<int> waitingKeys() const;
  /// True when events are left for another frame.
  bool pending() const { return !events_.empty(); }

 private:
  std::deque<InputEvent> events_;
  bool arranges_ = false;  ///< a key or a release came in the last frame
  int pauses_ = 0;         ///< coming frames without keys: which line takes them is not known yet
  int waited_ = 0;         ///< frames in a row in which nobody took keys
  std::array<std::optional<SteadyTime>, 5> pressed_at_;
  InputState state_;
};

}  // namespace rocinante
