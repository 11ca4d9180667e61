#include "viewer/ui/window/input_queue.h"

#include <algorithm>

namespace rocinante {

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

const InputState& InputQueue::nextFrame() {
  bool moved = false;
  state_.keys.clear();
  while (!events_.empty()) {
    const InputEvent event = events_.front();
    // A drag ends in a separate frame, so that its last move is seen with the button down.
    if (event.kind == InputEvent::Kind::release && moved) break;
    const bool is_key = event.kind == InputEvent::Kind::key;
    if (!is_key && !state_.keys.empty()) break;
    events_.pop_front();
    if (is_key) {
      state_.keys.push_back(event.pressed);
      continue;
    }
    state_.x = event.x;
    state_.y = event.y;
    if (event.kind == InputEvent::Kind::move) {
      moved = true;
      continue;
    }
    state_.down[event.button] = event.kind == InputEvent::Kind::press;
    break;
  }
  return state_;
}

}  // namespace rocinante
