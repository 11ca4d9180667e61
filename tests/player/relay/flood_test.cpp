// Forged subscriptions from tens of thousands of addresses to a relay that has one true subscriber.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "core/net/udp_socket.h"
#include "core/subscription/subscription_text.h"
#include "tests/support/forged_flood.h"
#include "tests/support/process_memory.h"
#include "tests/support/programs.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using test::ForgedFlood;
using test::Program;

Endpoint endpointOf(const std::string& text) { return Endpoint::parse(text).value(); }

/// The address that follows `word` in a line of the relay.
std::string addressAfter(Program& relay, const std::string& word) {
  const std::string line = relay.waitForLine(word);
  const std::size_t at = line.find("127.0.0.1:");
  if (at == line.npos) return "127.0.0.1:1";
  return line.substr(at, line.find_first_of(" ,;", at) - at);
}

/// A subscriber that asks on request, and keeps count of what it hears.
class TrueSubscriber {
 public:
  explicit TrueSubscriber(const std::string& relay)
      : relay_(endpointOf(relay).address),
        socket_(UdpReceiver::open(endpointOf("127.0.0.1:0")).value()) {}

  void ask(SubscriptionVerb verb) {
    SubscriptionMessage request;
    request.verb = verb;
    request.id = ++id_;
    request.cookie = cookie_;
    if (verb == SubscriptionVerb::subscribe) request.lease_s = kMaxLeaseSeconds;
    const std::size_t least = verb == SubscriptionVerb::subscribe ? kSubscribeBytes : 0;
    (void)socket_.sendTo(relay_, bytesOf(subscriptionText(request, least)));
  }
  void listen() {
    const auto batch = socket_.receive();
    for (std::size_t i = 0; batch && i < batch->size(); ++i) {
      const ByteView payload = (*batch)[i].payload;
      const Result<SubscriptionMessage> answer = readSubscription(payload);
      if (!answer) {
        packets += textOf(payload).starts_with("RK1 arm ") ? 1 : 0;
        continue;
      }
      accepted += answer->verb == SubscriptionVerb::accepted ? 1 : 0;
      kept += answer->verb == SubscriptionVerb::kept ? 1 : 0;
      refused += answer->verb == SubscriptionVerb::refused ? 1 : 0;
      if (!answer->cookie.empty()) cookie_ = answer->cookie;
    }
  }
  const std::string& cookie() const { return cookie_; }

  std::uint64_t packets = 0, accepted = 0, kept = 0, refused = 0;

 private:
  SocketAddress relay_;
  UdpReceiver socket_;
  std::string cookie_;
  std::uint64_t id_ = 0;
};

/// What a stranger may try, in datagrams of every kind. `cookie` is another's.
std::vector<std::string> forgedRequests(const std::string& cookie) {
  SubscriptionMessage subscribe;
  subscribe.id = 0x1234'5678'9abc'def0;
  subscribe.lease_s = kMaxLeaseSeconds;
  SubscriptionMessage stolen = subscribe;
  stolen.cookie = cookie;
  SubscriptionMessage keep;
  keep.verb = SubscriptionVerb::keep;
  SubscriptionMessage leave = stolen;
  leave.verb = SubscriptionVerb::leave;
  SubscriptionMessage answer = subscribe;
  answer.verb = SubscriptionVerb::refused;
  answer.sentence = "no subscription";
  return {subscriptionText(subscribe, kSubscribeBytes),
          subscriptionText(stolen, kSubscribeBytes),
          subscriptionText(subscribe),
          subscriptionText(keep),
          subscriptionText(leave),
          subscriptionText(answer),
          "RKS1 subscribe lease=\n"};
}

