#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "core/cli/program.h"
#include "core/duration_text.h"
#include "player/source.h"

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

void declare(CLI::App& app, Arguments& my) {
  auto* csv =
      app.add_option("--csv", my.csv.csv, "a table with a header row: t, joint, joint, ...");
  auto* device =
      app.add_option("--device", my.csv.device, "the device that the columns move")->needs(csv);
  csv->needs(device);
  app.add_option("--source", my.csv.source, "the name to speak as (default: the device's)")
      ->needs(csv);
  app.add_option("--columns", my.csv.columns, "the columns that are joints (default: all)")
      ->delimiter(',')
      ->needs(csv);
  app.add_option("--restate", my.restate, "say everything again this often; 0: never")
      ->needs(csv)
      ->capture_default_str();
  app.add_flag("--stamp-clock", my.csv.stamp_clock, "TIME is the clock's when sending")->needs(csv);
  app.add_option("--demo", my.demo, "the built-in motion: arm, gantry, planner or all")
      ->expected(0, 1)
      ->default_str("all")
      ->check(CLI::IsMember({"arm", "gantry", "planner", "all"}))
      ->excludes(csv);
  app.add_option("--to", my.to, "where to send: udp://HOST:PORT, HOST:PORT or a multicast group");
  app.add_option("--speed", my.speed, "seconds of the motion per second, 0.01 to 1000")
      ->capture_default_str();
  app.add_option("--loop", my.options.turns,
                 "send the motion this often; 0: until stopped (default: a table 1, the demo 0)");
  app.add_option("--duration", my.duration, "end after this much of the motion");
  app.add_option("--run", my.options.run, "the RUN token (default: a random one)");
  app.add_option("--mtu", my.options.mtu_bytes, "no datagram is larger")
      ->check(CLI::Range(64, 65'507))
      ->capture_default_str();
  app.add_option("--realtime", my.realtime, "auto, on or off: run before other threads")
      ->check(CLI::IsMember({"auto", "on", "off"}))
      ->capture_default_str();
  app.add_flag("--json", my.json, "say at the end what was sent, as JSON");
  app.add_flag("--quiet", my.quiet, "only errors");
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
      return Error{ErrorKind::bad_argument, "--duration must be above zero", my.duration};
    }
    my.options.duration = *duration;
  }
  // A table is a record and ends; the demo is a machine and goes on.
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
    if (!my.quiet) cli::warn(line);
  };
  std::vector<DemoPart> parts;
  for (const DemoPart part : kDemoParts) {
    if (my.demo == "all" || my.demo == nameOf(part)) parts.push_back(part);
  }
  const Result<PlayReport> report = my.demo.empty() ? sendCsv(my.csv, my.options, surroundings)
                                                    : sendDemo(parts, my.options, surroundings);
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
