#pragma once

#include "core/cli/program.h"

namespace rocinante {

// The subcommands of `rocinante log`, added to the program. Each lies in its own NAME_command.cpp
// (docs/programs/log.md).

cli::Subcommand addAttachCommand(cli::CommandLine program);
cli::Subcommand addCatCommand(cli::CommandLine program);
cli::Subcommand addCutCommand(cli::CommandLine program);
cli::Subcommand addFilterCommand(cli::CommandLine program);
cli::Subcommand addDecodeCommand(cli::CommandLine program);
cli::Subcommand addDiffCommand(cli::CommandLine program);
cli::Subcommand addDoctorCommand(cli::CommandLine program);
cli::Subcommand addExportCommand(cli::CommandLine program);
cli::Subcommand addExtractCommand(cli::CommandLine program);
cli::Subcommand addFollowCommand(cli::CommandLine program);
cli::Subcommand addImportCommand(cli::CommandLine program);
cli::Subcommand addInfoCommand(cli::CommandLine program);
cli::Subcommand addMarkCommand(cli::CommandLine program);
cli::Subcommand addMergeCommand(cli::CommandLine program);
cli::Subcommand addRecoverCommand(cli::CommandLine program);
cli::Subcommand addShiftCommand(cli::CommandLine program);
cli::Subcommand addSplitCommand(cli::CommandLine program);
cli::Subcommand addStateCommand(cli::CommandLine program);
cli::Subcommand addTableCommand(cli::CommandLine program);
cli::Subcommand addVerifyCommand(cli::CommandLine program);

}  // namespace rocinante
