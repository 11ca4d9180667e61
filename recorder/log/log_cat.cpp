#include "recorder/log/log_cat.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/duration_text.h"
#include "core/session/timeline.h"
#include "recorder/log/message_text.h"

namespace rocinante {
namespace {

/// Output is handed over in pieces of about this size.
constexpr std::size_t kPieceBytes = 1U << 16U;

struct TimeRange {
  LogTime from{Nanoseconds(std::numeric_limits<std::int64_t>::min())};
  LogTime until{Nanoseconds(std::numeric_limits<std::int64_t>::max())};
};

Result<TimeRange> rangeOf(const CatOptions& options, const LogSummary& summary) {
  TimeRange range;
  if (!options.from.empty()) {
    Result<LogTime> from = parseSessionTime(options.from, summary.origin, summary.end);
    if (!from) return from.error();
    range.from = *from;
  }
  if (!options.until.empty()) {
    Result<LogTime> until = parseSessionTime(options.until, summary.origin, summary.end);
    if (!until) return until.error();
    range.until = *until;
  }
  return range;
}

/// By channel id: whether its messages are wanted.
std::vector<bool> wantedChannels(const CatOptions& options, const LogReader& reader) {
  std::vector<bool> wanted;
  for (const LogChannel& channel : reader.channels()) {
    if (wanted.size() <= channel.id) wanted.resize(channel.id + 1U, false);
    bool chosen = options.channels.empty() && channel.captured();
    for (const std::string& pattern : options.channels) {
      chosen = chosen || ::fnmatch(pattern.c_str(), channel.topic.c_str(), 0) == 0;
    }
    wanted[channel.id] = chosen;
  }
  return wanted;
}

/// RFC 4180: quoted where it must be, quotes doubled.
std::string csvField(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + "\"";
}

class Printer {
 public:
  Printer(const LogReader& reader, const CatOptions& options, const std::vector<bool>& wanted)
      : options_(options), name_(reader.name()), origin_(reader.summary().origin) {
    for (const LogChannel& channel : reader.channels()) {
      if (wanted[channel.id]) {
        topic_width_ = std::max(topic_width_, plainText(channel.topic).size());
      }
    }
  }

  void header(std::string& out) const {
    if (options_.format != CatFormat::csv) return;
    if (options_.name_log) out += "log,";
    out += "log_time_ns,channel,sequence,publish_time_ns,encoding,text,payload_base64\r\n";
  }

  void message(const LogMessage& message, std::string& out) const {
    const std::string& encoding = message.channel->encoding;
    const bool is_text = (encoding == "rk1" || encoding == "json") && isUtf8(message.payload);
    switch (options_.format) {
      case CatFormat::text:
        return text(message, is_text, out);
      case CatFormat::json:
        return json(message, is_text, out);
      case CatFormat::csv:
        return csv(message, is_text, out);
    }
  }

 private:
  void text(const LogMessage& message, bool is_text, std::string& out) const {
    if (options_.name_log) out += plainText(name_) + "  ";
    out += fmt::format("{:>14}  {:<{}}  {:>6}  {}\n", secondsText(message.log_time - origin_, 9),
                       plainText(message.channel->topic), topic_width_, message.sequence,
                       payloadLine(message.payload, is_text));
  }

  void json(const LogMessage& message, bool is_text, std::string& out) const {
    using Json = nlohmann::ordered_json;
    Json line;
    if (options_.name_log) line["log"] = name_;
    line["log_time_ns"] = message.log_time.time_since_epoch().count();
    line["channel"] = message.channel->topic;
    line["sequence"] = message.sequence;
    if (is_text) {
      line["text"] = textOf(message.payload);
    } else {
      line["payload_base64"] = base64Of(message.payload);
    }
    out += line.dump(-1, ' ', false, Json::error_handler_t::replace);
    out += '\n';
  }

  void csv(const LogMessage& message, bool is_text, std::string& out) const {
    if (options_.name_log) out += csvField(name_) + ",";
    out += fmt::format("{},{},{},{},{},{},{}\r\n", message.log_time.time_since_epoch().count(),
                       csvField(message.channel->topic), message.sequence, message.publish_time_ns,
                       csvField(message.channel->encoding),
                       is_text ? csvField(textOf(message.payload)) : std::string(),
                       is_text ? std::string() : base64Of(message.payload));
  }

  const CatOptions& options_;
  const std::string& name_;
  LogTime origin_;
  std::size_t topic_width_ = 0;
};

}  // namespace

Result<std::uint64_t> catLog(LogReader& reader, const CatOptions& options, bool with_header,
                             const TextSink& out) {
  const Result<TimeRange> range = rangeOf(options, reader.summary());
  if (!range) return range.error();
  const std::vector<bool> wanted = wantedChannels(options, reader);
  const Printer printer(reader, options, wanted);
  std::string piece;
  if (with_header) printer.header(piece);
  if (Status found = reader.seek(range->from); !found) return found.error();
  std::uint64_t count = 0;
  while (true) {
    const Result<std::optional<LogMessage>> message = reader.next();
    if (!message) return message.error();
    if (!*message || (*message)->log_time >= range->until) break;
    if (!wanted[(*message)->channel->id]) continue;
    printer.message(**message, piece);
    ++count;
    if (piece.size() < kPieceBytes) continue;
    if (Status written = out(piece); !written) return written.error();
    piece.clear();
  }
  if (Status written = out(piece); !written) return written.error();
  return count;
}

}  // namespace rocinante
