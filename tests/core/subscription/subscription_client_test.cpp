#include "core/subscription/subscription_client.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "tests/core/subscription/fake_relay.h"

namespace rocinante {
namespace {

using std::chrono::milliseconds;
using test::FakeRelay;
using Arrival = SubscriptionClient::Arrival;

constexpr Nanoseconds kStep = milliseconds(50);

/// A client and a relay with nothing between them, in simulated time.
class Conversation {
 public:
  explicit Conversation(std::string_view endpoint = "subscribe://10.0.0.1:19961")
      : endpoint_(Endpoint::parse(endpoint).value()),
        client_(
            endpoint_, [this] { return next_id_ += 0x9E3779B97F4A7C15U; }, now_) {}

  void run(Nanoseconds time) {
    for (const SteadyTime end = now_ + time; now_ < end; now_ += kStep) step();
  }
  void step() {
    if (relay_speaks && relay.isServing(now_)) from("RK1 arm 1 -\n");
    // Each answer may be followed by a request at once.
    while (const auto request = client_.nextRequest(now_)) {
      requests.push_back(*request);
      sent_at.push_back(now_);
      const auto answer = relay_answers ? relay.answer(*request, now_) : std::nullopt;
      if (!answer) continue;
      EXPECT_EQ(from(*answer), Arrival::answer) << *answer;
    }
    if (const auto told = client_.takeNews()) news.push_back(*told);
  }
  Arrival from(std::string_view datagram) {
    return client_.take(now_, endpoint_.address, bytesOf(datagram));
  }
  Arrival fromElsewhere(std::string_view datagram, std::uint16_t port) {
    SocketAddress elsewhere = endpoint_.address;
    elsewhere.port = port;
    return client_.take(now_, elsewhere, bytesOf(datagram));
  }
  SubscriptionMessage request(std::size_t index) const {
    return readSubscription(bytesOf(requests.at(index))).value();
  }
  SubscriptionClient& client() { return client_; }

  FakeRelay relay;
  bool relay_answers = true;
  bool relay_speaks = true;
  std::vector<std::string> requests, news;
  std::vector<SteadyTime> sent_at;

