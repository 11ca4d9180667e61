#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <random>
#include <vector>

#include "core/subscription/subscription_client.h"
#include "tests/core/subscription/fake_relay.h"

namespace rocinante {
namespace {

using std::chrono::milliseconds;
using test::FakeRelay;

/// A network that loses, repeats, delays and reorders, with a forger on it who does not see the
/// ids of requests, in simulated time.
class BadNetwork {
 public:
  explicit BadNetwork(std::uint32_t seed)
      : random_(seed),
        endpoint_(Endpoint::parse("subscribe://10.0.0.1:19961").value()),
        client_(
            endpoint_, [this] { return (std::uint64_t{random_()} << 32U) | random_(); }, now_) {}

  void run(Nanoseconds time) {
    for (const SteadyTime end = now_ + time; now_ < end; now_ += milliseconds(10)) step();
  }

  double fault_rate = 0.4;
  bool forges = true;
  FakeRelay relay;
  std::vector<SteadyTime> sent;
  std::uint64_t passed_on = 0, forged_answers = 0;
  SubscriptionClient& client() { return client_; }
  SteadyTime now() const { return now_; }
  bool chance(double part) { return std::uniform_real_distribution<>()(random_) < part; }

 private:
  void carry(std::multimap<SteadyTime, std::string>& way, const std::string& datagram) {
    for (int copies = chance(fault_rate / 2) ? 2 : 1; copies > 0; --copies) {
      if (chance(fault_rate)) continue;
      const auto delay = milliseconds(5 + (chance(fault_rate) ? random_() % 900 : 0));
      way.emplace(now_ + delay, datagram);
    }
  }

  void forge() {
    SubscriptionMessage answer;
    answer.verb = static_cast<SubscriptionVerb>(random_() % 7);
    answer.id = random_();
    answer.lease_s = 1 + static_cast<std::uint32_t>(random_() % kMaxLeaseSeconds);
    answer.restate_s = 1;
    answer.cookie = "forged";
    answer.relay = answer.run = "forged";
    if (answer.verb == SubscriptionVerb::refused) answer.sentence = "no subscription";
    SocketAddress sender = endpoint_.address;
    if (chance(0.5)) sender.port += 1;
    const auto arrival = client_.take(now_, sender, bytesOf(subscriptionText(answer)));
    if (arrival == SubscriptionClient::Arrival::answer) ++forged_answers;
  }

  void step() {
    if (forges && chance(0.2)) forge();
    while (!to_relay_.empty() && to_relay_.begin()->first <= now_) {
      const auto answer = relay.answer(to_relay_.begin()->second, now_);
      to_relay_.erase(to_relay_.begin());
      if (answer) carry(to_client_, *answer);
    }
    if (relay.isServing(now_) && chance(0.3)) carry(to_client_, "RK1 arm 1 -\n");
    while (!to_client_.empty() && to_client_.begin()->first <= now_) {
      const auto arrival =
          client_.take(now_, endpoint_.address, bytesOf(to_client_.begin()->second));
      if (arrival == SubscriptionClient::Arrival::traffic) ++passed_on;
      to_client_.erase(to_client_.begin());
    }
    while (const auto request = client_.nextRequest(now_)) {
      sent.push_back(now_);
      carry(to_relay_, *request);
    }
  }

  SteadyTime now_{std::chrono::seconds(1)};
  std::mt19937 random_;
  Endpoint endpoint_;
  SubscriptionClient client_;
  std::multimap<SteadyTime, std::string> to_relay_, to_client_;
};

/// In any span of t seconds at most kBurst + kRequestsPerSecond * t requests.
void checkPace(const std::vector<SteadyTime>& sent) {
  for (std::size_t first = 0; first < sent.size(); ++first) {
    for (std::size_t last = first; last < std::min(sent.size(), first + 60); ++last) {
      const double most =
          SubscriptionClient::kBurst + 1e-6 +
          secondsOf(sent[last] - sent[first]) * SubscriptionClient::kRequestsPerSecond;
      RC_ASSERT(static_cast<double>(last - first + 1) <= most);
    }
  }
}

RC_GTEST_PROP(SubscriptionClientProperty, WhenFaultsEndTheSubscriptionHolds, ()) {
  BadNetwork network(*rc::gen::arbitrary<std::uint32_t>());
  network.relay.lease_s = *rc::gen::inRange<std::uint32_t>(3, 31);
  network.relay.restate_s = *rc::gen::inRange(1, 5);
  for (int part = 0; part < 4; ++part) {
    network.run(std::chrono::seconds(5));
    if (network.chance(0.5)) network.relay.restart("r" + std::to_string(part + 2));
    network.relay.refusal = network.chance(0.3) ? "full" : "";
  }
  network.relay.refusal.clear();
  network.fault_rate = 0;
  network.run(std::chrono::seconds(10));
  RC_ASSERT(network.forged_answers == 0U);
  const int accepted = network.relay.accepted;
  for (int i = 0; i < 60; ++i) {
    network.run(std::chrono::seconds(1));
    RC_ASSERT(network.client().isSubscribed());
    RC_ASSERT(network.relay.isServing(network.now()));
  }
  RC_ASSERT(network.relay.accepted == accepted);
  RC_ASSERT(network.passed_on > 0U);
  checkPace(network.sent);
}

/// A relay, or who sees the requests, may answer whatever it likes at once.
RC_GTEST_PROP(SubscriptionClientProperty, NoAnswersMakeItSendFaster, ()) {
  std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
  const Endpoint endpoint = Endpoint::parse("subscribe://[2001:db8::1]:19961").value();
  SteadyTime now{std::chrono::seconds(1)};
  std::uint64_t id = 0;
  SubscriptionClient client(
      endpoint, [&] { return ++id; }, now);
  std::vector<SteadyTime> sent;
  for (int step = 0; step < 3'000; ++step, now += milliseconds(random() % 20)) {
    if (client.nextRequest(now)) sent.push_back(now);
    SubscriptionMessage answer;
    answer.verb = static_cast<SubscriptionVerb>(3 + random() % 4);
    answer.id = id;
    answer.lease_s = 1 + static_cast<std::uint32_t>(random() % 3);
    answer.restate_s = 0.001;
    answer.cookie = answer.relay = answer.run = "x";
    if (answer.verb == SubscriptionVerb::refused && random() % 2 == 0) {
      answer.sentence = "no subscription";
    }
    client.take(now, endpoint.address, bytesOf(subscriptionText(answer)));
    client.takeNews();
  }
  RC_ASSERT(sent.size() > 5U);
  checkPace(sent);
}

}  // namespace
}  // namespace rocinante
