#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/packet/session_state.h"
#include "core/relay/restating.h"

namespace rocinante {

/// The relays that the newest datagram of each SOURCE has passed; sources without any are absent.
using ThroughBySource = std::map<std::string, std::string, std::less<>>;

/// Writes the datagrams that a relay itself makes for one output: chooses their headers, so that
/// newest-wins applies each of them at the listener. One thread.
class OutputHeader {
 public:
  struct Options {
    std::string relay;   ///< NAME
    std::string output;  ///< OUTPUT of via=NAME:OUTPUT:N; empty: a whole output, without via=
  };
  explicit OutputHeader(Options options);

  /// The datagram of `draft`: the source's own when its SEQUENCE is new to this output and the
  /// draft does not belong to a restatement, else `restated by=NAME`; of a draft with events, the
  /// source's own with SEQUENCE `-`.
  /// Says `reset` while the listener may remember a higher SEQUENCE, after the fold went back.
  std::string datagramOf(const RelayDraft& draft, const SessionState& state,
                         const ThroughBySource& through, bool restating);
  /// The bytes of the longest header for the source, its LF included; `part` adds those of part=.
  std::size_t mostBytes(std::string_view source, const SessionState& state,
                        const ThroughBySource& through,
                        std::optional<RestatementPart> part = {}) const;
  /// The bytes that a restatement has for statements in a datagram of `datagram_bytes`.
  std::size_t roomInParts(const SessionState& state, const ThroughBySource& through,
                          std::string_view part_id, std::size_t datagram_bytes) const;

 private:
  std::string unnumbered(const RelayDraft& draft, PacketHeader header,
                         const ThroughBySource& through);

  /// What the listener remembers of a source, when nothing was lost.
  struct Sent {
    std::string run;
    std::optional<std::uint64_t> sequence;
    std::optional<std::uint64_t> highest;  ///< of the run: what the listener may still remember
  };

  Options options_;
  std::string name_;  ///< the relay's, encoded
  std::string via_;   ///< NAME:OUTPUT
  std::uint64_t count_ = 0;
  std::map<std::string, Sent, std::less<>> sent_;
};

}  // namespace rocinante
