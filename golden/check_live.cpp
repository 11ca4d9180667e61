#include "golden/check_live.h"

#include <poll.h>

#include <algorithm>
#include <chrono>

#include "core/check/check.h"
#include "core/cli/program.h"
#include "core/net/udp_socket.h"

namespace rocinante {
namespace {

LogTime logTimeOf(WallTime time) { return LogTime(time.time_since_epoch()); }

}  // namespace

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
  report.interrupted = cli::stopRequested();
  conclude(report);
  return report;
}

}  // namespace rocinante
