#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/packet/session_state.h"

namespace rocinante {

/// How a state is said again (docs/packet-format.md, section "Restatements").
struct RestatementOptions {
  std::string_view by;           ///< who says it; empty when the source speaks for itself
  bool reset = false;            ///< forget the memory of SEQUENCE first, and drop other items
  bool with_seen = false;        ///< add `seen` lines: keyframes only
  std::string_view part_id;      ///< ID of part=ID:I/N; must be a name, not empty
  std::size_t mtu_bytes = 1200;  ///< a datagram holds at most this, unless one statement is larger
};

/// The datagrams that restate everything `source` owns in `state`, all parts in order: at least
/// one, also when it owns nothing. Folding them into an empty state gives the same items.
/// A source that speaks for itself numbers the datagrams later: SEQUENCE is written as the source's
/// highest seen, which is right for `by` and for a keyframe.
std::vector<std::string> restate(const SessionState& state, std::string_view source,
                                 const RestatementOptions& options);

/// The same for every source of the state, in the order of their names.
std::vector<std::string> restateAll(const SessionState& state, const RestatementOptions& options);

}  // namespace rocinante
