#include "player/source/source.h"

#include <algorithm>
#include <limits>
#include <set>

#include "core/base/atomic_file.h"
#include "core/base/data_file.h"
#include "core/base/name_hint.h"
#include "core/base/pattern.h"
#include "core/base/random_id.h"
#include "core/log/log_profile.h"
#include "core/packet/packet_text.h"
#include "core/signing/signed_datagram.h"
#include "player/logs/played_span.h"
#include "player/logs/read_ahead.h"
#include "player/logs/tape_finder.h"
#include "player/send/datagram_stream.h"
#include "player/source/csv_motion.h"
#include "player/source/csv_stream.h"
#include "player/source/log_stream.h"

namespace rocinante {
namespace {

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
  plan.notify = surroundings.notify;
  plan.began = [&] { surroundings.notify("sending " + names + " to " + options.to.text()); };
  if (options.key.empty()) return sendPlan(cut, plan, surroundings.stop);
  Result<SigningKey> key = SigningKey::read(options.key);
  if (!key) return key.error();
  DatagramSigner signer(std::move(*key), wallNow);
  SigningStream signing(cut, signer);
  return sendPlan(signing, plan, surroundings.stop);
}

/// A table of several devices has one source, named after the first of them.
std::string sourceOf(const CsvMotion& motion) {
  if (!motion.devices.empty()) return motion.devices.front().name;
  const std::string& device = motion.signals.columns().front().signal.device;
  return device.empty() ? "table" : device;
}

/// The motion's end over all its turns, for the progress line.
LogTime lastOf(LogTime first, Nanoseconds period, std::uint32_t turns) {
  std::int64_t whole = 0;
  if (turns == 0 || __builtin_mul_overflow(period.count(), turns, &whole)) return LogTime::max();
  return first + Nanoseconds(whole);
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

Status checkUtf8Name(const char* option, const std::string& name) {
  if (isName(name)) return {};
  return Error{ErrorKind::bad_argument, "a name is 1 to 255 bytes of UTF-8", option};
}

/// The channels of the chosen sources: the others are treated as if they had not been recorded.
Result<ChannelChoice> channelsOf(const LogSourceOptions& options) {
  const Result<MultiLogReader> log = MultiLogReader::open({options.log});
  if (!log) return log.error();
  const std::set<std::string> sources = log->sources();
  const std::vector<std::string_view> known(sources.begin(), sources.end());
  for (const auto& [name, new_name] : options.choice.names) {
    if (const Status is_name = checkUtf8Name("--as", new_name); !is_name) return is_name.error();
    if (sources.contains(name) && options.choice.includes(name)) continue;
    return Error{ErrorKind::bad_argument,
                 "--as names no source that is sent: " + whatThereIs(name, known), name};
  }
  for (const std::string& pattern : options.choice.sources) {
    if (std::any_of(known.begin(), known.end(),
                    [&](std::string_view source) { return patternMatches(pattern, source); })) {
      continue;
    }
    return Error{ErrorKind::bad_argument,
                 "no source of the log matches: " + whatThereIs(pattern, known), pattern};
  }
  ChannelChoice choice;
  if (options.choice.sources.empty()) return choice;
  for (const LogChannel& channel : log->channels(0)) {
    const auto source = channel.metadata.find("source");
    if (source == channel.metadata.end() || !options.choice.includes(source->second)) continue;
    choice.only.emplace_back(profile::capturedTopic(channel.topic));
  }
  return choice;
}

}  // namespace

Result<PlayReport> sendCsv(const CsvSourceOptions& csv, const SourceOptions& options,
                           const SendSurroundings& surroundings) {
  const Result<std::string> text = readFile(csv.csv);
  if (!text) return text.error();
  const Result<CsvMotion> motion = readCsvMotion(*text, csv.csv.string(), csv.device, csv.columns);
  if (!motion) return motion.error();
  if (surroundings.notify && !motion->left_out.empty()) {
    surroundings.notify(accountSentence(motion->left_out));
  }

  CsvStream::Options how;
  how.source = csv.source.empty() ? sourceOf(*motion) : csv.source;
  how.run = runOf(options);
  how.restate = csv.restate;
  how.speed = options.speed;
  how.mtu_bytes = unsignedBytes(options);
  how.turns = options.turns;
  if (csv.stamp_clock) how.wall_now = wallNow;
  Result<CsvStream> stream = CsvStream::open(*motion, how);
  if (!stream) return stream.error();

  SendPlan plan;
  plan.from = LogTime(motion->times.front());
  plan.until = plan.from + stream->period();
  plan.last = lastOf(plan.from, stream->period(), options.turns);
  Result<PlayReport> report = send(*stream, how.source, plan, options, surroundings);
  if (!report) return report;
  report->inputs = {csv.csv.string()};
  report->source = how.source;
  report->run = how.run;
  return report;
}

Result<PlayReport> sendLog(const LogSourceOptions& log, const SourceOptions& options,
                           const SendSurroundings& surroundings) {
  const std::string run = runOf(options);
  if (const Status is_name = checkUtf8Name("--run", run); !is_name) return is_name.error();
  const Result<ChannelChoice> channels = channelsOf(log);
  if (!channels) return channels.error();
  Result<MultiLogReader> reader = MultiLogReader::open({log.log}, *channels);
  if (!reader) return reader.error();
  Result<TapeFinder> finder = TapeFinder::open({log.log}, *channels);
  if (!finder) return finder.error();
  const Result<PlayedSpan> span = playedSpan(*reader, log.from, log.until);
  if (!span) return span.error();
  Result<bool> any = false;
  if (span->from < span->until) any = finder->anyIn(span->from, span->until);
  if (!any) return any.error();
  if (!*any) {
    return Error{ErrorKind::not_found, "nothing to send: no captured message in the chosen part",
                 log.log.string()};
  }
  Result<SessionState> before = finder->stateBefore(TapePosition::at(span->from));
  if (!before) return before.error();

  LogStream::Options how;
  how.choice = log.choice;
  how.run = run;
  how.span = *span;
  how.turns = options.turns;
  how.restate = options.speed.logDuration(log.restate);
  how.mtu_bytes = unsignedBytes(options);
  how.speed = options.speed;
  how.epoch_ns = wallNow().time_since_epoch().count();
  Result<LogStream> stream = LogStream::open(*reader, std::move(*before), how);
  if (!stream) {
    Error error = stream.error();
    if (error.where.empty()) error.where = log.log.string();
    return error;
  }
  const std::string names = joined(stream->names());

  SendPlan plan;
  plan.from = span->from;
  plan.until = span->until;
  plan.last = lastOf(plan.from, span->until - span->from, options.turns);
  std::optional<Result<PlayReport>> report;
  {
    ReadAhead ahead(*stream, false);
    report = send(ahead, names, plan, options, surroundings);
  }
  if (!*report) return *report;
  PlayReport& sent = **report;
  sent.inputs = {log.log.string()};
  sent.source = names;
  sent.run = run;
  sent.damage = reader->damage();
  if (!finder->stateDamage().empty()) {
    sent.damage.push_back("a restated state may be outdated: " + finder->stateDamage().text());
  }
  return *report;
}

Result<PlayReport> sendDemo(const std::string& part, Nanoseconds restate,
                            const SourceOptions& options, const SendSurroundings& surroundings) {
  const Result<std::filesystem::path> motion = findDataFile("examples/demo/motion.mcap");
  if (!motion) return motion.error();
  LogSourceOptions log;
  log.log = *motion;
  if (part != "all") log.choice.sources = {part};
  // A turn begins once every source has spoken, so that its first moment has the whole state.
  log.from = "0.01s";
  log.until = "20.01s";
  log.restate = restate;
  Result<PlayReport> report = sendLog(log, options, surroundings);
  if (report) report->inputs = {"demo"};
  return report;
}

WallTime wallNow() { return std::chrono::system_clock::now(); }

std::string runOf(const SourceOptions& options) {
  if (!options.run.empty()) return options.run;
  return randomId(5);
}

std::size_t unsignedBytes(const SourceOptions& options) {
  const std::size_t room = options.key.empty() ? 0 : kSignatureBytes;
  return options.mtu_bytes - std::min(options.mtu_bytes, room);
}

}  // namespace rocinante
