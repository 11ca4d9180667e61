#include <unistd.h>

#include <charconv>

#include "core/base/atomic_file.h"
#include "core/base/duration_text.h"
#include "core/base/plain_text.h"
#include "core/cli/import_progress.h"
#include "core/cli/no_wait.h"
#include "core/cli/program.h"
#include "core/foreign/recordings/opened_recording.h"
#include "core/report/account.h"
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

void declareWhat(cli::CommandLine app, Arguments& my) {
  app.addOption("LOG", my.options.logs, "logs to play, on one time line")
      .required()
      .valueText("...");
  app.addOption("--from", my.options.from, "begin at this session time (12.5s, -1s, RFC 3339)")
      .valueText("TIME");
  app.addOption("--until", my.options.until, "end before this session time").valueText("TIME");
  app.addOption("--loop", my.loop, "play N times (0: until stopped), or repeat the part A-B")
      .valueText("N|A-B=1");
  app.addOption("--channel", my.options.channels.only, "only topics that match; repeatable")
      .oneEach()
      .valueText("PATTERN");
  app.addOption("--mute", my.options.channels.muted, "not the topics that match; repeatable")
      .oneEach()
      .valueText("PATTERN");
}

void declareWhere(cli::CommandLine app, Arguments& my) {
  app.addOption("--to", my.to, "where to send: udp://HOST:PORT, HOST:PORT or a multicast group")
      .valueText("EP");
  cli::addNoWait(app, my.no_wait);
  app.addOption("--map", my.maps, "send topics that match elsewhere; repeatable")
      .oneEach()
      .valueText("PATTERN=EP");
  app.addFlag("--keep-ports", my.options.keep_ports, "send from the ports of the original senders");
}

