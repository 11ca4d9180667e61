#include "core/net/datagram_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "core/report/account.h"

namespace rocinante {

Account DatagramSource::leftOut() const { return {}; }

std::string boundText(const Endpoint& endpoint, const SocketAddress& bound) {
  if (endpoint.isSubscription()) return endpoint.text();
  Endpoint shown = endpoint;
  shown.address.port = bound.port;
  return shown.text();
}

std::string_view nameOf(Untrusted reason) {
  static constexpr std::array<std::string_view, kUntrustedReasons> kNames = {
      "not_signed", "malformed", "unknown_key", "not_allowed", "out_of_time", "repeated", "forged"};
  return kNames[static_cast<std::size_t>(reason)];
}

std::uint64_t UntrustedCounts::total() const {
  return std::accumulate(by_reason.begin(), by_reason.end(), std::uint64_t{0});
}

UntrustedCounts& UntrustedCounts::operator+=(const UntrustedCounts& others) {
  for (std::size_t i = 0; i < kUntrustedReasons; ++i) by_reason[i] += others.by_reason[i];
  return *this;
}

std::string UntrustedCounts::text() const {
  std::string text;
  for (std::size_t i = 0; i < kUntrustedReasons; ++i) {
    if (by_reason[i] == 0) continue;
    std::string words(nameOf(static_cast<Untrusted>(i)));
    std::replace(words.begin(), words.end(), '_', ' ');
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", by_reason[i], words);
  }
  return text;
}

std::string boundText(const DatagramSource& source) {
  return boundText(source.endpoint(), source.boundAddress());
}

std::optional<std::string> neverAcceptedText(const DatagramSource& source) {
  const std::optional<SubscriptionOutcome> subscription = source.subscription();
  if (!subscription || subscription->accepted_after) return std::nullopt;
  return boundText(source) + ": " + subscription->trouble;
}

}  // namespace rocinante
