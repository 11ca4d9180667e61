#include "golden/check/check_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <utility>

#include "core/base/duration_text.h"
#include "core/base/figure_text.h"
#include "core/check/reports/report_formats.h"
#include "core/check/watch/finding_watch.h"
#include "core/cli/service_notice.h"
#include "core/cli/status_line.h"
#include "core/report/json_text.h"
#include "golden/check/finding_command.h"
#include "golden/check/live_input.h"

namespace rocinante {
namespace {

constexpr Nanoseconds kStatusPeriod = std::chrono::milliseconds(500);
constexpr std::int64_t kWaitMs = 100;
constexpr int kLastCommandsMs = 500;

/// Judges, prints and runs commands.
class Watcher {
 public:
  Watcher(const Cell& cell, const CheckWatchOptions& options, std::optional<FindingCommand> command)
      : options_(options),
        watch_(cell, options),
        command_(std::move(command)),
        line_(!options.quiet) {}

  void take(LogTime time, const LiveDatagram& datagram) {
    // Time passes with datagrams, too: a file has no other.
    reach(time);
    if (!isOver()) judge(watch_, time, datagram);
  }

  void reach(LogTime now) {
    if (isOver()) return;
    if (!began_) began_ = now;
    reached_ = now;
    tellAll(watch_.reach(now));
  }
  /// --until-finding, and one began.
  bool isOver() const { return options_.until_finding && watch_.failed(); }

  void addLoss(const LossSpan& loss) { watch_.addLoss(loss); }
  Nanoseconds watched() const { return reached_ ? *reached_ - *began_ : Nanoseconds(0); }
  void tendCommands() {
    if (command_) command_->tend();
  }

  /// "1h02m03s, 12,345 packets; lasting: 1 error, 2 warnings"
  std::string status() const {
    return fmt::format("{}, {}; lasting: {}", secondsShown(), countText(watch_.packets(), "packet"),
                       lastingText());
  }

  void showStatus(SteadyTime now) {
    if (!line_.isVisible() || (shown_ && now - *shown_ < kStatusPeriod)) return;
    shown_ = now;
    line_.show("watching " + status());
  }

  cli::Exit finish() {
    if (reached_ && !isOver()) tellAll(watch_.update(*reached_));
    if (command_) {
      command_->finish(kLastCommandsMs);
      if (command_->failed() > 1) {
        cli::warn(fmt::format("--on-finding: {} failed", countText(command_->failed(), "command")));
      }
      if (command_->dropped() > 0) {
        cli::warn(fmt::format("--on-finding: {} not run, too many at a time",
                              countText(command_->dropped(), "command")));
      }
    }
    if (watch_.isFull()) {
      cli::warn(fmt::format("more than {} findings at a time: not all were reported",
                            FindingWatch::kMax));
    }
    line_.clear();
    const CheckVerdict verdict = watch_.failed()         ? CheckVerdict::incompatible
                                 : watch_.packets() == 0 ? CheckVerdict::nothing_judged
                                                         : CheckVerdict::compatible;
    printSummary(verdict);
    if (watch_.failed()) return cli::Exit::no;
    return watch_.packets() == 0 ? cli::Exit::could_not_run : cli::Exit::done;
  }

 private:
  void tellAll(const std::vector<FindingChange>& changes) {
    for (const FindingChange& change : changes) tell(change);
  }

  void tell(const FindingChange& change) {
    const std::string json = findingChangeJson(change);
    if (command_) command_->add(json);
    if (options_.quiet && !options_.json) return;
    line_.clear();
    cli::say(options_.json ? json : findingChangeText(change) + "\n");
    // A reader of the pipe sees it now.
    std::fflush(stdout);
  }

  std::string secondsShown() const {
    using namespace std::chrono;
    const auto whole = floor<seconds>(watched());
    const auto minutes_part = floor<minutes>(whole);
    if (whole < minutes(1)) return fmt::format("{} s", whole.count());
    const auto hours_part = floor<hours>(whole);
    if (hours_part.count() == 0) {
      return fmt::format("{}m{:02}s", minutes_part.count(), (whole - minutes_part).count());
    }
    return fmt::format("{}h{:02}m{:02}s", hours_part.count(), (minutes_part - hours_part).count(),
                       (whole - minutes_part).count());
  }