void declareHow(cli::CommandLine app, Arguments& my) {
  const cli::Option speed =
      app.addOption("--speed", my.speed, "log seconds per second, 0.01 to 1000").valueText("X=1");
  const cli::Option at_once = app.addFlag("--asap", my.options.at_once,
                                          "as fast as the network takes them, without a schedule")
                                  .excludes(speed)
                                  .valueText(" ");
  const cli::Option lockstep =
      app.addFlag("--lockstep", my.options.lockstep,
                  "after each, send `step N` to the controller and wait for `ack N`")
          .excludes(speed)
          .excludes(at_once)
          .valueText(" ");
  app.addOption("--ack-timeout", my.ack_timeout, "how long to wait for an ack, then exit 1")
      .needs(lockstep)
      .valueText("TIME=1s");
  app.addOption("--gap-limit", my.gap_limit, "shorten silences to at most this").valueText("TIME");
  app.addOption("--restate", my.restate,
                "restate every source's state first, then this often; 0: only first; off")
      .valueText("TIME=2s");
  app.addOption("--key", my.options.key,
                "sign the player's own restatements with this secret key (rocinante key)")
      .valueText("FILE");
  app.addOption("--realtime", my.realtime, "run before other threads: auto, on or off")
      .oneOf({"auto", "on", "off"})
      .valueText("WHEN=auto");
  const cli::Option control =
      app.addOption("--control", my.control,
                    "listen for commands on udp://127.0.0.1:PORT or unix:PATH")
          .valueText("EP");
  app.addOption("--control-allow", my.control_allow,
                "accept commands from this network too; repeatable")
      .needs(control)
      .oneEach()
      .valueText("CIDR");
  app.addFlag("--start-paused", my.options.start_paused, "wait for a command to play");
  lockstep.needs(control);
  app.addOption("--report", my.report, "write what was sent, and how late, as JSON; -: to stdout")
      .valueText("FILE");
  app.addFlag("--force", my.force, "replace the report file");
  app.addFlag("--json", my.json, "the same as --report -");
  app.addFlag("--quiet", my.quiet, "print nothing but errors (and --json)");
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

Status readTimes(Arguments& my) {
  const bool is_number = my.loop.find_first_not_of("0123456789") == my.loop.npos;
  if (is_number) {
    const char* end = my.loop.data() + my.loop.size();
    const auto [stop, fault] = std::from_chars(my.loop.data(), end, my.options.turns);
    if (fault != std::errc() || stop != end) {
      return Error{ErrorKind::bad_argument, "--loop takes up to 4294967295 turns", my.loop};
    }
  } else {
    // The range is checked after the log is opened.
    if (my.loop.find('-', 1) == my.loop.npos) return parseLoop(my.loop, {}, {}).error();
    my.options.loop = my.loop;
  }
  my.options.restate = my.restate != "off" && my.restate != "false";
  if (my.options.restate && my.restate != "true") {
    const auto repeat = durationOf("--restate", my.restate, Nanoseconds(0));
    if (!repeat) return repeat.error();
    my.options.repeat = *repeat;
    if (repeat->count() > 0 && *repeat < std::chrono::milliseconds(10)) {
      return Error{ErrorKind::bad_argument, "--restate is 0 or at least 10ms", my.restate};
    }
  }
  if (!my.gap_limit.empty()) {
    const auto limit = durationOf("--gap-limit", my.gap_limit, std::chrono::milliseconds(1));
    if (!limit) return limit.error();
    my.options.gap_limit = *limit;
  }
  const auto timeout = durationOf("--ack-timeout", my.ack_timeout, std::chrono::milliseconds(1));
  if (!timeout) return timeout.error();
  my.options.ack_timeout = *timeout;
  return {};
}

Status read(Arguments& my) {
  if (!my.to.empty()) {
    const auto to = Endpoint::parse(my.to);
    if (!to) return to.error();
    my.options.to = *to;
    my.options.to.nats.waits = !my.no_wait;
  }
  for (const std::string& text : my.maps) {
    const auto map = RouteMap::parse(text);
    if (!map) return map.error();
    my.options.maps.push_back(*map);
    my.options.maps.back().to.nats.waits = !my.no_wait;
  }
  const auto speed = PlaybackSpeed::parse(my.speed);
  if (!speed) return speed.error();
  my.options.speed = *speed;
  my.options.realtime = realtimeOf(my.realtime);
  return readTimes(my);
}

using Inputs = std::vector<std::unique_ptr<ControlInput>>;

Status openControl(Arguments& my, Inputs& inputs) {
  if (!my.control.empty()) {
    const auto address = ControlAddress::parse(my.control);
    if (!address) return address.error();
    Result<AddressFilter> allowed = AddressFilter::of(my.control_allow);
    if (!allowed) return allowed.error();
    auto control = ControlSocket::open(
        *address, std::move(*allowed),
        my.quiet ? std::function<void(std::string)>()
                 : [](const std::string& sentence) { cli::warn(sentence); });
    if (!control) return control.error();
    inputs.push_back(std::move(control->input));
    // In lockstep the player ends with the log.
    my.options.stays = !my.options.lockstep;
    if (!my.quiet) cli::tell("listening for commands on " + control->where + "\n");
  }
  if (my.options.progress) {
    if (auto keys = TerminalKeys::open()) inputs.push_back(std::move(keys));
  }
  if (my.options.start_paused && inputs.empty()) {
    return Error{ErrorKind::bad_argument, "a paused start needs a terminal or --control to resume",
                 "--start-paused"};
  }
  return {};
}

Result<PlayReport> playWithControl(Arguments& my) {
  cli::catchStopSignals();
  watchResumes();
  const auto slot = CommandSlot::make();
  if (!slot) return slot.error();
  Inputs inputs;
  if (const Status opened = openControl(my, inputs); !opened) return opened.error();
  PlayControl control;
  if (!inputs.empty()) control = {slot->get(), (*slot)->wake()};
  // Opening a log or folding a state does not check for a stop.
  const cli::StopDeadline deadline("stopped while reading the log; no report was made",
                                   giveTerminalBack);
  const ControlThread thread(**slot, std::move(inputs));
  // What other programs recorded becomes a log first.
  std::vector<OpenedRecording> opened;
  PlayOptions options = my.options;
  for (std::filesystem::path& log : options.logs) {
    RecordingRequest request;
    request.recording = log;
    request.progress = cli::importProgress(log.string());
    Result<OpenedRecording> found = openedRecording(request);
    if (!found) return found.error();
    for (const std::string& warning : found->warnings) cli::warn(warning);
    if (!found->not_kept.empty()) cli::warn(found->not_kept);
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
  surroundings.told = [&](std::string_view line) {
    if (!my.quiet) cli::tell(plainText(asNamed(std::string(line))) + "\n");
  };
  Result<PlayReport> report = play(options, surroundings, control);
  if (report) {
    report->inputs.clear();
    for (const auto& log : my.options.logs) report->inputs.push_back(log.string());
    return report;
  }
  Error error = report.error();
  for (const OpenedRecording& each : opened) error = each.named(std::move(error));
  return error;
}

Result<cli::Exit> run(Arguments& my) {
  if (const Status understood = read(my); !understood) return understood.error();
  const bool to_stdout = my.json || my.report == "-";
  const bool to_file = !my.report.empty() && my.report != "-";
  // Check before playing, not after an hour.
  if (to_file) {
    if (const Status may = mayWriteFile(my.report, my.force); !may) return may.error();
  }
  my.options.progress = !my.quiet && ::isatty(STDERR_FILENO) == 1;
  const Result<PlayReport> report = playWithControl(my);
  if (!report) return report.error();

  for (const std::string& damage : report->damage) cli::warn(damage);
  if (!report->keptUp() && !my.quiet) cli::warn(behindText(*report));
  bool is_kept = true;
  if (to_file) {
    const Status written = writeFileWhole(my.report, bytesOf(jsonText(*report)), my.force);
    if (!written) cli::warn(written.error().text());
    is_kept = written.ok();
  }
  if (to_stdout) cli::say(jsonText(*report));
  if (!to_stdout && !my.quiet) cli::say(summaryText(*report));
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
