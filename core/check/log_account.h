#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/log/log_reader.h"
#include "core/packet/session_state.h"
#include "core/report/account.h"
#include "core/session/timeline.h"

namespace rocinante {

/// What a log holds and no packet was made of, and what of a cell no packet of it moves
/// (docs/decisions/034): every program that opens a recording prints note().
struct LogAccount {
  /// Topics without packets, and what else an import did not use.
  Account left_out;
  /// Devices that are drawn at rest: they have joints, are there without an `add`, and no packet
  /// states their pose or one of their joints.
  std::vector<std::string> at_rest;
  std::size_t movable = 0;  ///< devices with joints that are there
  /// Devices that packets move and that neither the cell nor an `add` has: nothing shows them.
  std::vector<std::string> not_in_cell;
  bool no_packets = false;  ///< it has messages, and none is or became a packet
  bool imported = false;    ///< what another program recorded

  bool empty() const {
    return left_out.empty() && at_rest.empty() && not_in_cell.empty() && !no_packets;
  }
  /// "the cell has no device `ur10`; no packet of the log moves arm; left out: 1 topic `/camera`
  /// (...)"; empty when empty().
  std::string sentence(std::size_t most_listed = 4) const;
  /// The line that every program prints of a log that it opens, or empty: a shorter sentence, and
  /// which program has all of it. Of a log that was recorded only that it moves nothing, or what
  /// the cell lacks: what it holds besides packets was recorded on purpose.
  std::string note() const;
};

/// Of a log whose last state is `last`. `cell` null: none is known.
LogAccount logAccount(const LogReader& log, const SessionState& last, const Cell* cell);

/// Reads the last state from the nearest keyframe on; damage of the log is not told.
LogAccount logAccount(Timeline& session, const Cell* cell);
Result<LogAccount> logAccount(const std::filesystem::path& log, const Cell* cell);

}  // namespace rocinante
