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

/// How the times of one session belong to those of another of the same scenario: straight between
/// two events that both have, one to one before the first and behind the last.
struct EventAlignment {
  std::vector<MatchedEvent> matched;  ///< times of neither go back
  std::vector<Event> only_a, only_b;  ///< missing in the other one
  LogTime anchor_a{}, anchor_b{};     ///< belong to each other where no event is matched

  LogTime inB(LogTime in_a) const;
};

/// Matches events of one text and source, as many as can be without crossing. Marks, which a person
/// set on one recording, do not count. Without any in both, the anchors are laid on each other.
EventAlignment alignEvents(const std::vector<Event>& a, const std::vector<Event>& b,
                           LogTime anchor_a, LogTime anchor_b);

}  // namespace rocinante
