
#include "core/copy/log_edits.h"
#include "recorder/log/command_support.h"
#include "recorder/log/commands.h"

namespace rocinante {
namespace {

struct ShiftArguments {
  std::string log;
  ShiftOptions shift;
  CopyArguments copy;
};

Result<cli::Exit> runShift(const ShiftArguments& arguments) {
  const Result<CopyReport> report = runCopy(
      arguments.copy, "reading " + arguments.log,
      [&](const MakeOptions& make) { return shiftLog(arguments.log, arguments.shift, make); });
  if (!report) return report.error();
  return tellCopy(arguments.copy, *report);
}

}  // namespace

cli::Subcommand addShiftCommand(cli::CommandLine program) {
  auto arguments = std::make_shared<ShiftArguments>();
  const cli::CommandLine app = program.addSubcommand("shift", "move a log in time");
  app.addOption("LOG", arguments->log, "the log; it is not changed").required();
  const cli::CommandLine distance = app.addOneOf("how far", "How far (one of these)");
  distance
      .addOption("--by", arguments->shift.by,
                 "this much later, or earlier with a minus (0.25s, -1h)")
      .valueName("TIME");
  distance.addOption("--to", arguments->shift.to, "so that its origin is at this time (RFC 3339)")
      .valueName("TIME");
  app.addFlag("--publish", arguments->shift.publish, "move the senders' times too");
  addCopyArguments(app, arguments->copy);
  return {app, [arguments] { return runShift(*arguments); }};
}

}  // namespace rocinante
