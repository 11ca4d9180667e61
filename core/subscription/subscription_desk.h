#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/base/time.h"
#include "core/net/address_filter.h"
#include "core/subscription/subscription_cookie.h"
#include "core/subscription/subscription_text.h"

namespace rocinante {

/// The relay's half of docs/subscriptions.md: answers requests and keeps the leases. Opens no
/// socket and reads no clock. Memory is bounded: nothing is kept of an address without a valid
/// cookie, and at most Options::subscribers + Options::departed addresses with one. One thread.
class SubscriptionDesk {
 public:
  struct Options {
    std::string relay;     ///< NAME
    std::string run;       ///< chosen anew at each start
    double restate_s = 2;  ///< told to subscribers: seconds between restatements
    AddressFilter allow;   ///< others are refused
    std::size_t subscribers = 1024;
    std::size_t of_host = 256;  ///< subscriptions of one IP address, or of one IPv6 network (/64)
    /// Addresses that left, or that asked without a subscription, remembered for kGreetingGap; of
    /// one host at most half.
    std::size_t departed = 4096;
    /// Signs an answer; what it returns is valid until its next call. Empty: nothing is signed.
    std::function<ByteView(ByteView)> sign{};
  };
  /// Between greetings to one address.
  static constexpr Nanoseconds kGreetingGap = std::chrono::seconds(5);
  /// Requests that one proven address may send in a second; more are not answered.
  static constexpr double kRequestsPerSecond = 20;
  /// Challenges that are signed in a second, so that a flood of forged requests costs no more than
  /// a few percent of a core; further ones are sent unsigned.
  static constexpr double kSignedChallengesPerSecond = 1000;

  struct Outcome {
    enum class Change {
      none,
      begun,     ///< a new subscriber
      replaced,  ///< it subscribed anew, with another wish
      repeated,  ///< it subscribed anew, with the same wish
      ended,     ///< it left
    };
    std::string answer;  ///< to the sender; empty: none
    Change change = Change::none;
    SubscriptionWish wish;  ///< begun, replaced, repeated
    bool greet = false;     ///< send it the state, after the answer
  };
  struct Counts {
    std::uint64_t requests = 0;    ///< well formed
    std::uint64_t malformed = 0;   ///< not a request
    std::uint64_t challenged = 0;  ///< without a valid cookie, answered with one
    std::uint64_t ignored = 0;     ///< too short, or too many of one address or host
    std::uint64_t refused = 0;
    std::uint64_t bytes_in = 0;
    std::uint64_t bytes_out = 0;  ///< of answers
  };

  explicit SubscriptionDesk(Options options) : SubscriptionDesk(std::move(options), CookieMint()) {}
  SubscriptionDesk(Options options, CookieMint mint);

  /// `now` must not go back.
  Outcome handle(ByteView datagram, const SocketAddress& from, SteadyTime now);
  /// The subscribers whose lease has run out, which are forgotten.
  std::vector<SocketAddress> expire(SteadyTime now);

  std::size_t subscribers() const { return subscribers_; }
  const Counts& counts() const { return counts_; }

 private:
  struct Guest {
    bool subscribed = false;
    std::uint32_t lease_s = 0;
    SteadyTime until{};  ///< of the lease; without one: when it may be forgotten
    std::optional<SteadyTime> greeted;
    SubscriptionWish wish;
    double requests = kRequestsPerSecond;  ///< that it may send now
    SteadyTime asked{};
  };
  struct AddressHash {
    std::size_t operator()(const SocketAddress& address) const;
  };
  using Guests = std::unordered_map<SocketAddress, Guest, AddressHash>;
  struct Host {
    std::size_t subscribers = 0, others = 0;
  };
  using HostKey = std::array<std::uint8_t, 17>;

  Outcome judge(ByteView datagram, const SocketAddress& from, SteadyTime now);
  Outcome subscribe(const SubscriptionMessage& request, Guests::value_type& guest, SteadyTime now);
  Outcome keep(const SubscriptionMessage& request, Guests::value_type& guest, SteadyTime now);
  Outcome leave(Guests::value_type& guest, SteadyTime now);
  static HostKey hostOf(const SocketAddress& address);
  /// The address, which has a valid cookie; null when there is no room to remember it.
  Guests::value_type* guestFor(const SocketAddress& from, SteadyTime now);
  void setSubscribed(Guests::value_type& guest, bool subscribed);
  std::string written(const SubscriptionMessage& answer) const;
  Outcome challenge(const SubscriptionMessage& request, std::size_t request_bytes,
                    const SocketAddress& from, SteadyTime now);
  Outcome refuse(const SubscriptionMessage& request, std::string sentence);
  void forgetDeparted(SteadyTime now);
  static bool mayAsk(Guest& guest, SteadyTime now);
  bool maySignChallenge(SteadyTime now);

  Options options_;
  CookieMint mint_;
  Guests guests_;
  std::map<HostKey, Host> hosts_;
  std::size_t subscribers_ = 0;
  SteadyTime swept_{};
  double signable_challenges_ = kSignedChallengesPerSecond;
  SteadyTime challenged_{};
  Counts counts_;
};

}  // namespace rocinante
