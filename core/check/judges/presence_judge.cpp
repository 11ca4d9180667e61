#include "core/check/judges/presence_judge.h"

namespace rocinante {
namespace {

/// Another source needs a moment to learn that a device was removed.
constexpr Nanoseconds kRemovalKnown = std::chrono::seconds(1);

}  // namespace

void PresenceJudge::add(const PacketPlace& place) {
  // A restated `add` was first sent before the session was listened to.
  const bool is_wrong_order = state_ == State::unknown && !place.is_restated &&
                              waiting_source_ == place.source && waiting_stretch_ == place.stretch;
  if (is_wrong_order) before_add_.merge(waiting_);
  waiting_ = {};
  state_ = State::there;
}

void PresenceJudge::remove(const PacketPlace& place) {
  if (state_ == State::removed) return;  // a repetition
  state_ = State::removed;
  remover_ = place.source;
  removed_at_ = place.time;
}

void PresenceJudge::mentionAbsent(const PacketPlace& place) {
  if (place.is_restated) return;
  if (state_ == State::removed) {
    if (place.source == remover_ || place.time - removed_at_ > kRemovalKnown) {
      after_remove_.hit(place);
    }
    return;
  }
  if (waiting_.count == 0) {
    waiting_source_ = place.source;
    waiting_stretch_ = place.stretch;
  }
  if (waiting_source_ == place.source) waiting_.hit(place);
}

}  // namespace rocinante
