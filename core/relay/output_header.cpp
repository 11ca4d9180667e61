#include "core/relay/output_header.h"

#include <algorithm>
#include <utility>

#include "core/packet/packet_limits.h"
#include "core/packet/packet_text.h"
#include "core/relay/through.h"

namespace rocinante {
namespace {

/// One short statement has room in any datagram.
constexpr std::size_t kLeastRoom = 40;

PacketHeader headerOf(std::string_view source, const SessionState& state) {
  PacketHeader header;
  header.source = source;
  const auto known = state.sources().find(source);
  if (known == state.sources().end()) return header;
  header.run = known->second.run;
  header.sequence = known->second.highest_sequence;
  header.time_ns = known->second.time_ns;
  return header;
}

std::string throughText(const std::string& name, std::string_view source,
                        const ThroughBySource& through) {
  const auto passed = through.find(source);
  std::string_view before;
  if (passed != through.end()) before = passed->second;
  return " through=" + throughWith(before, name);
}

}  // namespace

OutputHeader::OutputHeader(Options options)
    : options_(std::move(options)),
      name_(encodeName(options_.relay)),
      via_(options_.relay + ":" + options_.output) {}

std::size_t OutputHeader::mostBytes(std::string_view source, const SessionState& state,
                                    const ThroughBySource& through,
                                    std::optional<RestatementPart> part) const {
  PacketHeader header = headerOf(source, state);
  header.part = part;
  header.restated = true;
  header.by = options_.relay;
  if (!options_.output.empty()) header.via = {via_, count_};
  return headerText(header).size() + throughText(name_, source, through).size() + 1;
}

std::size_t OutputHeader::roomInParts(const SessionState& state, const ThroughBySource& through,
                                      std::string_view part_id, std::size_t datagram_bytes) const {
  const RestatementPart longest{part_id, 99'999, 99'999};
  std::size_t header = 0;
  for (const auto& source : state.sources()) {
    header = std::max(header, mostBytes(source.first, state, through, longest));
  }
  return std::max(kLeastRoom, datagram_bytes - std::min(datagram_bytes, header));
}

/// An event that waited until its SEQUENCE was used: newest-wins would drop another datagram with
/// it, and ignore the events of one with `by=`.
std::string OutputHeader::unnumbered(const RelayDraft& draft, PacketHeader header,
                                     const ThroughBySource& through) {
  header.sequence.reset();
  if (!options_.output.empty()) header.via = {via_, count_++};
  return headerText(header) + throughText(name_, draft.source, through) + '\n' + draft.text;
}

std::string OutputHeader::datagramOf(const RelayDraft& draft, const SessionState& state,
                                     const ThroughBySource& through, bool restating) {
  PacketHeader header = headerOf(draft.source, state);
  auto known = sent_.find(draft.source);
  const bool same_run = known != sent_.end() && known->second.run == header.run;
  if (known == sent_.end()) known = sent_.emplace(draft.source, Sent()).first;
  Sent& sent = known->second;
  if (!same_run) sent = {std::string(header.run), {}, {}};
  const std::optional<std::uint64_t>& sequence = header.sequence;
  const bool is_new = !sequence || !sent.sequence || *sequence != *sent.sequence;
  if (draft.has_events && !is_new) return unnumbered(draft, header, through);
  const bool own = !restating && is_new;
  header.reset = sent.highest && (!sequence || *sequence < *sent.highest + (own ? 1 : 0));
  header.restated = !own;
  if (!own) header.by = options_.relay;
  header.part = draft.part;
  if (!options_.output.empty()) header.via = {via_, count_++};
  sent.sequence = sequence;
  if (sequence) sent.highest = std::max(*sequence, sent.highest.value_or(0));

  std::string text = headerText(header);
  if (!own || !sequence || header.reset) text += throughText(name_, draft.source, through);
  text += '\n';
  text += draft.text;
  return text;
}

}  // namespace rocinante
