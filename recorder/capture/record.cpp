#include "recorder/capture/record.h"

#include <fmt/format.h>
#include <sys/statvfs.h>

#include <algorithm>
#include <atomic>
#include <thread>
#include <utility>

#include "core/net/interface_wait.h"
#include "core/pcap/open_source.h"
#include "recorder/capture/capture_file_loop.h"
#include "recorder/capture/prompt_thread.h"
#include "recorder/capture/receive_loop.h"
#include "recorder/capture/record_sink.h"
#include "recorder/capture/tee_set.h"
#include "recorder/pieces/thread_without_signals.h"

namespace rocinante {
namespace {

using std::chrono::milliseconds;

// Every endpoint needs a receive buffer, and MCAP limits the number of channels.
constexpr std::size_t kMaxEndpoints = 256;
// Draining and sleeping costs half as much as waking for each datagram, and takes 600,000 a second.
constexpr Nanoseconds kReceiveSleep = std::chrono::microseconds(500);
constexpr Nanoseconds kIdleSleep = milliseconds(2);
constexpr int kIdlePasses = 200;
constexpr Nanoseconds kWriteWait = milliseconds(10);
constexpr Nanoseconds kControlSleep = milliseconds(10);
constexpr Nanoseconds kProgressPeriod = milliseconds(250);
constexpr const char* kRefused = "refused";
constexpr std::size_t kMaxWarnings = 100;
constexpr Nanoseconds kNarrowLook = std::chrono::microseconds(2);

SteadyTime steadyClockNow() { return std::chrono::steady_clock::now(); }

/// The narrowest of a few readings: an interrupted one measures the offset poorly.
ClockReading lookAtClocks() {
  ClockReading best{};
  for (int attempt = 0; attempt < 4; ++attempt) {
    ClockReading reading;
    reading.before = steadyClockNow();
    reading.wall = std::chrono::time_point_cast<Nanoseconds>(std::chrono::system_clock::now());
    reading.after = steadyClockNow();
    const bool narrower = reading.after - reading.before < best.after - best.before;
    if (attempt == 0 || narrower) best = reading;
    if (best.after - best.before <= kNarrowLook) break;
  }
  return best;
}

/// State that the threads share besides the datagrams.
struct Shared {
  std::atomic<bool> stop{false};
  std::atomic<bool> receiver_failed{false};
  std::atomic<bool> file_ended{false};
  std::atomic<bool> writer_over{false};
  std::atomic<bool> started{false};
  std::atomic<std::uint32_t> seams{0};     ///< requested so far
  std::atomic<std::uint32_t> triggers{0};  ///< likewise
  std::atomic<std::uint64_t> packets{0};
  std::atomic<std::uint64_t> lost{0};
  std::atomic<std::uint64_t> log_bytes{0};
  std::atomic<std::int64_t> held_ns{0};
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
  // Datagrams that have arrived may not be delivered yet.
  std::this_thread::sleep_for(loop.deliveryDelay());
  Status finished = loop.finish();
  return ended ? finished : ended;
}

/// The same for a capture file.
Status readUntilEnded(DatagramSource& file, HandOver& queue, Shared& shared) {
  CaptureFileLoop loop(file, queue);
  Status broken;
  while (!shared.stop.load(std::memory_order_relaxed) && !loop.ended()) {
    const Result<bool> passed = loop.pass();
    if (!passed) {
      broken = passed.error();
      break;
    }
    // The queue is full until the disk catches up.
    if (!*passed) std::this_thread::sleep_for(kReceiveSleep);
  }
  loop.finish();
  shared.file_ended.store(true);
  return broken;
}

void writeUntilFinished(CaptureWriter& writer, HandOver& queue, Shared& shared) {
  std::uint32_t seams = 0;
  std::uint32_t triggers = 0;
  for (bool finished = false; !finished;) {
    TakenOver taken = queue.take(kWriteWait);
    finished = taken.finished;
    writer.write(std::move(taken), queue);
    if (const std::uint32_t asked = shared.seams.load(); asked != seams) {
      seams = asked;
      writer.askForSeam();
    }
    if (const std::uint32_t asked = shared.triggers.load(); asked != triggers) {
      triggers = asked;
      writer.trigger("signal");
    }
    writer.flush(steadyClockNow());
    shared.packets.store(writer.packets(), std::memory_order_relaxed);
    shared.lost.store(writer.lost(), std::memory_order_relaxed);
    shared.log_bytes.store(writer.logBytes(), std::memory_order_relaxed);
    shared.held_ns.store(writer.held().count(), std::memory_order_relaxed);
    shared.started.store(writer.started(), std::memory_order_relaxed);
    shared.writer_over.store(writer.over(), std::memory_order_relaxed);
  }
}

std::optional<std::uint64_t> diskFree(const std::filesystem::path& log) {
  struct statvfs facts {};
  std::filesystem::path folder = log;
  // For a name pattern, use the folder above the parts that are filled in.
  while (!folder.empty() && ::statvfs(folder.c_str(), &facts) != 0) {
    folder = folder.has_parent_path() ? folder.parent_path() : std::filesystem::path();
  }
  if (folder.empty() && ::statvfs(".", &facts) != 0) return std::nullopt;
  return std::uint64_t{facts.f_bavail} * facts.f_frsize;
}

/// The caller's side of a running recording.
class Control {
 public:
  Control(const RecordOptions& options, const RecordEvents& events, NoteBox& notes, HandOver& queue,
          Shared& shared)
      : options_(options), events_(events), notes_(notes), queue_(queue), shared_(shared) {}

