#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/packet/session_state.h"

namespace rocinante {

/// How to restate a state (docs/packet-format.md, section "Restatements").
struct RestatementOptions {
  std::string_view by;           ///< the restating program; empty when it is the source itself
  bool reset = false;            ///< forget the memory of SEQUENCE first, and drop other items
  bool with_seen = false;        ///< add `seen` lines: keyframes only
  std::string_view part_id;      ///< ID of part=ID:I/N; must be a name, not empty
  std::size_t mtu_bytes = 1200;  ///< a datagram holds at most this, unless one statement is larger
  /// For a source that restates itself: the SEQUENCE of its first datagram, counted up from there,
  /// and the TIME of all. Empty: the source's highest SEQUENCE seen and last TIME, which is right
  /// for `by` and for a keyframe.
  std::optional<std::uint64_t> first_sequence;
  std::optional<std::int64_t> time_ns;
};

/// The datagrams that restate everything `source` owns in `state`, all parts in order: at least
/// one, also when it owns nothing or is unknown. Folding them restores its items, whatever the
/// receiver's state; the items of other sources on the same device need restateAll().
std::vector<std::string> restate(const SessionState& state, std::string_view source,
                                 const RestatementOptions& options);

/// The same for every source of the state. Folding all of them into an empty state, in this order,
/// gives the same items with the same owners; with `by` and `with_seen` it gives a state that is
/// sameAs() this one. Sources come in the order of their names; if several own items of one device
/// their parts interleave, so that statements that clear other sources' items come before those
/// items.
std::vector<std::string> restateAll(const SessionState& state, const RestatementOptions& options);

/// `source` and the sources whose restatements must come with its own, by restateAll(), so that
/// none deletes another's items: those that own items of a device of which `source` owns some, and
/// so on from them.
std::set<std::string, std::less<>> sourcesSharingDevices(const SessionState& state,
                                                         std::string_view source);

}  // namespace rocinante
