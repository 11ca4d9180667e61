#include "core/recording/hand_over.h"

#include <gtest/gtest.h>

#include <thread>

#include "tests/core/recording/fake_clocks.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using test::logTime;

const SocketAddress kHandedSender = SocketAddress::parse("10.0.0.1", 5000).value();

TEST(DatagramBlock, TakesTheLongestDatagramAndStopsWhenFull) {
  DatagramBlock block;
  const std::string longest(65'535, 'x');
  std::size_t taken = 0;
  while (block.add(0, logTime(0ns), kHandedSender, bytesOf(longest))) ++taken;
  EXPECT_EQ(taken, DatagramBlock::kBytes / longest.size());
  block.clear();
  EXPECT_TRUE(block.empty());
  // Empty datagrams use memory too.
  for (taken = 0; block.add(0, logTime(0ns), kHandedSender, {});) ++taken;
  EXPECT_EQ(taken, DatagramBlock::kArrivals);
}

TEST(HandOver, MakesNoMoreBlocksThanItMay) {
  HandOver queue(2);
  auto first = queue.freeBlock();
  auto second = queue.freeBlock();
  EXPECT_TRUE(first && second);
  EXPECT_FALSE(queue.freeBlock());
  const DatagramBlock* again = first.get();
  queue.giveBack(std::move(first));
  EXPECT_EQ(queue.freeBlock().get(), again);
}

TEST(HandOver, GathersLossesByEndpointAndBoundsSteps) {
  HandOver queue(1);
  for (int i = 0; i < 5'000; ++i) {
    EndpointLoss loss{static_cast<std::uint32_t>(i % 2), logTime(1ms * i), logTime(1ms * i), {}};
    loss.counts.queue = 1;
    std::vector<EndpointLoss> losses{loss};
    std::vector<ClockStep> steps{{logTime(1ms * i), 5ms}};
    queue.give(nullptr, losses, steps, std::nullopt);
    EXPECT_TRUE(losses.empty() && steps.empty());
  }
  const TakenOver taken = queue.take(0ns);
  ASSERT_EQ(taken.losses.size(), 2U);
  EXPECT_EQ(taken.losses[1].counts.queue, 2'500U);
  EXPECT_EQ(taken.losses[1].from, logTime(1ms));
  EXPECT_EQ(taken.losses[1].until, logTime(4'999ms));
  EXPECT_LE(taken.steps.size(), 1'000U);
}

TEST(HandOver, WhatIsDrainedNeverGoesBack) {
  HandOver queue(1);
  std::vector<EndpointLoss> losses;
  std::vector<ClockStep> steps;
  queue.give(nullptr, losses, steps, logTime(9ms));
  EXPECT_EQ(queue.take(0ns).drained_until, logTime(9ms));
  queue.give(nullptr, losses, steps, logTime(5ms));
  EXPECT_EQ(queue.take(0ns).drained_until, logTime(9ms));
}

TEST(HandOver, CarriesEverythingBetweenThreadsInOrder) {
  HandOver queue(4);
  constexpr std::uint32_t kCount = 20'000;
  std::thread giver([&] {
    std::vector<EndpointLoss> losses;
    std::vector<ClockStep> steps;
    for (std::uint32_t i = 0; i < kCount;) {
      auto block = queue.freeBlock();
      if (!block) {
        std::this_thread::yield();
        continue;
      }
      for (int each = 0; each < 7 && i < kCount; ++each, ++i) {
        const std::string payload = std::to_string(i);
        block->add(0, logTime(1us * i), kHandedSender, bytesOf(payload));
      }
      queue.give(std::move(block), losses, steps, logTime(1us * i));
    }
    queue.finish();
  });
  std::uint32_t expected = 0;
  for (bool finished = false; !finished;) {
    TakenOver taken = queue.take(10ms);
    finished = taken.finished;
    for (auto& block : taken.blocks) {
      for (const Arrival& arrival : block->arrivals()) {
        EXPECT_EQ(textOf(block->payload(arrival)), std::to_string(expected++));
      }
      queue.giveBack(std::move(block));
    }
    EXPECT_LE(taken.drained_until, logTime(1us * expected));
  }
  giver.join();
  EXPECT_EQ(expected, kCount);
}

}  // namespace
}  // namespace rocinante
