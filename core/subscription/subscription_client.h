#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "core/base/bytes.h"
#include "core/base/time.h"
#include "core/net/datagram_source.h"
#include "core/subscription/subscription_text.h"

namespace rocinante {

/// The subscriber's half of docs/subscriptions.md: asks a relay to send, keeps the lease, and asks
/// anew when the relay restarted or fell silent. Pure: no socket, no clock. One request is under
/// way at a time; whatever arrives, in t seconds it sends at most kBurst + kRequestsPerSecond * t
/// of them. Memory is constant. One thread.
class SubscriptionClient {
 public:
  static constexpr int kBurst = 4;
  static constexpr int kRequestsPerSecond = 2;
  /// How long a relay may take to answer before the user learns of it.
  static constexpr Nanoseconds kPatience = std::chrono::seconds(3);
  /// Between requests to a relay that refused.
  static constexpr Nanoseconds kAfterRefusal = std::chrono::seconds(5);

  /// A number for the id of a request. A forger must not be able to guess it.
  using Random = std::function<std::uint64_t()>;

  /// `relay` is a subscribe endpoint. The first request is due at once. `lease_s` is asked for; a
  /// relay may give less.
  SubscriptionClient(const Endpoint& relay, Random random, SteadyTime now,
                     std::uint32_t lease_s = kMaxLeaseSeconds);

  /// What a datagram is.
  enum class Arrival : std::uint8_t {
    traffic,   ///< from the relay, to be passed on
    answer,    ///< the answer to a request of this client
    ignored,   ///< another RKS1 line: of another request, malformed, not an answer
    stranger,  ///< from another address
  };
  Arrival take(SteadyTime now, const SocketAddress& sender, ByteView datagram);
  /// Instead of take(): what came from the relay's address, and is not trusted. The user learns the
  /// reason when it would have been the answer.
  void noteUntrusted(ByteView datagram, Untrusted reason);

  /// The request to send to the relay now; empty when none is due. Call it after take() and at
  /// least ten times a second.
  std::optional<std::string> nextRequest(SteadyTime now);

  /// What became of the subscription since the last call, as a sentence for the user: accepted, not
  /// answered, not trusted, refused, restarted. Only changes are reported.
  std::optional<std::string> takeNews();

  /// The request that ends a lease, to be sent once; empty when there is none.
  std::optional<std::string> leave();

  bool isSubscribed() const { return phase_ == Phase::subscribed; }
  SubscriptionOutcome outcome() const;

 private:
  enum class Phase : std::uint8_t { asking, subscribed };
  /// What the user was told last.
  enum class Report : std::uint8_t { nothing, subscribed, unanswered, untrusted, refused };

  void askAnew(SteadyTime now);
  void watchLease(SteadyTime now);
  void watchPatience(SteadyTime now);
  void takeAnswer(SteadyTime now, const SubscriptionMessage& answer);
  void accept(SteadyTime now, const SubscriptionMessage& answer);
  void refuse(SteadyTime now, const std::string& sentence);
  void extendLease(std::uint32_t lease_s);
  void tell(Report what, std::string sentence);
  bool spendToken(SteadyTime now);
  SubscriptionMessage request(SubscriptionVerb verb);

  Endpoint relay_;
  Random random_;
  std::uint32_t lease_s_;

  Phase phase_ = Phase::asking;
  std::string cookie_;
  SubscriptionMessage pending_;  ///< the request under way, when has_pending_
  bool has_pending_ = false;
  int attempts_ = 0;         ///< since the last answer; counts to 4
  SteadyTime first_sent_{};  ///< the first attempt of the pending request
  SteadyTime due_;           ///< of the next attempt, or of the next `keep`
  SteadyTime asking_since_;  ///< no lease, and no refusal, since then
  SteadyTime heard_{};       ///< the last datagram of the relay
  SteadyTime lease_until_{};
  Nanoseconds restate_{};               ///< between restatements of the relay; bounded
  std::string relay_run_;               ///< "NAME@RUN" of the last lease
  std::optional<Untrusted> untrusted_;  ///< why the last answer was refused; cleared by a good one
  double tokens_ = kBurst;
  SteadyTime tokens_at_;
  SteadyTime opened_;                          ///< the first request was due
  std::optional<Nanoseconds> accepted_after_;  ///< from opened_ to the first acceptance
  Report reported_ = Report::nothing;
  std::string last_refusal_;  ///< its sentence
  std::optional<std::string> news_;
};

}  // namespace rocinante
