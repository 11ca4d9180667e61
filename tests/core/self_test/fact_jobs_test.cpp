#include "core/self_test/fact_jobs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <cstdio>

namespace rocinante {
namespace {

using State = SelfTestFact::State;

// A passing test never waits this long.
constexpr Nanoseconds kLong = std::chrono::seconds(60);

FactJob answering(const char* name) {
  return {{name}, [name] { return std::vector{SelfTestFact{name, State::ok, "fine", ""}}; }};
}

FactJob doing(const char* name, std::function<void()> what) {
  return {{name}, [what] {
            what();
            return std::vector<SelfTestFact>();
          }};
}

/// As jobOfProgram(), of a line for the shell.
FactJob shell(std::vector<std::string> names, const char* line) {
  return {std::move(names), [line]() -> std::vector<SelfTestFact> {
            ::execl("/bin/sh", "sh", "-c", line, nullptr);
            ::_exit(127);
          }};
}

TEST(FactJobs, AnswerInTheOrderOfTheJobs) {
  const auto facts = findFacts({answering("one"), answering("two"), answering("three")}, kLong);
  ASSERT_EQ(facts.size(), 3U);
  EXPECT_EQ(facts[0], (SelfTestFact{"one", State::ok, "fine", ""}));
  EXPECT_EQ(facts[1].name, "two");
  EXPECT_EQ(facts[2].name, "three");
}

TEST(FactJobs, OneThatNeverAnswersIsEndedAndTheOthersStand) {
  const auto facts = findFacts({doing("stuck",
                                      [] {
                                        for (;;) ::pause();
                                      }),
                                answering("well")},
                               std::chrono::milliseconds(1500));
  ASSERT_EQ(facts.size(), 2U);
  EXPECT_EQ(facts[0].state, State::missing);
  EXPECT_THAT(facts[0].found, testing::HasSubstr("no answer within"));
  EXPECT_EQ(facts[1].state, State::ok) << facts[1].found;
}

TEST(FactJobs, OneThatAnsweredAndDoesNotEndIsEndedToo) {
  const FactJob job = shell({"stuck"}, "exec >&- 2>&-; sleep 600");
  const auto facts = findFacts({job}, std::chrono::milliseconds(300));
  ASSERT_EQ(facts.size(), 1U);
  EXPECT_THAT(facts[0].found, testing::HasSubstr("no answer within"));
}

TEST(FactJobs, ACrashCostsItsOwnFactsAndIsNamed) {
  const auto facts = findFacts({doing("driver",
                                      [] {
                                        ::signal(SIGSEGV, SIG_DFL);
                                        ::raise(SIGSEGV);
                                      }),
                                answering("well")},
                               kLong);
  EXPECT_THAT(facts[0].found, testing::HasSubstr("signal 11"));
  EXPECT_FALSE(facts[0].advice.empty());
  EXPECT_EQ(facts[1].state, State::ok);
}

TEST(FactJobs, AProgramThatCannotStartSaysWhy) {
  const FactJob job = shell({"context", "key"}, "echo 'libX.so.1: cannot open' >&2; exit 127");
  const auto facts = findFacts({job}, kLong);
  ASSERT_EQ(facts.size(), 2U);
  EXPECT_THAT(facts[0].found, testing::HasSubstr("it ended with exit 127"));
  EXPECT_THAT(facts[0].found, testing::HasSubstr("libX.so.1: cannot open"));
  EXPECT_EQ(facts[1].state, State::missing);
}

TEST(FactJobs, AProgramThatIsNotThereIsNoCrash) {
  const FactJob job = jobOfProgram({"frame"}, "/no/such/rocinante-draw", "install it");
  const auto facts = findFacts({job}, kLong);
  EXPECT_EQ(facts,
            (std::vector{SelfTestFact{"frame", State::missing,
                                      "rocinante-draw is not installed here", "install it"}}));
}

TEST(FactJobs, WhatADriverPrintsIsNotTakenForAnAnswer) {
  const FactJob job =
      shell({"frame"},
            "echo MESA: warning; echo '[{\"name\":\"frame\"}]'; echo '[{\"name\":\"frame\","
            "\"state\":\"limited\",\"says\":\"a\",\"advice\":\"b\"}]'; echo bye >&2");
  const auto facts = findFacts({job}, kLong);
  EXPECT_EQ(facts, (std::vector{SelfTestFact{"frame", State::limited, "a", "b"}}));
}

TEST(FactJobs, AnAnswerWithoutOneOfItsFactsIsSeen) {
  FactJob job = answering("one");
  job.names.push_back("two");
  const auto facts = findFacts({job}, kLong);
  EXPECT_EQ(facts[0].state, State::ok);
  EXPECT_EQ(facts[1].state, State::missing);
  EXPECT_EQ(facts[1].found, "no answer");
}

}  // namespace
}  // namespace rocinante
