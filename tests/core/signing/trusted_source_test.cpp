#include <gtest/gtest.h>

#include "core/signing/trust_judge.h"
#include "tests/core/net/fake_source.h"
#include "tests/core/signing/signing_support.h"

namespace rocinante {
namespace {

using test::FakeSource;
using test::kVectorAt;
using test::signedText;
using test::wallAt;

struct Trusting {
  explicit Trusting(std::shared_ptr<TrustJudge> judge) {
    auto fake = std::make_unique<FakeSource>("127.0.0.1:1");
    inner = fake.get();
    source = std::make_unique<TrustedSource>(std::move(fake), std::move(judge));
  }
  std::size_t received() const { return source->receive().value().size(); }
  UntrustedCounts untrusted() const { return source->counts().untrusted.value(); }

  FakeSource* inner;
  std::unique_ptr<TrustedSource> source;
};

std::shared_ptr<TrustJudge> makeJudge() {
  return std::make_shared<TrustJudge>(test::trusting(test::vectorKey(), {"arm"}));
}

TEST(TrustedSource, GivesWhatIsTrustedAndCountsTheRestByReason) {
  Trusting setup(makeJudge());
  const std::string good = signedText("RK1 arm 1 -\n");
  std::string forged = signedText("RK1 arm 2 -\n", kVectorAt + 1);
  forged[8] = '3';
  const WallTime now = wallAt(kVectorAt);
  setup.inner->arrive({{good, now}, {"RK1 arm 3 -\n", now}, {forged, now}, {good, now}});
  EXPECT_EQ(setup.received(), 1U);
  EXPECT_EQ(setup.untrusted().text(), "1 not signed, 1 repeated, 1 forged");
  EXPECT_EQ(setup.untrusted().total(), 3U);
}

TEST(TrustedSource, JudgesByTheTimeOfArrival) {
  Trusting setup(makeJudge());
  setup.inner->arrive({{signedText("RK1 arm 1 -\n"), wallAt(kVectorAt + 11'000'000'000)}});
  EXPECT_EQ(setup.received(), 0U);
  EXPECT_EQ(setup.untrusted().of(Untrusted::out_of_time), 1U);
}

TEST(TrustedSource, AFloodOfForgeriesIsNoSilence) {
  Trusting setup(makeJudge());
  for (int i = 0; i < 10; ++i) setup.inner->arrive({{"x", wallAt(0)}, {"y", wallAt(0)}});
  setup.inner->arrive({{signedText("RK1 arm 1 -\n"), wallAt(kVectorAt)}});
  EXPECT_EQ(setup.received(), 1U);
  EXPECT_EQ(setup.untrusted().of(Untrusted::not_signed), 20U);
}

TEST(TrustedSource, WhatOneInputAcceptedAnotherDoesNot) {
  const auto judge = makeJudge();
  Trusting one(judge);
  Trusting other(judge);
  const std::string good = signedText("RK1 arm 1 -\n");
  one.inner->arrive({{good, wallAt(kVectorAt)}});
  other.inner->arrive({{good, wallAt(kVectorAt)}});
  EXPECT_EQ(one.received(), 1U);
  EXPECT_EQ(other.received(), 0U);
  EXPECT_EQ(other.untrusted().of(Untrusted::repeated), 1U);
}

TEST(TrustedSource, ThatTheSocketFailsIsPassedOn) {
  Trusting setup(makeJudge());
  setup.inner->fail();
  EXPECT_FALSE(setup.source->receive().ok());
}

}  // namespace
}  // namespace rocinante
