#pragma once

#include <string>
#include <vector>

#include "core/check/rules/check_report.h"
#include "viewer/model/pose_request.h"

namespace rocinante {

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
