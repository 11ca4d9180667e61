#include <unistd.h>

#include <string>
#include <utility>
#include <vector>

#include "core/base/duration_text.h"
#include "core/base/plain_text.h"
#include "core/check/log_account.h"
#include "core/cli/import_progress.h"
#include "core/cli/no_wait.h"
#include "core/cli/program.h"
#include "core/foreign/recordings/opened_recording.h"
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

void declareTable(cli::CommandLine app, Arguments& my) {
  const cli::Option csv =
      app.addOption("--csv", my.csv.csv, "a table with a header row: t, joint, joint, ...")
          .valueText("FILE");
  const cli::Option log =
      app.addOption("--log", my.log.log, "a recorded session, its sources sent anew")
          .excludes(csv)
          .valueText("LOG");
  const cli::Option joystick =
      app.addOption("--joystick", my.joystick.device,
                    "joints moved by hand: /dev/input/jsN, or a file of its events")
          .excludes(csv)
          .excludes(log)
          .valueText("DEV");
  app.addOption("--map", my.joystick.map,
                "what an axis or a button does: axis0=arm.j1:0.5/s:-1..1 (turns it), "
                "axis1=grip.width:0..0.08 (is its place), button0=event:TEXT; repeatable")
      .needs(joystick)
      .oneEach()
      .valueText("ENTRY");
  app.addOption("--device", my.devices,
                "the device that the columns move; without it they are DEVICE.JOINT; of a log, "
                "only what is about devices that match; repeatable")
      .oneEach()
      .valueText("NAME");
  app.addOption("--source", my.sources,
                "the SOURCE name; default the first device's; of a log, only sources that match; "
                "repeatable")
      .oneEach()
      .valueText("NAME");
  app.addOption("--as", my.renamed, "send SOURCE OLD of the log as NEW; repeatable")
      .needs(log)
      .oneEach()
      .valueText("OLD=NEW");
  app.addOption("--from", my.log.from, "begin at this session time (12.5s, -1s, RFC 3339)")
      .needs(log)
      .valueText("TIME");
  app.addOption("--until", my.log.until, "end before this session time")
      .needs(log)
      .valueText("TIME");
  app.addOption("--columns", my.csv.columns,
                "the columns that are joints; default all but the time")
      .separatedBy(',')
      .needs(csv)
      .valueText("A,B,...");
  app.addOption("--restate", my.restate, "restate everything this often; 0: never")
      .valueText("TIME=2s");
  app.addFlag("--stamp-clock", my.csv.stamp_clock, "TIME is the wall clock when sending")
      .needs(csv)
      .valueText(" ");
  app.addOption("--demo", my.demo,
                "the motion of the demo cell: arm, gantry, planner or all (default)")
      .bareMeans("all")
      .oneOf({"arm", "gantry", "planner", "all"})
      .excludes(csv)
      .excludes(log)
      .excludes(joystick)
      .valueText("[PART]");
}