  /// Waits for a reason to end, and returns it.
  std::string waitForEnd(SteadyTime start) {
    std::optional<SteadyTime> begun;
    SteadyTime told = start;
    for (;;) {
      const SteadyTime now = steadyClockNow();
      passOn();
      if (!begun && (options_.start_on.empty() || shared_.started.load())) {
        begun = options_.start_on.empty() ? start : now;
      }
      if (events_.stop_requested()) return "interrupted";
      if (shared_.receiver_failed.load()) return "socket";
      if (shared_.file_ended.load()) return "end";
      if (shared_.writer_over.load(std::memory_order_relaxed)) return "limit";
      const bool by_the_clock = options_.endpoints.empty() || options_.endpoints[0].file.empty();
      if (by_the_clock && options_.duration && begun && now - *begun >= *options_.duration)
        return "duration";
      if (now - told >= kProgressPeriod) {
        told = now;
        events_.progress(progressAt(now - start));
      }
      std::this_thread::sleep_for(kControlSleep);
    }
  }

  /// Passes requests from the program to the threads, and notes back.
  void passOn() {
    shared_.seams.store(events_.seams_requested());
    shared_.triggers.store(events_.triggers_requested());
    for (const NoteBox::Note& note : notes_.take()) {
      events_.note(note);
      if (note.is_trouble && warnings_.size() < kMaxWarnings) warnings_.push_back(note.text);
    }
  }

  std::vector<std::string> takeWarnings() { return std::move(warnings_); }

 private:
  RecordProgress progressAt(Nanoseconds elapsed) const {
    RecordProgress progress;
    progress.elapsed = elapsed;
    progress.packets = shared_.packets.load(std::memory_order_relaxed);
    progress.lost = shared_.lost.load(std::memory_order_relaxed);
    progress.log_bytes = shared_.log_bytes.load(std::memory_order_relaxed);
    progress.started = options_.start_on.empty() || shared_.started.load();
    progress.held = Nanoseconds(shared_.held_ns.load(std::memory_order_relaxed));
    progress.queue_fill = queue_.fill();
    progress.disk_free_bytes = diskFree(options_.log);
    return progress;
  }

