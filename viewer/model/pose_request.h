#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/check/rules/check_report.h"
#include "core/packet/session_state.h"
#include "core/session/state_damage.h"
#include "viewer/model/link_poses.h"

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

/// Poses of every link of the requested device, or of all present devices, in the order of cell and
/// model. `damage` as in posedState().
Result<std::vector<LinkPose>> forwardKinematics(const Cell& cell, const PoseRequest& request,
                                                StateDamage* damage = nullptr);

/// A table in metres.
std::string forwardKinematicsText(const std::vector<LinkPose>& links);

/// The least distances of a cell in one pose.
struct PoseClearance {
  std::vector<CheckedClearance> clearances;  ///< with no times but the pose's
  std::vector<std::string> warnings;         ///< what was not measured, and why

  bool areKept() const;
};

/// The `[[clearance]]`s of the cell; without any the clearance of every two devices, and of every
/// device with itself, of which touching is the only violation. With a requested device only those
/// of that device. bad_argument when there is nothing to measure; `damage` as in posedState().
Result<PoseClearance> poseClearance(Cell& cell, const PoseRequest& request,
                                    StateDamage* damage = nullptr);

std::string poseClearanceText(const PoseClearance& measured);
/// The keys are those of `check --json`, without times.
std::string poseClearanceJson(const PoseClearance& measured,
                              const std::vector<std::string>& warnings);

}  // namespace rocinante