void declare(cli::CommandLine app, Arguments& my) {
  declareTable(app, my);
  app.addOption("--to", my.to, "where to send: udp://HOST:PORT, HOST:PORT or a multicast group")
      .valueText("EP");
  cli::addNoWait(app, my.no_wait);
  app.addOption("--speed", my.speed, "seconds of the motion per second, 0.01 to 1000")
      .valueText("X=1");
  app.addOption("--loop", my.options.turns,
                "send the motion N times; 0: until stopped; default 0 for the demo, else 1")
      .valueText("N");
  app.addOption("--duration", my.duration, "end after this much of the motion").valueText("TIME");
  app.addOption("--run", my.options.run, "the RUN token; default a random one").valueText("TOKEN");
  app.addOption("--mtu", my.options.mtu_bytes, "largest datagram, 64 to 65507 bytes")
      .within(64, 65'507)
      .valueText("BYTES=1200");
  app.addOption("--key", my.options.key, "sign every datagram with this secret key (rocinante key)")
      .valueText("FILE");
  app.addOption("--realtime", my.realtime, "run before other threads: auto, on or off")
      .oneOf({"auto", "on", "off"})
      .valueText("WHEN=auto");
  app.addFlag("--json", my.json, "print what was sent as JSON");
  app.addFlag("--quiet", my.quiet, "print nothing but errors (and --json)");
}

/// What names devices and sources: one of each for a table, any number of patterns for a log.
Status readNames(Arguments& my) {
  for (const auto& [option, names] :
       {std::pair("--device", &my.devices), {"--source", &my.sources}}) {
    if (names->empty() || !my.log.log.empty()) continue;
    const bool is_joystick = !my.joystick.device.empty();
    if (is_joystick && names == &my.devices) {
      return Error{ErrorKind::bad_argument, "--map names the devices of a joystick, not --device",
                   names->back()};
    }
    if (my.csv.csv.empty() && !is_joystick) {
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
  if (!my.csv.csv.empty()) {
    if (!my.devices.empty()) my.csv.device = my.devices.front();
    if (!my.sources.empty()) my.csv.source = my.sources.front();
  }
  if (!my.sources.empty()) my.joystick.source = my.sources.front();
  my.log.choice.devices = my.devices;
  my.log.choice.sources = my.sources;
  for (const std::string& text : my.renamed) {
    const std::size_t cut = text.find('=');
    if (cut == std::string::npos || cut == 0) {
      return Error{ErrorKind::bad_argument, "--as takes OLD=NEW", text};
    }
    if (!my.log.choice.names.emplace(text.substr(0, cut), text.substr(cut + 1)).second) {
      return Error{ErrorKind::bad_argument, "--as renames a source twice", text};
    }
  }
  return {};
}

Status readOptions(Arguments& my, bool loop_given) {
  if (!my.to.empty()) {
    const auto to = Endpoint::parse(my.to);
    if (!to) return to.error();
    my.options.to = *to;
    my.options.to.nats.waits = !my.no_wait;
  }
  const auto speed = PlaybackSpeed::parse(my.speed);
  if (!speed) return speed.error();
  my.options.speed = *speed;
  const auto restate = parseDuration(my.restate);
  if (!restate) return restate.error();
  if (restate->count() < 0) {
    return Error{ErrorKind::bad_argument, "--restate cannot be negative", my.restate};
  }
  if (restate->count() > 0 && *restate < std::chrono::milliseconds(10) && my.csv.csv.empty()) {
    return Error{ErrorKind::bad_argument, "--restate is 0 or at least 10ms", my.restate};
  }
  my.csv.restate = my.log.restate = my.joystick.restate = *restate;
  if (!my.duration.empty()) {
    const auto duration = parseDuration(my.duration);
    if (!duration) return duration.error();
    if (duration->count() <= 0) {
      return Error{ErrorKind::bad_argument, "--duration must be greater than zero", my.duration};
    }
    my.options.duration = *duration;
  }
  // By default the demo runs until stopped.
  if (!loop_given) my.options.turns = my.demo.empty() ? 1 : 0;
  my.options.realtime = realtimeOf(my.realtime);
  my.options.progress = !my.quiet && ::isatty(STDERR_FILENO) == 1;
  return {};
}

Result<PlayReport> send(Arguments& my) {
  SendSurroundings surroundings;
  surroundings.stop = cli::stopRequested;
  surroundings.told = [&my](std::string_view line) {
    if (!my.quiet) cli::tell(plainText(line) + "\n");
  };
  if (!my.log.log.empty()) {
    const cli::StopDeadline deadline("stopped while reading the log");
    // What another program recorded becomes a log first.
    RecordingRequest request;
    request.recording = my.log.log;
    request.progress = cli::importProgress(request.recording.string());
    const Result<OpenedRecording> opened = openedRecording(request);
    if (!opened) return opened.error();
    for (const std::string& warning : opened->warnings) cli::warn(warning);
    if (!opened->not_kept.empty()) cli::warn(opened->not_kept);
    const auto account = logAccount(opened->log, nullptr);
    if (account && account->imported && !account->note().empty()) cli::warn(account->note());
    LogSourceOptions log = my.log;
    log.log = opened->log;
    Result<PlayReport> report = sendLog(log, my.options, surroundings);
    if (!report) return opened->named(report.error());
    return report;
  }
  if (!my.csv.csv.empty()) {
    const cli::StopDeadline deadline("stopped while reading the table");
    return sendCsv(my.csv, my.options, surroundings);
  }
  if (!my.joystick.device.empty()) return sendJoystick(my.joystick, my.options, surroundings);
  return sendDemo(my.demo, my.log.restate, my.options, surroundings);
}

Result<cli::Exit> run(Arguments& my, bool loop_given) {
  if (const Status read = readNames(my); !read) return read.error();
  if (my.csv.csv.empty() && my.log.log.empty() && my.demo.empty() && my.joystick.device.empty()) {
    return Error{ErrorKind::bad_argument,
                 "nothing to send: give --csv FILE, --log LOG, --joystick DEV or --demo", ""};
  }
  if (const Status read = readOptions(my, loop_given); !read) return read.error();
  cli::catchStopSignals();
  const Result<PlayReport> report = send(my);
  if (!report) return report.error();
  for (const std::string& damage : report->damage) cli::warn(damage);
  if (!report->keptUp() && !my.quiet) cli::warn(behindText(*report));
  if (my.json) cli::say(jsonText(*report));
  if (!my.json && !my.quiet) cli::say(summaryText(*report));
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
