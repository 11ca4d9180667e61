#include "core/series/series_table.h"

#include <gtest/gtest.h>

#include "core/base/atomic_file.h"
#include "core/series/derived_value.h"
#include "tests/core/series/spoken_log.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

using test::spokenTime;

class Table : public testing::Test {
 protected:
  void SetUp() override {
    test::writeSpoken(folder_ / "s.mcap",
                      {{0, "RK1 s 0 -\njoint arm j1=0.1"},
                       {100, "RK1 s 1 -\njoint arm j1=0.30000000000000004\njoint other j=1"},
                       {200, "RK1 s 2 -\njoint other j=2"},
                       {300, "RK1 s 3 -\npose tray 1 2 3 0 0 0 1"},
                       {400, "RK1 s 4 -\nremove arm"}});
  }
  Result<std::uint64_t> write(SeriesTable table) {
    auto reader = LogReader::open(folder_ / "s.mcap");
    EXPECT_TRUE(reader.ok());
    return writeSeriesTable(table, SessionState(), *reader, folder_ / "t.csv");
  }

  static std::optional<LogTime> leadOf(const SeriesTable& table) {
    return rocinante::leadOf({table.keys.begin(), table.keys.end()}, table.from, spokenTime(0));
  }

  const test::TemporaryFolder folder_;
};

TEST_F(Table, HasARowForEveryPacketAboutItsDevices) {
  SeriesTable table;
  table.keys = {*parseSeriesKey("arm.j1"), *parseSeriesKey("tray:z")};
  table.from = spokenTime(0) - Nanoseconds(1);
  table.until = spokenTime(1000);
  const auto rows = write(table);
  ASSERT_TRUE(rows.ok()) << rows.error().text();
  EXPECT_EQ(*rows, 4U);
  EXPECT_EQ(*readFile(folder_ / "t.csv"),
            "t,arm.j1,tray:z\n"
            "0,0.1,\n"
            "0.1,0.30000000000000004,\n"
            "0.3,0.30000000000000004,3\n"
            "0.4,,3\n");
}

TEST_F(Table, EndsWhereItIsTold) {
  SeriesTable table;
  table.keys = {*parseSeriesKey("arm.j1")};
  table.from = spokenTime(0) - Nanoseconds(1);
  table.until = spokenTime(100);
  EXPECT_EQ(*write(table), 2U);
}

TEST_F(Table, RefusesRatesNothingAndAFolder) {
  SeriesTable table;
  table.from = spokenTime(0);
  table.until = spokenTime(1000);
  EXPECT_FALSE(write(table).ok());
  table.keys = {*parseSeriesKey("rate")};
  EXPECT_EQ(write(table).error().text(), "a table has joints, poses and signals only (rate)");
  table.keys = {*parseSeriesKey("nobody.j1")};
  EXPECT_FALSE(write(table).ok());
  EXPECT_FALSE(std::filesystem::exists(folder_ / "t.csv"));
  std::filesystem::create_directory(folder_ / "t.csv");
  table.keys = {*parseSeriesKey("arm.j1")};
  EXPECT_FALSE(write(table).ok());
}

TEST_F(Table, HasWhatIsDerivedAlone) {
  SeriesTable table;
  table.keys = {*parseSeriesKey("d/dt arm.j1")};
  table.from = spokenTime(0) - Nanoseconds(1);
  table.until = spokenTime(1000);
  const auto rows = write(table);
  ASSERT_TRUE(rows.ok()) << rows.error().text();
  EXPECT_EQ(*readFile(folder_ / "t.csv"), "t,\"d/dt arm.j1\"\n0.1,2.0000000000000004\n");
  table.from = spokenTime(0);
  EXPECT_EQ(*write(table), 1U) << "the first sample has its time";
}

TEST_F(Table, KnowsWhatIsDerivedWhereItBegins) {
  SeriesTable table;
  table.keys = {*parseSeriesKey("d/dt arm.j1"), *parseSeriesKey("mean 0.1 tray:x"),
                *parseSeriesKey("other.j - arm.j1")};
  table.from = spokenTime(150);
  table.until = spokenTime(350);
  EXPECT_FALSE(leadOf(table).has_value());
  const std::string expected =
      "t,\"d/dt arm.j1\",\"mean 0.1 tray:x\",\"other.j - arm.j1\"\n"
      "0.15,2.0000000000000004,,0.7\n"
      "0.2,2.0000000000000004,,1.7\n"
      "0.3,2.0000000000000004,1,1.7\n";
  ASSERT_TRUE(write(table).ok());
  EXPECT_EQ(*readFile(folder_ / "t.csv"), expected);
}

TEST_F(Table, ReadsNoFurtherBackThanDerivedValuesReach) {
  SeriesTable table;
  table.keys = {*parseSeriesKey("arm.j1")};
  table.from = spokenTime(100'000);
  EXPECT_FALSE(leadOf(table).has_value());
  table.keys.push_back(*parseSeriesKey("mean 2 d/dt arm.j1"));
  const auto lead = leadOf(table);
  ASSERT_TRUE(lead.has_value());
  EXPECT_LT(*lead, spokenTime(98'000));
  EXPECT_GT(*lead, spokenTime(50'000));
  table.keys.push_back(*parseSeriesKey("mean 3600 arm.j1"));
  EXPECT_FALSE(leadOf(table).has_value());
}

}  // namespace
}  // namespace rocinante
