#include "golden/check/check_live.h"

#include <poll.h>

#include <algorithm>
#include <chrono>

#include "core/check/check.h"
#include "core/check/session_check.h"
#include "core/cli/program.h"
#include "core/pcap/open_source.h"

namespace rocinante {
namespace {

LogTime logTimeOf(WallTime time) { return LogTime(time.time_since_epoch()); }

}  // namespace

Result<CheckReport> checkLive(const Cell& cell, const std::string& where, Nanoseconds duration) {
  const Result<Endpoint> endpoint = Endpoint::parse(where);
  if (!endpoint) return endpoint.error();
  const auto source = openSource(*endpoint);
  if (!source) return source.error();
  DatagramSource& input = **source;
  const bool is_file = !endpoint->file.empty();
  cli::catchStopSignals();
  // Shows the bound port: ":0" takes a free one.
  const std::string bound = boundText(input);
  cli::warn((is_file ? "reading " : "listening on ") + bound);
  SessionCheck session(cell);
  std::optional<LogTime> first, last;
  const auto deadline = std::chrono::steady_clock::now() + duration;
  while (!cli::stopRequested() && !input.ended()) {
    const auto left =
        std::chrono::ceil<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
    // A capture file is always read to its end.
    if (left.count() <= 0 && !is_file) break;
    if (const auto said = input.maintain()) cli::warn(*said);
    pollfd waiting{input.fileDescriptor(), POLLIN, 0};
    const auto wait = is_file ? 0 : std::min<std::int64_t>(left.count(), 100);
    ::poll(&waiting, 1, static_cast<int>(wait));
    while (true) {
      const auto datagrams = input.receive();
      if (!datagrams) return datagrams.error();
      if (datagrams->empty()) break;
      for (const ReceivedDatagram& datagram : *datagrams) {
        // The kernel's clock may be set back, but session time must not decrease.
        last = std::max(last.value_or(LogTime{}), logTimeOf(datagram.kernel_time));
        if (!first) first = last;
        session.add(*last, encodingOf(datagram.payload), true, datagram.payload);
      }
      if (!is_file && std::chrono::steady_clock::now() >= deadline) break;
    }
  }
  if (const auto dropped = input.droppedByNow(); dropped && *dropped > 0) {
    LossSpan loss;
    loss.endpoint = bound;
    loss.from = first.value_or(LogTime{});
    loss.until = last.value_or(LogTime{});
    loss.counts.kernel = *dropped;
    session.addLoss(loss);
  }
  CheckReport report = checkSession(cell, session);
  report.session = bound;
  report.origin = first.value_or(LogTime{});
  report.duration = last.value_or(LogTime{}) - first.value_or(LogTime{});
  report.interrupted = cli::stopRequested();
  conclude(report);
  return report;
}

}  // namespace rocinante
