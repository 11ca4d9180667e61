#include "viewer/ui/model/packet_search.h"

#include <gtest/gtest.h>

#include "core/log/log_writer.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"

namespace rocinante {
namespace {

/// A log of datagrams as they are: (milliseconds from the origin, text).
void writeDatagrams(const std::filesystem::path& path,
                    const std::vector<std::pair<std::int64_t, std::string>>& datagrams) {
  auto writer = LogWriter::create(path, {}, "0123456789abcdef0123456789abcdef");
  ASSERT_TRUE(writer.has_value());
  const auto channel = writer->addChannel("/udp/19960/robot", "rk1", {{"source", "robot"}});
  ASSERT_TRUE(channel.has_value());
  std::uint32_t count = 0;
  for (const auto& [milliseconds, text] : datagrams) {
    const LogTime time = test::sessionTime(milliseconds);
    ASSERT_TRUE(
        writer->write(*channel, count++, time, time.time_since_epoch().count(), bytesOf(text)));
  }
  ASSERT_TRUE(writer->close("test").has_value());
}

class PacketBehindAValue : public testing::Test {
 protected:
  /// The text of the packet behind the item, "none", or an error.
  std::string behind(const StatedItem& item, std::int64_t at_ms, std::size_t step = 3) {
    auto search = PacketSearch::open(folder_ / "s.mcap");
    if (!search) return search.error().text();
    if (Status begun = search->begin(item, test::sessionTime(at_ms)); !begun) {
      return begun.error().text();
    }
    for (int i = 0; i < 1000 && !search->finished(); ++i) {
      if (const auto stepped = search->step(step); !stepped) return stepped.error().text();
    }
    return search->found() ? search->found()->text : search->finished() ? "none" : "not finished";
  }

  const test::TemporaryFolder folder_;
};

TEST_F(PacketBehindAValue, IsTheLastOneThatSaidIt) {
  const std::string first = "RK1 robot 0 -\njoints arm 0 0\n";
  const std::string posed = "RK1 robot 1 -\npose arm 1 0 0 0 0 0 1\n";
  const std::string named = "RK1 planner 0 -\njoint arm elbow=1\n";
  const std::string other = "RK1 robot 2 -\njoints leg 1 2\n";
  const std::string last = "RK1 robot 3 -\njoints arm 5 6\n";
  writeDatagrams(folder_ / "s.mcap",
                 {{0, first}, {10, posed}, {20, named}, {30, other}, {40, last}});
  EXPECT_EQ(behind({"arm", "elbow"}, 5), first);
  EXPECT_EQ(behind({"arm", "elbow"}, 20), named);  // at its own moment
  EXPECT_EQ(behind({"arm", "elbow"}, 35), named);
  EXPECT_EQ(behind({"arm", "shoulder"}, 35), first);
  EXPECT_EQ(behind({"arm", "elbow"}, 50), last);  // positional values clear named ones
  EXPECT_EQ(behind({"arm", ""}, 15), posed);
  EXPECT_EQ(behind({"arm", ""}, 39), named);
  EXPECT_EQ(behind({"leg", ""}, 29), "none");
  EXPECT_EQ(behind({"nobody", ""}, 50), "none");
}

TEST_F(PacketBehindAValue, IsNotOneThatCameLate) {
  const std::string newest = "RK1 robot 5 -\njoints arm 5\n";
  writeDatagrams(folder_ / "s.mcap", {{0, "RK1 robot 3 -\njoints arm 3\n"},
                                      {10, newest},
                                      {20, "RK1 robot 4 -\njoints arm 4\n"},
                                      {30, "no packet at all"}});
  EXPECT_EQ(behind({"arm", ""}, 100), newest);
}

TEST_F(PacketBehindAValue, TellsWhoSaidItAndWhen) {
  writeDatagrams(folder_ / "s.mcap",
                 {{1500, "RK1 robot@r 7 1700000001.25 restated by=relay\njoints arm 3\n"}});
  auto search = PacketSearch::open(folder_ / "s.mcap");
  ASSERT_TRUE(search.ok());
  ASSERT_TRUE(search->begin({"arm", ""}, test::sessionTime(2000)));
  ASSERT_TRUE(*search->step(100));
  ASSERT_TRUE(search->found().has_value());
  const PacketBehind& found = *search->found();
  EXPECT_EQ(found.source, "robot");
  EXPECT_EQ(found.sequence, 7U);
  EXPECT_EQ(found.by, "relay");
  EXPECT_TRUE(found.restated);
  EXPECT_EQ(found.topic, "/udp/19960/robot");
  EXPECT_EQ(found.time, test::sessionTime(1500));
  EXPECT_EQ(found.source_time, test::sessionTime(1250).time_since_epoch().count());
}

TEST_F(PacketBehindAValue, IsLookedForInStepsHoweverFarBackItIs) {
  std::vector<std::pair<std::int64_t, std::string>> datagrams{{0, "RK1 once 0 -\njoints tray 1\n"}};
  for (int i = 1; i < 3000; ++i) {
    datagrams.emplace_back(i, "RK1 robot " + std::to_string(i) + " -\njoints arm 1\n");
  }
  writeDatagrams(folder_ / "s.mcap", datagrams);
  PacketLookup lookup;
  lookup.wanted = true;
  int steps = 0;
  do {
    lookup.look(folder_ / "s.mcap", {"tray", ""}, test::sessionTime(5000), 500);
    ++steps;
  } while (lookup.searching() && steps < 100);
  EXPECT_EQ(steps, 6);
  ASSERT_TRUE(lookup.search->found().has_value());
  EXPECT_EQ(lookup.search->found()->source, "once");
  // The same question is not asked again, another is.
  lookup.look(folder_ / "s.mcap", {"tray", ""}, test::sessionTime(5000), 500);
  EXPECT_FALSE(lookup.searching());
  lookup.look(folder_ / "s.mcap", {"arm", ""}, test::sessionTime(100), 500);
  ASSERT_TRUE(lookup.search->found().has_value());
  EXPECT_EQ(lookup.search->found()->sequence, 100U);
}

TEST_F(PacketBehindAValue, OfNoLogIsToldOnce) {
  PacketLookup lookup;
  lookup.look(folder_ / "missing.mcap", {"arm", ""}, LogTime{}, 10);
  EXPECT_FALSE(lookup.trouble.empty());
  EXPECT_FALSE(lookup.searching());
}

}  // namespace
}  // namespace rocinante
