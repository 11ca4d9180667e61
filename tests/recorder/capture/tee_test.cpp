#include "recorder/capture/tee.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

#include <algorithm>

#include "core/net/udp_socket.h"
#include "recorder/capture/tee_set.h"
#include "tests/core/net/fake_source.h"

namespace rocinante {
namespace {

using test::FakeSource;
using ::testing::HasSubstr;
using namespace std::chrono_literals;

Endpoint endpointOf(std::string_view text) { return Endpoint::parse(text).value(); }

std::vector<ReceivedDatagram> batchOf(const std::vector<std::string>& payloads) {
  std::vector<ReceivedDatagram> batch;
  for (const std::string& each : payloads) {
    batch.push_back({bytesOf(each), SocketAddress::parse("10.0.0.1", 1).value()});
  }
  return batch;
}

Endpoint reach(const UdpReceiver& receiver) {
  Endpoint to = receiver.endpoint();
  to.address = receiver.boundAddress();
  return to;
}

std::vector<std::string> receiveAll(UdpReceiver& receiver, std::size_t count) {
  std::vector<std::string> payloads;
  while (payloads.size() < count) {
    pollfd readable{receiver.fileDescriptor(), POLLIN, 0};
    if (::poll(&readable, 1, 2'000) <= 0) break;
    const auto batch = receiver.receive();
    if (!batch) break;
    for (const ReceivedDatagram& each : *batch) payloads.emplace_back(textOf(each.payload));
  }
  return payloads;
}

TEST(Tee, SendsOnVerbatimAndInOrder) {
  auto receiver = UdpReceiver::open(endpointOf("127.0.0.1:0"));
  ASSERT_TRUE(receiver.ok());
  auto tee = Tee::open(reach(*receiver));
  ASSERT_TRUE(tee.ok()) << tee.error().text();
  std::vector<std::string> sent{"", std::string(65'507, 'x'), std::string("\0\xff", 2)};
  for (int i = 0; i < 200; ++i) sent.push_back(std::to_string(i));
  for (std::size_t i = 0; i < sent.size(); i += 29) {
    const std::vector<std::string> some(
        sent.begin() + static_cast<std::ptrdiff_t>(i),
        sent.begin() + static_cast<std::ptrdiff_t>(std::min(sent.size(), i + 29)));
    (*tee)->forward(batchOf(some));
  }
  EXPECT_EQ(receiveAll(*receiver, sent.size()), sent);
  (*tee)->close();
  EXPECT_EQ((*tee)->account().sent, sent.size());
  EXPECT_EQ((*tee)->account().dropped, 0U);
}

TEST(Tee, WhatStillWaitsAtTheEndIsSent) {
  auto receiver = UdpReceiver::open(endpointOf("127.0.0.1:0"));
  ASSERT_TRUE(receiver.ok());
  auto tee = Tee::open(reach(*receiver));
  ASSERT_TRUE(tee.ok());
  (*tee)->forward(batchOf(std::vector<std::string>(100, "last")));
  (*tee)->close();
  EXPECT_EQ((*tee)->account().sent, 100U);
  EXPECT_EQ(receiveAll(*receiver, 100).size(), 100U);
}

TEST(Tee, AFullQueueCostsTheTeeAndIsCounted) {
  auto receiver = UdpReceiver::open(endpointOf("127.0.0.1:0"));
  ASSERT_TRUE(receiver.ok());
  // Without a block nothing can wait, as if the network were blocked.
  auto tee = Tee::open(reach(*receiver), {.queue_blocks = 0, .patience = 10ms});
  ASSERT_TRUE(tee.ok());
  for (int i = 0; i < 10; ++i) (*tee)->forward(batchOf({"a", "b"}));
  (*tee)->close();
  EXPECT_EQ((*tee)->account().dropped, 20U);
  EXPECT_EQ((*tee)->account().sent, 0U);
}

TEST(Tee, EverythingIsSentOrCountedWhateverTheRate) {
  auto receiver = UdpReceiver::open(endpointOf("127.0.0.1:0"));
  ASSERT_TRUE(receiver.ok());
  auto tee = Tee::open(reach(*receiver), {.queue_blocks = 2, .patience = 20ms});
  ASSERT_TRUE(tee.ok());
  const std::vector<std::string> payloads(100, std::string(9'000, 'x'));  // the batch borrows them
  const auto batch = batchOf(payloads);
  for (int i = 0; i < 200; ++i) (*tee)->forward(batch);
  (*tee)->close();
  const Tee::Account account = (*tee)->account();
  EXPECT_EQ(account.sent + account.dropped, 20'000U);
  EXPECT_GT(account.dropped, 0U);
  EXPECT_GT(account.sent, 0U);
}

TEST(Tee, ARefusalOfTheSystemIsOneDatagramAndTold) {
  auto receiver = UdpReceiver::open(endpointOf("127.0.0.1:0"));
  ASSERT_TRUE(receiver.ok());
  auto tee = Tee::open(reach(*receiver));
  ASSERT_TRUE(tee.ok());
  (*tee)->forward(batchOf({"before", std::string(65'510, 'x'), "after"}));
  (*tee)->close();
  const Tee::Account account = (*tee)->account();
  EXPECT_EQ(account.sent, 2U);
  EXPECT_EQ(account.dropped, 1U);
  ASSERT_TRUE(account.trouble.has_value());
  EXPECT_THAT(account.trouble->what, HasSubstr("65510 bytes is too long for the network"));
  EXPECT_EQ(receiveAll(*receiver, 2), (std::vector<std::string>{"before", "after"}));
}

TEST(Tee, NobodyAtTheOtherEndIsNoTrouble) {
  Endpoint gone;
  {
    const auto receiver = UdpReceiver::open(endpointOf("127.0.0.1:0"));
    ASSERT_TRUE(receiver.ok());
    gone = reach(*receiver);
  }
  auto tee = Tee::open(gone);
  ASSERT_TRUE(tee.ok());
  for (int i = 0; i < 50; ++i) (*tee)->forward(batchOf({"x"}));
  (*tee)->close();
  EXPECT_EQ((*tee)->account().sent, 50U);
  EXPECT_FALSE((*tee)->account().trouble.has_value());
}

TEST(Tee, OneThatWouldBeHeardByTheRecordingIsRefused) {
  struct Case {
    std::string_view listening, to;
    bool refused;
  };
  for (const Case& each : {
           Case{"127.0.0.1:5000", "127.0.0.1:5000", true},
           Case{"127.0.0.1:5000", "127.0.0.1:5001", false},
           Case{"127.0.0.1:5000", "127.0.0.2:5000", false},
           Case{":5000", "127.0.0.1:5000", true},
           Case{":5000", "127.7.7.7:5000", true},
           Case{":5000", "192.0.2.199:5000", false},  // a documentation address, of no machine
           Case{":5000", "239.1.2.3:5000", true},
           Case{":5000", "[::1]:5000", false},
           Case{"[::]:5000", "[::1]:5000", true},
           Case{"239.1.2.3:5000", "239.1.2.3:5000", true},
           Case{"239.1.2.3:5000?interface=lo", "239.1.2.3:5000", true},
           Case{"239.1.2.3:5000?interface=lo", "239.1.2.3:5000?interface=eth9", false},
           Case{"239.1.2.3:5000", "239.1.2.4:5000", false},
           Case{"pcap://lo", "127.0.0.1:5000", false},
       }) {
    SCOPED_TRACE(std::string(each.listening) + " tee " + std::string(each.to));
    FakeSource source(each.listening);
    const Status checked = checkTee(endpointOf(each.to), {&source});
    EXPECT_EQ(checked.ok(), !each.refused);
    if (!checked) {
      EXPECT_THAT(checked.error().what, HasSubstr("it would receive itself endlessly"));
    }
  }
}

/// A batch as it came from this sender.
std::vector<ReceivedDatagram> cameFrom(std::uint16_t port,
                                       const std::vector<std::string>& payloads) {
  std::vector<ReceivedDatagram> batch = batchOf(payloads);
  for (ReceivedDatagram& each : batch) each.sender.port = port;
  return batch;
}

// Two recorders that forward to each other.
TEST(TeeEchoes, WhatComesBackIsNotForwardedAgain) {
  TeeEchoes echoes;
  const SteadyTime begin{};
  const std::vector<std::string> packets{"RK1 arm 0 -\n", "RK1 arm - -\njoints arm 1\n"};
  EXPECT_EQ(echoes.firsts(cameFrom(1, packets), begin).size(), 2U);
  EXPECT_EQ(echoes.firsts(cameFrom(2, packets), begin + 100ms).size(), 0U);
  EXPECT_EQ(echoes.count(), 2U);
  EXPECT_TRUE(echoes.news().has_value());
  EXPECT_FALSE(echoes.news().has_value());
  // The same again from the sender is forwarded, and what is not packet text always is.
  EXPECT_EQ(echoes.firsts(cameFrom(1, packets), begin + 200ms).size(), 2U);
  EXPECT_EQ(echoes.firsts(cameFrom(2, packets), begin + 2300ms).size(), 2U);
  EXPECT_EQ(echoes.firsts(cameFrom(1, {"beat"}), begin + 3s).size(), 1U);
  EXPECT_EQ(echoes.firsts(cameFrom(2, {"beat"}), begin + 3s).size(), 1U);
}

TEST(TeeSet, EveryTeeGetsEverything) {
  auto first = UdpReceiver::open(endpointOf("127.0.0.1:0"));
  auto second = UdpReceiver::open(endpointOf("[::1]:0"));
  ASSERT_TRUE(first.ok() && second.ok());
  auto set = TeeSet::open({reach(*first), reach(*second)});
  ASSERT_TRUE(set.ok()) << set.error().text();
  set->forward(batchOf({"a", "b"}));
  const std::vector<std::string> expected{"a", "b"};
  EXPECT_EQ(receiveAll(*first, 2), expected);
  EXPECT_EQ(receiveAll(*second, 2), expected);
  set->close();
  EXPECT_EQ(set->accounts().size(), 2U);
  EXPECT_EQ(set->localAddresses()[0].hostText(), "127.0.0.1");
  EXPECT_FALSE(TeeSet::open({endpointOf(":5000")}).ok());
}

}  // namespace
}  // namespace rocinante
