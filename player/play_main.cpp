#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>

#include "core/atomic_file.h"
#include "core/cli/program.h"
#include "player/play.h"

namespace {

using namespace rocinante;

constexpr const char* kExamples =
    "  rocinante play session.mcap                       to the standard group, as recorded\n"
    "  rocinante play session.mcap --to 10.0.0.7:19960 --speed 0.25\n"
    "  rocinante play session.mcap --from 12.5s --until 14s --loop 0   until Ctrl-C\n"
    "  rocinante play left.mcap right.mcap --report -    both on one time line; how exact it was\n";

struct Arguments {
  PlayOptions options;
  std::string to;
  std::string speed = "1";
  std::string realtime = "auto";
  std::string report;
  bool force = false;
  bool json = false;
  bool quiet = false;
};

void declare(CLI::App& app, Arguments& my) {
  app.add_option("LOG", my.options.logs, "logs to play, on one time line")
      ->required()
      ->option_text("...");
  app.add_option("--to", my.to, "where to send: udp://HOST:PORT, HOST:PORT or a multicast group")
      ->option_text("EP");
  auto* speed = app.add_option("--speed", my.speed, "log seconds per second, 0.01 to 1000")
                    ->option_text("X=1");
  app.add_flag("--asap", my.options.at_once, "as fast as the network takes them, not on schedule")
      ->excludes(speed)
      ->option_text(" ");
  app.add_option("--from", my.options.from, "begin at this session time (12.5s, -1s, RFC 3339)")
      ->option_text("TIME");
  app.add_option("--until", my.options.until, "end before this session time")->option_text("TIME");
  app.add_option("--loop", my.options.turns, "play this often; 0: until stopped")
      ->option_text("N=1");
  app.add_option("--restate", my.options.restate,
                 "say every source's state at the beginning first: true or false")
      ->option_text("BOOL=true");
  app.add_option("--realtime", my.realtime, "run before other threads: auto, on or off")
      ->check(CLI::IsMember({"auto", "on", "off"}))
      ->option_text("WHEN=auto");
  app.add_option("--report", my.report, "write what was sent, and how late, as JSON; -: to stdout")
      ->option_text("FILE");
  app.add_flag("--force", my.force, "replace the report file");
  app.add_flag("--json", my.json, "the same as --report -");
  app.add_flag("--quiet", my.quiet, "print nothing but errors (and --json)");
}

Result<cli::Exit> run(Arguments& my) {
  if (!my.to.empty()) {
    const auto to = Endpoint::parse(my.to);
    if (!to) return to.error();
    my.options.to = *to;
  }
  const auto speed = PlaybackSpeed::parse(my.speed);
  if (!speed) return speed.error();
  my.options.speed = *speed;
  my.options.realtime = realtimeOf(my.realtime);
  const bool to_stdout = my.json || my.report == "-";
  const bool to_file = !my.report.empty() && my.report != "-";
  // Asked before playing: an hour later is too late to learn it.
  if (to_file && !my.force && std::filesystem::exists(my.report)) {
    return Error{ErrorKind::refused, "the report file exists; --force overwrites it", my.report};
  }
  my.options.progress = !my.quiet && ::isatty(STDERR_FILENO) == 1;

  cli::catchStopSignals();
  SendSurroundings surroundings;
  surroundings.stop = cli::stopRequested;
  surroundings.told = [&my](std::string_view line) {
    if (!my.quiet) std::fprintf(stderr, "%.*s\n", static_cast<int>(line.size()), line.data());
  };
  const Result<PlayReport> report = play(my.options, surroundings);
  if (!report) return report.error();

  for (const std::string& damage : report->damage) cli::warn(damage);
  if (!report->keptUp() && !my.quiet) cli::warn(behindText(*report));
  if (to_file) {
    const std::string json = jsonText(*report);
    if (const Status written = writeFileWhole(my.report, bytesOf(json), my.force); !written) {
      return written.error();
    }
  }
  const std::string said =
      to_stdout ? jsonText(*report) : (my.quiet ? std::string() : summaryText(*report));
  std::fwrite(said.data(), 1, said.size(), stdout);
  return report->damage.empty() ? cli::Exit::done : cli::Exit::no;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Re-emits recorded datagrams as UDP, on the session's own schedule.",
               "rocinante-play");
  Arguments arguments;
  declare(app, arguments);
  return rocinante::cli::run(app, argc, argv, kExamples, [&] { return run(arguments); });
}
