
#include "core/copy/log_edits.h"
#include "recorder/log/command_support.h"
#include "recorder/log/commands.h"

namespace rocinante {
namespace {

struct MergeArguments {
  std::vector<std::string> logs;
  CopyArguments copy;
};

Result<cli::Exit> runMerge(const MergeArguments& arguments) {
  const Result<CopyReport> report =
      runCopy(arguments.copy, "merging", [&](const MakeOptions& make) {
        return mergeLogs({arguments.logs.begin(), arguments.logs.end()}, make);
      });
  if (!report) return report.error();
  return tellCopy(arguments.copy, *report);
}

}  // namespace

cli::Subcommand addMergeCommand(cli::CommandLine program) {
  auto arguments = std::make_shared<MergeArguments>();
  const cli::CommandLine app =
      program.addSubcommand("merge", "merge logs by time: pieces, or several machines");
  app.addOption("LOG", arguments->logs, "the logs; for equal times the first named comes first")
      .required();
  addCopyArguments(app, arguments->copy);
  app.addFlag("--no-attachments", arguments->copy.without_attachments, "leave out attachments");
  return {app, [arguments] { return runMerge(*arguments); }};
}

}  // namespace rocinante
