#include <poll.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>

#include "core/bundle/attached_cell.h"
#include "core/check/check.h"
#include "core/check/report_formats.h"
#include "core/cli/program.h"
#include "core/duration_text.h"
#include "core/net/udp_socket.h"

namespace {

using namespace rocinante;

constexpr const char* kExamples =
    "  rocinante check cell.toml                         the model alone\n"
    "  rocinante check cell.toml session.mcap            does this session fit this model?\n"
    "  rocinante check session.mcap                      a log that carries its cell\n"
    "  rocinante check arm.urdf session.mcap --json      for a program\n"
    "  rocinante check cell.toml --live :19960 --duration 10s\n";

struct Arguments {
  std::string cell, log, live;
  std::string duration = "2s";
  std::string format = "text";
  bool json = false;
  std::vector<std::string> search;
  bool search_environment = false;
};

void declare(CLI::App& app, Arguments& my) {
  app.add_option("cell", my.cell,
                 "a *.cell.toml, .urdf or .obj file, or a log that carries its cell")
      ->required();
  auto* log = app.add_option("log", my.log, "a recorded session");
  auto* live = app.add_option("--live", my.live, "judge what arrives here: udp://HOST:PORT");
  live->excludes(log);
  app.add_option("--duration", my.duration, "how long to listen")
      ->needs(live)
      ->capture_default_str();
  auto* format = app.add_option("--format", my.format, "text or json")
                     ->check(CLI::IsMember({"text", "json"}))
                     ->capture_default_str();
  app.add_flag("--json", my.json, "the same as --format json")->excludes(format);
  app.add_option("--search", my.search,
                 "a root for package:// and relative names; may be repeated");
  app.add_flag("--search-env", my.search_environment,
               "search ROCINANTE_PATH, AMENT_PREFIX_PATH and ROS_PACKAGE_PATH too");
}

LogTime logTimeOf(WallTime time) { return LogTime(time.time_since_epoch()); }

/// Judges what arrives for a while, or until a stop signal.
Result<CheckReport> checkLive(const Cell& cell, const std::string& where, Nanoseconds duration) {
  const Result<Endpoint> endpoint = Endpoint::parse(where);
  if (!endpoint) return endpoint.error();
  Result<UdpReceiver> receiver = UdpReceiver::open(*endpoint);
  if (!receiver) return receiver.error();
  cli::catchStopSignals();
  // With the port that was bound: ":0" takes a free one.
  Endpoint bound = *endpoint;
  bound.address = receiver->boundAddress();
  cli::warn("listening on " + bound.text());
  SessionCheck session(cell);
  std::optional<LogTime> first, last;
  const auto deadline = std::chrono::steady_clock::now() + duration;
  while (!cli::stopRequested()) {
    const auto left =
        std::chrono::ceil<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
    if (left.count() <= 0) break;
    pollfd waiting{receiver->fileDescriptor(), POLLIN, 0};
    ::poll(&waiting, 1, static_cast<int>(std::min<std::int64_t>(left.count(), 100)));
    while (true) {
      const auto datagrams = receiver->receive();
      if (!datagrams) return datagrams.error();
      if (datagrams->empty()) break;
      for (const ReceivedDatagram& datagram : *datagrams) {
        // The kernel's clock may be set back; a session's time line never goes back.
        last = std::max(last.value_or(LogTime{}), logTimeOf(datagram.kernel_time));
        if (!first) first = last;
        session.add(*last, encodingOf(datagram.payload), true, datagram.payload);
      }
      if (std::chrono::steady_clock::now() >= deadline) break;
    }
  }
  if (const auto dropped = receiver->droppedByNow(); dropped && *dropped > 0) {
    LossSpan loss;
    loss.endpoint = bound.text();
    loss.from = first.value_or(LogTime{});
    loss.until = last.value_or(LogTime{});
    loss.counts.kernel = *dropped;
    session.addLoss(loss);
  }
  CheckReport report = checkSession(cell, session);
  report.session = bound.text();
  report.origin = first.value_or(LogTime{});
  report.duration = last.value_or(LogTime{}) - first.value_or(LogTime{});
  return report;
}

Result<CheckReport> judge(const Arguments& my) {
  CellOptions options;
  options.search.assign(my.search.begin(), my.search.end());
  options.search_environment = my.search_environment;
  Result<Cell> cell = loadCellOrLog(my.cell, options);
  if (!cell) return cell.error();
  // Nothing is read from files any more, and a signal ends this program at once.
  cell->keeps_files.reset();
  if (!my.live.empty()) {
    const Result<Nanoseconds> duration = parseDuration(my.duration);
    if (!duration) return duration.error();
    if (duration->count() <= 0) {
      return Error{ErrorKind::bad_argument, "must be longer than nothing", "--duration"};
    }
    return checkLive(*cell, my.live, *duration);
  }
  if (my.log.empty()) return checkCell(*cell);
  Result<LogReader> log = LogReader::open(my.log);
  if (!log) return log.error();
  return checkLog(*cell, *log);
}

cli::Exit exitOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::compatible:
      return cli::Exit::done;
    case Verdict::incompatible:
      return cli::Exit::no;
    case Verdict::nothing_judged:
    case Verdict::interrupted:
      break;
  }
  return cli::Exit::could_not_run;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Says whether a session fits a model: devices, joints, limits, losses.",
               "rocinante-check");
  Arguments my;
  declare(app, my);
  return cli::run(app, argc, argv, kExamples, [&]() -> Result<cli::Exit> {
    // A log that carries its cell is judged alone.
    if (my.log.empty() && my.live.empty() && isLog(my.cell)) my.log = my.cell;
    Result<CheckReport> report = judge(my);
    if (!report) return report.error();
    if (!my.log.empty()) report->session = my.log;
    const bool json = my.json || my.format == "json";
    const std::string text = json ? checkJson(*report) : checkText(*report);
    std::fputs(text.c_str(), stdout);
    return exitOf(report->verdict);
  });
}
