#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "core/cli/program.h"
#include "golden/command/suite_arguments.h"

namespace rocinante {

/// Arguments of `rocinante golden approve` (docs/programs/golden.md).
struct ApproveArguments {
  SuiteArguments suite;
  std::string message;
  std::filesystem::path from;      ///< a list of approvals copied from the report
  std::filesystem::path artifact;  ///< folder or ZIP file of a report: take its pictures
  bool interactive = false;
  std::string run;       ///< accept the log under test of this run instead of frames
  bool replace = false;  ///< of a run: instead of the logs accepted so far
  bool anyway = false;   ///< of a run: also a log that is refused otherwise
  bool also = false;     ///< keep the pictures accepted so far
};

/// Adds the sub-command `approve` to `app`; parsing fills `arguments`, which must outlive it.
CLI::App* addApproveCommand(CLI::App& app, ApproveArguments& arguments);

/// Makes the frames drawn now the goldens of the selected frames.
Result<cli::Exit> runApproveCommand(const ApproveArguments& arguments);

}  // namespace rocinante
