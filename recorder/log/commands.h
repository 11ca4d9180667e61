#pragma once

#include <functional>

#include "core/base/result.h"
#include "core/cli/program.h"

namespace CLI {
class App;
}

namespace rocinante {

/// A subcommand of `rocinante log`: its options, already added to the program, and the function to
/// run once they are parsed. Each lies in its own NAME_command.cpp (docs/programs/log.md).
struct LogCommand {
  CLI::App* app = nullptr;
  std::function<Result<cli::Exit>()> run;
};

LogCommand addAttachCommand(CLI::App& program);
LogCommand addCatCommand(CLI::App& program);
LogCommand addCutCommand(CLI::App& program);
LogCommand addFilterCommand(CLI::App& program);
LogCommand addDecodeCommand(CLI::App& program);
LogCommand addDiffCommand(CLI::App& program);
LogCommand addDoctorCommand(CLI::App& program);
LogCommand addExportCommand(CLI::App& program);
LogCommand addExtractCommand(CLI::App& program);
LogCommand addFollowCommand(CLI::App& program);
LogCommand addImportCommand(CLI::App& program);
LogCommand addInfoCommand(CLI::App& program);
LogCommand addMarkCommand(CLI::App& program);
LogCommand addMergeCommand(CLI::App& program);
LogCommand addRecoverCommand(CLI::App& program);
LogCommand addShiftCommand(CLI::App& program);
LogCommand addSplitCommand(CLI::App& program);
LogCommand addStateCommand(CLI::App& program);
LogCommand addTableCommand(CLI::App& program);
LogCommand addVerifyCommand(CLI::App& program);

}  // namespace rocinante
