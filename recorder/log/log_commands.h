#pragma once

#include <functional>

#include "core/cli/program.h"
#include "core/result.h"

namespace CLI {
class App;
}

namespace rocinante {

/// A subcommand of `rocinante log`: its options, already added to the program, and what it does
/// once they are read. Each lies in a file of its own, NAME_command.cpp.
struct LogCommand {
  CLI::App* app = nullptr;
  std::function<Result<cli::Exit>()> run;
};

LogCommand addInfoCommand(CLI::App& program);
LogCommand addCatCommand(CLI::App& program);
LogCommand addStateCommand(CLI::App& program);
LogCommand addDiffCommand(CLI::App& program);
LogCommand addDoctorCommand(CLI::App& program);
LogCommand addFollowCommand(CLI::App& program);
LogCommand addMarkCommand(CLI::App& program);
LogCommand addCutCommand(CLI::App& program);
LogCommand addFilterCommand(CLI::App& program);
LogCommand addMergeCommand(CLI::App& program);
LogCommand addSplitCommand(CLI::App& program);
LogCommand addShiftCommand(CLI::App& program);
LogCommand addRecoverCommand(CLI::App& program);
LogCommand addAttachCommand(CLI::App& program);
LogCommand addExtractCommand(CLI::App& program);

}  // namespace rocinante
