#pragma once

#include <vector>

#include "core/cell/cell.h"
#include "core/check/rules/check_report.h"
#include "core/clearance/clearance_judge.h"

namespace rocinante {

/// Adds what was found about each clearance of the cell, and a finding for each two devices that
/// came too near. Distances are rounded to 0.01 mm, those above zero to 0.01 mm at least.
void reportClearances(const Cell& cell, const ClearanceJudge& judge,
                      std::vector<CheckedClearance>& clearances, Findings& findings);

/// "12.34 mm", from metres.
std::string millimetres(double metres);

}  // namespace rocinante
