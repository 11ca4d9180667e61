#pragma once

#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/base/bytes.h"
#include "core/cell/cell.h"
#include "core/check/judges/datagram_judge.h"
#include "core/check/judges/device_judge.h"
#include "core/check/judges/layer_judge.h"
#include "core/check/judges/log_judge.h"
#include "core/check/judges/source_judge.h"
#include "core/check/rules/finding.h"
#include "core/check/rules/rule_settings.h"
#include "core/log/log_types.h"
#include "core/packet/decoder.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// Judges a session against a cell while it folds it, datagram by datagram, from a log or live:
/// hands each packet to the judges of its source, its devices and its layers. No allocation per
/// packet once everything in it has been seen. The cell must outlive it. One thread.
class SessionCheck {
 public:
  explicit SessionCheck(const Cell& cell);
  ~SessionCheck();

  /// The next datagram in time order. `captured`: it came from outside (LogChannel::captured); all
  /// others are restatements by a recorder, judged but not counted.
  void add(LogTime time, std::string_view encoding, bool captured, ByteView datagram);

  // What the log says about its own recording.
  void addLoss(const LossSpan& span) { log_.takeLoss(span); }
  void addDamage(const DamageSpan& span) { log_.takeDamage(span); }
  /// A message on /rocinante/clock.
  void addClockStep(LogTime time, ByteView payload) { log_.takeClockStep(time, payload); }
  /// Call it when the recorder did not close the log.
  void noteIncomplete() { log_.noteIncomplete(); }

  /// Reports the findings about the session, unsorted, without the cell's own faults. Fills
  /// datagrams, packets, sources and findings of `report`.
  void finish(CheckReport& report) const;

 private:
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const {
      return std::hash<std::string_view>{}(text);
    }
  };
  template <class T>
  using ByName = std::unordered_map<std::string, T, Hash, std::equal_to<>>;
  using Names = std::set<std::string, std::less<>>;

  struct Source {
    SourceJudge judge;
    const SourceCounts* counts;  ///< in state_, whose map does not move them
  };

  void expectDevices();
  DeviceJudge& newDevice(std::string_view name);
  Decoder* decoderFor(std::string_view encoding);
  Source& sourceNamed(std::string_view name);
  /// Null beyond the bound on names.
  DeviceJudge* deviceNamed(std::string_view name);
  void judge(const Statement& statement, SourceJudge& source, const PacketPlace& place);
  void judgeOfDevice(const Statement& statement, SourceJudge& source, const PacketPlace& place);
  void judgeJoints(const Statement& statement, const SourceJudge& source, DeviceJudge& device,
                   const PacketPlace& place);
  void judgeAdd(const Statement& statement, DeviceJudge& device, const PacketPlace& place);
  /// Losses behind a relay, by the relay's own count.
  std::uint64_t relayGap(std::string_view relay) const;
  void judgePath(const PathView& path, const PacketPlace& place);
  void reportSources(const SessionRoster& roster, std::vector<Finding>& findings) const;
  void reportMissing(const SessionRoster& roster, std::vector<Finding>& findings) const;

  const Cell& cell_;
  RuleSettings rules_;
  MotionThresholds motion_;
  SessionState state_;
  Names bound_sources_;  ///< sources of the cell that list their devices
  ByName<std::unique_ptr<Decoder>> decoders_;
  ByName<Source> sources_;
  std::vector<std::string> source_names_;  ///< by number
  ByName<DeviceJudge> devices_;
  NameCache<Decoder*> decoder_cache_;
  NameCache<Source*> source_cache_;
  NameCache<DeviceJudge*> device_cache_;
  LayerJudge layers_;
  DatagramJudge faults_;
  LogJudge log_;
  std::uint64_t datagrams_ = 0, packets_ = 0;
  LogTime end_{};
  Tally refused_, relay_gap_;
};

/// Cell and session, as checkLog() judges them, of a session that was judged datagram by datagram.
CheckReport checkSession(const Cell& cell, const SessionCheck& session);

}  // namespace rocinante
