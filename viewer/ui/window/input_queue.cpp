#include "viewer/ui/window/input_queue.h"

#include <algorithm>
#include <utility>

namespace rocinante {
namespace {

/// By GLFW's numbers: what is below is a character, what is above only changes what others mean.
constexpr int kFirstFunctionKey = 256, kFirstModifierKey = 340;
constexpr int kEscapeKey = 256, kEnterKey = 257, kTabKey = 258, kPadEnterKey = 335;
constexpr std::chrono::milliseconds kDoubleClick(300);
constexpr int kMostWaiting = 30;

bool isModifier(const KeyPress& press) { return press.key >= kFirstModifierKey; }

/// For how many frames what follows a key of a line waits: which may close it, or lets the next
/// line get the keyboard, in a frame that loses what is typed.
int framesAfter(const KeyPress& press) {
  if (press.key == kTabKey) return 2;
  return press.key == kEnterKey || press.key == kPadEnterKey || press.key == kEscapeKey ? 1 : 0;
}

bool edits(const KeyPress& press) {
  return press.control || (press.key >= kFirstFunctionKey && press.key < kFirstModifierKey);
}

}  // namespace

bool InputState::anyDown() const {
  return std::ranges::any_of(down, [](bool one) { return one; });
}

void InputQueue::add(const InputEvent& event) {
  if (event.button >= state_.down.size()) return;
  // Only the last of consecutive moves counts.
  const bool follows_move = !events_.empty() && events_.back().kind == InputEvent::Kind::move;
  if (event.kind == InputEvent::Kind::move && follows_move) events_.pop_back();
  events_.push_back(event);
}

const InputState& InputQueue::nextFrame(KeyTaker taker) {
  waited_ = taker == KeyTaker::nobody ? waited_ + 1 : 0;
  if (waited_ > kMostWaiting) taker = KeyTaker::line;
  bool moved = false;
  const bool arranged = std::exchange(arranges_, false);
  const bool waits = taker == KeyTaker::nobody || pauses_ > 0;
  if (pauses_ > 0) --pauses_;
  bool ends = false;
  state_.again = false;
  state_.letters.clear();
  const std::vector<KeyPress> before = std::exchange(state_.keys, {});
  const auto keyWaits = [&](const KeyPress& press) {
    if (waits || ends) return true;
    if (press.repeated || isModifier(press)) return false;
    if (taker == KeyTaker::commands) {
      return std::ranges::any_of(state_.keys, [](const KeyPress& one) { return !isModifier(one); });
    }
    return edits(press) && (std::ranges::any_of(state_.keys, edits) ||
                            std::ranges::find(before, press.key, &KeyPress::key) != before.end());
  };
  const auto letterWaits = [&] {
    if (waits || ends) return true;
    return taker == KeyTaker::line && std::ranges::any_of(state_.keys, edits);
  };
  while (!events_.empty()) {
    const InputEvent event = events_.front();
    // A drag ends in a separate frame, so that its last move is seen with the button down.
    if (event.kind == InputEvent::Kind::release && moved) break;
    if (event.kind == InputEvent::Kind::press && arranged) break;
    const bool is_key = event.kind == InputEvent::Kind::key;
    const bool is_letter = event.kind == InputEvent::Kind::letter;
    if (!is_key && !is_letter && !(state_.keys.empty() && state_.letters.empty())) break;
    if ((is_key && keyWaits(event.pressed)) || (is_letter && letterWaits())) break;
    events_.pop_front();
    if (is_letter) {
      state_.letters.push_back(event.letter);
      continue;
    }
    if (is_key) {
      state_.keys.push_back(event.pressed);
      arranges_ = true;
      if (taker == KeyTaker::line) pauses_ = std::max(pauses_, framesAfter(event.pressed));
      ends = pauses_ > 0;
      continue;
    }
    state_.x = event.x;
    state_.y = event.y;
    if (event.kind == InputEvent::Kind::move) {
      moved = true;
      continue;
    }
    const bool goes_down = event.kind == InputEvent::Kind::press;
    state_.down[event.button] = goes_down;
    if (goes_down) {
      const auto last = std::exchange(pressed_at_[event.button], event.to);
      const SteadyTime probably = event.from + (event.to - event.from) / 2;
      state_.again = last && probably - *last < kDoubleClick;
    }
    arranges_ = !goes_down;
    break;
  }
  return state_;
}

std::vector<int> InputQueue::waitingKeys() const {
  std::vector<int> keys;
  for (const InputEvent& event : events_) {
    if (event.kind == InputEvent::Kind::key && !event.pressed.repeated) {
      keys.push_back(event.pressed.key);
    }
  }
  return keys;
}

}  // namespace rocinante