TEST(RelayFlood, ForgedSubscriptionsCostNobodyTheLeaseAndNoStrangerMoreThanItSent) {
  const bool is_long = std::getenv("ROCINANTE_LONG") != nullptr;
  const double a_second = is_long ? 100'000 : 0;
  const std::uint64_t least_sent = is_long ? 500'000 : 70'000;
  Program relay = Program::start("rocinante-relay", {"--from", "127.0.0.1:0", "--serve",
                                                     "127.0.0.1:0", "--name", "hub", "--json"});
  const std::string from = addressAfter(relay, "listening on");
  const std::string served = addressAfter(relay, "serving at");
  TrueSubscriber subscriber(served);
  UdpSender source = UdpSender::open(endpointOf(from)).value();
  std::uint64_t sequence = 0;
  Clock::time_point next_keep{}, next_packet{};
  // The source sends 500 a second; a keep goes each 100 ms.
  const auto pump = [&](bool keeps) {
    const auto now = Clock::now();
    if (now >= next_packet) {
      next_packet = now + 2ms;
      const std::string text = fmt::format("RK1 arm {} -\njoints arm {}\n", ++sequence, sequence);
      (void)source.send(bytesOf(text));
    }
    if (now >= next_keep) {
      next_keep = now + 100ms;
      subscriber.ask(keeps ? SubscriptionVerb::keep : SubscriptionVerb::subscribe);
    }
    subscriber.listen();
    std::this_thread::sleep_for(200us);
  };
  const auto pumpUntil = [&](const auto& holds, bool keeps = true) {
    const auto give_up = Clock::now() + 60s;
    while (!holds() && Clock::now() < give_up) pump(keeps);
    return holds();
  };
  ASSERT_TRUE(pumpUntil([&] { return subscriber.accepted > 0 && subscriber.packets > 0; }, false));

  const std::vector<std::string> requests = forgedRequests(subscriber.cookie());
  ForgedFlood flood(endpointOf(served).address.port, requests, a_second);
  ASSERT_TRUE(pumpUntil([&] { return flood.answers() >= 1000; }));
  const std::uint64_t before = test::mostBytes(relay.pid());
  const std::uint64_t kept = subscriber.kept, packets = subscriber.packets;
  const std::uint64_t said = sequence, forged = flood.sent();
  const auto began = Clock::now();
  EXPECT_TRUE(pumpUntil([&] {
    return flood.sent() >= least_sent && subscriber.kept >= kept + 3 &&
           subscriber.packets >= packets + 100;
  })) << "kept "
      << subscriber.kept - kept << " times, heard " << subscriber.packets - packets;
  const double seconds = std::chrono::duration<double>(Clock::now() - began).count();
  flood.stopSending();
  const std::uint64_t after = test::mostBytes(relay.pid());
  EXPECT_LE(after, before + (4U << 20U)) << "bytes of memory";
  fmt::print("{} forged in {:.1f} s, {} answered; heard {} of {}, kept {} of {:.0f}; {} KiB more\n",
             flood.sent() - forged, seconds, flood.answers(), subscriber.packets - packets,
             sequence - said, subscriber.kept - kept, seconds * 10, (after - before) / 1024);

  // It still has its lease, and hears what is said.
  const std::uint64_t kept_by_now = subscriber.kept, heard = subscriber.packets;
  EXPECT_TRUE(
      pumpUntil([&] { return subscriber.kept > kept_by_now && subscriber.packets > heard; }));
  EXPECT_EQ(subscriber.accepted, 1U);
  EXPECT_EQ(subscriber.refused, 0U);
  const auto report = nlohmann::json::parse(relay.stop().out);
  EXPECT_EQ(report["subscribers"]["most"], 1);
  EXPECT_EQ(report["subscribers"]["now"], 1);
  EXPECT_GT(report["subscribers"]["challenged"], 1000);
  for (std::size_t i = 0; i < flood.traffic().size(); ++i) {
    const ForgedFlood::Traffic& each = flood.traffic()[i];
    ASSERT_LE(each.received.load(), each.sent.load())
        << "address " << i << " sent " << requests[i % requests.size()];
  }
}

}  // namespace
}  // namespace rocinante
