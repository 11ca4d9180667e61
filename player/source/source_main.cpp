#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <optional>

#include "core/base/duration_text.h"
#include "core/base/plain_text.h"
#include "core/cli/program.h"
#include "player/source/source.h"

namespace {

using namespace rocinante;

constexpr const char* kExamples =
    "  rocinante source --csv joints.csv --device arm    columns t,joint1,joint2,...\n"
    "  rocinante source --csv joints.csv --device arm --columns shoulder,elbow --loop 0\n"
    "  rocinante source --demo all                       the demo cell, until Ctrl-C\n"
    "  rocinante source --demo arm --to 10.0.0.7:19960 --speed 2 --duration 20s\n";

struct Arguments {
  CsvSourceOptions csv;
  SourceOptions options;
  std::string demo;
  std::string to;
  std::string speed = "1";
  std::string restate = "2s";
  std::string duration;
  std::string realtime = "auto";
  bool json = false;
  bool quiet = false;
};

void declareTable(CLI::App& app, Arguments& my) {
  auto* csv = app.add_option("--csv", my.csv.csv, "a table with a header row: t, joint, joint, ...")
                  ->option_text("FILE");
  auto* device = app.add_option("--device", my.csv.device, "the device that the columns move")
                     ->needs(csv)
                     ->option_text("NAME");
  csv->needs(device);
  app.add_option("--source", my.csv.source, "the SOURCE name; default the device's")
      ->needs(csv)
      ->option_text("NAME");
  app.add_option("--columns", my.csv.columns,
                 "the columns that are joints; default all but the time")
      ->delimiter(',')
      ->needs(csv)
      ->option_text("A,B,...");
  app.add_option("--restate", my.restate, "restate everything this often; 0: never")
      ->needs(csv)
      ->option_text("TIME=2s");
  app.add_flag("--stamp-clock", my.csv.stamp_clock, "TIME is the wall clock when sending")
      ->needs(csv)
      ->option_text(" ");
  app.add_option("--demo", my.demo, "the built-in motion: arm, gantry, planner or all (default)")
      ->expected(0, 1)
      ->default_str("all")
      ->check(CLI::IsMember({"arm", "gantry", "planner", "all"}))
      ->excludes(csv)
      ->option_text("[PART]");
}

void declare(CLI::App& app, Arguments& my) {
  declareTable(app, my);
  app.add_option("--to", my.to, "where to send: udp://HOST:PORT, HOST:PORT or a multicast group")
      ->option_text("EP");
  app.add_option("--speed", my.speed, "seconds of the motion per second, 0.01 to 1000")
      ->option_text("X=1");
  app.add_option("--loop", my.options.turns,
                 "send the motion N times; 0: until stopped; default 1 for a table, 0 for a demo")
      ->option_text("N");
  app.add_option("--duration", my.duration, "end after this much of the motion")
      ->option_text("TIME");
  app.add_option("--run", my.options.run, "the RUN token; default a random one")
      ->option_text("TOKEN");
  app.add_option("--mtu", my.options.mtu_bytes, "largest datagram, 64 to 65507 bytes")
      ->check(CLI::Range(64, 65'507))
      ->option_text("BYTES=1200");
  app.add_option("--realtime", my.realtime, "run before other threads: auto, on or off")
      ->check(CLI::IsMember({"auto", "on", "off"}))
      ->option_text("WHEN=auto");
  app.add_flag("--json", my.json, "print what was sent as JSON");
  app.add_flag("--quiet", my.quiet, "print nothing but errors (and --json)");
}

Status readOptions(Arguments& my, bool loop_given) {
  if (!my.to.empty()) {
    const auto to = Endpoint::parse(my.to);
    if (!to) return to.error();
    my.options.to = *to;
  }
  const auto speed = PlaybackSpeed::parse(my.speed);
  if (!speed) return speed.error();
  my.options.speed = *speed;
  const auto restate = parseDuration(my.restate);
  if (!restate) return restate.error();
  if (restate->count() < 0) {
    return Error{ErrorKind::bad_argument, "--restate cannot be negative", my.restate};
  }
  my.csv.restate = *restate;
  if (!my.duration.empty()) {
    const auto duration = parseDuration(my.duration);
    if (!duration) return duration.error();
    if (duration->count() <= 0) {
      return Error{ErrorKind::bad_argument, "--duration must be greater than zero", my.duration};
    }
    my.options.duration = *duration;
  }
  // By default a table is sent once, and the demo runs until stopped.
  if (!loop_given) my.options.turns = my.demo.empty() ? 1 : 0;
  my.options.realtime = realtimeOf(my.realtime);
  my.options.progress = !my.quiet && ::isatty(STDERR_FILENO) == 1;
  return {};
}

Result<cli::Exit> run(Arguments& my, bool loop_given) {
  if (my.csv.csv.empty() && my.demo.empty()) {
    return Error{ErrorKind::bad_argument, "nothing to send: give --csv FILE or --demo", ""};
  }
  if (const Status read = readOptions(my, loop_given); !read) return read.error();

  cli::catchStopSignals();
  SendSurroundings surroundings;
  surroundings.stop = cli::stopRequested;
  surroundings.told = [&my](std::string_view line) {
    if (!my.quiet) std::fprintf(stderr, "%s\n", plainText(line).c_str());
  };
  std::vector<DemoPart> parts;
  for (const DemoPart part : kDemoParts) {
    if (my.demo == "all" || my.demo == nameOf(part)) parts.push_back(part);
  }
  std::optional<cli::StopDeadline> deadline("stopped while reading the table");
  const Result<PlayReport> report = my.demo.empty() ? sendCsv(my.csv, my.options, surroundings)
                                                    : sendDemo(parts, my.options, surroundings);
  deadline.reset();
  if (!report) return report.error();
  if (!report->keptUp() && !my.quiet) cli::warn(behindText(*report));
  const std::string said =
      my.json ? jsonText(*report) : (my.quiet ? std::string() : summaryText(*report));
  std::fwrite(said.data(), 1, said.size(), stdout);
  return cli::Exit::done;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Sends kinematic state as packets: from a CSV file, or the demo's motion.",
               "rocinante-source");
  Arguments arguments;
  declare(app, arguments);
  return rocinante::cli::run(app, argc, argv, kExamples,
                             [&] { return run(arguments, app.count("--loop") > 0); });
}
