#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/net/endpoint.h"

namespace rocinante {

/// What a subscriber and a relay say to each other: one line of text a datagram
/// (docs/subscriptions.md). A subscriber sends the first three, a relay the others.
enum class SubscriptionVerb : std::uint8_t {
  subscribe,
  keep,
  leave,
  challenge,  ///< prove that you receive at your address: ask again with this cookie
  accepted,
  kept,
  refused,
};

/// The longest lease that is asked for or given.
inline constexpr std::uint32_t kMaxLeaseSeconds = 30;
/// A `subscribe` shorter than this is ignored, so that no answer is longer than its request.
inline constexpr std::size_t kSubscribeBytes = 256;

/// What a subscriber asks for.
using SubscriptionWish = Endpoint::Selection;

/// One such line, decoded. The verb decides which fields have a meaning; the others keep their
/// defaults and are not written.
struct SubscriptionMessage {
  SubscriptionVerb verb = SubscriptionVerb::subscribe;
  std::uint64_t id = 0;       ///< random for each request; its answer repeats it
  std::uint32_t lease_s = 0;  ///< subscribe, accepted, kept: 1 to kMaxLeaseSeconds
  std::string cookie;         ///< subscribe, keep, leave (empty: none yet), challenge, kept
  SubscriptionWish wish;      ///< subscribe
  double restate_s = 0;       ///< accepted: seconds between restatements; > 0
  std::string relay;          ///< accepted: the relay's NAME
  std::string run;            ///< accepted: its RUN
  std::string sentence;       ///< refused: why
  bool operator==(const SubscriptionMessage&) const = default;
};

/// True for a datagram that begins like such a line. It is never a packet, and never recorded or
/// forwarded.
bool isSubscriptionText(ByteView datagram);

/// Reads one; malformed, with the fault and its column, for anything else. Words that are unknown
/// are skipped; a known one that occurs twice, or is missing where its verb needs it, is malformed.
Result<SubscriptionMessage> readSubscription(ByteView datagram);

/// The line with its LF, padded by a comment line to `least_bytes`.
std::string subscriptionText(const SubscriptionMessage& message, std::size_t least_bytes = 0);

}  // namespace rocinante
