#pragma once

#include <set>
#include <string>
#include <string_view>
#include <unordered_map>

#include "core/base/bytes.h"
#include "core/cell/cell.h"
#include "core/check/judges/carrier_judge.h"
#include "core/check/judges/device_judge.h"
#include "core/check/judges/layer_judge.h"
#include "core/check/judges/log_judge.h"
#include "core/check/judges/signal_judge.h"
#include "core/check/judges/stream_judge.h"
#include "core/check/rules/check_report.h"
#include "core/clearance/clearance_session.h"
#include "core/log/log_types.h"

namespace rocinante {

/// Judges a session against a cell while it folds it, datagram by datagram, from a log or live:
/// hands each packet to the judges of its source, its devices and its layers. No allocation per
/// packet once everything in it has been seen. The cell must outlive it. One thread.
class SessionCheck {
 public:
  explicit SessionCheck(const Cell& cell);
  ~SessionCheck();
  SessionCheck(const SessionCheck&) = delete;
  SessionCheck& operator=(const SessionCheck&) = delete;

  /// The next datagram in time order. `captured`: it came from outside (LogChannel::captured); all
  /// others are restatements by a recorder, judged but not counted.
  /// `sender`: its address and port, where they are known.
  void add(LogTime time, std::string_view encoding, bool captured, ByteView datagram,
           std::string_view sender = {});

  /// Octets that the decoders of the session may have understood; when they did, their packet
  /// follows by add() as not captured.
  void addOctets(LogTime time, std::string_view encoding, bool decoded) {
    log_.takeTime(time);
    stream_.addOctets(time, encoding, decoded);
  }
  /// Of the octets that are added next: a decoder could not use this field.
  void addNotFinite(LogTime time, const NotFiniteField& field) {
    stream_.addNotFinite(time, field);
  }

  // What the log says about its own recording.
  void addLoss(const LossSpan& span) { log_.takeLoss(span); }
  void addDamage(const DamageSpan& span) { log_.takeDamage(span); }
  /// A message on /rocinante/clock.
  void addClockStep(LogTime time, ByteView payload) { log_.takeClockStep(time, payload); }
  /// Call it when the recorder did not close the log.
  void addLeftOut(const Account& account) { log_.takeLeftOut(account); }
  void addImportWarning(std::string text) { log_.takeImportWarning(std::move(text)); }
  void noteIncomplete() { log_.noteIncomplete(); }

  /// It is `now`, though no datagram says so: silences grow.
  void advance(LogTime now) { stream_.advance(now); }
  /// Forgets what was found so far, so that findings are those of the time since; the session
  /// itself is followed on: state, numbers, clocks, rhythms, motion. Memory stays as it is, however
  /// long the session and however many names it uses.
  void dropFindings();
  std::uint64_t datagrams() const { return stream_.datagrams(); }
  std::uint64_t packets() const { return stream_.packets(); }

  /// Judges what waits for the next packet: call it before finish().
  void settle() { clearance_.settle(); }

  /// Reports the findings about the session, unsorted, without the cell's own faults. Fills
  /// datagrams, packets, sources, clearances and findings of `report`.
  void finish(CheckReport& report) const;

 private:
  template <class T>
  using ByName = StreamJudge::ByName<T>;
  using Names = std::set<std::string, std::less<>>;

  void expectDevices();
  DeviceJudge& newDevice(std::string_view name);
  /// Null beyond the bound on names.
  DeviceJudge* deviceNamed(std::string_view name);
  void judge(const Statement& statement, SourceJudge& source, const PacketPlace& place);
  void judgeOfDevice(const Statement& statement, SourceJudge& source, const PacketPlace& place);
  void judgeJoints(const Statement& statement, const SourceJudge& source, DeviceJudge& device,
                   const PacketPlace& place);
  void judgeAdd(const Statement& statement, DeviceJudge& device, const PacketPlace& place);
  void judgePath(const PathView& path, const PacketPlace& place);
  void reportMissing(const SessionRoster& roster, Findings& findings) const;

  const Cell& cell_;
  RuleSettings rules_;
  StreamJudge stream_;
  Names bound_sources_;  ///< sources of the cell that list their devices
  ByName<DeviceJudge> devices_;
  NameCache<DeviceJudge*> device_cache_;
  LayerJudge layers_;
  SignalJudge signals_;
  CarrierJudge carriers_;
  LogJudge log_;
  ClearanceSession clearance_;
};

/// Cell and session, as checkLog() judges them, of a session that was judged datagram by datagram.
CheckReport checkSession(const Cell& cell, const SessionCheck& session);

}  // namespace rocinante
