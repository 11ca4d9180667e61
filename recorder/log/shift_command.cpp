#include <CLI/CLI.hpp>

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

LogCommand addShiftCommand(CLI::App& program) {
  auto arguments = std::make_shared<ShiftArguments>();
  CLI::App* const app = program.add_subcommand("shift", "move a log in time");
  app->add_option("LOG", arguments->log, "the log; it is not changed")->required();
  CLI::Option_group* const distance = app->add_option_group("how far", "How far (one of these)");
  distance
      ->add_option("--by", arguments->shift.by,
                   "this much later, or earlier with a minus (0.25s, -1h)")
      ->type_name("TIME");
  distance->add_option("--to", arguments->shift.to, "so that its origin is at this time (RFC 3339)")
      ->type_name("TIME");
  distance->require_option(1);
  app->add_flag("--publish", arguments->shift.publish, "move the senders' times too");
  addCopyArguments(*app, arguments->copy);
  return {app, [arguments] { return runShift(*arguments); }};
}

}  // namespace rocinante
