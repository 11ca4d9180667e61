#include "recorder/capture/record.h"

#include <fmt/format.h>
#include <sys/statvfs.h>

#include <algorithm>
#include <thread>
#include <utility>

#include "core/foreign/live/received_decoder.h"
#include "core/net/interfaces.h"
#include "core/transport/open_source.h"
#include "recorder/capture/capture_file_loop.h"
#include "recorder/capture/reception.h"
#include "recorder/capture/record_sink.h"
#include "recorder/capture/stream_loop.h"
#include "recorder/capture/tee_set.h"
#include "recorder/capture/writing.h"

namespace rocinante {
namespace {

using std::chrono::milliseconds;

// Every endpoint needs a receive buffer, and MCAP limits the number of channels.
constexpr std::size_t kMaxEndpoints = 256;
constexpr Nanoseconds kControlSleep = milliseconds(10);
constexpr Nanoseconds kProgressPeriod = milliseconds(250);
constexpr const char* kRefused = "refused";
constexpr std::size_t kMaxWarnings = 100;

SteadyTime steadyClockNow() { return std::chrono::steady_clock::now(); }

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

/// Decides when a recording ends. Pure.
class EndRule {
 public:
  EndRule(const RecordOptions& options, bool is_live, SteadyTime start)
      : duration_(is_live ? options.duration.value_or(kForEver) : kForEver) {
    if (options.start_on.empty()) begin(start);
  }

  /// Why it ends `now`, as in rocinante.end; empty when it continues.
  std::string reason(SteadyTime now, bool stop_requested, bool input_over,
                     const Writing::Progress& written) {
    if (!begun_ && written.started) begin(now);
    if (stop_requested) return "interrupted";
    if (input_over) return "end";
    if (written.over) return "limit";
    return now >= until_ ? "duration" : "";
  }

 private:
  static constexpr Nanoseconds kForEver = Nanoseconds::max();

  void begin(SteadyTime now) {
    begun_ = true;
    if (duration_ < SteadyTime::max() - now) until_ = now + duration_;
  }

  Nanoseconds duration_;  ///< by the clock; the writer judges that of a file
  bool begun_ = false;
  SteadyTime until_ = SteadyTime::max();
};

/// A running recording as its caller sees it.
class Control {
 public:
  Control(const RecordOptions& options, const RecordEvents& events, NoteBox& notes, HandOver& queue,
          const Reception& reception, Writing& writing)
      : options_(options),
        events_(events),
        notes_(notes),
        queue_(queue),
        reception_(reception),
        writing_(writing) {}

  /// Waits for a reason to end, and returns it.
  std::string waitForEnd() {
    const SteadyTime start = reception_.start();
    EndRule rule(options_, reception_.loop().isLive(), start);
    for (SteadyTime reported_at = start;; std::this_thread::sleep_for(kControlSleep)) {
      passOn();
      const SteadyTime now = steadyClockNow();
      const Writing::Progress written = writing_.progress();
      std::string reason = rule.reason(now, events_.stop_requested(), reception_.over(), written);
      if (!reason.empty()) return reason;
      if (now - reported_at < kProgressPeriod) continue;
      reported_at = now;
      events_.progress(progressOf(written, now - start));
    }
  }

  /// Passes requests from the program to the threads, and notes back.
  void passOn() {
    writing_.ask({events_.seams_requested(), events_.triggers_requested()});
    for (const NoteBox::Note& note : notes_.take()) {
      events_.note(note);
      if (note.is_trouble && warnings_.size() < kMaxWarnings) warnings_.push_back(note.text);
    }
  }

  std::vector<std::string> takeWarnings() { return std::move(warnings_); }

 private:
  RecordProgress progressOf(const Writing::Progress& written, Nanoseconds elapsed) const {
    RecordProgress progress;
    progress.elapsed = elapsed;
    progress.packets = written.packets;
    progress.lost = written.lost;
    progress.log_bytes = written.log_bytes;
    progress.started = options_.start_on.empty() || written.started;
    progress.held = written.held;
    progress.queue_fill = queue_.fill();
    progress.disk_free_bytes = diskFree(options_.log);
    return progress;
  }

