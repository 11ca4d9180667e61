#pragma once

#include <string>
#include <vector>

#include "core/base/time.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// An event that both sessions have.
struct MatchedEvent {
  std::string text;
  LogTime a{}, b{};
};

/// Maps times of one session to another of the same scenario: linear between two common events, one
/// to one before the first and after the last.
struct EventAlignment {
  std::vector<MatchedEvent> matched;  ///< times do not decrease on either side
  std::vector<Event> only_a, only_b;  ///< missing on the other side
  LogTime anchor_a{}, anchor_b{};     ///< aligned with each other when no event is matched

  LogTime inB(LogTime in_a) const;
};

/// Matches as many events of equal text and source as possible without crossing. Marks, which a
/// person set on one recording, are ignored. Without common events, the anchors are aligned.
EventAlignment alignEvents(const std::vector<Event>& a, const std::vector<Event>& b,
                           LogTime anchor_a, LogTime anchor_b);

}  // namespace rocinante
