#include "core/subscription/subscription_desk.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

using Change = SubscriptionDesk::Outcome::Change;

SteadyTime at(double seconds) {
  return SteadyTime(Nanoseconds(static_cast<std::int64_t>(seconds * 1e9)));
}

SocketAddress addressOf(std::uint32_t number, std::uint16_t port = 40000) {
  SocketAddress address;
  address.address = {127, static_cast<std::uint8_t>(number >> 16U),
                     static_cast<std::uint8_t>(number >> 8U), static_cast<std::uint8_t>(number)};
  address.port = port;
  return address;
}

SubscriptionDesk::Options smallDesk() {
  SubscriptionDesk::Options options;
  options.relay = "site";
  options.run = "7f3a";
  return options;
}

/// A client that asks and remembers its cookie.
struct Client {
  SubscriptionDesk& desk;
  SocketAddress address;
  std::string cookie;
  std::uint64_t id = 0;

  SubscriptionDesk::Outcome ask(SubscriptionVerb verb, double seconds, SubscriptionWish wish = {}) {
    SubscriptionMessage request;
    request.verb = verb;
    request.id = ++id;
    request.cookie = cookie;
    if (verb == SubscriptionVerb::subscribe) {
      request.lease_s = 9;
      request.wish = std::move(wish);
    }
    const std::string text = subscriptionText(request, kSubscribeBytes);
    SubscriptionDesk::Outcome outcome = desk.handle(bytesOf(text), address, at(seconds));
    if (const auto answer = readSubscription(bytesOf(outcome.answer)); answer) {
      EXPECT_EQ(answer->id, id);
      if (!answer->cookie.empty()) cookie = answer->cookie;
    }
    return outcome;
  }
  SubscriptionDesk::Outcome join(double seconds, const SubscriptionWish& wish = {}) {
    ask(SubscriptionVerb::subscribe, seconds, wish);
    return ask(SubscriptionVerb::subscribe, seconds, wish);
  }
};

SubscriptionVerb verbOf(const SubscriptionDesk::Outcome& outcome) {
  return readSubscription(bytesOf(outcome.answer)).value().verb;
}

TEST(SubscriptionDesk, AcceptsAProvenAddressAndGreetsIt) {
  SubscriptionDesk desk(smallDesk());
  Client client{desk, addressOf(1), {}};
  auto outcome = client.ask(SubscriptionVerb::subscribe, 0, {"s", "d*", 5.0});
  EXPECT_EQ(verbOf(outcome), SubscriptionVerb::challenge);
  EXPECT_EQ(desk.subscribers(), 0U);
  outcome = client.ask(SubscriptionVerb::subscribe, 0.1, {"s", "d*", 5.0});
  EXPECT_EQ(verbOf(outcome), SubscriptionVerb::accepted);
  EXPECT_EQ(outcome.change, Change::begun);
  EXPECT_TRUE(outcome.greet);
  EXPECT_EQ(outcome.wish, (SubscriptionWish{"s", "d*", 5.0}));
}

TEST(SubscriptionDesk, SubscribingAgainReplacesAndGreetsOnceInFiveSeconds) {
  SubscriptionDesk desk(smallDesk());
  Client client{desk, addressOf(1), {}};
  client.join(0);
  auto outcome = client.ask(SubscriptionVerb::subscribe, 1);
  EXPECT_EQ(outcome.change, Change::repeated);
  EXPECT_FALSE(outcome.greet);
  outcome = client.ask(SubscriptionVerb::subscribe, 2, {{}, "arm", {}});
  EXPECT_EQ(outcome.change, Change::replaced);
  EXPECT_FALSE(outcome.greet);
  client.ask(SubscriptionVerb::leave, 3);
  EXPECT_FALSE(client.ask(SubscriptionVerb::subscribe, 4).greet);
  EXPECT_TRUE(client.ask(SubscriptionVerb::subscribe, 5).greet);
  EXPECT_EQ(desk.subscribers(), 1U);
}

TEST(SubscriptionDesk, ALeaseRunsOutUnlessItIsKept) {
  SubscriptionDesk desk(smallDesk());
  Client kept{desk, addressOf(1), {}};
  Client lost{desk, addressOf(2), {}};
  kept.join(0);
  lost.join(0);
  EXPECT_EQ(verbOf(kept.ask(SubscriptionVerb::keep, 3)), SubscriptionVerb::kept);
  EXPECT_TRUE(desk.expire(at(8.9)).empty());
  EXPECT_EQ(desk.expire(at(9.1)), std::vector{lost.address});
  EXPECT_EQ(verbOf(lost.ask(SubscriptionVerb::keep, 9.2)), SubscriptionVerb::refused);
  EXPECT_EQ(desk.expire(at(12.1)), std::vector{kept.address});
  EXPECT_EQ(desk.subscribers(), 0U);
}

