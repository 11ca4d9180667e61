#include "viewer/ui/live/live_feed.h"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>

#include "core/net/udp_socket.h"
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

  std::unique_ptr<LiveSnapshot> newest;
  const auto deadline = std::chrono::steady_clock::now() + 1min;
  while (std::chrono::steady_clock::now() < deadline &&
         (newest == nullptr || newest->datagrams < kCount + 1)) {
    if (auto snapshot = feed->take()) newest = std::move(snapshot);
    std::this_thread::yield();
  }
  ASSERT_NE(newest, nullptr);
  EXPECT_EQ(newest->datagrams, kCount + 1U);
  EXPECT_EQ(newest->undecoded, 1U);
  EXPECT_EQ(newest->gaps, 0U);
  const auto arm = newest->state.devices().find("arm");
  ASSERT_NE(arm, newest->state.devices().end());
  EXPECT_EQ(arm->second.joints->value, std::vector<double>{kCount - 1});
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