  const RecordOptions& options_;
  const RecordEvents& events_;
  NoteBox& notes_;
  HandOver& queue_;
  const Reception& reception_;
  Writing& writing_;
  std::vector<std::string> warnings_;
};

CaptureLimits limitsOf(const RecordOptions& options, const InputLoop& loop) {
  CaptureLimits limits;
  limits.max_packets = options.max_packets;
  limits.start_on = options.start_on;
  limits.stop_on = options.stop_on;
  limits.duration = options.duration;
  if (options.duration && options.start_on.empty() && !loop.keepsPlace()) {
    limits.until = loop.begins() + *options.duration;
  }
  return limits;
}

/// How long the recording was, on the session's time line.
Nanoseconds durationOf(const RecordSummary& summary, const RecordOptions& options,
                       const InputLoop& loop, Nanoseconds elapsed) {
  if (!loop.isLive()) {
    LogTime ends = loop.begins();
    for (const PieceFacts& each : summary.files.pieces) {
      ends = std::max(ends, each.end.value_or(loop.begins()));
    }
    return ends - loop.begins();
  }
  const bool is_bounded = options.duration && options.start_on.empty();
  return is_bounded ? std::min(elapsed, *options.duration) : elapsed;
}

RecordSummary recordInto(std::unique_ptr<CaptureSink> sink, const std::string& name,
                         Reception& reception, HandOver& queue, TeeSet& tees, NoteBox& notes,
                         const RecordOptions& options, const RecordEvents& events) {
  std::vector<ListenedEndpoint> listened;
  for (const DatagramSource* source : reception.sources()) {
    listened.push_back({source->endpoint(), source->boundAddress()});
  }
  InputLoop& loop = reception.loop();
  std::shared_ptr<LiveDecoder> octets;
  if (options.decoders) octets = std::make_shared<LiveDecoder>(options.decoders);
  CaptureWriter writer(std::move(sink), std::move(listened), limitsOf(options, loop), octets);
  Writing writing(writer, queue, loop);
  events.ready(reception.names(), name);
  Control control(options, events, notes, queue, reception, writing);
  std::string reason = control.waitForEnd();
  const Nanoseconds elapsed = steadyClockNow() - reception.start();
  const Status received = reception.stop();
  tees.close();
  writing.join();
  if (reason == "limit") reason = writer.endReason();
  if (!received) reason = kRefused;
  writer.close(reason, queue);
  if (loop.keepsPlace() && !writer.trouble()) {
    reception.sources()[0]->confirm(writer.packets() + writer.packetsBefore());
  }
  control.passOn();

  RecordSummary summary = summaryOf(writer, received);
  summary.duration = durationOf(summary, options, loop, elapsed);
  if (const auto first = writer.firstTime(); first && !loop.keepsPlace()) {
    // It may have waited in the socket already.
    summary.first_after = std::max(*first - loop.begins(), Nanoseconds(0));
  }
  summary.reason = summary.trouble ? kRefused : reason;
  summary.warnings = control.takeWarnings();
  summary.inputs = inputAccounts(reception.sources(), loop);
  summary.tees = tees.accounts();
  if (octets) summary.decoded = octets->account();
  return summary;
}

/// Fails for what a capture file or a stream cannot be combined with.
Status checkOwnTimes(const Endpoint& first, const RecordOptions& options) {
  if (first.hasOwnTimes() && !options.tees.empty()) {
    return Error{ErrorKind::bad_argument,
                 first.isNats()
                     ? "--tee cannot forward a stream: subscribe to its subjects too"
                     : "--tee cannot forward a capture file: record it, then play the log",
                 first.text()};
  }
  if (first.scheme == Endpoint::Scheme::jetstream && options.ring) {
    return Error{ErrorKind::bad_argument,
                 "--ring forgets what no trigger saves, and a stream would take it for recorded",
                 first.text()};
  }
  return {};
}

/// When a capture file begins, if the first endpoint is one.
Result<std::optional<LogTime>> fileBegins(const Endpoint& first) {
  if (first.file.empty()) return std::optional<LogTime>();
  Result<std::optional<LogTime>> begins = firstMoment(first);
  if (begins && !*begins) {
    return Error{ErrorKind::refused, "the capture file contains no UDP datagram", first.text()};
  }
  return begins;
}

}  // namespace

RecordSummary recordFrom(const std::vector<DatagramSource*>& sources, LogWriter log,
                         const RecordOptions& options, const RecordEvents& events) {
  NoteBox notes;
  TeeSet tees;
  HandOver queue(options.queue_blocks);
  const std::unique_ptr<InputLoop> loop = socketLoop(sources, queue, tees, notes);
  Reception reception(sources, *loop);
  return recordInto(sinkOf(std::move(log), options, notes), options.log.string(), reception, queue,
                    tees, notes, options, events);
}

Result<RecordSummary> record(const RecordOptions& options, const RecordEvents& events) {
  if (options.endpoints.empty() || options.endpoints.size() > kMaxEndpoints) {
    return Error{ErrorKind::bad_argument,
                 fmt::format("1 to {} endpoints can be recorded", kMaxEndpoints), ""};
  }
  if (Status checked = checkOwnTimes(options.endpoints[0], options); !checked) {
    return checked.error();
  }
  // Open the sockets first: a port in use must not leave an empty log behind.
  Result<TeeSet> tees = TeeSet::open(options.tees);
  if (!tees) return tees.error();
  for (const std::string& each : tees->news()) events.note({each, false});
  if (options.wait_interface) {
    const auto tell = [&](const std::string& text) { events.note({text, false}); };
    if (Status there = waitForInterfaces(options.endpoints, *options.wait_interface, tell,
                                         events.stop_requested);
        !there) {
      return there.error();
    }
  }
  const InputOptions listening{options.receiving, options.allow, tees->localAddresses(),
                               options.trust, /*resuming=*/true};
  const Result<Sources> opened = openSources(options.endpoints, listening);
  if (!opened) return opened.error();
  std::vector<DatagramSource*> sources;
  for (const auto& each : *opened) sources.push_back(each.get());
  if (Status checked = tees->check(sources); !checked) return checked.error();
  const Result<std::optional<LogTime>> file_begins = fileBegins(options.endpoints[0]);
  if (!file_begins) return file_begins.error();
  NoteBox notes;
  const LogTime named_at = file_begins->value_or(LogTime(readClocks().wall.time_since_epoch()));
  HandOver queue(options.queue_blocks);
  std::unique_ptr<InputLoop> loop;
  if (*file_begins) {
    loop = std::make_unique<CaptureFileLoop>(*sources[0], queue, **file_begins);
  } else if (sources[0]->keepsPlace()) {
    loop = std::make_unique<StreamLoop>(*sources[0], queue, named_at, notes);
  } else {
    loop = socketLoop(sources, queue, *tees, notes);
  }
  Reception reception(sources, *loop);
  RecordOptions whole = options;
  if (options.load_cell || options.load_watched) events.listening(reception.names());
  if (options.load_cell) {
    auto cell = options.load_cell();
    if (!cell) {
      Error refused = cell.error();
      refused.what = "nothing is recorded: " + refused.what +
                     "; without --cell it records, and `rocinante log attach` adds the cell later";
      return refused;
    }
    whole.cell = std::move(cell->cell);
    if (!whole.decoders) whole.decoders = std::move(cell->decoders);
  }
  if (options.load_watched) {
    Result<Cell> watched = options.load_watched();
    if (!watched) return watched.error();
    whole.watch = std::make_shared<FindingTrigger>(std::move(*watched), options.watch_severity,
                                                   reception.loop().isLive());
  }
  Result<RecordSink> made = makeSink(whole, named_at, notes);
  if (!made) return made.error();
  return recordInto(std::move(made->sink), made->name, reception, queue, *tees, notes, whole,
                    events);
}

}  // namespace rocinante
