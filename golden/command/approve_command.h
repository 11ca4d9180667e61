#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "core/cli/program.h"
#include "golden/command/suite_arguments.h"

namespace rocinante {

/// What `rocinante golden approve` was asked for (docs/programs/golden.md).
struct ApproveArguments {
  SuiteArguments suite;
  std::string message;
  std::filesystem::path from;  ///< a list of approvals, as the report copies it
  bool interactive = false;
  bool also = false;  ///< beside the pictures that are accepted already
};

/// Adds the sub-command `approve` to `app`; parsing fills `arguments`, which must outlive it.
CLI::App* addApproveCommand(CLI::App& app, ApproveArguments& arguments);

/// Makes what is drawn now the goldens of the selected frames.
Result<cli::Exit> runApproveCommand(const ApproveArguments& arguments);

}  // namespace rocinante