 private:
  SteadyTime now_{std::chrono::seconds(1'000)};
  std::uint64_t next_id_ = 1;
  Endpoint endpoint_;
  SubscriptionClient client_;
};

TEST(SubscriptionClient, SubscribesWithTheCookieOfTheChallenge) {
  Conversation talk(
      "subscribe://10.0.0.1:19961?device=arm*&signal=arm%20*&source=cell%20?&"
      "min-change=signal=2&rate=2.5");
  talk.step();
  ASSERT_EQ(talk.requests.size(), 2U);
  EXPECT_EQ(talk.request(0).cookie, "");
  EXPECT_EQ(talk.request(1).cookie, "r1");
  EXPECT_NE(talk.request(0).id, talk.request(1).id);
  EXPECT_EQ(talk.relay.wanted.wish.device, "arm*");
  EXPECT_EQ(talk.relay.wanted.wish.source, "cell ?");
  EXPECT_EQ(talk.relay.wanted.wish.signal, "arm *");
  EXPECT_EQ(talk.relay.wanted.wish.min_change, "signal=2");
  EXPECT_EQ(talk.relay.wanted.wish.rate_hz, 2.5);
  EXPECT_EQ(talk.relay.wanted.lease_s, kMaxLeaseSeconds);
  EXPECT_TRUE(talk.client().isSubscribed());
  EXPECT_EQ(talk.news, (std::vector<std::string>{
                           "subscribed to relay hall at subscribe://10.0.0.1:19961?device=arm*&"
                           "signal=arm%20*&source=cell%20?&min-change=signal=2&rate=2.5"}));
}

TEST(SubscriptionClient, KeepsTheLeaseAtEveryThirdOfIt) {
  Conversation talk;
  talk.run(std::chrono::seconds(31));
  EXPECT_EQ(talk.relay.accepted, 1);
  EXPECT_EQ(talk.relay.kept, 10);
  EXPECT_EQ(talk.requests.size(), 12U);
  EXPECT_EQ(talk.news.size(), 1U);
}

TEST(SubscriptionClient, KeepsEachSecondUntilKept) {
  Conversation talk;
  talk.run(std::chrono::seconds(1));
  talk.relay_answers = false;
  const std::size_t before = talk.requests.size();
  talk.run(milliseconds(5'500));
  // At 3 s and each second after, with traffic all the time.
  ASSERT_EQ(talk.requests.size(), before + 4);
  for (std::size_t i = before; i < talk.requests.size(); ++i) {
    EXPECT_EQ(talk.request(i).verb, SubscriptionVerb::keep);
    EXPECT_EQ(talk.sent_at[i] - talk.sent_at[before], (i - before) * std::chrono::seconds(1));
  }
  talk.relay_answers = true;
  talk.run(std::chrono::seconds(5));
  EXPECT_EQ(talk.relay.accepted, 1);
  EXPECT_GE(talk.relay.kept, 1);
}

TEST(SubscriptionClient, ALeaseThatRanOutIsAskedForAnew) {
  Conversation talk;
  talk.run(std::chrono::seconds(1));
  talk.relay_answers = false;
  talk.run(std::chrono::seconds(10));
  talk.relay_answers = true;
  talk.run(std::chrono::seconds(5));
  EXPECT_EQ(talk.relay.accepted, 2);
  EXPECT_TRUE(talk.client().isSubscribed());
}

TEST(SubscriptionClient, ARelayThatRestartedIsSubscribedToAgain) {
  Conversation talk;
  talk.run(std::chrono::seconds(1));
  talk.relay.restart("r2");
  talk.run(std::chrono::seconds(3));
  EXPECT_EQ(talk.relay.accepted, 2);
  EXPECT_EQ(talk.news.back(),
            "relay hall at subscribe://10.0.0.1:19961 was restarted; subscribed again");
  EXPECT_EQ(talk.news.size(), 2U);
}

TEST(SubscriptionClient, ARelayThatForgotTheLeaseIsAskedAtOnceAndSilently) {
  Conversation talk;
  talk.run(std::chrono::seconds(1));
  talk.relay.has_lease = false;
  talk.run(std::chrono::seconds(3));
  EXPECT_EQ(talk.relay.accepted, 2);
  EXPECT_EQ(talk.news.size(), 1U);
}

TEST(SubscriptionClient, AQuietRelayIsOnlyAskedWhetherItIsThere) {
  Conversation talk;
  talk.relay_speaks = false;
  talk.run(std::chrono::seconds(60));
  EXPECT_EQ(talk.relay.accepted, 1);
  EXPECT_LE(talk.requests.size(), 33U);
  EXPECT_EQ(talk.news.size(), 1U);
}

TEST(SubscriptionClient, SilenceForTwoRestatementsIsAskedAboutAnew) {
  Conversation talk;
  talk.run(std::chrono::seconds(1));
  talk.relay_answers = talk.relay_speaks = false;
  talk.run(milliseconds(3'800));
  EXPECT_TRUE(talk.client().isSubscribed());
  talk.run(milliseconds(300));
  EXPECT_FALSE(talk.client().isSubscribed());
  EXPECT_EQ(talk.request(talk.requests.size() - 1).verb, SubscriptionVerb::subscribe);
}

TEST(SubscriptionClient, ARelayThatIsAwayIsReportedOnce) {
  Conversation talk;
  talk.relay_answers = false;
  talk.run(std::chrono::seconds(60));
  EXPECT_EQ(talk.news, (std::vector<std::string>{"subscribe://10.0.0.1:19961 does not answer; "
                                                 "nothing is received until it does"}));
  EXPECT_GE(talk.requests.size(), 58U);
  EXPECT_LE(talk.requests.size(), 66U);
  talk.relay_answers = true;
  talk.run(std::chrono::seconds(2));
  EXPECT_EQ(talk.news.back(), "subscribed to relay hall at subscribe://10.0.0.1:19961");
  talk.relay_answers = talk.relay_speaks = false;
  talk.run(std::chrono::seconds(20));
  talk.relay_answers = true;
  talk.run(std::chrono::seconds(2));
  ASSERT_EQ(talk.news.size(), 4U);
  EXPECT_EQ(talk.news[3], "subscribed to relay hall at subscribe://10.0.0.1:19961 again");
}

TEST(SubscriptionClient, TheOutcomeNamesTheFirstAcceptance) {
  Conversation talk;
  EXPECT_EQ(talk.client().outcome().accepted_after, std::nullopt);
  talk.relay_answers = false;
  talk.run(milliseconds(500));
  talk.relay_answers = true;
  // Asked at 0, 0.25, 0.75 s.
  talk.run(std::chrono::seconds(1));
  EXPECT_EQ(talk.client().outcome().accepted_after, Nanoseconds(milliseconds(750)));
  EXPECT_EQ(talk.client().outcome().trouble, "");
  talk.relay.restart("r2");
  talk.run(std::chrono::seconds(5));
  EXPECT_EQ(talk.client().outcome().accepted_after, Nanoseconds(milliseconds(750)));
}

TEST(SubscriptionClient, TheOutcomeSaysWhyItWasNeverAcceptedBeforeTheUserLearnsOfIt) {
  Conversation silent;
  silent.relay_answers = false;
  silent.run(milliseconds(200));
  EXPECT_TRUE(silent.news.empty());
  EXPECT_EQ(silent.client().outcome().trouble, "never answered");
  Conversation refused;
  refused.relay.refusal = "full\u202E";
  refused.run(milliseconds(200));
  EXPECT_EQ(refused.client().outcome().trouble, "never accepted, it refused: full\\xe2\\x80\\xae");
  EXPECT_EQ(refused.client().outcome().accepted_after, std::nullopt);
}

TEST(SubscriptionClient, ARefusalIsReportedOnceAndRetriedSlowly) {
  Conversation talk;
  talk.relay.refusal = "full\u202E";  // right to left from here
  talk.run(std::chrono::seconds(31));
  EXPECT_EQ(talk.news,
            (std::vector<std::string>{"subscribe://10.0.0.1:19961 refused: full\\xe2\\x80\\xae; "
                                      "asking again every 5 s"}));
  EXPECT_EQ(talk.requests.size(), 1U + 7U);
  talk.relay.refusal = "closed on sundays";
  talk.run(std::chrono::seconds(10));
  EXPECT_EQ(talk.news.size(), 2U);
  talk.relay.refusal.clear();
  talk.run(std::chrono::seconds(6));
  EXPECT_TRUE(talk.client().isSubscribed());
  EXPECT_EQ(talk.news.size(), 3U);
}

TEST(SubscriptionClient, WhatIsNotAnAnswerIsIgnored) {
  Conversation talk;
  talk.relay_answers = false;
  talk.step();
  SubscriptionMessage answer;
  answer.verb = SubscriptionVerb::accepted;
  answer.id = talk.request(0).id;
  answer.lease_s = 30;
  answer.restate_s = 2;
  answer.relay = "forged";
  answer.run = "r";
  EXPECT_EQ(talk.fromElsewhere(subscriptionText(answer), 19'962), Arrival::stranger);
  EXPECT_EQ(talk.fromElsewhere("RK1 arm 1 -\n", 19'962), Arrival::stranger);
  answer.id += 1;
  EXPECT_EQ(talk.from(subscriptionText(answer)), Arrival::ignored);
  EXPECT_EQ(talk.from("RKS1 accepted id=zz"), Arrival::ignored);
  EXPECT_EQ(talk.from(talk.requests[0]), Arrival::ignored);
  answer.id = talk.request(0).id;
  answer.verb = SubscriptionVerb::kept;
  answer.cookie = "c";
  EXPECT_EQ(talk.from(subscriptionText(answer)), Arrival::ignored);
  EXPECT_FALSE(talk.client().isSubscribed());
  EXPECT_EQ(talk.from("RK1 arm 1 -\n"), Arrival::traffic);
  EXPECT_EQ(talk.from(""), Arrival::traffic);
}

TEST(SubscriptionClient, AnAnswerThatIsRepeatedCountsOnce) {
  Conversation talk;
  talk.relay_answers = false;
  talk.step();
  const std::string challenge = talk.relay.answer(talk.requests[0], SteadyTime()).value();
  EXPECT_EQ(talk.from(challenge), Arrival::answer);
  EXPECT_EQ(talk.from(challenge), Arrival::ignored);
  talk.step();
  EXPECT_EQ(talk.requests.size(), 2U);
}

TEST(SubscriptionClient, RequestsArePaddedAndNumberedAnew) {
  Conversation talk;
  talk.run(std::chrono::seconds(60));
  std::set<std::uint64_t> ids;
  for (std::size_t i = 0; i < talk.requests.size(); ++i) {
    EXPECT_EQ(talk.requests[i].size(), kSubscribeBytes);
    ids.insert(talk.request(i).id);
  }
  EXPECT_EQ(ids.size(), talk.requests.size());
}

TEST(SubscriptionClient, LeavesWhenItMayHaveALease) {
  Conversation talk;
  EXPECT_FALSE(talk.client().leave().has_value());
  talk.step();
  const auto leave = talk.client().leave();
  ASSERT_TRUE(leave.has_value());
  EXPECT_EQ(readSubscription(bytesOf(*leave))->verb, SubscriptionVerb::leave);
  EXPECT_EQ(readSubscription(bytesOf(*leave))->cookie, "r1");
}

TEST(SubscriptionClient, AnyRestatementAndLeaseOfARelayIsSurvived) {
  for (const double restate : {1e-300, 0.01, 1e9, 1e300}) {
    SCOPED_TRACE(restate);
    Conversation talk;
    talk.relay.restate_s = restate;
    talk.relay.lease_s = 1;
    talk.run(std::chrono::seconds(20));
    EXPECT_LE(talk.requests.size(), 4U + 40U);
    EXPECT_EQ(talk.news.size(), 1U);
  }
}

}  // namespace
}  // namespace rocinante