  std::string lastingText() const {
    std::string text;
    for (const Severity each : {Severity::error, Severity::warning, Severity::note}) {
      const std::size_t count = watch_.lasting(each);
      if (count > 0) text += (text.empty() ? "" : ", ") + countText(count, nameOf(each));
    }
    return text.empty() ? "nothing" : text;
  }

  void printSummary(CheckVerdict verdict) {
    if (!options_.json) {
      cli::say(fmt::format("watched {}; {} began\n{}\n", status(),
                           countText(watch_.begun(), "finding"), verdictText(verdict)));
      return;
    }
    Json json;
    json["format"] = 1;
    json["event"] = "summary";
    json["verdict"] = std::string(nameOf(verdict));
    json["duration_s"] = static_cast<double>(watched().count()) / 1e9;
    json["datagrams"] = watch_.datagrams();
    json["packets"] = watch_.packets();
    json["begun"] = watch_.begun();
    for (const Severity each : {Severity::error, Severity::warning, Severity::note}) {
      json["lasting"][std::string(nameOf(each))] = watch_.lasting(each);
    }
    cli::say(jsonText(json, -1));
  }

  const CheckWatchOptions& options_;
  FindingWatch watch_;
  std::optional<FindingCommand> command_;
  cli::StatusLine line_;
  std::optional<LogTime> began_, reached_;
  std::optional<SteadyTime> shown_;
};

void warnOfUntrusted(const LiveInput& input) {
  const auto untrusted = input.untrusted();
  if (!untrusted || untrusted->total() == 0) return;
  cli::warn(fmt::format("{} not trusted: {}", countText(untrusted->total(), "datagram"),
                        untrusted->text()));
}

void warnOfDecoded(const LiveInput& input) {
  const auto decoded = input.decoded();
  if (!decoded) return;
  cli::warn(
      fmt::format("decoded {} of {}:", decoded->decoded(), countText(decoded->octets, "datagram")));
  cli::tell(decode::accountText(*decoded));
}

}  // namespace

Result<cli::Exit> watchLive(const Cell& cell, const CheckWatchOptions& options) {
  std::optional<FindingCommand> command;
  if (!options.command.empty()) {
    Result<FindingCommand> parsed = FindingCommand::parse(options.command);
    if (!parsed) return parsed.error();
    command = std::move(*parsed);
  }
  Watcher watcher(cell, options, std::move(command));
  Result<LiveInput> input = LiveInput::open(
      options.endpoints, options.trust_file, options.decoders, LiveTime::steady,
      [&](LogTime time, const LiveDatagram& datagram) { watcher.take(time, datagram); });
  if (!input) return input.error();
  cli::catchStopSignals();
  cli::ServiceNotice notice = cli::ServiceNotice::fromEnvironment();
  cli::warn((input->isFile() ? "reading " : "watching ") + input->names());
  notice.ready();
  const SteadyTime start = std::chrono::steady_clock::now();
  std::optional<SteadyTime> noticed;
  while (!cli::stopRequested() && !input->ended() && !watcher.isOver()) {
    const SteadyTime now = std::chrono::steady_clock::now();
    if (options.duration && !input->isFile() && now - start >= *options.duration) break;
    if (Status passed = input->pass(input->isFile() ? 0 : kWaitMs); !passed) {
      return passed.error();
    }
    for (const LossSpan& loss : input->takeLosses()) watcher.addLoss(loss);
    if (const auto reached = input->now()) watcher.reach(*reached);
    watcher.tendCommands();
    watcher.showStatus(now);
    notice.alive(now);
    if (notice.isOpen() && (!noticed || now - *noticed >= std::chrono::seconds(2))) {
      noticed = now;
      notice.status(watcher.status());
    }
  }
  notice.stopping();
  if (const auto reached = input->now()) watcher.reach(*reached);
  input->warnOfSilence();
  warnOfUntrusted(*input);
  warnOfDecoded(*input);
  return watcher.finish();
}

}  // namespace rocinante
