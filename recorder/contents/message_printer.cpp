#include "recorder/contents/message_printer.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/base64.h"
#include "core/base/duration_text.h"
#include "core/base/hash.h"
#include "core/base/plain_text.h"
#include "core/log/log_profile.h"
#include "core/report/json_text.h"

namespace rocinante {
namespace {

constexpr std::size_t kHexBytes = 32;

/// RFC 4180: quoted where necessary, quotes doubled.
std::string csvField(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + "\"";
}

}  // namespace

std::string payloadLine(ByteView payload, bool is_text) {
  if (!is_text) {
    std::string line = hexOf(payload.first(std::min(payload.size(), kHexBytes)));
    if (payload.size() > kHexBytes) line += "...";
    return fmt::format("{} ({} bytes)", line, payload.size());
  }
  std::string_view text = textOf(payload);
  while (text.ends_with('\n') || text.ends_with('\r') || text.ends_with('\0')) {
    text.remove_suffix(1);
  }
  std::string line;
  while (true) {
    const std::size_t end = text.find('\n');
    std::string_view each = text.substr(0, end);
    if (each.ends_with('\r')) each.remove_suffix(1);
    line += plainText(each);
    if (end == std::string_view::npos) return line;
    line += " | ";
    text.remove_prefix(end + 1);
  }
}

void MessagePrinter::makeRoomFor(const LogChannel& channel) {
  topic_width_ = std::max(topic_width_, plainText(channel.topic).size());
}

void MessagePrinter::header(std::string& out) const {
  if (format_ != CatFormat::csv) return;
  if (!name_.empty()) out += "log,";
  out += "log_time_ns,channel,sequence,publish_time_ns,encoding,text,payload_base64\r\n";
}

void MessagePrinter::message(const LogMessage& message, std::string& out) const {
  const std::string& encoding = message.channel->encoding;
  const bool declares_text =
      encoding == "rk1" || encoding == "json" || encoding == profile::kKeyframeEncoding;
  const bool is_text = declares_text && isUtf8(message.payload);
  switch (format_) {
    case CatFormat::text:
      return text(message, is_text, out);
    case CatFormat::json:
      return json(message, is_text, out);
    case CatFormat::csv:
      return csv(message, is_text, out);
  }
}

void MessagePrinter::text(const LogMessage& message, bool is_text, std::string& out) const {
  if (!name_.empty()) out += plainText(name_) + "  ";
  out += fmt::format("{:>14}  {:<{}}  {:>6}  {}\n", secondsText(message.log_time - origin_, 9),
                     plainText(message.channel->topic), topic_width_, message.sequence,
                     payloadLine(message.payload, is_text));
}

void MessagePrinter::json(const LogMessage& message, bool is_text, std::string& out) const {
  Json line;
  if (!name_.empty()) line["log"] = name_;
  line["log_time_ns"] = message.log_time.time_since_epoch().count();
  line["channel"] = message.channel->topic;
  line["sequence"] = message.sequence;
  if (is_text) {
    line["text"] = textOf(message.payload);
  } else {
    line["payload_base64"] = base64Of(message.payload);
  }
  out += jsonText(line, -1);
}

void MessagePrinter::csv(const LogMessage& message, bool is_text, std::string& out) const {
  if (!name_.empty()) out += csvField(name_) + ",";
  out += fmt::format("{},{},{},{},{},{},{}\r\n", message.log_time.time_since_epoch().count(),
                     csvField(message.channel->topic), message.sequence, message.publish_time_ns,
                     csvField(message.channel->encoding),
                     is_text ? csvField(textOf(message.payload)) : std::string(),
                     is_text ? std::string() : base64Of(message.payload));
}

}  // namespace rocinante
