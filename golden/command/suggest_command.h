#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/cli/program.h"
#include "golden/command/suite_arguments.h"

namespace rocinante {

struct SuggestArguments {
  SuiteArguments suite;
  std::string run;
  std::vector<std::filesystem::path> recordings;
};

/// Adds `suggest`; parsing fills `arguments`, which must outlive the command.
CLI::App* addSuggestCommand(CLI::App& app, SuggestArguments& arguments);
/// Prints the limits of a run with which recordings of it accept each other, as TOML.
Result<cli::Exit> runSuggestCommand(const SuggestArguments& arguments);

}  // namespace rocinante
