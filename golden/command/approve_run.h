#pragma once

#include "core/base/result.h"
#include "core/cli/program.h"
#include "golden/command/approve_command.h"

namespace rocinante {

/// Accepts the log under test of the run that `arguments.run` names (docs/golden-suites.md,
/// "Accepting a log"): one that is compatible with the cell, that can be judged, and that widens
/// what is accepted by no more than kMostWidening limits; others only with `arguments.anyway`.
/// Prints what it widens.
Result<cli::Exit> approveRunOfSuite(const ApproveArguments& arguments);

inline constexpr double kMostWidening = 10;

}  // namespace rocinante
