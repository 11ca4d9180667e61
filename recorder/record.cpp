#include "recorder/record.h"

#include <fmt/format.h>
#include <pthread.h>
#include <signal.h>
#include <sys/random.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <thread>
#include <utility>

#include "core/hash.h"
#include "recorder/receive_loop.h"

namespace rocinante {
namespace {

using std::chrono::milliseconds;

// Every endpoint takes a receive buffer; MCAP's channels are bounded too.
constexpr std::size_t kMaxEndpoints = 256;
// A loss of one endpoint as it stands in the log, its index with it.
constexpr std::uint64_t kLossBytes = 512;
// Drained and slept: half the cost of waking up for each datagram, and 600,000 a second.
constexpr Nanoseconds kReceiveSleep = std::chrono::microseconds(500);
constexpr Nanoseconds kIdleSleep = milliseconds(2);
constexpr int kIdlePasses = 200;
constexpr Nanoseconds kWriteWait = milliseconds(10);
constexpr Nanoseconds kControlSleep = milliseconds(10);
constexpr Nanoseconds kProgressPeriod = milliseconds(250);
constexpr const char* kRefused = "refused";
constexpr Nanoseconds kNarrowLook = std::chrono::microseconds(2);

SteadyTime steadyNow() { return std::chrono::steady_clock::now(); }

/// The narrowest of a few looks: one that was interrupted tells the offset badly.
ClockReading lookAtClocks() {
  ClockReading best{};
  for (int attempt = 0; attempt < 4; ++attempt) {
    ClockReading reading;
    reading.before = steadyNow();
    reading.wall = std::chrono::time_point_cast<Nanoseconds>(std::chrono::system_clock::now());
    reading.after = steadyNow();
    const bool narrower = reading.after - reading.before < best.after - best.before;
    if (attempt == 0 || narrower) best = reading;
    if (best.after - best.before <= kNarrowLook) break;
  }
  return best;
}

std::string newSessionId() {
  std::array<std::byte, 16> bytes{};
  // 16 bytes come whole or not at all, and only an early boot makes it wait.
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    const auto now = steadyNow().time_since_epoch().count();
    std::memcpy(bytes.data(), &now, sizeof now);
  }
  return hexOf(bytes);
}

/// A thread that leaves signals to the caller's.
template <class Body>
std::thread quietThread(const char* name, Body body) {
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &before);
  std::thread thread(std::move(body));
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  ::pthread_setname_np(thread.native_handle(), name);
  return thread;
}

/// What the threads tell each other beside the datagrams.
struct Shared {
  std::atomic<bool> stop{false};
  std::atomic<bool> receiver_failed{false};
  std::atomic<bool> writer_over{false};
  std::atomic<std::uint64_t> packets{0};
  std::atomic<std::uint64_t> lost{0};
  std::atomic<std::uint64_t> log_bytes{0};
};

Status receiveUntilStopped(ReceiveLoop& loop, Shared& shared) {
  Status ended;
  int idle = 0;
  while (!shared.stop.load(std::memory_order_relaxed)) {
    const Result<bool> busy = loop.pass();
    if (!busy) {
      ended = busy.error();
      shared.receiver_failed.store(true);
      break;
    }
    idle = *busy ? 0 : std::min(idle + 1, kIdlePasses);
    std::this_thread::sleep_for(idle == kIdlePasses ? kIdleSleep : kReceiveSleep);
  }
  Status finished = loop.finish();
  return ended ? finished : ended;
}

void writeUntilFinished(CaptureWriter& writer, HandOver& queue, Shared& shared) {
  for (bool finished = false; !finished;) {
    TakenOver taken = queue.take(kWriteWait);
    finished = taken.finished;
    writer.write(std::move(taken), queue);
    writer.flush(steadyNow());
    shared.packets.store(writer.packets(), std::memory_order_relaxed);
    shared.lost.store(writer.lost(), std::memory_order_relaxed);
    shared.log_bytes.store(writer.logBytes(), std::memory_order_relaxed);
    shared.writer_over.store(writer.over(), std::memory_order_relaxed);
  }
}

