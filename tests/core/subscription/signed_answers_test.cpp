#include <gtest/gtest.h>

#include "core/signing/trust_judge.h"
#include "core/subscription/subscription_desk.h"
#include "tests/core/signing/signing_support.h"

namespace rocinante {
namespace {

/// A relay that signs its answers, and a subscriber that judges them.
class SigningDesk {
 public:
  /// The answer to the request, padded to `least_bytes`.
  std::string ask(SubscriptionVerb verb, double seconds,
                  std::size_t least_bytes = kSubscribeBytes) {
    SubscriptionMessage request;
    request.verb = verb;
    request.id = ++id_;
    request.lease_s = verb == SubscriptionVerb::subscribe ? 9 : 0;
    request.cookie = cookie;
    const std::string text = subscriptionText(request, least_bytes);
    const SteadyTime now{Nanoseconds(static_cast<std::int64_t>(seconds * 1e9))};
    SocketAddress from;
    from.port = 40000;
    return desk.handle(bytesOf(text), from, now).answer;
  }
  /// The same, of an answer that must be trusted.
  SubscriptionMessage trusted(SubscriptionVerb verb, double seconds) {
    const std::string answer = ask(verb, seconds);
    EXPECT_FALSE(judge_.judge(bytesOf(answer), test::wallAt(test::kVectorAt))) << answer;
    return readSubscription(bytesOf(answer)).value();
  }
  bool isSigned(const std::string& answer) const {
    return !answer.empty() && !parseSignature(bytesOf(answer)).fault;
  }

  std::string cookie;
  DatagramSigner signer{test::vectorKey(), [] { return test::wallAt(test::kVectorAt); }};
  SubscriptionDesk desk{[this] {
    SubscriptionDesk::Options options;
    options.relay = "site";
    options.run = "7f3a";
    options.sign = [this](ByteView datagram) { return signer.sign(datagram); };
    return options;
  }()};

 private:
  std::uint64_t id_ = 0;
  TrustJudge judge_{test::trusting(test::vectorKey(), {}, /*is_relay=*/true)};
};

TEST(SignedAnswers, EveryAnswerIsSigned) {
  SigningDesk relay;
  const SubscriptionMessage challenge = relay.trusted(SubscriptionVerb::subscribe, 0);
  EXPECT_EQ(challenge.verb, SubscriptionVerb::challenge);
  relay.cookie = challenge.cookie;
  EXPECT_EQ(relay.trusted(SubscriptionVerb::keep, 1).sentence, "no subscription");
  EXPECT_EQ(relay.trusted(SubscriptionVerb::subscribe, 2).verb, SubscriptionVerb::accepted);
  EXPECT_EQ(relay.trusted(SubscriptionVerb::keep, 3).verb, SubscriptionVerb::kept);
}

TEST(SignedAnswers, ASignedChallengeFitsTheRequest) {
  SigningDesk relay;
  EXPECT_EQ(relay.ask(SubscriptionVerb::subscribe, 0).size(), 208U);
  EXPECT_TRUE(relay.isSigned(relay.ask(SubscriptionVerb::keep, 1, 208)));
  // Never longer than the request: a shorter one gets as much as it has room for.
  EXPECT_EQ(relay.ask(SubscriptionVerb::keep, 2, 207).size(), 75U);
  EXPECT_EQ(relay.ask(SubscriptionVerb::keep, 3, 74).size(), 0U);
}

TEST(SignedAnswers, AFloodGetsNoMoreSignaturesThanAreAffordable) {
  SigningDesk relay;
  int signed_ones = 0;
  for (int i = 0; i < 5000; ++i) {
    const std::string answer = relay.ask(SubscriptionVerb::subscribe, 10);
    ASSERT_FALSE(answer.empty());
    if (relay.isSigned(answer)) ++signed_ones;
  }
  EXPECT_EQ(signed_ones, SubscriptionDesk::kSignedChallengesPerSecond);
  EXPECT_TRUE(relay.isSigned(relay.ask(SubscriptionVerb::subscribe, 10.5)));
}

}  // namespace
}  // namespace rocinante
