#include "viewer/ui/live/live_feed.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <string>
#include <thread>

#include "core/log/log_reader.h"
#include "core/net/udp_socket.h"
#include "core/signing/trust_judge.h"
#include "tests/core/signing/signing_support.h"
#include "tests/core/subscription/loopback_relay.h"
#include "tests/support/udp_queue.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;

/// A port of 127.0.0.1 that was free a moment ago.
Endpoint freeEndpoint() {
  auto probe = UdpReceiver::open(Endpoint::parse("127.0.0.1:0").value());
  Endpoint endpoint = Endpoint::parse("127.0.0.1:1").value();
  endpoint.address.port = probe->boundAddress().port;
  return endpoint;
}

TEST(LiveFeed, WakesWhoWaitsForNews) {
  const Endpoint endpoint = freeEndpoint();
  auto feed = LiveFeed::start({endpoint});
  ASSERT_TRUE(feed.ok()) << feed.error().text();
  std::atomic<int> woken{0};
  feed->onNews([&] { woken.fetch_add(1), woken.notify_all(); });
  auto sender = UdpSender::open(endpoint);
  ASSERT_TRUE(sender.ok());
  const auto newest = std::make_unique<LiveSnapshot>();
  while (feed->update(*newest)) continue;
  for (std::uint64_t i = 1; i <= 3; ++i) {
    const int before = woken;
    ASSERT_TRUE(sender->send(bytesOf("RK1 me " + std::to_string(i) + " -\n")).ok());
    while (newest->datagrams < i) {
      if (!feed->update(*newest)) woken.wait(before);
    }
  }
  feed->onNews({});
  const int last = woken;
  ASSERT_TRUE(sender->send(bytesOf("RK1 me 4 -\n")).ok());
  while (newest->datagrams < 4) feed->update(*newest);
  EXPECT_EQ(woken, last);
}

TEST(LiveFeed, FoldsWhatComesAndHandsItOverOnce) {
  const Endpoint endpoint = freeEndpoint();
  auto feed = LiveFeed::start({endpoint});
  ASSERT_TRUE(feed.ok()) << feed.error().text();
  auto sender = UdpSender::open(endpoint);
  ASSERT_TRUE(sender.ok());
  constexpr int kCount = 500;
  for (int i = 0; i < kCount; ++i) {
    const std::string text =
        "RK1 me@a " + std::to_string(i) + " -\njoints arm " + std::to_string(i) + "\n";
    ASSERT_TRUE(sender->send(bytesOf(text)).ok());
    // A machine that may not force its buffers holds some 250.
    if (i % 100 == 99) {
      ASSERT_TRUE(test::waitUntilTaken(endpoint.address.port));
    }
  }
  ASSERT_TRUE(sender->send(bytesOf("not a packet")).ok());

  const auto newest = std::make_unique<LiveSnapshot>();
  const auto deadline = std::chrono::steady_clock::now() + 1min;
  while (std::chrono::steady_clock::now() < deadline && newest->datagrams < kCount + 1) {
    feed->update(*newest);
    std::this_thread::yield();
  }
  EXPECT_EQ(newest->datagrams, kCount + 1U);
  EXPECT_EQ(newest->undecoded, 1U);
  EXPECT_EQ(newest->gaps, 0U);
  const auto arm = newest->state.devices().find("arm");
  ASSERT_NE(arm, newest->state.devices().end());
  EXPECT_EQ(arm->second.joints->value, std::vector<double>{kCount - 1});
}

/// The newest snapshot once it holds; null after 20 s.
std::unique_ptr<LiveSnapshot> waitFor(
    LiveFeed& feed, const std::function<bool(const LiveSnapshot&)>& holds,
    const std::function<void()>& meanwhile = [] {}) {
  const auto deadline = std::chrono::steady_clock::now() + 20s;
  auto snapshot = std::make_unique<LiveSnapshot>();
  while (std::chrono::steady_clock::now() < deadline) {
    meanwhile();
    if (feed.update(*snapshot) && holds(*snapshot)) return snapshot;
    std::this_thread::sleep_for(2ms);
  }
  return nullptr;
}

TEST(LiveFeed, SeveralEndpointsGiveOneState) {
  const Endpoint left = freeEndpoint();
  const Endpoint right = freeEndpoint();
  auto feed = LiveFeed::start({left, right});
  ASSERT_TRUE(feed.ok()) << feed.error().text();
  auto to_left = UdpSender::open(left);
  auto to_right = UdpSender::open(right);
  // One source by both ways, and one by each alone.
  for (int i = 0; i < 20; ++i) {
    const std::string both = "RK1 both@a " + std::to_string(100 + i) + " -\njoints arm 1\n";
    ASSERT_TRUE(to_left->send(bytesOf(both)).ok());
    ASSERT_TRUE(to_right->send(bytesOf(both)).ok());
  }
  ASSERT_TRUE(to_left->send(bytesOf("RK1 l@a 1 -\njoints left 1\n")).ok());
  ASSERT_TRUE(to_right->send(bytesOf("RK1 r@a 1 -\njoints right 1\n")).ok());
  const auto newest = waitFor(*feed, [](const LiveSnapshot& each) { return each.datagrams == 42; });
  ASSERT_NE(newest, nullptr);
  EXPECT_EQ(newest->state.devices().size(), 3U);
  EXPECT_EQ(newest->gaps, 0U);
  EXPECT_EQ(newest->state.counts().at("both").packets, 20U);
  EXPECT_EQ(newest->state.counts().at("both").duplicates, 20U);
}

