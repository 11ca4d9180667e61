#include "viewer/ui/live/source_rows.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

using namespace std::chrono_literals;

constexpr SteadyTime kFirstLook{Nanoseconds(1'000'000'000'000)};

using Counts = std::map<std::string, SourceCounts, std::less<>>;

TEST(SourceWatch, TurnsCountsIntoRatesOfTheLastSecond) {
  SourceWatch watch;
  Counts counts;
  for (int tenth = 0; tenth <= 30; ++tenth) {
    counts["arm"].packets += 5;
    watch.look(kFirstLook + tenth * 100ms, counts);
  }
  ASSERT_EQ(watch.sources().size(), 1U);
  EXPECT_NEAR(watch.sources()[0].rate_hz, 50, 0.5);
  EXPECT_EQ(watch.sources()[0].packets, 155U);
  EXPECT_FALSE(watch.look(kFirstLook + 3050ms, counts)) << "a tenth has not passed";
}

TEST(SourceWatch, TellsASourceThatIsHeardWholeAndFiltered) {
  SourceWatch watch;
  Counts counts;
  counts["arm"].packets = counts["arm"].filtered = 7;
  watch.look(kFirstLook, counts);
  EXPECT_FALSE(watch.sources()[0].is_mixed);
  counts["arm"].whole = 1;
  EXPECT_TRUE(watch.look(kFirstLook + 200ms, counts));
  EXPECT_TRUE(watch.sources()[0].is_mixed);
}

TEST(SourceWatch, ASourceThatStopsKeepsItsCountsAndWhenItWasHeard) {
  SourceWatch watch;
  Counts counts;
  counts["arm"].packets = 7;
  counts["arm"].gap = 2;
  EXPECT_TRUE(watch.look(kFirstLook, counts));
  for (int tenth = 1; tenth <= 40; ++tenth) watch.look(kFirstLook + tenth * 100ms, counts);
  ASSERT_EQ(watch.sources().size(), 1U);
  EXPECT_EQ(watch.sources()[0].rate_hz, 0);
  EXPECT_EQ(watch.sources()[0].lost, 2U);
  EXPECT_EQ(watch.sources()[0].heard, kFirstLook);
  EXPECT_FALSE(watch.look(kFirstLook + 5s, counts)) << "nothing became another";
}

TEST(SourceWatch, OneThatOnlyOthersSpokeForIsNone) {
  SourceWatch watch;
  Counts counts;
  counts["arm"].by_others = 3;
  watch.look(kFirstLook, counts);
  EXPECT_TRUE(watch.sources().empty());
}

TEST(SourceRows, TellWhoIsSilentWhoNeverSpokeAndWhoIsOffItsRate) {
  Cell cell;
  cell.sources.push_back({"arm", std::pair(50.0, 70.0), {}, {}, {}});
  cell.sources.push_back({"patient", {}, SourceLimits{30.0, {}, {}, {}}, {}, {}});
  cell.sources.push_back({"planner", {}, {}, {}, {}});
  std::vector<LiveSource> live(3);
  live[0] = {"arm", 20, kFirstLook - 100ms};
  live[1] = {"patient", 0, kFirstLook - 10s};
  live[2] = {"stranger", 0, kFirstLook - 10s};
  const auto rows = sourceRows(live, cell, kFirstLook);
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0].name, "arm");
  EXPECT_TRUE(rows[0].off_rate);
  EXPECT_FALSE(rows[0].is_silent);
  EXPECT_FALSE(rows[1].is_silent) << "the cell grants it 30 s";
  EXPECT_EQ(rows[2].name, "planner");
  EXPECT_EQ(rows[2].live, nullptr);
  EXPECT_TRUE(rows[2].is_silent);
  EXPECT_TRUE(rows[3].is_silent);
}

TEST(SourceRows, AgesStandStillForASecondAtLeast) {
  EXPECT_EQ(ageText(900ms), "now");
  EXPECT_EQ(ageText(1999ms), "1 s");
  EXPECT_EQ(ageText(61s), "1 min");
  EXPECT_EQ(ageText(2h), "2 h");
}

}  // namespace
}  // namespace rocinante
