#include <fmt/format.h>

#include "core/copy/copy_report.h"
#include "core/copy/log_edits.h"
#include "recorder/log/command_support.h"
#include "recorder/log/commands.h"

namespace rocinante {
namespace {

struct RecoverArguments {
  std::string log;
  CopyArguments copy;
};

Result<cli::Exit> runRecover(const RecoverArguments& arguments) {
  const Result<CopyReport> report =
      runCopy(arguments.copy, "reading " + arguments.log,
              [&](const MakeOptions& make) { return recoverLog(arguments.log, make); });
  if (!report) return report.error();
  const std::string& output = arguments.copy.output;
  const Status printed =
      toStandardOutput(arguments.copy.json ? recoverReportJson(output, *report)
                                           : copyReportText(output, report->counts));
  if (!printed) return printed.error();
  bool lossy = false;
  for (const CopyGap& gap : report->gaps) {
    if (!gap.costs) continue;
    lossy = true;
    cli::warn("lost: " + gapText(gap));
  }
  for (const std::string& note : report->notes) cli::warn(note);
  return lossy || !report->notes.empty() ? cli::Exit::no : cli::Exit::done;
}

}  // namespace

cli::Subcommand addRecoverCommand(cli::CommandLine program) {
  auto arguments = std::make_shared<RecoverArguments>();
  const cli::CommandLine app =
      program.addSubcommand("recover", "copy what is left of a truncated, damaged or unclosed log");
  app.addOption("LOG", arguments->log, "the log; it is not changed").required();
  addCopyArguments(app, arguments->copy);
  return {app, [arguments] { return runRecover(*arguments); }};
}

}  // namespace rocinante
