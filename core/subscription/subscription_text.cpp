#include "core/subscription/subscription_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/min_change.h"
#include "core/packet/packet_text.h"
#include "core/packet/text_lines.h"
#include "core/packet/text_name.h"
#include "core/packet/text_number.h"

namespace rocinante {
namespace {

constexpr std::string_view kVersionWord = "RKS1";
constexpr std::size_t kCookieBytes = 64;

constexpr std::array<std::string_view, 7> kVerbs = {"subscribe", "keep", "leave",  "challenge",
                                                    "accepted",  "kept", "refused"};

/// A pattern holds characters that no name may: only separators, controls and '%' are encoded.
std::optional<std::string> decodePattern(std::string_view raw) {
  std::string pattern;
  for (std::size_t i = 0; i < raw.size(); ++i) {
    if (raw[i] != '%') {
      pattern += raw[i];
      continue;
    }
    const auto byte = readHex(raw.substr(i + 1, 2), 2);
    if (!byte) return std::nullopt;
    pattern += static_cast<char>(*byte);
    i += 2;
  }
  if (!isName(pattern)) return std::nullopt;
  return pattern;
}

void appendPattern(std::string& text, std::string_view pattern) {
  for (const char character : pattern) {
    const auto byte = static_cast<unsigned char>(character);
    if (byte > 0x20 && byte < 0x7F && character != '%') {
      text += character;
    } else {
      text += '%';
      appendHex(text, byte, 2);
    }
  }
}

std::optional<double> readPositive(std::string_view value) {
  const char* at = value.data();
  const char* const end = at + value.size();
  double number = 0;
  if (!readNumber(at, end, number) || at != end || !(number > 0)) return std::nullopt;
  return number;
}

/// Reads the words of one line. Each returns false for a value that its word cannot have.
class WordReader {
 public:
  WordReader(SubscriptionMessage& message, TextArena& arena) : message_(message), arena_(arena) {}

  bool read(std::string_view field) {
    const std::size_t equals = field.find('=');
    if (equals == std::string_view::npos) return true;
    const std::string_view word = field.substr(0, equals);
    const std::string_view value = field.substr(equals + 1);
    if (word == "id") return once(id_) && readId(value);
    if (word == "lease") return once(lease_) && readLease(value);
    if (word == "cookie") return once(cookie_) && readCookie(value);
    if (word == "source") return readPattern(value, message_.wish.source);
    if (word == "device") return readPattern(value, message_.wish.device);
    if (word == "signal") return readPattern(value, message_.wish.signal);
    if (word == "min-change") return readMinChange(value);
    if (word == "rate")
      return !message_.wish.rate_hz && (message_.wish.rate_hz = readPositive(value));
    if (word == "restate") return once(restate_) && readRestate(value);
    if (word == "relay") return once(relay_) && readRelay(value);
    return true;
  }

  /// The first word that the verb needs and the line lacks; empty when it has all.
  std::string_view missing() const {
    if (!id_) return "id";
    switch (message_.verb) {
      case SubscriptionVerb::subscribe:
        return lease_ ? "" : "lease";
      case SubscriptionVerb::challenge:
        return cookie_ ? "" : "cookie";
      case SubscriptionVerb::accepted:
        return !lease_ ? "lease" : !restate_ ? "restate" : !relay_ ? "relay" : "";
      case SubscriptionVerb::kept:
        return !lease_ ? "lease" : !cookie_ ? "cookie" : "";
      default:
        return "";
    }
  }

 private:
  static bool once(bool& seen) { return !std::exchange(seen, true); }

  bool readId(std::string_view value) {
    const auto id = readHex(value, 16);
    message_.id = id.value_or(0);
    return id.has_value();
  }
  bool readLease(std::string_view value) {
    const auto seconds = readUnsigned(value);
    if (!seconds || *seconds == 0 || *seconds > kMaxLeaseSeconds) return false;
    message_.lease_s = static_cast<std::uint32_t>(*seconds);
    return true;
  }
  bool readCookie(std::string_view value) {
    if (value.empty() || value.size() > kCookieBytes) return false;
    if (!std::all_of(value.begin(), value.end(), isNameByte)) return false;
    message_.cookie = value;
    return true;
  }
  static bool readPattern(std::string_view value, std::string& pattern) {
    if (!pattern.empty()) return false;
    auto decoded = decodePattern(value);
    if (!decoded) return false;
    pattern = *std::move(decoded);
    return true;
  }
  bool readMinChange(std::string_view value) {
    MinChange least;
    return readPattern(value, message_.wish.min_change) &&
           least.addAll(message_.wish.min_change).ok();
  }
  bool readRestate(std::string_view value) {
    const auto seconds = readPositive(value);
    message_.restate_s = seconds.value_or(0);
    return seconds.has_value();
  }
  bool readRelay(std::string_view value) {
    const std::size_t at_sign = value.find('@');
    if (at_sign == std::string_view::npos) return false;
    const auto relay = decodeName(value.substr(0, at_sign), arena_);
    const auto run = decodeName(value.substr(at_sign + 1), arena_);
    if (!relay || !run) return false;
    message_.relay = *relay;
    message_.run = *run;
    return true;
  }

