#include "player/source/source.h"

#include <sys/random.h>

#include <algorithm>
#include <array>
#include <limits>

#include "core/base/atomic_file.h"
#include "player/demo/demo_stream.h"
#include "player/source/csv_motion.h"
#include "player/source/csv_stream.h"
#include "player/source/cut_stream.h"

namespace rocinante {
namespace {

WallTime wallNow() { return std::chrono::system_clock::now(); }

/// Chosen at each start, so that a receiver can tell a restart from late packets.
std::string randomRun() {
  std::array<unsigned char, 5> random{};
  if (::getrandom(random.data(), random.size(), 0) != static_cast<ssize_t>(random.size())) {
    const auto now = static_cast<std::uint64_t>(wallNow().time_since_epoch().count());
    for (std::size_t i = 0; i < random.size(); ++i) {
      random[i] = static_cast<unsigned char>(now >> (8 * i));
    }
  }
  return hexOf(std::as_bytes(std::span(random)));
}

LogTime endOf(LogTime first, const std::optional<Nanoseconds>& duration) {
  return duration ? first + *duration : LogTime::max();
}

Result<PlayReport> send(DatagramStream& stream, const std::string& names, SendPlan plan,
                        const SourceOptions& options, const SendSurroundings& surroundings) {
  plan.to = options.to;
  plan.speed = options.speed;
  plan.origin = plan.first = plan.from;
  plan.realtime = options.realtime;
  plan.progress = options.progress;
  const LogTime end = endOf(plan.first, options.duration);
  plan.last = std::min(plan.last, end);
  CutStream cut(stream, end);
  plan.began = [&] { surroundings.told("sending " + names + " to " + options.to.text()); };
  return sendPlan(cut, plan, surroundings.stop);
}

/// The motion's end over all its turns, for the progress line.
LogTime lastOf(LogTime first, Nanoseconds period, std::uint32_t turns) {
  std::int64_t whole = 0;
  if (turns == 0 || __builtin_mul_overflow(period.count(), turns, &whole)) return LogTime::max();
  return first + Nanoseconds(whole);
}

}  // namespace

Result<PlayReport> sendCsv(const CsvSourceOptions& csv, const SourceOptions& options,
                           const SendSurroundings& surroundings) {
  const Result<std::string> text = readFile(csv.csv);
  if (!text) return text.error();
  const Result<CsvMotion> motion = readCsvMotion(*text, csv.csv.string(), csv.columns);
  if (!motion) return motion.error();

  CsvStream::Options how;
  how.device = csv.device;
  how.source = csv.source.empty() ? csv.device : csv.source;
  how.run = options.run.empty() ? randomRun() : options.run;
  how.restate = options.speed.logDuration(csv.restate);
  how.mtu_bytes = options.mtu_bytes;
  how.turns = options.turns;
  if (csv.stamp_clock) how.wall_now = wallNow;
  Result<CsvStream> stream = CsvStream::open(*motion, how);
  if (!stream) return stream.error();

  SendPlan plan;
  plan.from = LogTime(motion->rows.front().time);
  plan.until = plan.from + stream->period();
  plan.last = lastOf(plan.from, stream->period(), options.turns);
  Result<PlayReport> report = send(*stream, how.source, plan, options, surroundings);
  if (!report) return report;
  report->inputs = {csv.csv.string()};
  report->source = how.source;
  report->run = how.run;
  return report;
}

Result<PlayReport> sendDemo(const std::vector<DemoPart>& parts, const SourceOptions& options,
                            const SendSurroundings& surroundings) {
  std::string names;
  for (const DemoPart part : parts) {
    names += (names.empty() ? "" : ", ") + std::string(nameOf(part));
  }
  DemoStream::Options how;
  how.parts = parts;
  how.run = options.run.empty() ? randomRun() : options.run;
  how.epoch_ns = wallNow().time_since_epoch().count();
  how.mtu_bytes = options.mtu_bytes;
  how.turns = options.turns;
  DemoStream stream(how);

  SendPlan plan;
  plan.until = LogTime(kDemoLength);
  plan.last = lastOf(plan.from, kDemoLength, options.turns);
  Result<PlayReport> report = send(stream, names, plan, options, surroundings);
  if (!report) return report;
  report->inputs = {"demo"};
  report->source = names;
  report->run = how.run;
  return report;
}

}  // namespace rocinante
