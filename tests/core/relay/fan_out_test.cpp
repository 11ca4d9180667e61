#include "core/relay/fan_out.h"

#include <gtest/gtest.h>

#include <set>

#include "core/net/udp_socket.h"

namespace rocinante {
namespace {

bool dropTheRest() { return false; }

TEST(FanOut, SendsEveryDatagramToEveryAddressInOrder) {
  for (const char* host : {"127.0.0.1:0", "[::1]:0"}) {
    SCOPED_TRACE(host);
    const auto any = Endpoint::parse(host);
    ASSERT_TRUE(any.ok());
    auto from = UdpReceiver::open(*any);
    if (!from && any->address.is_ipv6) GTEST_SKIP() << from.error().text();
    ASSERT_TRUE(from.ok());
    std::vector<UdpReceiver> listeners;
    std::vector<FanOut::Destination> addresses;
    for (int i = 0; i < 20; ++i) {
      listeners.push_back(UdpReceiver::open(*any).value());
      addresses.emplace_back(listeners.back().boundAddress());
    }
    std::vector<std::string> texts;
    for (int i = 0; i < 100; ++i) texts.push_back("datagram " + std::to_string(i));
    FanOut fan_out(from->fileDescriptor());
    std::uint64_t sent = 0;
    for (const std::string& text : texts) {
      for (const auto& each : addresses) fan_out.add(bytesOf(text), each);
      if (fan_out.full()) sent += fan_out.flush([] { return true; }).sent;
    }
    sent += fan_out.flush([] { return true; }).sent;
    EXPECT_EQ(sent, 2000U);
    EXPECT_TRUE(fan_out.empty());
    for (UdpReceiver& listener : listeners) {
      std::vector<std::string> heard;
      while (heard.size() < texts.size()) {
        const auto batch = listener.receive();
        ASSERT_TRUE(batch.ok() && !batch->empty());
        for (const auto& each : *batch) {
          heard.emplace_back(textOf(each.payload));
          EXPECT_EQ(each.sender, from->boundAddress());
        }
      }
      EXPECT_EQ(heard, texts);
    }
  }
}

TEST(FanOut, ADatagramThatTheSystemRefusesIsDroppedAlone) {
  auto from = UdpReceiver::open(Endpoint::parse("127.0.0.1:0").value()).value();
  auto listener = UdpReceiver::open(Endpoint::parse("127.0.0.1:0").value()).value();
  const FanOut::Destination home(listener.boundAddress());
  const std::string good = "good", too_long(70'000, 'x');
  FanOut fan_out(from.fileDescriptor());
  fan_out.add(bytesOf(good), home);
  fan_out.add(bytesOf(too_long), home);
  fan_out.add(bytesOf(good), home);
  const FanOut::Outcome outcome = fan_out.flush(dropTheRest);
  EXPECT_EQ(outcome.sent, 2U);
  EXPECT_EQ(outcome.dropped, 1U);
}

/// Takes some datagrams, then has no room; refuses one.
class NarrowSink final : public DatagramSink {
 public:
  Status send(std::span<const ByteView>) override { return {}; }
  Result<std::size_t> sendWithoutWaiting(std::span<const ByteView> payloads) override {
    if (textOf(payloads[0]) == "bad") return Error{ErrorKind::refused, "no", ""};
    if (room == 0) return std::size_t{0};
    --room;
    taken.emplace_back(textOf(payloads[0]));
    return std::size_t{1};
  }
  int fileDescriptor() const override { return -1; }
  const Endpoint& endpoint() const override { return endpoint_; }

  int room = 0;
  std::vector<std::string> taken;

 private:
  Endpoint endpoint_;
};

TEST(SendInOrder, WaitsForRoomAndDropsTheRest) {
  NarrowSink sink;
  const std::vector<std::string> texts = {"a", "bad", "b", "c"};
  std::vector<ByteView> payloads;
  for (const auto& each : texts) payloads.push_back(bytesOf(each));
  int waits = 0;
  const SendOutcome outcome = sendInOrder(sink, payloads, [&] {
    ++sink.room;
    return ++waits <= 2;
  });
  EXPECT_EQ(sink.taken, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(outcome.sent, 2U);
  EXPECT_EQ(outcome.dropped, 2U);
  EXPECT_EQ(outcome.trouble.value().what, "no");
}

}  // namespace
}  // namespace rocinante