TEST(SubscriptionDesk, CookiesAreRenewedByKeepingForHours) {
  SubscriptionDesk desk(smallDesk());
  Client client{desk, addressOf(1), {}};
  client.join(0);
  for (int s = 3; s < 7200; s += 3) {
    ASSERT_EQ(verbOf(client.ask(SubscriptionVerb::keep, s)), SubscriptionVerb::kept) << s;
    ASSERT_TRUE(desk.expire(at(s)).empty());
  }
}

TEST(SubscriptionDesk, LeavingEndsOnceAndHasNoAnswer) {
  SubscriptionDesk desk(smallDesk());
  Client client{desk, addressOf(1), {}};
  client.join(0);
  auto outcome = client.ask(SubscriptionVerb::leave, 1);
  EXPECT_EQ(outcome.change, Change::ended);
  EXPECT_TRUE(outcome.answer.empty());
  EXPECT_EQ(client.ask(SubscriptionVerb::leave, 1).change, Change::none);
}

TEST(SubscriptionDesk, RefusesWhenFullOrNotAllowed) {
  SubscriptionDesk::Options options = smallDesk();
  options.subscribers = 2;
  ASSERT_TRUE(options.allow.add("127.0.0.0/24"));
  SubscriptionDesk desk(options);
  Client first{desk, addressOf(1), {}}, second{desk, addressOf(2), {}};
  Client third{desk, addressOf(3), {}}, stranger{desk, addressOf(0x100), {}};
  first.join(0);
  second.join(0);
  EXPECT_EQ(verbOf(third.join(0)), SubscriptionVerb::refused);
  EXPECT_EQ(verbOf(stranger.join(0)), SubscriptionVerb::refused);
  EXPECT_EQ(desk.counts().refused, 2U);
  first.ask(SubscriptionVerb::leave, 1);
  EXPECT_EQ(verbOf(third.join(1)), SubscriptionVerb::accepted);
}

TEST(SubscriptionDesk, AnswersAtMostTwentyRequestsASecondOfOneAddress) {
  SubscriptionDesk desk(smallDesk());
  Client client{desk, addressOf(1), {}};
  client.join(0);
  int answered = 0;
  for (int i = 0; i < 1000; ++i) {
    answered += client.ask(SubscriptionVerb::keep, 0.001 * i).answer.empty() ? 0 : 1;
  }
  EXPECT_GE(answered, 30);
  EXPECT_LE(answered, 40);
}

// With a valid cookie, and without a subscription: refused, or not allowed.
TEST(SubscriptionDesk, AnswersNoMoreToAnAddressThatHasNoSubscription) {
  for (const bool is_allowed : {true, false}) {
    SubscriptionDesk::Options options = smallDesk();
    if (!is_allowed) {
      ASSERT_TRUE(options.allow.add("192.0.2.0/24"));
    }
    SubscriptionDesk desk(options);
    Client client{desk, addressOf(1), {}};
    client.ask(SubscriptionVerb::keep, 0);
    int answered = 0;
    for (int i = 0; i < 1000; ++i) {
      answered += client.ask(SubscriptionVerb::keep, 0.001 * i).answer.empty() ? 0 : 1;
    }
    EXPECT_GE(answered, 30);
    EXPECT_LE(answered, 40);
    EXPECT_EQ(desk.counts().ignored, 1000U - static_cast<unsigned>(answered));
  }
}

TEST(SubscriptionDesk, OneHostDoesNotTakeAllSubscriptions) {
  SubscriptionDesk::Options options = smallDesk();
  options.of_host = 3;
  SubscriptionDesk desk(options);
  const auto from = [](const char* host, int port) {
    return SocketAddress::parse(host, static_cast<std::uint16_t>(port)).value();
  };
  const auto joins = [&](const SocketAddress& address) {
    Client client{desk, address, {}};
    return verbOf(client.join(0)) == SubscriptionVerb::accepted;
  };
  for (int port = 1; port <= 3; ++port) {
    EXPECT_TRUE(joins(from("192.0.2.1", port)));
    EXPECT_TRUE(joins(from(("2001:db8::" + std::to_string(port)).c_str(), 1)));
  }
  EXPECT_FALSE(joins(from("192.0.2.1", 4)));
  EXPECT_FALSE(joins(from("2001:db8::ffff", 1))) << "a host has a network of its own";
  EXPECT_TRUE(joins(from("192.0.2.2", 1)));
  EXPECT_TRUE(joins(from("2001:db8:0:1::1", 1)));
  Client again{desk, from("192.0.2.1", 1), {}};
  EXPECT_EQ(verbOf(again.join(1)), SubscriptionVerb::accepted);
  again.ask(SubscriptionVerb::leave, 1);
  EXPECT_TRUE(joins(from("192.0.2.1", 4)));
}

