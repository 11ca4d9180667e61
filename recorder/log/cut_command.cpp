
#include "core/copy/log_edits.h"
#include "recorder/log/command_support.h"
#include "recorder/log/commands.h"

namespace rocinante {
namespace {

struct CutArguments {
  std::string log;
  SelectionOptions selection;
  CopyArguments copy;
};

Result<cli::Exit> runCut(const CutArguments& arguments, const std::string& reason) {
  const Result<CopyReport> report =
      runCopy(arguments.copy, "reading " + arguments.log, [&](const MakeOptions& make) {
        return cutLog(arguments.log, arguments.selection, make, reason);
      });
  if (!report) return report.error();
  return tellCopy(arguments.copy, *report);
}

/// `cut` and `filter` take the same options, and differ in which are required.
std::shared_ptr<CutArguments> addArguments(cli::CommandLine app) {
  auto arguments = std::make_shared<CutArguments>();
  app.addOption("LOG", arguments->log, "the log; it is not changed").required();
  addTimeArguments(app, arguments->selection);
  addChoiceArguments(app, arguments->selection);
  addCopyArguments(app, arguments->copy);
  app.addFlag("--no-attachments", arguments->copy.without_attachments, "leave out attachments");
  return arguments;
}

}  // namespace

cli::Subcommand addCutCommand(cli::CommandLine program) {
  const cli::CommandLine app =
      program.addSubcommand("cut", "copy a part of a log, by time or events");
  const auto arguments = addArguments(app);
  return {app, [arguments]() -> Result<cli::Exit> {
            if (!arguments->selection.anyTime()) {
              return Error{ErrorKind::bad_argument,
                           "give a range to cut: --from, --until, --from-event or "
                           "--until-event",
                           {}};
            }
            return runCut(*arguments, "rocinante log cut");
          }};
}

cli::Subcommand addFilterCommand(cli::CommandLine program) {
  const cli::CommandLine app =
      program.addSubcommand("filter", "copy some of the messages, by channel, source, device");
  const auto arguments = addArguments(app);
  return {app, [arguments]() -> Result<cli::Exit> {
            if (!arguments->selection.anyChoice()) {
              return Error{ErrorKind::bad_argument,
                           "give what to keep: --channel, --not-channel, --source, "
                           "--device or --encoding",
                           {}};
            }
            return runCut(*arguments, "rocinante log filter");
          }};
}

}  // namespace rocinante
