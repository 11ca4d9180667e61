#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <string>

#include "core/base/time.h"
#include "core/subscription/subscription_text.h"

namespace rocinante::test {

/// A relay's half of the protocol in its plainest form, for one subscriber. The cookie is the run.
struct FakeRelay {
  std::string run = "r1";
  std::uint32_t lease_s = 9;
  double restate_s = 2;
  std::string refusal;                           ///< when not empty: the answer to every subscribe
  std::function<std::string(std::string)> sign;  ///< of answers; empty: not signed

  bool has_lease = false;
  SteadyTime lease_until{};
  SubscriptionMessage wanted;  ///< the last subscribe that was accepted
  int accepted = 0, kept = 0, left = 0, challenged = 0;

  void restart(std::string new_run) {
    run = std::move(new_run);
    has_lease = false;
  }
  bool isServing(SteadyTime now) const { return has_lease && now < lease_until; }

  /// The answer to a request; empty for what a relay ignores.
  std::optional<std::string> answer(std::string_view request, SteadyTime now) {
    const auto read = readSubscription(bytesOf(request));
    EXPECT_TRUE(read.ok()) << request;
    if (!read || request.size() < kSubscribeBytes) return std::nullopt;
    SubscriptionMessage answer;
    answer.id = read->id;
    answer.cookie = run;
    if (read->cookie != run) {
      answer.verb = SubscriptionVerb::challenge;
      ++challenged;
    } else if (read->verb == SubscriptionVerb::subscribe && !refusal.empty()) {
      answer.cookie.clear();
      answer.verb = SubscriptionVerb::refused;
      answer.sentence = refusal;
    } else if (read->verb == SubscriptionVerb::subscribe) {
      answer.cookie.clear();
      answer.verb = SubscriptionVerb::accepted;
      answer.lease_s = lease_s;
      answer.restate_s = restate_s;
      answer.relay = "hall";
      answer.run = run;
      wanted = *read;
      has_lease = true;
      ++accepted;
    } else if (read->verb == SubscriptionVerb::leave) {
      has_lease = false;
      ++left;
      return std::nullopt;
    } else if (!isServing(now)) {
      answer.cookie.clear();
      answer.verb = SubscriptionVerb::refused;
      answer.sentence = "no subscription";
    } else {
      answer.verb = SubscriptionVerb::kept;
      answer.lease_s = lease_s;
      ++kept;
    }
    if (has_lease) lease_until = now + std::chrono::seconds(lease_s);
    const std::string text = subscriptionText(answer);
    return sign ? sign(text) : text;
  }
};

}  // namespace rocinante::test