// A host that asks from all of its ports leaves room for others.
TEST(SubscriptionDesk, OneHostDoesNotTakeAllMemory) {
  SubscriptionDesk::Options options = smallDesk();
  options.departed = 20;
  SubscriptionDesk desk(options);
  SocketAddress greedy = addressOf(1);
  for (int port = 1; port < 2000; ++port) {
    greedy.port = static_cast<std::uint16_t>(port);
    Client client{desk, greedy, {}};
    client.ask(SubscriptionVerb::keep, 0);
    client.ask(SubscriptionVerb::keep, 0);
  }
  EXPECT_EQ(desk.counts().refused, 10U);
  Client other{desk, addressOf(2), {}};
  EXPECT_EQ(verbOf(other.join(0)), SubscriptionVerb::accepted);
}

TEST(SubscriptionDesk, IgnoresShortSubscriptionsAndWhatIsNoRequest) {
  SubscriptionDesk desk(smallDesk());
  for (const char* text : {"RKS1 subscribe id=0000000000000001 lease=9\n", "RK1 arm 1 -\n", "",
                           "RKS1 accepted id=0000000000000001 lease=9 restate=2 relay=a@b\n",
                           "RKS1 keep id=0000000000000001\n"}) {
    EXPECT_TRUE(desk.handle(bytesOf(text), addressOf(1), at(0)).answer.empty()) << text;
  }
  EXPECT_EQ(desk.counts().malformed, 3U);
  EXPECT_EQ(desk.counts().ignored, 2U);
}

// Forged requests, also in the name of the true subscriber.
TEST(SubscriptionDesk, AFloodOfForgedRequestsCostsNothingAndEndsNoLease) {
  SubscriptionDesk desk(smallDesk());
  Client client{desk, addressOf(0xFFFFFF), {}};
  client.join(0);
  SubscriptionMessage forged;
  forged.lease_s = 30;
  forged.cookie = std::string(CookieMint::kTextBytes, 'a');
  for (std::uint32_t i = 0; i < 100'000; ++i) {
    const double now = i * 5e-5;
    forged.id = i;
    forged.verb = static_cast<SubscriptionVerb>(i % 3);
    const std::size_t bytes = i % 7 == 0 ? 0 : kSubscribeBytes;
    const std::string text = subscriptionText(forged, bytes);
    // The true subscriber's own address is forged too.
    const SocketAddress from = i % 100 == 0 ? client.address : addressOf(i % 65'536);
    const auto outcome = desk.handle(bytesOf(text), from, at(now));
    ASSERT_LE(outcome.answer.size(), text.size());
    ASSERT_EQ(outcome.change, Change::none);
    if (i % 1000 == 0) {
      ASSERT_TRUE(desk.expire(at(now)).empty());
    }
    if (i % 30'000 == 29'999) {
      ASSERT_EQ(verbOf(client.ask(SubscriptionVerb::keep, now)), SubscriptionVerb::kept);
    }
  }
  EXPECT_EQ(desk.subscribers(), 1U);
  EXPECT_EQ(verbOf(client.ask(SubscriptionVerb::keep, 5.1)), SubscriptionVerb::kept);
}

TEST(SubscriptionDesk, ThoseThatComeAndLeaveAreRememberedWithinALimit) {
  SubscriptionDesk::Options options = smallDesk();
  options.subscribers = 10;
  options.departed = 20;
  SubscriptionDesk desk(options);
  int refused = 0;
  for (std::uint32_t i = 0; i < 100; ++i) {
    Client client{desk, addressOf(i), {}};
    refused += verbOf(client.join(0)) == SubscriptionVerb::refused ? 1 : 0;
    client.ask(SubscriptionVerb::leave, 0);
  }
  EXPECT_EQ(refused, 70);
  Client later{desk, addressOf(1000), {}};
  EXPECT_EQ(verbOf(later.join(5.1)), SubscriptionVerb::accepted);
}

}  // namespace
}  // namespace rocinante
