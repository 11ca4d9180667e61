#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/packet/session_state.h"
#include "core/session/state_damage.h"

namespace rocinante {

/// Where a cell's joints are to stand. All of it is folded as packets would be, so that what is
/// computed is what a viewer draws.
struct PoseRequest {
  std::string device;                         ///< whose; empty: the only one of the cell
  std::optional<std::vector<double>> joints;  ///< positional, as `joints DEVICE` has them
  std::vector<std::pair<std::string, double>> named;
  bool degrees = false;       ///< values of joints that turn are degrees
  std::optional<Pose> base;   ///< of the device, in place of the cell's
  std::filesystem::path log;  ///< a session to begin with; empty: the cell alone
  std::string at;             ///< a moment of it, as parseSessionTime() reads it
};

/// The state of `cell` that is asked for. bad_argument when a joint is not there or the number of
/// values is not what the model takes, naming what it does take. Where the log is damaged so that
/// the state may be older than its time says: an error of kind `damaged`, or that state, and what
/// it may lack is added to `damage`.
Result<SessionState> posedState(const Cell& cell, const PoseRequest& request,
                                StateDamage* damage = nullptr);

/// Numbers between spaces or commas; bad_argument naming the first that is none.
Result<std::vector<double>> parseNumbers(std::string_view text);

}  // namespace rocinante
