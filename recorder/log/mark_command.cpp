#include <fmt/format.h>

#include "core/base/duration_text.h"
#include "core/base/plain_text.h"
#include "recorder/contents/log_mark.h"
#include "recorder/log/command_support.h"
#include "recorder/log/commands.h"

namespace rocinante {
namespace {

struct MarkOptions {
  std::string log;
  std::string time;
  std::string text;
};

Result<cli::Exit> runMark(const MarkOptions& options) {
  const Result<MarkMade> made = markLog(options.log, options.time, options.text);
  if (!made) return made.error();
  const Status printed = toStandardOutput(fmt::format(
      "{} s  {}\n", secondsText(made->mark.time - made->origin, 3), plainText(made->mark.text)));
  if (!printed) return printed.error();
  return cli::Exit::done;
}

}  // namespace

cli::Subcommand addMarkCommand(cli::CommandLine program) {
  auto options = std::make_shared<MarkOptions>();
  const cli::CommandLine app =
      program.addSubcommand("mark", "add an event beside a log, in LOG.marks");
  app.addOption("LOG", options->log, "the log; it is not changed").required();
  app.addOption("TIME", options->time, "12.5s from the origin, -1s from the end, or RFC 3339")
      .required();
  app.addOption("TEXT", options->text, "what happened there").required();
  return {app, [options] { return runMark(*options); }};
}

}  // namespace rocinante
