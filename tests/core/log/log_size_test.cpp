#include <gtest/gtest.h>

#include "tests/core/log/log_support.h"
#include "tests/support/joint_packets.h"

namespace rocinante::test {
namespace {

/// The size of a log of `count` packets at `rate_hz`, with flushIfDue() every 10 ms as the recorder
/// does, or never.
std::size_t logBytes(double rate_hz, std::size_t count, bool flushed) {
  Bytes file;
  LogWriter writer = makeWriter(file);
  const ChannelId channel = *writer.addChannel("/udp/19960/arm", "rk1", {});
  const Nanoseconds period(static_cast<std::int64_t>(1e9 / rate_hz));
  constexpr Nanoseconds kLook = std::chrono::milliseconds(10);
  SteadyTime look{};
  for (std::size_t i = 0; i < count; ++i) {
    // Timestamps of a busy machine.
    const auto jitter = static_cast<std::int64_t>(i * 2'654'435'761U % 200'000U);
    const Nanoseconds since = period * static_cast<std::int64_t>(i);
    for (; flushed && look <= SteadyTime(since); look += kLook) {
      EXPECT_TRUE(writer.flushIfDue(look).ok());
    }
    const std::string packet = jointPacket(i, rate_hz);
    const std::int64_t sent_ns = 1'770'091'506'000'000'000 + since.count() / 1000 * 1000;
    EXPECT_TRUE(writer
                    .write(channel, static_cast<std::uint32_t>(i), at(sent_ns + 40'000 + jitter),
                           sent_ns, bytesOf(packet))
                    .ok());
  }
  EXPECT_TRUE(writer.close("finished").ok());
  return file.size();
}

void expectWithin(double rate_hz, double ratio) {
  const std::size_t packets = 20'000;  // two and a half chunks
  const std::size_t safe = logBytes(rate_hz, packets, true);
  const std::size_t bare = logBytes(rate_hz, packets, false);
  const double found = static_cast<double>(safe) / static_cast<double>(bare);
  EXPECT_LE(found, ratio);
  EXPECT_NE(safe, bare) << "nothing was flushed";
  std::printf("%g packets/s: %.1f bytes a packet, %.3f x 1 MiB chunks\n", rate_hz,
              static_cast<double>(safe) / static_cast<double>(packets), found);
}

TEST(LogSize, AtTenPacketsASecondIsWithinOneAndAHalfOfWholeChunks) { expectWithin(10, 1.5); }
TEST(LogSize, AtAHundredPacketsASecondIsWithinOneAndAQuarterOfWholeChunks) {
  expectWithin(100, 1.25);
}
TEST(LogSize, AtSixThousandPacketsASecondIsThatOfWholeChunks) { expectWithin(6'000, 1.05); }

}  // namespace
}  // namespace rocinante::test
