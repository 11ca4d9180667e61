#include <algorithm>

#include "core/base/duration_text.h"
#include "core/cli/opened_session.h"
#include "core/log/damage_text.h"
#include "recorder/diff/log_diff.h"
#include "recorder/diff/replay_diff.h"
#include "recorder/log/command_support.h"
#include "recorder/log/commands.h"

namespace rocinante {
namespace {

struct DiffOptions {
  std::string a;
  std::string b;
  std::string by = "all";
  bool replay = false;
  std::string speed = "1";
  std::vector<std::string> maps;
  std::string within;
  bool json = false;
};

DiffBy byOf(const std::string& text) {
  if (text == "payload") return DiffBy::payload;
  if (text == "time") return DiffBy::time;
  return text == "state" ? DiffBy::state : DiffBy::all;
}

Error nothingToCompare(const std::string& log) {
  return Error{ErrorKind::not_found, "neither log contains a message: nothing to compare", log};
}

/// Warns about damage in either log; true if there is any.
bool tellDamage(const LogReader& a, const LogReader& b) {
  for (const LogReader* reader : {&a, &b}) {
    for (const DamageSpan& span : reader->damage()) {
      cli::warn(damageText(span, reader->name()));
    }
  }
  return !a.damage().empty() || !b.damage().empty();
}

Result<ReplayOptions> readReplay(const DiffOptions& options) {
  ReplayOptions replay;
  const Result<PlaybackSpeed> speed = PlaybackSpeed::parse(options.speed);
  if (!speed) return speed.error();
  replay.speed = *speed;
  for (const std::string& text : options.maps) {
    Result<RouteMap> map = RouteMap::parse(text);
    if (!map) return map.error();
    replay.maps.push_back(std::move(*map));
  }
  if (options.within.empty()) return replay;
  const Result<Nanoseconds> within = parseDuration(options.within);
  if (!within) return within.error();
  if (*within < Nanoseconds(0)) {
    return Error{ErrorKind::bad_argument, "--within cannot be negative", options.within};
  }
  replay.within = *within;
  return replay;
}

Result<cli::Exit> runReplayDiff(const DiffOptions& options) {
  const Result<ReplayOptions> replay = readReplay(options);
  if (!replay) return replay.error();
  Result<LogReader> a = LogReader::open(options.a);
  if (!a) return a.error();
  Result<LogReader> b = LogReader::open(options.b);
  if (!b) return b.error();
  for (const RouteMap& map : replay->maps) {
    const bool used = std::ranges::any_of(a->channels(), [&](const LogChannel& channel) {
      return channel.captured() && map.matches(channel.topic);
    });
    if (used) continue;
    return Error{ErrorKind::bad_argument, "no channel of the log that was played matches the map",
                 map.pattern};
  }
  ProgressLine progress("comparing");
  const Result<ReplayDiff> diff =
      diffReplay(*a, *b, *replay, [&](double part) { progress.show(part); });
  if (!diff) return diff.error();
  if (diff->messages_a == 0 && diff->messages_b == 0) return nothingToCompare(options.a);
  const std::string text = options.json ? replayJson(*diff) : replayText(*diff);
  if (Status written = toStandardOutput(text); !written) return written.error();
  const bool damaged = tellDamage(*a, *b);
  return diff->same() && !damaged ? cli::Exit::done : cli::Exit::no;
}

Result<cli::Exit> runDiff(DiffOptions options) {
  const auto opened_a = cli::openSession(options.a);
  if (!opened_a) return opened_a.error();
  const auto opened_b = cli::openSession(options.b);
  if (!opened_b) return opened_b.error();
  options.a = opened_a->log.string();
  options.b = opened_b->log.string();
  if (options.replay) return runReplayDiff(options);
  Result<LogReader> a = LogReader::open(options.a);
  if (!a) return a.error();
  Result<LogReader> b = LogReader::open(options.b);
  if (!b) return b.error();
  ProgressLine progress("comparing");
  const Result<LogDiff> diff =
      diffLogs(*a, *b, byOf(options.by), [&](double part) { progress.show(part); });
  if (!diff) return diff.error();
  if (diff->messages_a == 0 && diff->messages_b == 0) {
    return nothingToCompare(options.a);
  }
  const std::string text = options.json ? diffJson(*diff) : diffText(*diff);
  if (Status written = toStandardOutput(text); !written) return written.error();
  const bool damaged = tellDamage(*a, *b);
  return diff->same() && !damaged ? cli::Exit::done : cli::Exit::no;
}

}  // namespace

cli::Subcommand addDiffCommand(cli::CommandLine program) {
  auto options = std::make_shared<DiffOptions>();
  const cli::CommandLine app =
      program.addSubcommand("diff", "compare two logs: messages, their times, their states");
  app.addOption("A", options->a, "a log").required();
  app.addOption("B", options->b, "another log").required();
  const cli::Option by = app.addOption("--by", options->by, "what to compare")
                             .oneOf({"payload", "time", "state", "all"})
                             .showDefault();
  const cli::Option replay = app.addFlag(
      "--replay", options->replay, "B recorded A as it was played, to other ports, at any speed");
  replay.excludes(by);
  app.addOption("--speed", options->speed, "the --speed that A was played with")
      .needs(replay)
      .valueName("X")
      .showDefault();
  app.addOption("--map", options->maps, "the --map that A was played with (PATTERN=EP); repeatable")
      .needs(replay)
      .oneEach()
      .valueName("PATTERN=EP");
  app.addOption("--within", options->within,
                "report a difference when a message is further off than this")
      .needs(replay)
      .valueName("TIME");
  app.addFlag("--json", options->json, "print JSON");
  return {app, [options] { return runDiff(*options); }};
}

}  // namespace rocinante
