#include <unistd.h>

#include <charconv>

#include "core/base/atomic_file.h"
#include "core/base/duration_text.h"
#include "core/base/plain_text.h"
#include "core/cli/no_wait.h"
#include "core/cli/opened_session.h"
#include "core/cli/program.h"
#include "core/report/account.h"
#include "core/report/json_text.h"
#include "player/control/command_slot.h"
#include "player/control/control_socket.h"
#include "player/control/control_thread.h"
#include "player/control/terminal_keys.h"
#include "player/play/play.h"
#include "player/send/send_progress.h"

namespace {

using namespace rocinante;

constexpr const char* kExamples =
    "  rocinante play session.mcap                       to the standard group, as recorded\n"
    "  rocinante play session.mcap --to 10.0.0.7:19960 --speed 0.25\n"
    "  rocinante play session.mcap --from 12.5s --until 14s --loop 0   until Ctrl-C\n"
    "  rocinante play session.mcap --loop 12.5s-14s --gap-limit 2s\n"
    "  rocinante play session.mcap --start-paused --control 127.0.0.1:7000\n"
    "  rocinante play left.mcap right.mcap --report -    both on one time line; how exact it was\n"
    "\nKeys on a terminal: space pauses, arrows step (right, left: a message; up, down: 1 s),\n"
    "+ and - change the speed, n and p go to the next event and the one before, q quits.\n";

struct Arguments {
  PlayOptions options;
  std::string to;
  std::string speed = "1";
  std::string loop = "1";
  std::string restate = "2s";
  std::string gap_limit;
  std::string ack_timeout = "1s";
  std::vector<std::string> maps;
  std::string control;
  std::vector<std::string> control_allow;
  std::string realtime = "auto";
  std::string report;
  bool force = false;
  bool no_wait = false;
  bool json = false;
  bool quiet = false;
};

void declareWhat(cli::CommandLine app, Arguments& arguments) {
  app.addOption("LOG", arguments.options.logs, "logs to play, on one time line")
      .required()
      .valueText("...");
  app.addOption("--from", arguments.options.from,
                "begin at this session time (12.5s, -1s, RFC 3339)")
      .valueText("TIME");
  app.addOption("--until", arguments.options.until, "end before this session time")
      .valueText("TIME");
  app.addOption("--loop", arguments.loop, "play N times (0: until stopped), or repeat the part A-B")
      .valueText("N|A-B=1");
  app.addOption("--channel", arguments.options.channels.only, "only topics that match; repeatable")
      .oneEach()
      .valueText("PATTERN");
  app.addOption("--mute", arguments.options.channels.muted, "not the topics that match; repeatable")
      .oneEach()
      .valueText("PATTERN");
}

void declareWhere(cli::CommandLine app, Arguments& arguments) {
  app.addOption("--to", arguments.to,
                "where to send: udp://HOST:PORT, HOST:PORT or a multicast group")
      .valueText("EP");
  cli::addNoWait(app, arguments.no_wait);
  app.addOption("--map", arguments.maps, "send topics that match elsewhere; repeatable")
      .oneEach()
      .valueText("PATTERN=EP");
  app.addFlag("--keep-ports", arguments.options.keep_ports,
              "send from the ports of the original senders");
}

void declareHow(cli::CommandLine app, Arguments& arguments) {
  const cli::Option speed =
      app.addOption("--speed", arguments.speed, "log seconds per second, 0.01 to 1000")
          .valueText("X=1");
  const cli::Option at_once = app.addFlag("--asap", arguments.options.at_once,
                                          "as fast as the network takes them, without a schedule")
                                  .excludes(speed)
                                  .valueText(" ");
  const cli::Option lockstep =
      app.addFlag("--lockstep", arguments.options.lockstep,
                  "after each, send `step N` to the controller and wait for `ack N`")
          .excludes(speed)
          .excludes(at_once)
          .valueText(" ");
  app.addOption("--ack-timeout", arguments.ack_timeout, "how long to wait for an ack, then exit 1")
      .needs(lockstep)
      .valueText("TIME=1s");
  app.addOption("--gap-limit", arguments.gap_limit, "shorten silences to at most this")
      .valueText("TIME");
  app.addOption("--restate", arguments.restate,
                "restate every source's state first, then this often; 0: only first; off")
      .valueText("TIME=2s");
  app.addOption("--key", arguments.options.key,
                "sign the player's own restatements with this secret key (rocinante key)")
      .valueText("FILE");
  app.addOption("--realtime", arguments.realtime, "run before other threads: auto, on or off")
      .oneOf({"auto", "on", "off"})
      .valueText("WHEN=auto");
  const cli::Option control =
      app.addOption("--control", arguments.control,
                    "listen for commands on udp://127.0.0.1:PORT or unix:PATH")
          .valueText("EP");
  app.addOption("--control-allow", arguments.control_allow,
                "accept commands from this network too; repeatable")
      .needs(control)
      .oneEach()
      .valueText("CIDR");
  app.addFlag("--start-paused", arguments.options.start_paused, "wait for a command to play");
  lockstep.needs(control);
  app.addOption("--report", arguments.report,
                "write what was sent, and how late, as JSON; -: to stdout")
      .valueText("FILE");
  app.addFlag("--force", arguments.force, "replace the report file");
  app.addFlag("--json", arguments.json, "the same as --report -");
  app.addFlag("--quiet", arguments.quiet, "print nothing but errors (and --json)");
}

Result<Nanoseconds> durationOf(const char* option, const std::string& text, Nanoseconds least) {
  const Result<Nanoseconds> duration = parseDuration(text);
  if (!duration) return duration.error();
  if (*duration < least) {
    return Error{ErrorKind::bad_argument,
                 std::string(option) + " is at least " + secondsText(least) + " s", text};
  }
  return *duration;
}

Status readTimes(Arguments& arguments) {
  const bool is_number = arguments.loop.find_first_not_of("0123456789") == arguments.loop.npos;
  if (is_number) {
    const char* end = arguments.loop.data() + arguments.loop.size();
    const auto [stop, fault] = std::from_chars(arguments.loop.data(), end, arguments.options.turns);
    if (fault != std::errc() || stop != end) {
      return Error{ErrorKind::bad_argument, "--loop takes up to 4294967295 turns", arguments.loop};
    }
  } else {
    // The range is checked after the log is opened.
    if (arguments.loop.find('-', 1) == arguments.loop.npos)
      return parseLoop(arguments.loop, {}, {}).error();
    arguments.options.loop = arguments.loop;
  }
  arguments.options.restate = arguments.restate != "off" && arguments.restate != "false";
  if (arguments.options.restate && arguments.restate != "true") {
    const auto repeat = durationOf("--restate", arguments.restate, Nanoseconds(0));
    if (!repeat) return repeat.error();
    arguments.options.repeat = *repeat;
    if (repeat->count() > 0 && *repeat < std::chrono::milliseconds(10)) {
      return Error{ErrorKind::bad_argument, "--restate is 0 or at least 10ms", arguments.restate};
    }
  }
  if (!arguments.gap_limit.empty()) {
    const auto limit = durationOf("--gap-limit", arguments.gap_limit, std::chrono::milliseconds(1));
    if (!limit) return limit.error();
    arguments.options.gap_limit = *limit;
  }
  const auto timeout =
      durationOf("--ack-timeout", arguments.ack_timeout, std::chrono::milliseconds(1));
  if (!timeout) return timeout.error();
  arguments.options.ack_timeout = *timeout;
  return {};
}

Status read(Arguments& arguments) {
  if (!arguments.to.empty()) {
    const auto to = Endpoint::parse(arguments.to);
    if (!to) return to.error();
    arguments.options.to = *to;
    arguments.options.to.nats.waits = !arguments.no_wait;
  }
  for (const std::string& text : arguments.maps) {
    const auto map = RouteMap::parse(text);
    if (!map) return map.error();
    arguments.options.maps.push_back(*map);
    arguments.options.maps.back().to.nats.waits = !arguments.no_wait;
  }
  const auto speed = PlaybackSpeed::parse(arguments.speed);
  if (!speed) return speed.error();
  arguments.options.speed = *speed;
  arguments.options.realtime = realtimeOf(arguments.realtime);
  return readTimes(arguments);
}

using Inputs = std::vector<std::unique_ptr<ControlInput>>;

Status openControl(Arguments& arguments, Inputs& inputs) {
  if (!arguments.control.empty()) {
    const auto address = ControlAddress::parse(arguments.control);
    if (!address) return address.error();
    Result<AddressFilter> allowed = AddressFilter::of(arguments.control_allow);
    if (!allowed) return allowed.error();
    auto control = ControlSocket::open(
        *address, std::move(*allowed),
        arguments.quiet ? std::function<void(std::string)>()
                        : [](const std::string& sentence) { cli::warn(sentence); });
    if (!control) return control.error();
    inputs.push_back(std::move(control->input));
    // In lockstep the player ends with the log.
    arguments.options.stays = !arguments.options.lockstep;
    if (!arguments.quiet) cli::tell("listening for commands on " + control->where + "\n");
  }
  if (arguments.options.progress) {
    if (auto keys = TerminalKeys::open()) inputs.push_back(std::move(keys));
  }
  if (arguments.options.start_paused && inputs.empty()) {
    return Error{ErrorKind::bad_argument, "a paused start needs a terminal or --control to resume",
                 "--start-paused"};
  }
  return {};
}

Result<PlayReport> playWithControl(Arguments& arguments) {
  cli::catchStopSignals();
  watchResumes();
  const auto slot = CommandSlot::make();
  if (!slot) return slot.error();
  Inputs inputs;
  if (const Status opened = openControl(arguments, inputs); !opened) return opened.error();
  PlayControl control;
  if (!inputs.empty()) control = {slot->get(), (*slot)->wake()};
  // Opening a log or folding a state does not check for a stop.
  const cli::StopDeadline deadline("stopped while reading the log; no report was made",
                                   restoreTerminal);
  const ControlThread thread(**slot, std::move(inputs));
  // What other programs recorded becomes a log first.
  std::vector<OpenedRecording> opened;
  PlayOptions options = arguments.options;
  for (std::filesystem::path& log : options.logs) {
    Result<OpenedRecording> found = cli::openWithinDeadline(log);
    if (!found) return found.error();
    // Topics without packets are played as they are.
    if (!found->left_out.empty()) cli::warn(accountSentence(found->left_out));
    log = found->log;
    opened.push_back(std::move(*found));
  }
  const auto asNamed = [&](std::string text) {
    for (const OpenedRecording& each : opened) text = each.named({{}, std::move(text), {}}).what;
    return text;
  };
  SendSurroundings surroundings;
  surroundings.stop = cli::stopRequested;
  surroundings.notify = [&](std::string_view line) {
    if (!arguments.quiet) cli::tell(plainText(asNamed(std::string(line))) + "\n");
  };
  Result<PlayReport> report = play(options, surroundings, control);
  if (report) {
    report->inputs.clear();
    for (const auto& log : arguments.options.logs) report->inputs.push_back(log.string());
    return report;
  }
  Error error = report.error();
  for (const OpenedRecording& each : opened) error = each.named(std::move(error));
  return error;
}

Result<cli::Exit> run(Arguments& arguments) {
  if (const Status understood = read(arguments); !understood) return understood.error();
  const bool to_stdout = arguments.json || arguments.report == "-";
  const bool to_file = !arguments.report.empty() && arguments.report != "-";
  // Check before playing, not after an hour.
  if (to_file) {
    if (const Status may = mayWriteFile(arguments.report, arguments.force); !may)
      return may.error();
  }
  arguments.options.progress = !arguments.quiet && ::isatty(STDERR_FILENO) == 1;
  const Result<PlayReport> report = playWithControl(arguments);
  if (!report) return report.error();

  for (const std::string& damage : report->damage) cli::warn(damage);
  if (!report->keptUp() && !arguments.quiet) cli::warn(behindText(*report));
  bool is_kept = true;
  if (to_file) {
    const Status written =
        writeFileWhole(arguments.report, bytesOf(jsonText(*report)), arguments.force);
    if (!written) cli::warn(written.error().text());
    is_kept = written.ok();
  }
  if (to_stdout) cli::say(jsonText(*report));
  if (!to_stdout && !arguments.quiet) cli::say(summaryText(*report));
  if (report->failure) cli::warn(report->failure->text());
  const bool is_whole = report->damage.empty() && !report->failure && is_kept;
  return is_whole ? cli::Exit::done : cli::Exit::no;
}

}  // namespace

int main(int argc, char** argv) {
  cli::Program app("Re-emits recorded datagrams as UDP, on the session's own schedule.",
                   "rocinante-play");
  Arguments arguments;
  declareWhat(app, arguments);
  declareWhere(app, arguments);
  declareHow(app, arguments);
  return rocinante::cli::run(app, argc, argv, kExamples, [&] { return run(arguments); });
}
