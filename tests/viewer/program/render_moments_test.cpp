#include "viewer/program/render_moments.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"
#include "viewer/program/render_files.h"
#include "viewer/render/source_rates.h"

namespace rocinante {
namespace {

class RenderMomentsTest : public testing::Test {
 protected:
  void SetUp() override {
    test::writeSession(folder_ / "log.mcap", {{0, "event \"start\"\n"},
                                              {950, "joints arm 1\n"},
                                              {1000, "event \"pick up\"\n"},
                                              {1900, "joints arm 2\n"},
                                              {2000, "event \"put/down\"\njoints arm 3\n"}});
  }
  Timeline session() {
    auto opened = Timeline::open(folder_ / "log.mcap");
    EXPECT_TRUE(opened.has_value());
    return std::move(*opened);
  }
  std::vector<std::int64_t> offsets(const MomentChoice& choice) {
    Timeline line = session();
    const auto moments = renderMoments(choice, line, hiding_);
    EXPECT_TRUE(moments.has_value()) << moments.error().text();
    std::vector<std::int64_t> found;
    for (const RenderMoment& moment : *moments) {
      found.push_back((moment.time - line.origin()).count());
    }
    return found;
  }

  test::TemporaryFolder folder_;
  StateDamage hiding_;
};

TEST_F(RenderMomentsTest, AFrameRateIsExactAndNeverDrifts) {
  MomentChoice choice;
  choice.rate = "30000/1001";
  const auto found = offsets(choice);
  ASSERT_EQ(found.size(), 60U);
  for (std::size_t i = 0; i < found.size(); ++i) {
    // Floor of i * 1001 / 30000 seconds in nanoseconds.
    EXPECT_EQ(found[i], static_cast<std::int64_t>(i) * 100'100'000 / 3) << i;
  }
}

TEST_F(RenderMomentsTest, SpansAreHalfOpenAndStepsCountFromTheOrigin) {
  MomentChoice choice;
  choice.every = "0.3s";
  choice.from = "0.6s";
  choice.until = "1.5s";
  EXPECT_EQ(offsets(choice), (std::vector<std::int64_t>{600'000'000, 900'000'000, 1'200'000'000}));
  choice.until.clear();
  choice.from = "1.7s";
  EXPECT_EQ(offsets(choice), (std::vector<std::int64_t>{1'800'000'000}));
}

TEST_F(RenderMomentsTest, EventsAreChosenByTheirText) {
  MomentChoice choice;
  choice.events = {"p*"};
  EXPECT_EQ(offsets(choice), (std::vector<std::int64_t>{1'000'000'000, 2'000'000'000}));
  choice.all_events = true;
  EXPECT_EQ(offsets(choice).size(), 3U);
}

TEST_F(RenderMomentsTest, NothingLeftAndTooMuchAreRefused) {
  Timeline line = session();
  MomentChoice choice;
  choice.every = "1ns";
  EXPECT_FALSE(renderMoments(choice, line, hiding_).has_value());
  choice.every = "9000000000s";
  EXPECT_EQ(renderMoments(choice, line, hiding_)->size(), 1U) << "the origin";
  choice.from = "1s";
  EXPECT_FALSE(renderMoments(choice, line, hiding_).has_value());
  choice.until = "0.5s";
  EXPECT_FALSE(renderMoments(choice, line, hiding_).has_value());
}

TEST_F(RenderMomentsTest, RatesAreThoseOfTheLastSecondHoweverTheyAreReached) {
  const auto rateAt = [&](SourceRates& rates, std::int64_t milliseconds) {
    const auto found = rates.at(test::sessionTime(milliseconds), hiding_);
    EXPECT_TRUE(found.has_value());
    return found->at("robot");
  };
  const std::vector<std::pair<std::int64_t, std::uint64_t>> expected{
      {0, 1}, {949, 1}, {950, 2}, {999, 2}, {1000, 2}, {1899, 2}, {1950, 2}, {2000, 2}};
  SourceRates forwards(std::move(*LogReader::open(folder_ / "log.mcap")));
  for (const auto& [time, rate] : expected) EXPECT_EQ(rateAt(forwards, time), rate) << time;
  for (auto at = expected.rbegin(); at != expected.rend(); ++at) {
    EXPECT_EQ(rateAt(forwards, at->first), at->second) << at->first;
    SourceRates alone(std::move(*LogReader::open(folder_ / "log.mcap")));
    EXPECT_EQ(rateAt(alone, at->first), at->second) << at->first;
  }
}

TEST(RenderFiles, TextOfStrangersBecomesAPlainName) {
  EXPECT_EQ(fileNamePart("picked"), "picked");
  EXPECT_EQ(fileNamePart("../../etc/passwd"), "etc_passwd");
  EXPECT_EQ(fileNamePart("a  b\n\x1B[31m\xC3\xA9 c"), "a_b_31m_c");
  EXPECT_EQ(fileNamePart("..."), "unnamed");
  EXPECT_EQ(fileNamePart(std::string(300, 'x')).size(), 60U);
}

TEST(FrameRate, SaysWhatItWasGivenInLowestTerms) {
  EXPECT_EQ(parseFrameRate("29.97")->text(), "2997/100");
  EXPECT_EQ(parseFrameRate("50/2")->text(), "25");
  for (const char* wrong : {"", "0", "-1", "1/0", "1001", "1e3", "1.23456", "/", "1/", "nan"}) {
    EXPECT_FALSE(parseFrameRate(wrong).has_value()) << wrong;
  }
}

}  // namespace
}  // namespace rocinante
