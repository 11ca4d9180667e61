#include "core/relay/relay_filter.h"

#include <gtest/gtest.h>

#include "core/relay/paced_statements.h"

namespace rocinante {
namespace {

TEST(RelayFilter, WhatBelongsTogetherPassesTogether) {
  RelayFilter filter;
  EXPECT_TRUE(filter.passesEverything());
  filter.kinds = statementKindsOf("joint").value();
  EXPECT_FALSE(filter.passesEverything());
  for (const auto kind : {StatementKind::joints, StatementKind::order, StatementKind::joint}) {
    EXPECT_TRUE(filter.passesKind(kind));
  }
  EXPECT_FALSE(filter.passesKind(StatementKind::pose));
  filter.kinds = statementKindsOf("line").value();
  EXPECT_TRUE(filter.passesKind(StatementKind::erase));
  EXPECT_FALSE(filter.passesKind(StatementKind::points));
  filter.kinds = statementKindsOf("hide").value() | statementKindsOf("event").value();
  EXPECT_TRUE(filter.passesKind(StatementKind::show));
  EXPECT_TRUE(filter.passesKind(StatementKind::event));
}

TEST(RelayFilter, RefusesWhatIsNoStatement) {
  for (const char* word : {"", "jonts", "seen", "JOINTS"}) {
    EXPECT_FALSE(statementKindsOf(word).ok()) << word;
  }
}

TEST(RelayFilter, OnePatternOfSeveralIsEnough) {
  RelayFilter filter;
  filter.sources = {"a*", "b"};
  filter.devices = {"arm?"};
  EXPECT_TRUE(filter.passesSource("alpha"));
  EXPECT_TRUE(filter.passesSource("b"));
  EXPECT_FALSE(filter.passesSource("c"));
  EXPECT_TRUE(filter.passesDevice("arm1"));
  EXPECT_FALSE(filter.passesDevice("arm"));
}

TEST(RelayFilter, PatternsOfSignalsAreOverPathAndName) {
  RelayFilter filter;
  EXPECT_TRUE(filter.passesSignal("arm load"));
  filter.signals = {"arm *.effort", "arm/tool0 *", "- estop"};
  EXPECT_FALSE(filter.passesEverything());
  EXPECT_TRUE(filter.passesSignal("arm j1.effort"));
  EXPECT_TRUE(filter.passesSignal("arm/tool0 force"));
  EXPECT_TRUE(filter.passesSignal("- estop"));
  EXPECT_FALSE(filter.passesSignal("arm load"));
  EXPECT_FALSE(filter.passesSignal("estop"));
}

TEST(TokenBucket, HoldsTheRateAndAllowsABurst) {
  LogTime now{};
  TokenBucket bucket(1000, 100, now);
  std::size_t sent = 0;
  for (int ms = 0; ms < 10'000; ++ms) {
    now += std::chrono::milliseconds(1);
    while (bucket.allows(now)) {
      bucket.spend(30);
      sent += 30;
    }
    EXPECT_GT(bucket.allowsAt(), now);
  }
  EXPECT_GE(sent, 10'000U);
  EXPECT_LE(sent, 10'130U);
}

}  // namespace
}  // namespace rocinante
