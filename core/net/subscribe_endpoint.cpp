#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/bytes.h"
#include "core/base/min_change.h"
#include "core/base/plain_text.h"
#include "core/net/endpoint_text.h"

namespace rocinante {
namespace {

// As a request to a relay has them (core/subscription/subscription_text.h).
constexpr std::size_t kPatternBytes = 255;

Status setPattern(std::string& pattern, std::string_view name, std::string_view value,
                  std::string_view text) {
  if (!pattern.empty()) return badEndpoint(text, fmt::format("{}= is given twice", name));
  const auto decoded = decodePercent(value);
  if (!decoded) {
    return badEndpoint(text, fmt::format("a % in {}= is written %25, as in URLs", name));
  }
  const bool has_control = std::any_of(decoded->begin(), decoded->end(), isControl);
  if (name == "min-change") {
    MinChange ignored;
    if (const Status added = ignored.addAll(*decoded); !added) {
      return badEndpoint(text, fmt::format("min-change= {}", added.error().what));
    }
  }
  if (decoded->empty() || decoded->size() > kPatternBytes || has_control ||
      !isUtf8(bytesOf(*decoded))) {
    return badEndpoint(text, fmt::format("{}= takes a pattern of 1 to {} bytes, such as arm*", name,
                                         kPatternBytes));
  }
  pattern = *decoded;
  return {};
}

Status setRate(std::optional<double>& rate, std::string_view value, std::string_view text) {
  if (rate) return badEndpoint(text, "rate= is given twice");
  double hertz = 0;
  const char* const end = value.data() + value.size();
  const auto [read, fault] = std::from_chars(value.data(), end, hertz);
  if (fault != std::errc() || read != end || !std::isfinite(hertz) || hertz <= 0) {
    return badEndpoint(text, "rate= is a number of hertz above 0");
  }
  rate = hertz;
  return {};
}

Status setOption(Endpoint::Selection& selection, std::string_view option, std::string_view text) {
  const std::size_t equals = std::min(option.find('='), option.size());
  const std::string_view name = option.substr(0, equals);
  const std::string_view value = option.substr(std::min(equals + 1, option.size()));
  if (name == "source") return setPattern(selection.source, name, value, text);
  if (name == "device") return setPattern(selection.device, name, value, text);
  if (name == "signal") return setPattern(selection.signal, name, value, text);
  if (name == "min-change") return setPattern(selection.min_change, name, value, text);
  if (name == "rate") return setRate(selection.rate_hz, value, text);
  return badEndpoint(text,
                     "the options of a subscribe:// endpoint are device=, signal=, source=, "
                     "min-change= and rate=");
}

}  // namespace

Result<Endpoint> parseSubscribe(std::string_view text, HostNames names) {
  std::string_view rest = text.substr(kSubscribeScheme.size());
  const std::size_t question = rest.find('?');
  auto address = parseHostPort(rest.substr(0, question), text, names);
  if (!address) return address.error();
  if (address->isAny()) return badEndpoint(text, "subscribe:// needs the relay's host");
  if (address->port == 0) return badEndpoint(text, "subscribe:// needs the relay's port");
  if (address->isMulticast()) {
    return badEndpoint(text, "a relay is asked at an address of its own, not at a group");
  }
  Endpoint endpoint;
  endpoint.scheme = Endpoint::Scheme::subscribe;
  endpoint.address = *address;
  // A pattern may hold a `?`, so only `&` separates.
  for (std::size_t mark = question; mark != rest.npos; mark = rest.find('&')) {
    rest.remove_prefix(mark + 1);
    const std::string_view option = rest.substr(0, rest.find('&'));
    if (Status set = setOption(endpoint.selection, option, text); !set) return set.error();
  }
  return endpoint;
}

std::string subscribeText(const Endpoint& endpoint) {
  std::string text = std::string(kSubscribeScheme) + endpoint.address.text();
  char mark = '?';
  const auto add = [&](std::string_view name, std::string_view value) {
    text += mark;
    text += name;
    text += value;
    mark = '&';
  };
  const Endpoint::Selection& selection = endpoint.selection;
  if (!selection.device.empty()) add("device=", encodePercent(selection.device, "&"));
  if (!selection.signal.empty()) add("signal=", encodePercent(selection.signal, "&"));
  if (!selection.source.empty()) add("source=", encodePercent(selection.source, "&"));
  if (!selection.min_change.empty()) {
    add("min-change=", encodePercent(selection.min_change, "&"));
  }
  if (selection.rate_hz) add("rate=", fmt::format("{}", *selection.rate_hz));
  return text;
}

}  // namespace rocinante
