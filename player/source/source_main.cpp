#include <unistd.h>

#include <string>
#include <utility>
#include <vector>

#include "core/base/duration_text.h"
#include "core/base/plain_text.h"
#include "core/check/log_account.h"
#include "core/cli/no_wait.h"
#include "core/cli/opened_session.h"
#include "core/cli/program.h"
#include "core/report/json_text.h"
#include "player/source/joystick.h"
#include "player/source/source.h"

namespace {

using namespace rocinante;

constexpr const char* kExamples =
    "  rocinante source --csv joints.csv --device arm    columns t,joint1,joint2,...\n"
    "  rocinante source --csv joints.csv --device arm --columns shoulder,elbow --loop 0\n"
    "  rocinante source --csv cell.csv                   columns t,arm.j1,arm.j2,tray:x,...\n"
    "  rocinante source --joystick /dev/input/js0 --map axis0=arm.j1:0.5/s --map "
    "button0=event:pick\n"
    "  rocinante source --log session.mcap --loop 0      its sources anew, with TIME of now\n"
    "  rocinante source --log session.mcap --source arm --as arm=left_arm --from 12s\n"
    "  rocinante source --demo all                       the demo cell, until Ctrl-C\n"
    "  rocinante source --demo arm --to 10.0.0.7:19960 --speed 2 --duration 20s\n";

struct Arguments {
  CsvSourceOptions csv;
  LogSourceOptions log;
  JoystickSourceOptions joystick;
  std::vector<std::string> sources;
  std::vector<std::string> devices;
  std::vector<std::string> renamed;
  SourceOptions options;
  std::string demo;
  std::string to;
  std::string speed = "1";
  std::string restate = "2s";
  std::string duration;
  std::string realtime = "auto";
  bool no_wait = false;
  bool json = false;
  bool quiet = false;
};

void declareTable(cli::CommandLine app, Arguments& arguments) {
  const cli::Option csv =
      app.addOption("--csv", arguments.csv.csv, "a table with a header row: t, joint, joint, ...")
          .valueText("FILE");
  const cli::Option log =
      app.addOption("--log", arguments.log.log, "a recorded session, its sources sent anew")
          .excludes(csv)
          .valueText("LOG");
  const cli::Option joystick =
      app.addOption("--joystick", arguments.joystick.device,
                    "joints moved by hand: /dev/input/jsN, or a file of its events")
          .excludes(csv)
          .excludes(log)
          .valueText("DEV");
  app.addOption("--map", arguments.joystick.map,
                "what an axis or a button does: axis0=arm.j1:0.5/s:-1..1 (turns it), "
                "axis1=grip.width:0..0.08 (is its place), button0=event:TEXT; repeatable")
      .needs(joystick)
      .oneEach()
      .valueText("ENTRY");
  app.addOption("--device", arguments.devices,
                "the device that the columns move; without it they are DEVICE.JOINT; of a log, "
                "only what is about devices that match; repeatable")
      .oneEach()
      .valueText("NAME");
  app.addOption("--source", arguments.sources,
                "the SOURCE name; default the first device's; of a log, only sources that match; "
                "repeatable")
      .oneEach()
      .valueText("NAME");
  app.addOption("--as", arguments.renamed, "send SOURCE OLD of the log as NEW; repeatable")
      .needs(log)
      .oneEach()
      .valueText("OLD=NEW");
  app.addOption("--from", arguments.log.from, "begin at this session time (12.5s, -1s, RFC 3339)")
      .needs(log)
      .valueText("TIME");
  app.addOption("--until", arguments.log.until, "end before this session time")
      .needs(log)
      .valueText("TIME");
  app.addOption("--columns", arguments.csv.columns,
                "the columns that are joints; default all but the time")
      .separatedBy(',')
      .needs(csv)
      .valueText("A,B,...");
  app.addOption("--restate", arguments.restate, "restate everything this often; 0: never")
      .valueText("TIME=2s");
  app.addFlag("--stamp-clock", arguments.csv.stamp_clock, "TIME is the wall clock when sending")
      .needs(csv)
      .valueText(" ");
  app.addOption("--demo", arguments.demo,
                "the motion of the demo cell: arm, gantry, planner or all (default)")
      .bareMeans("all")
      .oneOf({"arm", "gantry", "planner", "all"})
      .excludes(csv)
      .excludes(log)
      .excludes(joystick)
      .valueText("[PART]");
}

void declare(cli::CommandLine app, Arguments& arguments) {
  declareTable(app, arguments);
  app.addOption("--to", arguments.to,
                "where to send: udp://HOST:PORT, HOST:PORT or a multicast group")
      .valueText("EP");
  cli::addNoWait(app, arguments.no_wait);
  app.addOption("--speed", arguments.speed, "seconds of the motion per second, 0.01 to 1000")
      .valueText("X=1");
  app.addOption("--loop", arguments.options.turns,
                "send the motion N times; 0: until stopped; default 0 for the demo, else 1")
      .valueText("N");
  app.addOption("--duration", arguments.duration, "end after this much of the motion")
      .valueText("TIME");
  app.addOption("--run", arguments.options.run, "the RUN token; default a random one")
      .valueText("TOKEN");
  app.addOption("--mtu", arguments.options.mtu_bytes, "largest datagram, 64 to 65507 bytes")
      .within(64, 65'507)
      .valueText("BYTES=1200");
  app.addOption("--key", arguments.options.key,
                "sign every datagram with this secret key (rocinante key)")
      .valueText("FILE");
  app.addOption("--realtime", arguments.realtime, "run before other threads: auto, on or off")
      .oneOf({"auto", "on", "off"})
      .valueText("WHEN=auto");
  app.addFlag("--json", arguments.json, "print what was sent as JSON");
  app.addFlag("--quiet", arguments.quiet, "print nothing but errors (and --json)");
}

/// What names devices and sources: one of each for a table, any number of patterns for a log.
Status readNames(Arguments& arguments) {
  for (const auto& [option, names] :
       {std::pair("--device", &arguments.devices), {"--source", &arguments.sources}}) {
    if (names->empty() || !arguments.log.log.empty()) continue;
    const bool is_joystick = !arguments.joystick.device.empty();
    if (is_joystick && names == &arguments.devices) {
      return Error{ErrorKind::bad_argument, "--map names the devices of a joystick, not --device",
                   names->back()};
    }
    if (arguments.csv.csv.empty() && !is_joystick) {
      return Error{ErrorKind::bad_argument,
                   std::string(option) + " needs --csv, --log or --joystick", ""};
    }
    if (names->size() > 1) {
      return Error{
          ErrorKind::bad_argument,
          std::string(is_joystick ? "a joystick takes one " : "a table takes one ") + option,
          names->back()};
    }
  }
  if (!arguments.csv.csv.empty()) {
    if (!arguments.devices.empty()) arguments.csv.device = arguments.devices.front();
    if (!arguments.sources.empty()) arguments.csv.source = arguments.sources.front();
  }
  if (!arguments.sources.empty()) arguments.joystick.source = arguments.sources.front();
  arguments.log.choice.devices = arguments.devices;
  arguments.log.choice.sources = arguments.sources;
  for (const std::string& text : arguments.renamed) {
    const std::size_t cut = text.find('=');
    if (cut == std::string::npos || cut == 0) {
      return Error{ErrorKind::bad_argument, "--as takes OLD=NEW", text};
    }
    if (!arguments.log.choice.names.emplace(text.substr(0, cut), text.substr(cut + 1)).second) {
      return Error{ErrorKind::bad_argument, "--as renames a source twice", text};
    }
  }
  return {};
}

Status readOptions(Arguments& arguments, bool loop_given) {
  if (!arguments.to.empty()) {
    const auto to = Endpoint::parse(arguments.to);
    if (!to) return to.error();
    arguments.options.to = *to;
    arguments.options.to.nats.waits = !arguments.no_wait;
  }
  const auto speed = PlaybackSpeed::parse(arguments.speed);
  if (!speed) return speed.error();
  arguments.options.speed = *speed;
  const auto restate = parseDuration(arguments.restate);
  if (!restate) return restate.error();
  if (restate->count() < 0) {
    return Error{ErrorKind::bad_argument, "--restate cannot be negative", arguments.restate};
  }
  if (restate->count() > 0 && *restate < std::chrono::milliseconds(10) &&
      arguments.csv.csv.empty()) {
    return Error{ErrorKind::bad_argument, "--restate is 0 or at least 10ms", arguments.restate};
  }
  arguments.csv.restate = arguments.log.restate = arguments.joystick.restate = *restate;
  if (!arguments.duration.empty()) {
    const auto duration = parseDuration(arguments.duration);
    if (!duration) return duration.error();
    if (duration->count() <= 0) {
      return Error{ErrorKind::bad_argument, "--duration must be greater than zero",
                   arguments.duration};
    }
    arguments.options.duration = *duration;
  }
  // By default the demo runs until stopped.
  if (!loop_given) arguments.options.turns = arguments.demo.empty() ? 1 : 0;
  arguments.options.realtime = realtimeOf(arguments.realtime);
  arguments.options.progress = !arguments.quiet && ::isatty(STDERR_FILENO) == 1;
  return {};
}

Result<PlayReport> send(Arguments& arguments) {
  SendSurroundings surroundings;
  surroundings.stop = cli::stopRequested;
  surroundings.notify = [&arguments](std::string_view line) {
    if (!arguments.quiet) cli::tell(plainText(line) + "\n");
  };
  if (!arguments.log.log.empty()) {
    const cli::StopDeadline deadline("stopped while reading the log");
    // What another program recorded becomes a log first.
    const Result<OpenedRecording> opened = cli::openWithinDeadline(arguments.log.log);
    if (!opened) return opened.error();
    const auto account = logAccount(opened->log, nullptr);
    if (account && account->imported && !account->note().empty()) cli::warn(account->note());
    LogSourceOptions log = arguments.log;
    log.log = opened->log;
    Result<PlayReport> report = sendLog(log, arguments.options, surroundings);
    if (!report) return opened->named(report.error());
    return report;
  }
  if (!arguments.csv.csv.empty()) {
    const cli::StopDeadline deadline("stopped while reading the table");
    return sendCsv(arguments.csv, arguments.options, surroundings);
  }
  if (!arguments.joystick.device.empty())
    return sendJoystick(arguments.joystick, arguments.options, surroundings);
  return sendDemo(arguments.demo, arguments.log.restate, arguments.options, surroundings);
}

Result<cli::Exit> run(Arguments& arguments, bool loop_given) {
  if (const Status read = readNames(arguments); !read) return read.error();
  if (arguments.csv.csv.empty() && arguments.log.log.empty() && arguments.demo.empty() &&
      arguments.joystick.device.empty()) {
    return Error{ErrorKind::bad_argument,
                 "nothing to send: give --csv FILE, --log LOG, --joystick DEV or --demo", ""};
  }
  if (const Status read = readOptions(arguments, loop_given); !read) return read.error();
  cli::catchStopSignals();
  const Result<PlayReport> report = send(arguments);
  if (!report) return report.error();
  for (const std::string& damage : report->damage) cli::warn(damage);
  if (!report->keptUp() && !arguments.quiet) cli::warn(behindText(*report));
  if (arguments.json) cli::say(jsonText(*report));
  if (!arguments.json && !arguments.quiet) cli::say(summaryText(*report));
  return report->damage.empty() ? cli::Exit::done : cli::Exit::no;
}

}  // namespace

int main(int argc, char** argv) {
  cli::Program app(
      "Sends kinematic state as packets: from a CSV file, a recorded session, a joystick, or the "
      "demo's motion.",
      "rocinante-source");
  Arguments arguments;
  declare(app, arguments);
  return rocinante::cli::run(app, argc, argv, kExamples,
                             [&] { return run(arguments, app.option("--loop").given()); });
}