  const RecordOptions& options_;
  const RecordEvents& events_;
  NoteBox& notes_;
  HandOver& queue_;
  Shared& shared_;
  std::vector<std::string> warnings_;
};

RecordSummary summaryOf(const CaptureWriter& writer, const Status& received) {
  RecordSummary summary;
  summary.files = writer.files();
  for (const PieceFacts& each : summary.files.pieces) {
    summary.log = each.file.path;
    summary.log_bytes += each.bytes;
  }
  summary.endpoints = writer.accounts();
  for (const EndpointAccount& each : summary.endpoints) {
    summary.packets += each.recorded;
    summary.losses += each.losses;
  }
  summary.restated = writer.restated();
  summary.payload_bytes = writer.payloadBytes();
  summary.packets_before = writer.packetsBefore();
  summary.channels = writer.channelCount();
  summary.late = writer.late();
  if (writer.trouble()) {
    summary.trouble = writer.trouble();
  } else if (!received) {
    summary.trouble = received.error();
  }
  return summary;
}

/// Duration of a capture file on its own time line.
Nanoseconds spanOf(const RecordedFiles& files, LogTime begins) {
  LogTime ends = begins;
  for (const PieceFacts& each : files.pieces) ends = std::max(ends, each.end.value_or(begins));
  return ends - begins;
}

/// The receiving half of a recording. Listens during its whole lifetime.
class Reception {
 public:
  Reception(const std::vector<DatagramSource*>& sources, TeeSet& tees, const RecordOptions& options,
            NoteBox& notes, std::optional<LogTime> file_begins)
      : sources_(sources),
        tees_(tees),
        queue_(options.queue_blocks),
        loop_(sources, lookAtClocks, queue_, callbacks(notes)),
        start_(steadyClockNow()),
        begins_(file_begins.value_or(loop_.clock().now())),
        thread_(threadWithoutSignals("receive", [this, from_file = file_begins.has_value()] {
          askToRunPromptly();
          received_ = from_file ? readUntilEnded(*sources_[0], queue_, shared_)
                                : receiveUntilStopped(loop_, shared_);
        })) {}
  ~Reception() { (void)stop(); }
  Reception(const Reception&) = delete;
  Reception& operator=(const Reception&) = delete;

  /// Stops receiving. Idempotent; returns the failure of a socket.
  Status stop() {
    shared_.stop.store(true);
    if (thread_.joinable()) thread_.join();
    return received_;
  }

  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const DatagramSource* source : sources_) names.push_back(boundText(*source));
    return names;
  }
  const std::vector<DatagramSource*>& sources() const { return sources_; }
  TeeSet& tees() { return tees_; }
  HandOver& queue() { return queue_; }
  Shared& shared() { return shared_; }
  const ReceiveLoop& loop() const { return loop_; }
  SteadyTime start() const { return start_; }
  LogTime begins() const { return begins_; }

 private:
  ReceiveLoop::Callbacks callbacks(NoteBox& notes) {
    ReceiveLoop::Callbacks callbacks;
    callbacks.note = [&notes](const std::string& note) { notes.say(note); };
    if (!tees_.empty()) callbacks.tee = [this](auto batch) { tees_.forward(batch); };
    return callbacks;
  }

  const std::vector<DatagramSource*>& sources_;
  TeeSet& tees_;
  Shared shared_;
  HandOver queue_;
  ReceiveLoop loop_;
  SteadyTime start_;
  LogTime begins_;
  Status received_;
  std::thread thread_;  ///< last: it uses the members above
};

