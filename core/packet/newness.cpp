#include "core/packet/newness.h"

namespace rocinante {

Newness newnessOf(const SessionState& state, const PacketHeader& header) {
  const auto found = state.sources().find(header.source);
  if (found == state.sources().end()) return Newness::newest;
  const SourceState& source = found->second;
  if (source.run != header.run) return Newness::restart;
  const std::optional<std::uint64_t>& highest = source.highest_sequence;
  if (header.reset || !header.sequence || !highest) return Newness::newest;
  const bool own = header.by.empty();
  if (own && isRestart(*header.sequence, *highest)) return Newness::restart;
  const bool is_above = *header.sequence > *highest || (!own && *header.sequence == *highest);
  return is_above ? Newness::newest : Newness::late;
}

}  // namespace rocinante