TEST(LiveFeed, FoldsWhatIsTrustedAndCountsTheRest) {
  const Endpoint endpoint = freeEndpoint();
  auto feed = LiveFeed::start(
      {endpoint}, std::make_shared<TrustJudge>(test::trusting(test::vectorKey(), {"arm"})));
  ASSERT_TRUE(feed.ok()) << feed.error().text();
  auto sender = UdpSender::open(endpoint);
  DatagramSigner signer(test::vectorKey(),
                        [] { return WallTime(std::chrono::system_clock::now()); });
  const auto sign = [&](std::string_view text) {
    return std::string(textOf(signer.sign(bytesOf(text))));
  };
  const std::string mine = sign("RK1 arm@a 1 -\njoints arm 1\n");
  for (const std::string& each : {std::string("RK1 arm@a 7 -\njoints arm 7\n"), mine, mine,
                                  sign("RK1 leg@a 1 -\njoints leg 1\n")}) {
    ASSERT_TRUE(sender->send(bytesOf(each)).ok());
  }
  const auto newest = waitFor(*feed, [](const LiveSnapshot& each) {
    return each.datagrams == 1 && each.untrusted.total() == 3;
  });
  ASSERT_NE(newest, nullptr);
  EXPECT_EQ(newest->untrusted.text(), "1 not signed, 1 not allowed, 1 repeated");
  EXPECT_EQ(newest->state.devices().size(), 1U);
  EXPECT_EQ(newest->state.devices().at("arm").joints->value, std::vector<double>{1});
}

TEST(LiveFeed, ShowsWhatARelaySendsAndWhatBecameOfIt) {
  test::LoopbackRelay relay;
  auto feed = LiveFeed::start({Endpoint::parse(relay.endpoint()).value()});
  ASSERT_TRUE(feed.ok()) << feed.error().text();
  const auto newest = waitFor(
      *feed,
      [](const LiveSnapshot& each) {
        return each.state.devices().contains("arm") && !each.news.empty();
      },
      [&] { relay.send("RK1 arm - -\njoints arm 1\n"); });
  ASSERT_NE(newest, nullptr);
  EXPECT_EQ(newest->news, "subscribed to relay hall at " + relay.endpoint());
  EXPECT_EQ(newest->undecoded, 0U);
}

TEST(LiveFeed, DecodesWhatIsDeclaredInItsStateAndInTheKeptLog) {
  const Endpoint endpoint = freeEndpoint();
  auto set = decode::parseDecoders(
      "[[decoder]]\nname = \"arm\"\nkind = \"delimited\"\nbegins_with = \"J,\"\n"
      "[[decoder.field]]\nname = \"q\"\ncolumn = 1\n"
      "[[decoder.joint]]\ndevice = \"arm\"\njoint = \"j\"\nfield = \"q\"\n",
      "test");
  ASSERT_TRUE(set.ok()) << set.error().text();
  auto feed = LiveFeed::start({endpoint}, nullptr, KeepLimits{}, *set);
  ASSERT_TRUE(feed.ok()) << feed.error().text();
  auto sender = UdpSender::open(endpoint);
  for (const char* const text : {"J,1", "others", "RK1 me@a 1 -\njoints leg 1\n", "J,2.5"}) {
    ASSERT_TRUE(sender->send(bytesOf(std::string_view(text))).ok());
  }
  const auto newest = waitFor(*feed, [](const LiveSnapshot& each) { return each.datagrams == 4; });
  ASSERT_NE(newest, nullptr);
  EXPECT_EQ(newest->undecoded, 1U);
  ASSERT_TRUE(newest->state.devices().contains("arm"));
  EXPECT_EQ(newest->state.devices().at("arm").named_joints.at("j").value, 2.5);
  EXPECT_TRUE(newest->state.devices().contains("leg"));

  ASSERT_NE(feed->keeper(), nullptr) << feed->keepingFault();
  feed->keeper()->finishUpTo(newest->time);
  const auto deadline = std::chrono::steady_clock::now() + 20s;
  while (feed->keeper()->progress().finished.empty() &&
         std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(2ms);
  }
  const KeptProgress kept = feed->keeper()->progress();
  ASSERT_FALSE(kept.finished.empty()) << kept.trouble;
  auto log = LogReader::open(kept.finished.front());
  ASSERT_TRUE(log.ok()) << log.error().text();
  ASSERT_EQ(log->attachments().size(), 1U);
  EXPECT_EQ(log->attachments()[0].name, "decoders/" + (*set)->hash + ".toml");
  std::vector<std::string> topics;
  for (auto message = log->next(); message.ok() && *message; message = log->next()) {
    topics.push_back((*message)->channel->topic);
  }
  const std::string root = "/udp/" + std::to_string(endpoint.address.port);
  EXPECT_EQ(topics, (std::vector<std::string>{
                        root + "/127.0.0.1", "/rocinante/decoded" + root + "/127.0.0.1",
                        root + "/127.0.0.1", root + "/me", root + "/127.0.0.1",
                        "/rocinante/decoded" + root + "/127.0.0.1"}));
}

TEST(LiveFeed, ATakenPortIsRefused) {
  auto holder = UdpReceiver::open(Endpoint::parse("127.0.0.1:0").value());
  ASSERT_TRUE(holder.ok());
  Endpoint endpoint = Endpoint::parse("127.0.0.1:1").value();
  endpoint.address.port = holder->boundAddress().port;
  const auto feed = LiveFeed::start({endpoint});
  ASSERT_FALSE(feed.ok());
  EXPECT_EQ(feed.error().kind, ErrorKind::refused);
}

}  // namespace
}  // namespace rocinante
