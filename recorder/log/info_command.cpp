#include <cstdio>
#include <limits>

#include "core/cli/terminal.h"
#include "recorder/contents/log_info.h"
#include "recorder/log/command_support.h"
#include "recorder/log/commands.h"

namespace rocinante {
namespace {

struct InfoOptions {
  std::vector<std::string> logs;
  bool json = false, all_events = false;
};

Result<cli::Exit> runInfo(const InfoOptions& options) {
  cli::Exit exit = cli::Exit::done;
  bool first = true;
  for (const std::string& log : options.logs) {
    ProgressLine progress("reading " + log);
    const std::size_t max_events =
        options.all_events ? std::numeric_limits<std::size_t>::max() : kMaxEvents;
    const Result<LogInfo> info = logInfo(
        log, [&](double part) { progress.show(part); }, max_events);
    if (!info) return info.error();
    if (!options.json && !first) std::fputc('\n', stdout);
    first = false;
    const std::string text = options.json ? logInfoJson(*info, options.logs.size() == 1)
                                          : logInfoText(*info, cli::outputTerminal().columns);
    if (Status written = toStandardOutput(text); !written) return written.error();
    if (!info->damage.empty() || !info->summary.complete) exit = cli::Exit::no;
  }
  return exit;
}

}  // namespace

cli::Subcommand addInfoCommand(cli::CommandLine program) {
  auto options = std::make_shared<InfoOptions>();
  const cli::CommandLine app =
      program.addSubcommand("info", "describe a log: channels, rates, losses, damage");
  app.addOption("LOG", options->logs, "logs to describe").required();
  const cli::Option json =
      app.addFlag("--json", options->json, "print JSON; for several logs, one object per line");
  app.addFlag("--all-events", options->all_events, "every event, not the first 1,000").needs(json);
  return {app, [options] { return runInfo(*options); }};
}

}  // namespace rocinante
