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

/// Requested joint values and poses of a cell. They are folded like packets, so that the result is
/// what the viewer draws.
struct PoseRequest {
  std::string device;                         ///< empty: the cell's only device
  std::optional<std::vector<double>> joints;  ///< positional, as in `joints DEVICE`
  std::vector<std::pair<std::string, double>> named;
  bool degrees = false;       ///< values of rotating joints are degrees
  std::optional<Pose> base;   ///< of the device, replacing the cell's
  std::filesystem::path log;  ///< initial session; empty: only the cell
  std::string at;             ///< a moment of it, for parseMoment()
  std::string event;          ///< in its place, for momentOfEvent()
};

/// The requested state of `cell`. bad_argument for an unknown joint or a wrong number of values,
/// naming the expected ones. When a damaged log may make the state stale: an error of kind
/// `damaged`, or the state with the damage added to `damage`.
Result<SessionState> posedState(const Cell& cell, const PoseRequest& request,
                                StateDamage* damage = nullptr);

}  // namespace rocinante
