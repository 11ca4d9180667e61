#include "core/check/judges/presence_judge.h"

#include <fmt/format.h>

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

void PresenceJudge::report(const std::string& device, Findings& findings) const {
  if (before_add_.count > 0) {
    findings.push_back(before_add_.finding(
        "packet.before-add", device,
        fmt::format("device {} is used before the same source adds it", device)));
    findings.back().hint = "say `add` first: until it comes, nothing is drawn";
  }
  if (after_remove_.count > 0) {
    findings.push_back(
        after_remove_.finding("packet.after-remove", device,
                              fmt::format("device {} is used after it was removed", device)));
    findings.back().hint = "what is said of it is kept, and shown when it is added again";
  }
}

}  // namespace rocinante