  SubscriptionMessage& message_;
  TextArena& arena_;
  bool id_ = false, lease_ = false, cookie_ = false, restate_ = false, relay_ = false;
};

Error malformed(std::string what, std::uint32_t line, std::uint32_t column) {
  return {ErrorKind::damaged, std::move(what), fmt::format("line {}, column {}", line, column)};
}

}  // namespace

bool isSubscriptionText(ByteView datagram) {
  // Every datagram of a listener passes here, and nearly all begin with RK1.
  if (textOf(datagram.first(std::min<std::size_t>(datagram.size(), 3))) == "RK1") return false;
  TextLines lines(textOf(datagram));
  std::string_view line;
  return lines.next(line) && TextFields(line).peek() == kVersionWord;
}

Result<SubscriptionMessage> readSubscription(ByteView datagram) {
  TextLines lines(textOf(datagram));
  std::string_view line;
  if (!isSubscriptionText(datagram) || !lines.next(line)) {
    return malformed("not a subscription line: it does not begin with RKS1", 1, 1);
  }
  TextArena arena;
  arena.begin(line.size());
  TextFields fields(line);
  fields.take();
  SubscriptionMessage message;
  const std::string_view verb = fields.take();
  const auto* const known = std::find(kVerbs.begin(), kVerbs.end(), verb);
  const auto fault = [&](std::string what, std::string_view field) {
    const char* const place = field.empty() ? line.data() + line.size() : field.data();
    return malformed(std::move(what), lines.number(), fields.columnOf(place));
  };
  if (known == kVerbs.end()) return fault("not a verb of version 1", verb);
  message.verb = static_cast<SubscriptionVerb>(known - kVerbs.begin());
  WordReader words(message, arena);
  while (!fields.atEnd()) {
    const std::string_view field = fields.peek();
    if (field.front() == '"') {
      const auto sentence = decodeString(fields.at(), fields.end(), arena);
      if (!sentence || !fields.atSeparator() || message.verb != SubscriptionVerb::refused ||
          !message.sentence.empty() || sentence->empty()) {
        return fault("a malformed sentence", field);
      }
      message.sentence = *sentence;
      continue;
    }
    fields.skip(field);
    if (!words.read(field)) return fault("a malformed word", field);
  }
  if (const std::string_view missing = words.missing(); !missing.empty()) {
    return fault(fmt::format("{} without {}=", verb, missing), {});
  }
  return message;
}

std::string subscriptionText(const SubscriptionMessage& message, std::size_t least_bytes) {
  std::string text(kVersionWord);
  text += ' ';
  text += kVerbs[static_cast<std::size_t>(message.verb)];
  text += " id=";
  appendHex(text, message.id, 16);
  if (message.lease_s != 0) text += fmt::format(" lease={}", message.lease_s);
  if (message.verb == SubscriptionVerb::accepted) {
    text += " restate=";
    appendNumber(text, message.restate_s);
    text += " relay=";
    appendName(text, message.relay);
    text += '@';
    appendName(text, message.run);
  }
  for (const auto& [word, pattern] :
       {std::pair<std::string_view, const std::string&>{"source", message.wish.source},
        {"device", message.wish.device},
        {"signal", message.wish.signal},
        {"min-change", message.wish.min_change}}) {
    if (pattern.empty()) continue;
    text += fmt::format(" {}=", word);
    appendPattern(text, pattern);
  }
  if (message.wish.rate_hz) {
    text += " rate=";
    appendNumber(text, *message.wish.rate_hz);
  }
  if (!message.cookie.empty()) text += " cookie=" + message.cookie;
  if (message.verb == SubscriptionVerb::refused && !message.sentence.empty()) {
    text += ' ';
    appendString(text, message.sentence);
  }
  text += '\n';
  if (text.size() < least_bytes) {
    text += '#';
    if (text.size() + 1 < least_bytes) text.append(least_bytes - text.size() - 1, '.');
    text += '\n';
  }
  return text;
}

}  // namespace rocinante
