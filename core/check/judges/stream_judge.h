#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/base/bytes.h"
#include "core/cell/cell.h"
#include "core/check/judges/datagram_judge.h"
#include "core/check/judges/source_judge.h"
#include "core/check/rules/rule_settings.h"
#include "core/packet/decoder.h"
#include "core/packet/name_cache.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// Folds a stream of datagrams and judges what needs no model: encodings, faults of packet text,
/// and each source's numbers, clock, cadence and restatements. No allocation per packet once
/// everything in it has been seen. One thread.
class StreamJudge {
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const {
      return std::hash<std::string_view>{}(text);
    }
  };

 public:
  template <class T>
  using ByName = std::unordered_map<std::string, T, Hash, std::equal_to<>>;

  /// `sources` of the cell, for their limits; borrowed.
  explicit StreamJudge(const RuleSettings& rules = {}, std::span<const CellSource> sources = {});
  StreamJudge(const StreamJudge&) = delete;
  StreamJudge& operator=(const StreamJudge&) = delete;

  /// A judged packet, valid until the next add().
  struct Judged {
    const Packet* packet = nullptr;   ///< null: the datagram is not a packet
    std::span<const FaultAt> faults;  ///< of its decoder
    /// Null unless the packet took effect; late packets and those of too many sources do not.
    SourceJudge* source = nullptr;
    PacketPlace place;  ///< of the header
  };
  /// The next datagram in time order, which a decoder turned into a packet or, when not `decoded`,
  /// nobody could.
  void addOctets(LogTime time, std::string_view encoding, bool decoded);
  /// Of the octets that are added next.
  void addNotFinite(LogTime time, const NotFiniteField& field) {
    PacketPlace place;
    place.time = time;
    place.packet = datagrams_ + 1;
    faults_.takeNotFinite(field, place);
  }
  /// The next datagram in time order. `captured`: it came from outside (LogChannel::captured); all
  /// others are restatements by a recorder, judged but not counted.
  /// `sender`: its address and port, where they are known.
  Judged add(LogTime time, std::string_view encoding, bool captured, ByteView datagram,
             std::string_view sender = {});

  /// Faults of the packet at `place` that only the caller can tell.
  void takeFaults(std::span<const FaultAt> faults, const PacketPlace& place) {
    faults_.takeFaults(faults, place);
  }

  const SessionState& state() const { return state_; }
  std::vector<Event> takeEvents() { return state_.takeEvents(); }
  std::uint64_t datagrams() const { return datagrams_; }
  std::uint64_t packets() const { return packets_; }
  /// Of the latest datagram that was sent, not restated by a recorder.
  LogTime end() const { return end_; }

  /// Names by the number of their source.
  const std::vector<std::string>& sourceNames() const { return source_names_; }
  bool hasSource(std::string_view name) const { return sources_.contains(name); }
  /// Of a source that is in the state.
  SourceJudge& sourceNamed(std::string_view name) { return source(name).judge; }

  void reportDatagrams(Findings& findings) const { faults_.report(findings); }
  /// `now`: silences and restatements count up to it.
  void reportSources(LogTime now, Findings& findings) const;
  /// Forgets what was found; every stream is followed on.
  void dropFindings();
  /// It is `now`, though no datagram says so.
  void advance(LogTime now) { end_ = std::max(end_, now); }

 private:
  struct Source {
    SourceJudge judge;
    const SourceCounts* counts;  ///< in state_, whose map does not move them
  };

  Decoder* decoderFor(std::string_view encoding);
  Source& source(std::string_view name);
  /// Losses behind a relay, by the relay's own count.
  std::uint64_t relayGap(std::string_view relay) const;
  std::uint64_t relayGaps() const;

  RuleSettings rules_;
  std::span<const CellSource> cell_sources_;
  SessionState state_;
  ByName<std::unique_ptr<Decoder>> decoders_;
  ByName<Source> sources_;
  std::vector<std::string> source_names_;
  NameCache<Decoder*> decoder_cache_;
  NameCache<Source*> source_cache_;
  DatagramJudge faults_;
  Tally refused_, relay_gap_;
  std::uint64_t dropped_relay_gaps_ = 0;
  std::uint64_t datagrams_ = 0, packets_ = 0;
  LogTime end_{};
};

}  // namespace rocinante
