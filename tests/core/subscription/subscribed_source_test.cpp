#include "core/subscription/subscribed_source.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "core/transport/open_source.h"
#include "tests/core/signing/signing_support.h"
#include "tests/core/subscription/loopback_relay.h"

namespace rocinante {
namespace {

using test::FakeRelay;
using test::LoopbackRelay;

/// A subscription, and all that came of it.
class Listener {
 public:
  explicit Listener(const std::string& endpoint, const InputOptions& options = {})
      : source_(openSource(Endpoint::parse(endpoint).value(), options).value()) {}

  /// Listens until it holds, at most 20 s. `quietly`: as a program under a flood, which never finds
  /// the time for maintain().
  bool until(const std::function<bool()>& holds, bool quietly = false) {
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (std::chrono::steady_clock::now() < give_up) {
      if (holds()) return true;
      pollfd waiting{source_->fileDescriptor(), POLLIN, 0};
      ::poll(&waiting, 1, 5);
      if (!quietly) {
        if (const auto said = source_->maintain()) news.push_back(*said);
      }
      const auto batch = source_->receive();
      if (!batch) return false;
      for (const ReceivedDatagram& each : *batch) {
        heard.emplace_back(textOf(each.payload));
        sender = each.sender;
        stamped = each.kernel_time;
      }
    }
    return false;
  }
  bool isTold(const std::string& sentence) {
    return until([&] { return std::ranges::count(news, sentence) > 0; });
  }
  void close() { source_.reset(); }
  DatagramSource& source() { return *source_; }

  std::vector<std::string> heard, news;
  SocketAddress sender;
  WallTime stamped{};

