#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "core/cli/program.h"

namespace rocinante {

/// Arguments of `rocinante golden diff` (docs/programs/golden.md).
struct DiffArguments {
  std::string revision;
  std::filesystem::path suite;  ///< empty: every manifest of goldens in the repository
  std::string report, json_file;
};

/// Adds the sub-command `diff` to `app`; parsing fills `arguments`, which must outlive it.
CLI::App* addDiffCommand(CLI::App& app, DiffArguments& arguments);

/// Prints which goldens changed since a git revision. Exit code 0: none, 1: some.
Result<cli::Exit> runDiffCommand(const DiffArguments& arguments);

}  // namespace rocinante
