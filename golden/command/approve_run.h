#pragma once

#include "core/base/result.h"
#include "core/cli/program.h"
#include "golden/command/approve_command.h"
#include "golden/judge/judged_run.h"

namespace rocinante {

/// Accepts the log under test of the run that `arguments.run` names (docs/golden-suites.md,
/// "Accepting a log"): one that is compatible with the cell, that can be judged, and that widens
/// what is accepted by no more than kMostWidening limits; others only with `arguments.anyway`.
/// Prints what it widens.
Result<cli::Exit> approveRunOfSuite(const ApproveArguments& arguments);
/// The same for a run of a list of approvals: refused unless its log has the hash of the list
/// (JudgedRun::log_bytes).
Result<cli::Exit> approveListedRun(const ApproveArguments& arguments, const std::string& run,
                                   const std::string& bytes);
/// The same with the copy of the log in a report of CI.
Result<cli::Exit> approveReportedRun(const ApproveArguments& arguments, const JudgedRun& run,
                                     const std::string& bytes);

inline constexpr double kMostWidening = 10;

}  // namespace rocinante
