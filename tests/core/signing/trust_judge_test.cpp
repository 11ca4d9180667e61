#include "core/signing/trust_judge.h"

#include <gtest/gtest.h>

#include "tests/core/signing/signing_support.h"

namespace rocinante {
namespace {

using test::kSignedPacket;
using test::kVectorAt;
using test::signedText;
using test::vectorKey;
using test::wallAt;

std::string judged(TrustJudge& judge, std::string_view datagram, std::int64_t now = kVectorAt) {
  const auto reason = judge.judge(bytesOf(datagram), wallAt(now));
  return reason ? std::string(nameOf(*reason)) : "trusted";
}

TrustJudge armJudge() { return TrustJudge(test::trusting(vectorKey(), {"arm"})); }
TrustJudge relayJudge() { return TrustJudge(test::trusting(vectorKey(), {"arm"}, true)); }

TEST(TrustJudge, TrustsWhatIsSignedOnce) {
  TrustJudge judge = armJudge();
  EXPECT_EQ(judged(judge, kSignedPacket), "trusted");
  EXPECT_EQ(judged(judge, kSignedPacket), "repeated");
}

TEST(TrustJudge, AKeySpeaksForItsSourcesOnly) {
  TrustJudge judge = armJudge();
  EXPECT_EQ(judged(judge, signedText("RK1 gantry 1 -\n")), "not_allowed");
  EXPECT_EQ(judged(judge, signedText("RK1 arm%2Fx 1 -\n")), "not_allowed");
  EXPECT_EQ(judged(judge, signedText("RK1 %61rm 1 -\n")), "trusted");
  EXPECT_EQ(judged(judge, signedText("RK1 arm 1 -\n", kVectorAt, 1)), "unknown_key");
  EXPECT_EQ(judged(judge, signedText("RK1 arm x -\n")), "malformed");
}

TEST(TrustJudge, OnlyARelaySaysByAndViaAndSubscriptionLines) {
  const std::array<std::string, 3> lines = {"RK1 arm 1 - restated by=relay\n",
                                            "RK1 arm 1 - via=relay:4\n",
                                            "RKS1 keep id=00000000000000ff\n"};
  std::int64_t at = kVectorAt;
  for (const std::string& line : lines) {
    SCOPED_TRACE(line);
    TrustJudge source = armJudge();
    TrustJudge relay = relayJudge();
    EXPECT_EQ(judged(source, signedText(line, ++at)), "not_allowed");
    EXPECT_EQ(judged(relay, signedText(line, at)), "trusted");
  }
  TrustJudge relay = relayJudge();
  EXPECT_EQ(judged(relay, signedText("RK1 gantry 1 - by=relay\n")), "not_allowed");
}

TEST(TrustJudge, AClockMayBeTenSecondsOff) {
  constexpr std::int64_t kMax = 10'000'000'000;
  for (const std::int64_t off : {kMax, -kMax}) {
    TrustJudge judge = armJudge();
    EXPECT_EQ(judged(judge, kSignedPacket, kVectorAt + off + (off > 0 ? 1 : -1)), "out_of_time");
    EXPECT_EQ(judged(judge, kSignedPacket, kVectorAt + off), "trusted");
  }
  TrustJudge judge = armJudge();
  EXPECT_EQ(judged(judge, kSignedPacket, -5), "out_of_time");
  EXPECT_EQ(judged(judge, signedText("RK1 arm - -", std::numeric_limits<std::int64_t>::max()), 0),
            "out_of_time");
}

TEST(TrustJudge, AForgeryIsNotRememberedInPlaceOfTheTruth) {
  TrustJudge judge = armJudge();
  std::string forged(kSignedPacket);
  forged[forged.find("1.57")] = '2';
  EXPECT_EQ(judged(judge, forged), "forged");
  EXPECT_EQ(judged(judge, kSignedPacket), "trusted");
  // What is known to be repeated costs no verification.
  EXPECT_EQ(judged(judge, forged), "repeated");
}

TEST(TrustJudge, EveryFlippedBitIsRefused) {
  TrustJudge judge = armJudge();
  for (std::size_t bit = 0; bit < kSignedPacket.size() * 8; ++bit) {
    std::string flipped(kSignedPacket);
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << (bit % 8)));
    EXPECT_NE(judged(judge, flipped), "trusted") << "bit " << bit;
  }
}

TEST(TrustJudge, ReorderedDatagramsAreTrustedEachOnce) {
  TrustJudge judge = armJudge();
  std::vector<std::string> datagrams;
  for (int i = 0; i < 64; ++i) datagrams.push_back(signedText("RK1 arm - -", kVectorAt + i));
  for (std::size_t i = 0; i < 64; ++i) {
    EXPECT_EQ(judged(judge, datagrams[i * 37 % 64]), "trusted") << i;
  }
  for (const std::string& each : datagrams) EXPECT_EQ(judged(judge, each), "repeated");
}

TEST(SeenTimes, RemembersTheNewestAndTakesOlderOnesForSeen) {
  SeenTimes seen;
  constexpr std::int64_t kCount = 3 * static_cast<std::int64_t>(SeenTimes::kLeast);
  for (std::int64_t at = 0; at < kCount; ++at) {
    EXPECT_FALSE(seen.has(10 * at));
    seen.add(10 * at);
  }
  for (std::int64_t at = 0; at < kCount; ++at) EXPECT_TRUE(seen.has(10 * at)) << at;
  const std::int64_t newest_kept = 10 * (kCount - static_cast<std::int64_t>(SeenTimes::kLeast));
  EXPECT_FALSE(seen.has(newest_kept + 5));
  EXPECT_TRUE(seen.has(5));
}

}  // namespace
}  // namespace rocinante
