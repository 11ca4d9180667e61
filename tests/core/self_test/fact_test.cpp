#include "core/self_test/fact.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/self_test/machine_facts.h"

namespace rocinante {
namespace {

using State = SelfTestFact::State;

TEST(SelfTestFact, ComesThroughTheWireAsItWas) {
  const std::vector<SelfTestFact> facts{{"key", State::ok, "a \"quoted\" name\nof two lines", ""},
                                        {"frame", State::missing, "\xC3\xA9", "mend it"}};
  const std::string wire = factsWire(facts);
  EXPECT_EQ(wire.find('\n'), std::string::npos);
  EXPECT_EQ(factsOfWire(wire), facts);
}

TEST(SelfTestFact, WhatIsNotFactsIsRefused) {
  for (const char* line : {"", "[", "{}", "[1]", "[{}]",
                           "[{\"name\":\"a\",\"state\":\"fine\",\"says\":\"\",\"advice\":\"\"}]",
                           "[{\"name\":1,\"state\":\"ok\",\"says\":\"\",\"advice\":\"\"}]"}) {
    EXPECT_FALSE(factsOfWire(line)) << line;
  }
}

TEST(SelfTestFact, TextHasALineForEachAndCounts) {
  const std::vector<SelfTestFact> facts{{"key", State::ok, "llvmpipe", ""},
                                        {"clock", State::limited, "drifts", "install chrony"},
                                        {"frame", State::missing, "two\nlines", "mend it"}};
  EXPECT_EQ(factsText(facts),
            "ok       key             llvmpipe\n"
            "limited  clock           drifts; install chrony\n"
            "missing  frame           two\\x0alines; mend it\n"
            "1 ok, 1 limited, 1 missing\n");
}

TEST(SelfTestFact, AReceiveBufferIsJudgedByWhatWasAskedFor) {
  // 32 MiB requested, which the kernel counts twice.
  const SelfTestFact all = judgeReceiveBuffer(67'108'864, 67'108'864);
  EXPECT_EQ(all.state, State::ok);
  EXPECT_EQ(all.advice, "");
  // The default: 212992, counted twice; a datagram of 100 bytes takes 832.
  const SelfTestFact less = judgeReceiveBuffer(425'984, 67'108'864);
  EXPECT_EQ(less.state, State::limited);
  EXPECT_THAT(less.found, testing::HasSubstr("50 ms of 10240 datagrams/s of 100 bytes"));
  EXPECT_THAT(less.advice, testing::HasSubstr("net.core.rmem_max=33554432"));
}

TEST(SelfTestFact, AClockThatNothingSetsIsLimited) {
  EXPECT_EQ(judgeClock(true, 12'345).found, "synchronised, wrong by 12.3 ms at most");
  EXPECT_EQ(judgeClock(false, 16'000'000).state, State::limited);
}

}  // namespace
}  // namespace rocinante
