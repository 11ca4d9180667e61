#pragma once

#include "core/base/result.h"
#include "core/cli/program.h"
#include "golden/command/suite_arguments.h"

namespace rocinante {

/// Arguments of `rocinante golden list` (docs/programs/golden.md).
struct ListArguments {
  SuiteArguments suite;
  bool verify = false;  ///< read every golden and check its hash
  bool json = false;
};

/// Adds the sub-command `list` to `app`; parsing fills `arguments`, which must outlive it.
CLI::App* addListCommand(CLI::App& app, ListArguments& arguments);

/// Prints the frames with their goldens and the faults of the folder. Draws nothing.
Result<cli::Exit> runListCommand(const ListArguments& arguments);

}  // namespace rocinante
