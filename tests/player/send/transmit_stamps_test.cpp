#include "player/send/transmit_stamps.h"

#include <gtest/gtest.h>

#include <array>

#include "core/net/udp_socket.h"

namespace rocinante {
namespace {

constexpr SteadyTime kClock{};  // time of a datagram without a timestamp

struct Sending {
  UdpReceiver receiver = UdpReceiver::open(Endpoint::parse("127.0.0.1:0").value()).value();
  UdpSender sender = UdpSender::open(Endpoint::parse(boundText(receiver)).value()).value();
  TransmitStamps stamps{sender.fileDescriptor()};

  void send() { ASSERT_TRUE(sender.send(bytesOf("x")).ok()); }
  SteadyTime collectOne() {
    std::array<SteadyTime, 1> sent_at{kClock};
    stamps.collect(sent_at);
    return sent_at[0];
  }
};

TEST(TransmitStamps, EachDatagramHasTheKernelsStamp) {
  Sending sending;
  SteadyTime before = kClock;
  for (int i = 0; i < 3; ++i) {
    sending.send();
    const SteadyTime stamp = sending.collectOne();
    if (stamp == kClock) GTEST_SKIP() << "no transmit stamps here";
    EXPECT_GT(stamp, before);
    before = stamp;
  }
  EXPECT_EQ(sending.stamps.stamped(), 3U);
}

TEST(TransmitStamps, ALateStampIsNoLaterDatagrams) {
  Sending sending;
  sending.send();
  if (sending.collectOne() == kClock) GTEST_SKIP() << "no transmit stamps here";
  // Read before the device has reported: there is no timestamp.
  EXPECT_EQ(sending.collectOne(), kClock);
  // The device now reports the first datagram, but not yet the requested one.
  sending.send();
  EXPECT_EQ(sending.collectOne(), kClock);
  EXPECT_EQ(sending.stamps.stamped(), 1U);
  EXPECT_EQ(sending.stamps.unstamped(), 2U);
}

TEST(TransmitStamps, ADatagramThatWasRefusedAtFirstSpoilsNothing) {
  Sending sending;
  sending.send();
  if (sending.collectOne() == kClock) GTEST_SKIP() << "no transmit stamps here";
  sending.send();  // the first try, which took a number
  sending.send();
  EXPECT_EQ(sending.collectOne(), kClock);  // two came, one was expected
  sending.send();
  EXPECT_NE(sending.collectOne(), kClock);
  EXPECT_EQ(sending.stamps.stamped(), 2U);
}

}  // namespace
}  // namespace rocinante