 private:
  std::unique_ptr<DatagramSource> source_;
};

TEST(SubscribedSource, ReceivesWhatTheRelaySends) {
  for (const char* const address : {"127.0.0.1:0", "[::1]:0"}) {
    SCOPED_TRACE(address);
    LoopbackRelay relay(address);
    Listener listener(relay.endpoint() + "?device=arm*&rate=5");
    ASSERT_TRUE(listener.until([&] { return relay.send("RK1 arm 1 -\n"); }));
    ASSERT_TRUE(listener.until([&] { return !listener.heard.empty(); }));
    EXPECT_EQ(listener.heard[0], "RK1 arm 1 -\n");
    EXPECT_EQ(listener.sender, relay.address());
    EXPECT_GT(listener.stamped, WallTime());
    EXPECT_EQ(boundText(listener.source()), relay.endpoint() + "?device=arm*&rate=5");
    EXPECT_EQ(listener.source().boundAddress().port, relay.subscriber().port);
    EXPECT_EQ(listener.source().counts(), InputCounts());
    EXPECT_EQ(listener.source().droppedByNow().value(), 0U);
    EXPECT_GT(listener.source().receiveBufferBytes(), 0U);
    relay.with([](const FakeRelay& each) {
      EXPECT_EQ(each.wanted.wish.device, "arm*");
      EXPECT_EQ(each.wanted.wish.rate_hz, 5);
    });
  }
}

TEST(SubscribedSource, KeepsTheLeaseUnderConstantTraffic) {
  LoopbackRelay relay;
  relay.with([](FakeRelay& each) { each.lease_s = 3; });
  Listener listener(relay.endpoint());
  int kept = 0;
  const auto flood = [&] {
    for (int i = 0; i < 20; ++i) relay.send("RK1 arm - -\n");
    relay.with([&](const FakeRelay& each) { kept = each.kept; });
    return kept >= 3;
  };
  EXPECT_TRUE(listener.until(flood, /*quietly=*/true));
  EXPECT_GT(listener.heard.size(), 100U);
}

TEST(SubscribedSource, KeepsTheLeaseInSilence) {
  LoopbackRelay relay;
  relay.with([](FakeRelay& each) { each.restate_s = 1; });
  Listener listener(relay.endpoint());
  EXPECT_TRUE(listener.until([&] {
    int kept = 0;
    relay.with([&](const FakeRelay& each) { kept = each.kept; });
    return kept >= 2;
  }));
}

TEST(SubscribedSource, EndsTheLeaseWhenItGoes) {
  LoopbackRelay relay;
  Listener listener(relay.endpoint());
  ASSERT_TRUE(listener.until([&] { return relay.send("RK1 arm 1 -\n"); }));
  listener.close();
  EXPECT_TRUE(relay.waitUntil([](const FakeRelay& each) { return each.left == 1; }));
}

TEST(SubscribedSource, OthersAreNotHeardAndCounted) {
  LoopbackRelay relay;
  Listener listener(relay.endpoint());
  ASSERT_TRUE(listener.until([&] { return relay.send("first"); }));
  Endpoint port;
  port.address = relay.subscriber();
  UdpSender stranger = UdpSender::open(port).value();
  ASSERT_TRUE(stranger.send(bytesOf("RK1 forged 1 -\n")).ok());
  ASSERT_TRUE(
      stranger.send(bytesOf("RKS1 refused id=0000000000000000 \"no subscription\"\n")).ok());
  // The relay itself, but to no request of ours.
  ASSERT_TRUE(relay.send("# first\nRKS1 refused id=0000000000000000 \"no subscription\"\n"));
  ASSERT_TRUE(relay.send("last"));
  ASSERT_TRUE(
      listener.until([&] { return !listener.heard.empty() && listener.heard.back() == "last"; }));
  EXPECT_EQ(listener.heard, (std::vector<std::string>{"first", "last"}));
  EXPECT_EQ(listener.source().counts().strangers, 2U);
  EXPECT_EQ(listener.source().counts().requests, 1U);
}

TEST(SubscribedSource, SaysWhenTheRelayIsAwayRefusesOrReturns) {
  LoopbackRelay relay;
  relay.with([](FakeRelay& each) { each.restate_s = 0.5; });
  relay.setAway(true);
  Listener listener(relay.endpoint());
  EXPECT_TRUE(
      listener.isTold(relay.endpoint() + " does not answer; nothing is received until it does"));
  relay.with([](FakeRelay& each) { each.refusal = "there is no room"; });
  relay.setAway(false);
  EXPECT_TRUE(
      listener.isTold(relay.endpoint() + " refused: there is no room; asking again every 5 s"));
  relay.with([](FakeRelay& each) { each.refusal.clear(); });
  EXPECT_TRUE(listener.isTold("subscribed to relay hall at " + relay.endpoint()));
  relay.with([](FakeRelay& each) { each.restart("r2"); });
  EXPECT_TRUE(
      listener.isTold("relay hall at " + relay.endpoint() + " was restarted; subscribed again"));
}

/// Signs with the key that begins with `first`, now.
std::function<std::string(std::string)> signingNow(unsigned char first) {
  const auto signer = std::make_shared<DatagramSigner>(
      test::vectorKey(first), [] { return WallTime(std::chrono::system_clock::now()); });
  return [signer](const std::string& text) {
    return std::string(textOf(signer->sign(bytesOf(text))));
  };
}

InputOptions trustingRelay(bool is_relay) {
  InputOptions options;
  options.trust =
      std::make_shared<TrustJudge>(test::trusting(test::vectorKey(), {"arm"}, is_relay));
  return options;
}

TEST(SubscribedSource, TrustsOnlyARelayThatSigns) {
  LoopbackRelay relay;
  Listener listener(relay.endpoint(), trustingRelay(/*is_relay=*/true));
  const std::string untrusted = "the answers of " + relay.endpoint() + " are not trusted (";
  EXPECT_TRUE(listener.isTold(untrusted +
                              "not_signed); nothing is received until the relay runs with --key"));
  relay.with([](FakeRelay& each) { EXPECT_EQ(each.accepted, 0); });
  relay.with([](FakeRelay& each) { each.sign = signingNow(1); });
  ASSERT_TRUE(listener.until(
      [&] { return listener.source().counts().untrusted->of(Untrusted::unknown_key) > 0; }));
  const auto sign = signingNow(0);
  relay.with([&](FakeRelay& each) { each.sign = sign; });
  EXPECT_TRUE(listener.isTold("subscribed to relay hall at " + relay.endpoint()));

  const std::uint64_t before = listener.source().counts().untrusted->of(Untrusted::not_signed);
  ASSERT_TRUE(relay.send("RK1 arm 1 -\n"));
  std::string greeting;
  relay.with([&](const FakeRelay&) { greeting = sign("RK1 arm 2 - by=hall\n"); });
  ASSERT_TRUE(relay.send(greeting));
  ASSERT_TRUE(listener.until([&] { return !listener.heard.empty(); }));
  EXPECT_EQ(listener.heard, std::vector<std::string>{greeting});
  EXPECT_EQ(listener.source().counts().untrusted->of(Untrusted::not_signed), before + 1);
}

TEST(SubscribedSource, ASourcesKeyMayNotAnswer) {
  LoopbackRelay relay;
  relay.with([](FakeRelay& each) { each.sign = signingNow(0); });
  Listener listener(relay.endpoint(), trustingRelay(/*is_relay=*/false));
  EXPECT_TRUE(listener.isTold("the answers of " + relay.endpoint() +
                              " are not trusted (not_allowed); nothing is received until the trust "
                              "file lists the relay's key with relay = true"));
  EXPECT_FALSE(relay.send("RK1 arm 1 -\n"));
}

TEST(SubscribedSource, ARelayWithoutARouteIsNoFailure) {
  // The system refuses to send there, with a route and without.
  Listener listener("subscribe://255.255.255.255:9");
  ASSERT_TRUE(listener.until([&] { return !listener.news.empty(); }));
  EXPECT_NE(listener.news[0].find("does not answer"), std::string::npos);
  EXPECT_NE(listener.news[0].find("(cannot send to 255.255.255.255:9: "), std::string::npos);
}

TEST(SubscribedSource, NeedsASubscription) {
  const auto source = SubscribedSource::open(Endpoint::parse("127.0.0.1:0").value());
  ASSERT_FALSE(source.ok());
  EXPECT_EQ(source.error().kind, ErrorKind::bad_argument);
}

TEST(SubscribedSource, NothingCanBeSentThere) {
  const auto sender = UdpSender::open(Endpoint::parse("subscribe://127.0.0.1:9").value());
  ASSERT_FALSE(sender.ok());
  EXPECT_EQ(sender.error().text(),
            "subscribe:// only receives: record, spy, check --live and view --live take it "
            "(subscribe://127.0.0.1:9)");
}

TEST(OpenSource, RequestsForARelayAreNotPassedOn) {
  Listener listener("127.0.0.1:0");
  Endpoint to;
  to.address = listener.source().boundAddress();
  UdpSender sender = UdpSender::open(to).value();
  ASSERT_TRUE(sender.send(bytesOf("RKS1 subscribe id=0000000000000001 lease=30\n")).ok());
  ASSERT_TRUE(sender.send(bytesOf("\n #\n\tRKS1 nonsense")).ok());
  ASSERT_TRUE(sender.send(bytesOf("RKS2 is not one")).ok());
  ASSERT_TRUE(sender.send(bytesOf("RK1 arm 1 -\n")).ok());
  ASSERT_TRUE(listener.until([&] { return listener.heard.size() == 2; }));
  EXPECT_EQ(listener.heard[0], "RKS2 is not one");
  EXPECT_EQ(listener.source().counts().requests, 2U);
}

}  // namespace
}  // namespace rocinante
