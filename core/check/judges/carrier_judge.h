#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/cell/cell.h"
#include "core/check/judges/tally.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// Judges what packets put devices on: devices that carry one another in a loop stand nowhere. The
/// cell's own `on` alone is judged when it is loaded.
class CarrierJudge {
 public:
  explicit CarrierJudge(const Cell& cell) : cell_(cell) {}

  /// A `pose` of the device on another one, in a state that has it.
  void judge(std::string_view device, const SessionState& state, const PacketPlace& place);
  void report(Findings& findings) const;
  /// Forgets what was found.
  void dropFindings() {
    loops_.clear();
    others_ = {};
  }

 private:
  /// What a device is on; empty: the world or a layer.
  std::string_view carrierOf(std::string_view device, const SessionState& state) const;

  const Cell& cell_;
  /// Each from its least name: a b, of "a on b on a".
  std::map<std::vector<std::string>, Tally> loops_;
  Tally others_;  ///< loops beyond the number that is listed
};

}  // namespace rocinante
