#include "core/net/receive_buffer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/sock_diag.h>
#include <sys/socket.h>

#include <array>

#include "core/net/udp_socket.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;

/// The kernel's charge for one waiting datagram on this machine.
std::uint64_t measuredCharge(std::size_t payload_bytes) {
  auto receiver = UdpReceiver::open(Endpoint::parse("127.0.0.1:0").value()).value();
  Endpoint to = receiver.endpoint();
  to.address = receiver.boundAddress();
  auto sender = UdpSender::open(to).value();
  const std::string payload(payload_bytes, 'x');
  EXPECT_TRUE(sender.send(bytesOf(payload)).ok());
  std::array<std::uint32_t, SK_MEMINFO_VARS> info{};
  socklen_t length = sizeof info;
  EXPECT_EQ(::getsockopt(receiver.fileDescriptor(), SOL_SOCKET, SO_MEMINFO, info.data(), &length),
            0);
  return info[SK_MEMINFO_RMEM_ALLOC];
}

TEST(ReceiveBuffer, ChargesAsThisKernelDoes) {
  // Kernels round differently; the advice allows for a factor of two.
  for (const std::size_t bytes : {0U, 100U, 400U, 1'200U, 4'000U, 9'000U, 40'000U, 65'507U}) {
    SCOPED_TRACE(bytes);
    const std::uint64_t measured = measuredCharge(bytes);
    EXPECT_LE(chargedBytes(bytes), 2 * measured);
    EXPECT_GE(2 * chargedBytes(bytes), measured);
  }
  EXPECT_EQ(chargedBytes(100), 832U);
}

TEST(ReceiveBuffer, NeedsWhatComesWhileTheReceiverIsAway) {
  EXPECT_EQ(neededReceiveBuffer({6'000, 100}, 50ms), 300U * 832);
  EXPECT_EQ(neededReceiveBuffer({6'000, 100}, 100ms), 600U * 832);
  EXPECT_EQ(neededReceiveBuffer({0, 0}), 0U);
  // Less than one datagram counts as one.
  EXPECT_EQ(neededReceiveBuffer({1, 100}, 50ms), 832U);
}

TEST(ReceiveBuffer, WhatAUserGetsByDefaultIsEnoughForSixThousandASecondAndNotForMore) {
  constexpr std::uint64_t kDefault = 2 * 212'992;
  EXPECT_FALSE(receiveBufferAdvice("udp://127.0.0.1:1", kDefault, {6'000, 100}).has_value());
  const auto advice = receiveBufferAdvice("udp://127.0.0.1:1", kDefault, {20'000, 100});
  ASSERT_TRUE(advice.has_value());
  EXPECT_EQ(*advice,
            "the receive buffer of udp://127.0.0.1:1 holds 26 ms of 20000 datagrams/s, and a busy "
            "machine may be away for 50 ms: run sysctl -w net.core.rmem_max=524288 and restart, or "
            "run as root");
}

TEST(ReceiveBuffer, TheSettingAdvisedIsEnough) {
  for (const double rate : {11'000.0, 50'000.0, 400'000.0}) {
    for (const double bytes : {10.0, 1'200.0, 9'000.0}) {
      const auto advice = receiveBufferAdvice("e", 425'984, {rate, bytes});
      ASSERT_TRUE(advice.has_value());
      const std::size_t at = advice->find("rmem_max=") + 9;
      const std::uint64_t setting = std::stoull(advice->substr(at));
      EXPECT_FALSE(receiveBufferAdvice("e", 2 * setting, {rate, bytes}).has_value());
    }
  }
}

TEST(ReceiveBuffer, HasNoAdviceForASourceThatIsNoSocket) {
  EXPECT_FALSE(receiveBufferAdvice("e", 0, {1e6, 100}).has_value());
}

}  // namespace
}  // namespace rocinante