RecordSummary recordInto(std::unique_ptr<CaptureSink> sink, const std::string& name,
                         Reception& reception, const RecordOptions& options,
                         const RecordEvents& events, NoteBox& notes, bool from_file) {
  std::vector<ListenedEndpoint> listened;
  for (const DatagramSource* source : reception.sources()) {
    listened.push_back({source->endpoint(), source->boundAddress()});
  }
  Shared& shared = reception.shared();
  HandOver& queue = reception.queue();
  CaptureLimits limits;
  limits.max_packets = options.max_packets;
  limits.start_on = options.start_on;
  limits.stop_on = options.stop_on;
  limits.duration = options.duration;
  if (options.duration && options.start_on.empty()) {
    limits.until = reception.begins() + *options.duration;
  }
  CaptureWriter writer(std::move(sink), std::move(listened), std::move(limits));

  std::thread writing = threadWithoutSignals("write", [&] {
    askToRunPromptly();
    writeUntilFinished(writer, queue, shared);
  });
  events.ready(reception.names(), name);
  Control control(options, events, notes, queue, shared);
  std::string reason = control.waitForEnd(reception.start());
  const Nanoseconds duration = steadyClockNow() - reception.start();
  const Status received = reception.stop();
  reception.tees().close();
  writing.join();
  if (reason == "limit") reason = writer.endReason();
  if (!received) reason = kRefused;
  writer.close(reason, queue);
  control.passOn();

  RecordSummary summary = summaryOf(writer, received);
  const bool bounded = options.duration && options.start_on.empty();
  summary.duration = bounded ? std::min(duration, *options.duration) : duration;
  if (from_file) summary.duration = spanOf(summary.files, reception.begins());
  summary.reason = summary.trouble ? kRefused : reason;
  summary.warnings = control.takeWarnings();
  summary.inputs = inputAccounts(reception.sources(), reception.loop());
  summary.tees = reception.tees().accounts();
  return summary;
}

}  // namespace

RecordSummary recordFrom(const std::vector<DatagramSource*>& sources, LogWriter log,
                         const RecordOptions& options, const RecordEvents& events) {
  NoteBox notes;
  TeeSet tees;
  Reception reception(sources, tees, options, notes, std::nullopt);
  return recordInto(sinkOf(std::move(log), options, notes), options.log.string(), reception,
                    options, events, notes, /*from_file=*/false);
}

Result<RecordSummary> record(const RecordOptions& options, const RecordEvents& events) {
  if (options.endpoints.empty() || options.endpoints.size() > kMaxEndpoints) {
    return Error{ErrorKind::bad_argument,
                 fmt::format("1 to {} endpoints can be recorded", kMaxEndpoints), ""};
  }
  // Open the sockets first: a port in use must not leave an empty log behind.
  Result<TeeSet> tees = TeeSet::open(options.tees);
  if (!tees) return tees.error();
  if (options.wait_interface) {
    const auto tell = [&](const std::string& text) { events.note({text, false}); };
    if (Status there = waitForInterfaces(options.endpoints, *options.wait_interface, tell,
                                         events.stop_requested);
        !there) {
      return there.error();
    }
  }
  const InputOptions listening{options.receiving, options.allow, tees->localAddresses()};
  const Result<Sources> opened = openSources(options.endpoints, listening);
  if (!opened) return opened.error();
  std::vector<DatagramSource*> sources;
  for (const auto& each : *opened) sources.push_back(each.get());
  if (Status checked = tees->check(sources); !checked) return checked.error();
  std::optional<LogTime> file_begins;
  if (const Endpoint& first = options.endpoints[0]; !first.file.empty()) {
    if (!tees->empty()) {
      return Error{ErrorKind::bad_argument,
                   "--tee cannot forward a capture file: record it, then play the log",
                   first.text()};
    }
    const auto begins = firstMoment(first);
    if (!begins) return begins.error();
    if (!*begins) {
      return Error{ErrorKind::refused, "the capture file contains no UDP datagram", first.text()};
    }
    file_begins = *begins;
  }
  NoteBox notes;
  const LogTime named_at = file_begins.value_or(LogTime(lookAtClocks().wall.time_since_epoch()));
  Reception reception(sources, *tees, options, notes, file_begins);
  RecordOptions whole = options;
  if (options.load_cell) {
    events.listening(reception.names());
    auto cell = options.load_cell();
    if (!cell) return cell.error();
    whole.cell = std::move(*cell);
  }
  Result<RecordSink> made = makeSink(whole, named_at, notes);
  if (!made) return made.error();
  return recordInto(std::move(made->sink), made->name, reception, whole, events, notes,
                    file_begins.has_value());
}

}  // namespace rocinante
