#include "core/recording/reorder_window.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/core/recording/fake_clocks.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using test::logTime;

const SocketAddress kReorderedSender = SocketAddress::parse("10.0.0.1", 5000).value();

TEST(ReorderWindow, MergesEndpointsInOrderOfTime) {
  ReorderWindow window(2);
  DatagramBlock block;
  block.add(0, logTime(1ms), kReorderedSender, {});
  block.add(0, logTime(4ms), kReorderedSender, {});
  block.add(1, logTime(2ms), kReorderedSender, {});
  block.add(1, logTime(3ms), kReorderedSender, {});
  window.add(block);
  std::vector<LogTime> times;
  while (const auto held = window.nextOfAll()) times.push_back(held->time);
  EXPECT_EQ(times, (std::vector{logTime(1ms), logTime(2ms), logTime(3ms), logTime(4ms)}));
  EXPECT_EQ(window.late(), 0U);
}

TEST(ReorderWindow, HoldsWhatAnEarlierOneMayStillPrecede) {
  ReorderWindow window(2);
  DatagramBlock block;
  block.add(0, logTime(100ms), kReorderedSender, {});
  window.add(block);
  EXPECT_FALSE(window.next(logTime(119ms)));
  EXPECT_TRUE(window.next(logTime(120ms)));
  EXPECT_FALSE(window.next(logTime(1h)));
}

TEST(ReorderWindow, EqualTimesGoByEndpoint) {
  ReorderWindow window(3);
  DatagramBlock block;
  for (const std::uint32_t endpoint : {2U, 0U, 1U})
    block.add(endpoint, logTime(1ms), kReorderedSender, {});
  window.add(block);
  for (const std::uint32_t endpoint : {0U, 1U, 2U}) {
    EXPECT_EQ(window.nextOfAll()->arrival->endpoint, endpoint);
  }
}

TEST(ReorderWindow, RaisesAndCountsWhatComesTooLate) {
  ReorderWindow window(2);
  DatagramBlock first;
  first.add(0, logTime(100ms), kReorderedSender, {});
  window.add(first);
  ASSERT_TRUE(window.next(logTime(200ms)));
  DatagramBlock second;
  second.add(1, logTime(50ms), kReorderedSender, {});
  window.add(second);
  const auto late = window.next(logTime(200ms));
  ASSERT_TRUE(late);
  EXPECT_EQ(late->time, logTime(100ms));
  EXPECT_EQ(window.late(), 1U);
}

/// However they are spread over sockets and blocks, all are returned once, sorted, each socket's
/// own in its order.
TEST(ReorderWindow, GivesEverythingOnceInOrder) {
  std::mt19937 random(1996);
  for (int round = 0; round < 50; ++round) {
    constexpr std::size_t kEndpoints = 4;
    ReorderWindow window(kEndpoints);
    std::vector<std::unique_ptr<DatagramBlock>> blocks;
    std::vector<LogTime> last(kEndpoints, logTime(0ns));
    std::vector<std::uint32_t> arrived(kEndpoints), left(kEndpoints);
    std::size_t added = 0;
    std::size_t given = 0;
    LogTime before{};
    const auto check = [&](const ReorderWindow::Held& held) {
      EXPECT_LE(before, held.time);
      before = held.time;
      const std::uint32_t endpoint = held.arrival->endpoint;
      EXPECT_EQ(textOf(held.block->payload(*held.arrival)), std::to_string(left[endpoint]++));
      ++given;
    };
    for (int pass = 0; pass < 20; ++pass) {
      blocks.push_back(std::make_unique<DatagramBlock>());
      for (std::uint32_t endpoint = 0; endpoint < kEndpoints; ++endpoint) {
        for (auto i = random() % 6; i > 0; --i) {
          last[endpoint] += Nanoseconds(random() % 5'000'000);
          const std::string payload = std::to_string(arrived[endpoint]++);
          ASSERT_TRUE(
              blocks.back()->add(endpoint, last[endpoint], kReorderedSender, bytesOf(payload)));
          ++added;
        }
      }
      window.add(*blocks.back());
      const LogTime drained = *std::min_element(last.begin(), last.end());
      while (const auto held = window.next(drained)) check(*held);
    }
    while (const auto held = window.nextOfAll()) check(*held);
    EXPECT_EQ(given, added);
    EXPECT_EQ(window.late(), 0U);
  }
}

}  // namespace
}  // namespace rocinante
