#include "core/check/judges/stream_judge.h"

#include <algorithm>

namespace rocinante {

StreamJudge::StreamJudge(const RuleSettings& rules, std::span<const CellSource> sources)
    : rules_(rules), cell_sources_(sources) {}

Decoder* StreamJudge::decoderFor(std::string_view encoding) {
  if (Decoder* const* const known = decoder_cache_.find(encoding)) return *known;
  auto found = decoders_.find(encoding);
  if (found == decoders_.end()) {
    found = decoders_.emplace(std::string(encoding), makeDecoder(encoding)).first;
  }
  decoder_cache_.remember(found->first, found->second.get());
  return found->second.get();
}

StreamJudge::Source& StreamJudge::source(std::string_view name) {
  if (Source* const* const known = source_cache_.find(name)) return **known;
  auto found = sources_.find(name);
  if (found == sources_.end()) {
    const auto listed = std::ranges::find(cell_sources_, name, &CellSource::name);
    const CellSource* const expected = listed == cell_sources_.end() ? nullptr : &*listed;
    const auto number = static_cast<std::uint32_t>(source_names_.size());
    source_names_.emplace_back(name);
    SourceJudge judge(source_names_.back(), number, SourceThresholds::of(rules_, expected));
    const SourceCounts& counts = state_.counts().find(name)->second;
    found = sources_.emplace(source_names_.back(), Source{std::move(judge), &counts}).first;
  }
  source_cache_.remember(found->first, &found->second);
  return found->second;
}

StreamJudge::Judged StreamJudge::add(LogTime time, std::string_view encoding, bool captured,
                                     ByteView datagram, std::string_view sender) {
  if (captured) ++datagrams_;
  if (captured || datagrams_ == 0) end_ = std::max(end_, time);
  Judged judged;
  PacketPlace& place = judged.place;
  place.time = time;
  place.packet = datagrams_;
  place.datagram = datagram;
  place.sender = sender;
  Decoder* const decoder = decoderFor(encoding);
  if (decoder == nullptr) {
    faults_.takeUndecoded(encoding, place);
    return judged;
  }
  judged.packet = decoder->decode(datagram);
  judged.faults = decoder->faults();
  if (!judged.faults.empty()) faults_.takeFaults(judged.faults, place);
  if (judged.packet == nullptr) return judged;
  if (captured) ++packets_;

  const PacketHeader& header = judged.packet->header;
  const std::uint64_t relay_gap_before = header.via ? relayGap(header.via->relay) : 0;
  const Applied applied = state_.apply(time, *judged.packet);
  if (applied == Applied::refused) {
    refused_.hit(place);
    return judged;
  }
  if (header.via && relayGap(header.via->relay) > relay_gap_before) relay_gap_.hit(place);
  Source& from = source(header.source);
  place.line = 1;
  place.sequence = header.sequence.value_or(0);
  if (!captured && header.by.empty() && !judged.packet->statements.empty()) {
    place.publisher = judged.packet->statements.front().name;
  }
  from.judge.take(header, applied, *from.counts, place);
  // A late packet is dropped whole and has no effect.
  if (applied != Applied::late) judged.source = &from.judge;
  return judged;
}

void StreamJudge::addOctets(LogTime time, std::string_view encoding, bool decoded) {
  ++datagrams_;
  end_ = std::max(end_, time);
  if (decoded) {
    ++packets_;
    return;
  }
  PacketPlace place;
  place.time = time;
  place.packet = datagrams_;
  faults_.takeUndecoded(encoding, place);
}

std::uint64_t StreamJudge::relayGap(std::string_view relay) const {
  const auto found = state_.relays().find(relay);
  return found == state_.relays().end() ? 0 : found->second.gap;
}

std::uint64_t StreamJudge::relayGaps() const {
  std::uint64_t gaps = 0;
  for (const auto& [relay, counts] : state_.relays()) gaps += counts.gap;
  return gaps;
}

void StreamJudge::dropFindings() {
  faults_.dropFindings();
  refused_ = relay_gap_ = {};
  dropped_relay_gaps_ = relayGaps();
  for (auto& [name, each] : sources_) each.judge.dropFindings();
}

void StreamJudge::reportSources(LogTime now, Findings& findings) const {
  for (const std::string& name : source_names_) {
    sources_.find(name)->second.judge.report(now, findings);
  }
  if (refused_.count > 0) {
    findings.push_back(
        refused_.finding("source.refused", "", "packets of more sources than the limit allows"));
  }
  const std::uint64_t gaps = relayGaps();
  if (gaps > dropped_relay_gaps_) {
    findings.push_back(
        relay_gap_.finding("source.relay-gap", "",
                           "packets that a relay sent on, by its own count, and that never "
                           "arrived"));
    findings.back().count = gaps - dropped_relay_gaps_;
  }
}

}  // namespace rocinante
