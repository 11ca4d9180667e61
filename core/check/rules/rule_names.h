#pragma once

#include "core/cell/cell.h"
#include "core/report/finding.h"

namespace rocinante {

/// Thresholds of `[rules]` for devices and joints that the cell does not have. A device may still
/// be added: that is a warning.
void judgeRuleNames(const Cell& cell, Findings& findings);

}  // namespace rocinante
