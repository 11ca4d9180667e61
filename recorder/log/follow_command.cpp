#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <thread>

#include "core/base/plain_text.h"
#include "core/log/damage_text.h"
#include "recorder/contents/log_follow.h"
#include "recorder/log/command_support.h"
#include "recorder/log/commands.h"

namespace rocinante {
namespace {

/// A recorder adds to its log every 50 ms by default.
constexpr std::chrono::milliseconds kBetweenLooks{20};

struct FollowCommandOptions {
  std::string log;
  std::string format = "text";
  FollowOptions follow;
};

/// What the end by SIGBUS says.
std::string truncated_farewell;

/// A log is read in place: where another program truncates it meanwhile, the system sends SIGBUS.
/// That ends as LogReader::refresh() does, which finds it at any other time.
void endTruncated(int) {
  [[maybe_unused]] const ssize_t written =
      ::write(STDERR_FILENO, truncated_farewell.data(), truncated_farewell.size());
  ::_exit(static_cast<int>(cli::Exit::could_not_run));
}

void endWhereTruncated(const std::string& log) {
  truncated_farewell =
      fmt::format("rocinante-log: the log was truncated while it was read ({})\n", plainText(log));
  std::signal(SIGBUS, endTruncated);
}

Status toFlushedOutput(std::string_view text) {
  if (Status written = toStandardOutput(text); !written) return written;
  if (std::fflush(stdout) == 0) return {};
  return Error{ErrorKind::unreadable, "cannot write to standard output", {}};
}

Result<cli::Exit> runFollow(FollowCommandOptions& options) {
  options.follow.format = options.format == "json"  ? CatFormat::json
                          : options.format == "csv" ? CatFormat::csv
                                                    : CatFormat::text;
  cli::catchStopSignals();
  const cli::StopDeadline deadline("stopped while standard output was blocked");
  endWhereTruncated(options.log);
  Result<LogReader> log = LogReader::follow(options.log);
  if (!log) return log.error();
  cli::Exit exit = cli::Exit::done;
  FollowEvents events;
  events.wait = [] {
    if (!cli::stopRequested()) std::this_thread::sleep_for(kBetweenLooks);
    return !cli::stopRequested();
  };
  events.damaged = [&](const DamageSpan& span) {
    cli::warn(damageText(span, options.log));
    exit = cli::Exit::no;
  };
  const Result<std::uint64_t> shown = followLog(*log, options.follow, events, toFlushedOutput);
  if (!shown) return shown.error();
  return exit;
}

}  // namespace

cli::Subcommand addFollowCommand(cli::CommandLine program) {
  auto options = std::make_shared<FollowCommandOptions>();
  const cli::CommandLine app =
      program.addSubcommand("follow", "print the messages of a log while it is recorded");
  app.addOption("LOG", options->log, "the log, which may still grow").required();
  app.addFlag("--from-start", options->follow.from_start, "print the messages already there first");
  app.addOption("--channel", options->follow.channels,
                "only topics that match this pattern; may be repeated")
      .valueName("PATTERN")
      .oneEach();
  app.addOption("--format", options->format, "json: one object per line")
      .oneOf({"text", "json", "csv"})
      .showDefault();
  return {app, [options] { return runFollow(*options); }};
}

}  // namespace rocinante
