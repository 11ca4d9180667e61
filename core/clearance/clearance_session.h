#pragma once

#include <vector>

#include "core/base/time.h"
#include "core/cell/cell.h"
#include "core/clearance/clearance_judge.h"
#include "core/packet/packet.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// Judges the clearances of a cell over a session, packet by packet. Packets are gathered to one
/// placement until one moves a device a second time, or for kGathered: no value that a source sent
/// is left out, and what several sources say at nearly the same time is one step. Needs no more
/// memory as the session continues. The cell must outlive it. One thread.
class ClearanceSession {
 public:
  static constexpr Nanoseconds kGathered{20'000'000};

  explicit ClearanceSession(const Cell& cell);

  /// After `packet`, which took effect, was folded into `state`.
  void take(LogTime time, const Packet& packet, const SessionState& state);
  /// Judges what is gathered so far.
  void settle();

  const ClearanceJudge& judge() const { return judge_; }
  /// Forgets what was found.
  void dropFindings() { judge_.dropFindings(); }

 private:
  void restart(LogTime time, const SessionState& state);
  bool keepsStructure(StatementKind kind, const DeviceState* device_state,
                      const PlacedDevice* device) const;
  void gatherAll(LogTime time, const SessionState& state);
  void touch(std::size_t device, LogTime time);

  const Cell& cell_;
  ClearanceJudge judge_;
  CellPlacement next_;                ///< gathered; of the structure of judge_.placement()
  std::vector<bool> touched_;         ///< by device: moved since the last step
  std::vector<std::size_t> changes_;  ///< scratch: devices of the packet at hand
  bool has_moved_ = false;
  LogTime first_{}, last_{};  ///< of the packets gathered
};

}  // namespace rocinante
