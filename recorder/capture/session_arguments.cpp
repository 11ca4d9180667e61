#include "recorder/capture/session_arguments.h"

#include "core/base/duration_text.h"
#include "core/base/figure_text.h"

namespace rocinante {
namespace {

/// As for `log split`: a smaller piece is hardly more than its beginning and end.
constexpr std::uint64_t kLeastPieceBytes = 4'096;
constexpr std::uint64_t kLeastQuotaBytes = 64 << 10U;

Error badArgument(const char* what) { return Error{ErrorKind::bad_argument, what, {}}; }

Result<std::uint64_t> readSize(const std::string& text, const char* option, std::uint64_t least) {
  Result<std::uint64_t> size = parseSize(text);
  if (size && *size < least) {
    return Error{ErrorKind::bad_argument,
                 std::string(option) + " is at least " + std::to_string(least) + " bytes", text};
  }
  return size;
}

Result<std::vector<Condition>> readConditions(const std::vector<std::string>& texts) {
  std::vector<Condition> conditions;
  for (const std::string& text : texts) {
    Result<Condition> condition = Condition::parse(text);
    if (!condition) return condition.error();
    conditions.push_back(std::move(*condition));
  }
  return conditions;
}

Status readSplit(const SessionArguments& arguments, RecordOptions& options) {
  if (!arguments.split_size.empty()) {
    const auto size = readSize(arguments.split_size, "--split-size", kLeastPieceBytes);
    if (!size) return size.error();
    options.split.size_bytes = *size;
  }
  if (!arguments.split_time.empty()) {
    const auto time = readSpan(arguments.split_time, "--split-time");
    if (!time) return time.error();
    options.split.time = *time;
  }
  if (arguments.keep == 0U) return badArgument("--keep must be at least 1");
  options.limits.keep = arguments.keep;
  if (!arguments.disk_quota.empty()) {
    const auto quota = readSize(arguments.disk_quota, "--disk-quota", kLeastQuotaBytes);
    if (!quota) return quota.error();
    if (options.split.size_bytes > *quota) {
      return badArgument("--split-size must not exceed --disk-quota");
    }
    options.limits.disk_quota_bytes = *quota;
  }
  options.attach_once = arguments.attach_once;
  const bool deletes = options.limits.keep || options.limits.disk_quota_bytes;
  if (options.attach_once && deletes) {
    return badArgument(
        "--keep and --disk-quota would delete the piece that --attach-once gave the "
        "cell to");
  }
  return {};
}

Status readRing(const SessionArguments& arguments, RecordOptions& options) {
  if (arguments.ring.empty()) {
    const bool lonely =
        !arguments.ring_after.empty() || !arguments.ring_size.empty() || !arguments.ring_on.empty();
    if (!arguments.watch.empty()) return badArgument("--watch needs --ring");
    return lonely ? Status(badArgument("--ring-on, --ring-after and --ring-size need --ring"))
                  : Status();
  }
  RingRule ring;
  const auto span = readSpan(arguments.ring, "--ring");
  if (!span) return span.error();
  ring.span = *span;
  if (!arguments.ring_after.empty()) {
    const auto after = readSpan(arguments.ring_after, "--ring-after");
    if (!after) return after.error();
    ring.after = *after;
  }
  if (!arguments.ring_size.empty()) {
    const auto size = readSize(arguments.ring_size, "--ring-size", 4 * RingBuffer::kBlockBytes);
    if (!size) return size.error();
    ring.max_bytes = *size;
  }
  if (options.split.size_bytes > 0 || options.split.time > Nanoseconds(0)) {
    return badArgument("--ring writes whole files: leave out --split-size and --split-time");
  }
  auto triggers = readConditions(arguments.ring_on);
  if (!triggers) return triggers.error();
  options.ring_on = std::move(*triggers);
  for (const Severity each : {Severity::note, Severity::warning, Severity::error}) {
    if (arguments.watch_severity == nameOf(each)) options.watch_severity = each;
  }
  options.ring = ring;
  return {};
}

}  // namespace

Result<Nanoseconds> readSpan(const std::string& text, const char* option) {
  const Result<Nanoseconds> duration = parseDuration(text);
  if (!duration) return duration.error();
  if (*duration <= Nanoseconds(0)) {
    return Error{ErrorKind::bad_argument, std::string(option) + " must be greater than zero", text};
  }
  return *duration;
}

void addSessionArguments(cli::CommandLine app, SessionArguments& arguments) {
  const auto add = [&](const char* name, auto& value, const char* type, const char* help) {
    return app.addOption(name, value, help).valueName(type).oneEach();
  };
  add("--start-on", arguments.start_on, "COND",
      "start with the first datagram that matches event=TEXT, source=NAME\nor device=NAME "
      "(patterns)");
  add("--stop-on", arguments.stop_on, "COND",
      "end with the first datagram that matches, or after silence=TIME");
  add("--split-size", arguments.split_size, "SIZE", "a new piece about every SIZE (1GB, 512MiB)");
  add("--split-time", arguments.split_time, "TIME", "a new piece every TIME");
  add("--keep", arguments.keep, "N", "keep only the newest N pieces");
  add("--disk-quota", arguments.disk_quota, "SIZE",
      "delete the oldest pieces when all take more than SIZE");
  app.addFlag("--attach-once", arguments.attach_once, "attach the cell to the first piece only");
  add("--ring", arguments.ring, "TIME",
      "hold the last TIME in memory; write it to a file of its own\nonly on SIGUSR1 or --ring-on");
  add("--ring-on", arguments.ring_on, "COND", "write the ring when this matches, too");
  const cli::Option watch =
      add("--watch", arguments.watch, "CELL",
          "judge with this cell (rocinante check), and write the ring when a finding\n"
          "begins, too");
  add("--watch-severity", arguments.watch_severity, "SEVERITY",
      "least severe finding that writes the ring: note, warning or error")
      .needs(watch)
      .oneOf({"note", "warning", "error"})
      .showDefault();
  add("--ring-after", arguments.ring_after, "TIME",
      "continue the ring's file for TIME after the trigger");
  add("--ring-size", arguments.ring_size, "SIZE",
      "most memory that the ring takes; default 256MiB");
}

Status readSessionArguments(const SessionArguments& arguments, RecordOptions& options) {
  if (Status split = readSplit(arguments, options); !split) return split;
  if (Status ring = readRing(arguments, options); !ring) return ring;
  auto start = readConditions(arguments.start_on);
  if (!start) return start.error();
  options.start_on = std::move(*start);
  for (const Condition& each : options.start_on) {
    if (each.kind == Condition::Kind::silence) {
      return badArgument(
          "a recording cannot begin with a silence: --start-on takes event=, "
          "source= and device=");
    }
  }
  auto stop = readConditions(arguments.stop_on);
  if (!stop) return stop.error();
  options.stop_on = std::move(*stop);
  return {};
}

}  // namespace rocinante
