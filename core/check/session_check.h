#pragma once

#include <array>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/bytes.h"
#include "core/check/device_judge.h"
#include "core/check/finding.h"
#include "core/log/log_types.h"
#include "core/model/cell.h"
#include "core/packet/decoder.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// Judges a session against a cell while it folds it, datagram by datagram, from a log or live.
/// No allocation a packet once everything in it has been seen. The cell must outlive it.
/// One thread.
class SessionCheck {
 public:
  explicit SessionCheck(const Cell& cell);
  ~SessionCheck();

  /// The next datagram in time order. `captured`: it came from outside (LogChannel::captured); the
  /// others that are folded are restatements by a recorder, judged but not counted.
  void add(LogTime time, std::string_view encoding, bool captured, ByteView datagram);

  void addLoss(const LossSpan& span);
  void addDamage(const DamageSpan& span);

  /// What was found about the session, in no order; the cell's own faults are not in it. Fills
  /// datagrams, packets, sources and findings of `report`.
  void finish(CheckReport& report) const;

 private:
  struct Source {
    std::string name;
    std::uint32_t number = 0;
    const SourceCounts* counts = nullptr;  ///< in state_, whose map does not move them
    std::uint64_t gap_seen = 0, late_seen = 0, restarts_seen = 0;
    Tally gap, late, restart;
  };
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const {
      return std::hash<std::string_view>{}(text);
    }
  };
  template <class T>
  using ByName = std::unordered_map<std::string, T, Hash, std::equal_to<>>;

  Decoder* decoderFor(std::string_view encoding);
  Source& sourceNamed(std::string_view name);
  /// Null beyond the bound on names.
  DeviceJudge* deviceNamed(std::string_view name);
  void countFaults(std::span<const FaultAt> faults, Place place);
  void watchSource(Source& source, const Place& place);
  void judge(const Statement& statement, Source& source, const Place& place);
  void judgeJoints(const Statement& statement, const Source& source, DeviceJudge& device,
                   const Place& place);
  void judgeAdd(const Statement& statement, DeviceJudge& device, const Place& place);
  void judgePath(const PathView& path, const Place& place);
  void reportSources(std::vector<Finding>& findings) const;
  void reportLosses(std::vector<Finding>& findings) const;

  const Cell& cell_;
  SessionState state_;
  ByName<std::unique_ptr<Decoder>> decoders_;
  ByName<Source> sources_;
  std::vector<std::string> source_names_;  ///< by number
  ByName<DeviceJudge> devices_;
  std::map<std::string, bool, std::less<>> layers_;
  std::uint64_t datagrams_ = 0, packets_ = 0;
  std::array<Tally, kPacketFaultCount> faults_;
  std::array<std::uint32_t, kPacketFaultCount> fault_columns_{};
  std::map<std::string, Tally, std::less<>> undecoded_;  ///< by encoding
  std::map<std::string, Tally, std::less<>> unknown_layers_;
  Tally refused_;
  std::map<std::string, std::vector<LossSpan>, std::less<>> losses_;  ///< by endpoint
  std::vector<DamageSpan> damage_;
};

}  // namespace rocinante
