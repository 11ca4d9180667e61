#include "core/recording/loss_ledger.h"

#include <gtest/gtest.h>

#include "tests/core/recording/fake_clocks.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using test::logTime;

EndpointLoss kernelLoss(std::uint32_t endpoint, Nanoseconds from, Nanoseconds until,
                        std::uint64_t count) {
  EndpointLoss loss{endpoint, logTime(from), logTime(until), {}};
  loss.counts.kernel = count;
  return loss;
}

TEST(LossLedger, GathersASpanAndGivesItWhenTheLogHasReachedIt) {
  LossLedger ledger(1);
  ledger.add(kernelLoss(0, 10ms, 11ms, 3));
  ledger.add(kernelLoss(0, 50ms, 60ms, 4));
  EXPECT_TRUE(ledger.due(logTime(60ms)).empty());
  const auto due = ledger.due(logTime(111ms));
  ASSERT_EQ(due.size(), 1U);
  EXPECT_EQ(due[0].from, logTime(10ms));
  EXPECT_EQ(due[0].until, logTime(60ms));
  EXPECT_EQ(due[0].counts.kernel, 7U);
  EXPECT_TRUE(ledger.due(logTime(1h)).empty());
  EXPECT_TRUE(ledger.rest().empty());
}

TEST(LossLedger, AConstantLossIsToldAllTheWhile) {
  LossLedger ledger(1);
  std::uint64_t told = 0;
  std::size_t spans = 0;
  for (int i = 0; i < 10'000; ++i) {
    ledger.add(kernelLoss(0, 1ms * i, 1ms * (i + 1), 2));
    for (const EndpointLoss& each : ledger.due(logTime(1ms * i - 20ms))) {
      told += each.counts.kernel;
      ++spans;
    }
  }
  EXPECT_GE(told, 19'000U);
  EXPECT_LE(spans, 100U);
  for (const EndpointLoss& each : ledger.rest()) told += each.counts.kernel;
  EXPECT_EQ(told, 20'000U);
}

TEST(LossLedger, KeepsEndpointsAndKindsApart) {
  LossLedger ledger(2);
  ledger.add(kernelLoss(0, 1ms, 2ms, 1));
  EndpointLoss queue{1, logTime(3ms), logTime(4ms), {}};
  queue.counts.queue = 5;
  queue.counts.truncated = 6;
  ledger.add(queue);
  EXPECT_EQ(ledger.rest().size(), 2U);
  EXPECT_EQ(ledger.totals()[0], (LossCounts{1, 0, 0, 0}));
  EXPECT_EQ(ledger.totals()[1], (LossCounts{0, 5, 0, 6}));
}

}  // namespace
}  // namespace rocinante