/// Waits for a reason to end, and says which.
std::string waitForEnd(const RecordOptions& options, const RecordEvents& events, SteadyTime start,
                       Shared& shared) {
  SteadyTime told = start;
  for (;;) {
    const SteadyTime now = steadyNow();
    if (events.stop_requested()) return "interrupted";
    if (shared.receiver_failed.load()) return "socket";
    if (shared.writer_over.load(std::memory_order_relaxed)) return "limit";
    if (options.duration && now - start >= *options.duration) return "duration";
    if (now - told >= kProgressPeriod) {
      told = now;
      events.progress({now - start, shared.packets.load(std::memory_order_relaxed),
                       shared.lost.load(std::memory_order_relaxed),
                       shared.log_bytes.load(std::memory_order_relaxed)});
    }
    std::this_thread::sleep_for(kControlSleep);
  }
}

RecordSummary summaryOf(const CaptureWriter& writer, const RecordOptions& options,
                        const Status& received) {
  RecordSummary summary;
  summary.log = options.log;
  summary.endpoints = writer.accounts();
  for (const EndpointAccount& each : summary.endpoints) {
    summary.packets += each.recorded;
    summary.losses += each.losses;
  }
  summary.restated = writer.restated();
  summary.payload_bytes = writer.payloadBytes();
  summary.log_bytes = writer.logBytes();
  summary.channels = writer.channelCount();
  summary.late = writer.late();
  if (writer.trouble()) {
    summary.trouble = writer.trouble();
  } else if (!received) {
    summary.trouble = received.error();
  }
  return summary;
}

/// A log that did not get its cell is none: nothing of it stays.
Status attachCell(const RecordOptions& options, LogWriter& log) {
  if (!options.cell) return {};
  const LogTime now(lookAtClocks().wall.time_since_epoch());
  Status attached = AttachedBundle(*options.cell).writeTo(log, now);
  std::error_code ignored;
  if (!attached && std::filesystem::is_regular_file(options.log, ignored)) {
    std::filesystem::remove(options.log, ignored);
  }
  return attached;
}

}  // namespace

RecordSummary recordFrom(const std::vector<DatagramSource*>& sources, LogWriter log,
                         const RecordOptions& options, const RecordEvents& events) {
  std::vector<ListenedEndpoint> listened;
  std::vector<std::string> names;
  for (const DatagramSource* source : sources) {
    listened.push_back({source->endpoint(), source->boundAddress()});
    names.push_back(boundText(*source));
  }
  Shared shared;
  HandOver queue(options.queue_blocks);
  ReceiveLoop loop(sources, lookAtClocks, queue);
  const SteadyTime start = steadyNow();
  CaptureLimits limits{std::nullopt, options.max_packets};
  if (options.duration) limits.until = loop.clock().now() + *options.duration;
  CaptureWriter writer(std::move(log), std::move(listened), limits);

  Status received;
  std::thread receiving =
      quietThread("receive", [&] { received = receiveUntilStopped(loop, shared); });
  std::thread writing = quietThread("write", [&] { writeUntilFinished(writer, queue, shared); });
  events.ready(names);
  std::string reason = waitForEnd(options, events, start, shared);
  const Nanoseconds duration = steadyNow() - start;
  shared.stop.store(true);
  receiving.join();
  writing.join();
  if (reason == "limit") reason = writer.packets() == options.max_packets ? "packets" : "duration";
  if (!received) reason = kRefused;
  writer.close(reason, steadyNow(), queue);

  RecordSummary summary = summaryOf(writer, options, received);
  summary.duration = options.duration ? std::min(duration, *options.duration) : duration;
  summary.reason = summary.trouble ? kRefused : reason;
  return summary;
}

Result<RecordSummary> record(const RecordOptions& options, const RecordEvents& events) {
  if (options.endpoints.empty() || options.endpoints.size() > kMaxEndpoints) {
    return Error{ErrorKind::bad_argument,
                 fmt::format("1 to {} endpoints can be recorded", kMaxEndpoints), ""};
  }
  // Sockets first: a port that is taken must not leave an empty log behind.
  std::vector<UdpReceiver> receivers;
  for (const Endpoint& endpoint : options.endpoints) {
    Result<UdpReceiver> receiver = UdpReceiver::open(endpoint, options.receiving);
    if (!receiver) return receiver.error();
    receivers.push_back(std::move(*receiver));
  }
  LogWriterOptions writing = options.writing;
  writing.closing_room_bytes += kLossBytes * options.endpoints.size();
  Result<LogWriter> log = LogWriter::create(options.log, writing, newSessionId());
  if (!log) return log.error();
  if (Status attached = attachCell(options, *log); !attached) return attached.error();
  std::vector<DatagramSource*> sources;
  for (UdpReceiver& each : receivers) sources.push_back(&each);
  return recordFrom(sources, std::move(*log), options, events);
}

}  // namespace rocinante
