#include "viewer/ui/live/kept_folder.h"

#include <gmock/gmock.h>

#include <chrono>

#include "tests/support/environment.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"
#include "viewer/ui/live/keep_limits.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

TEST(KeepLimits, AreATimeASizeOrBoth) {
  EXPECT_EQ(parseKeepLimits("10m,2GB")->time, 10min);
  EXPECT_EQ(parseKeepLimits("10m,2GB")->bytes, 2'000'000'000U);
  EXPECT_EQ(parseKeepLimits("500MB,90")->time, 90s);
  EXPECT_EQ(parseKeepLimits("500MB,90")->bytes, 500'000'000U);
  EXPECT_EQ(parseKeepLimits("1h")->bytes, KeepLimits().bytes);
  EXPECT_EQ(parseKeepLimits("64MiB")->time, KeepLimits().time);
  EXPECT_TRUE(parseKeepLimits("0")->none());
  EXPECT_FALSE(parseKeepLimits("10m")->none());
  for (const char* wrong :
       {"", ",", "10m,", "10m,5m", "1GB,2GB", "-5s", "0.5s", "1MB", "all", "5 m"}) {
    SCOPED_TRACE(wrong);
    EXPECT_FALSE(parseKeepLimits(wrong).ok());
  }
}

TEST(KeptFolder, IsGoneWithItsWindow) {
  const test::TemporaryFolder cache;
  fs::path path;
  {
    auto folder = KeptFolder::make(cache / "a" / "b");
    ASSERT_TRUE(folder.ok()) << folder.error().text();
    path = folder->path();
    test::writeFile(path / "live-000001.mcap", "x");
    EXPECT_TRUE(KeptFolder::leftovers(cache / "a" / "b").empty()) << "its window is alive";
  }
  EXPECT_FALSE(fs::exists(path));
  EXPECT_TRUE(fs::exists(cache / "a" / "b"));
}

TEST(KeptFolder, WhatAKilledWindowLeftIsOfferedAndForgotten) {
  const test::TemporaryFolder cache;
  fs::create_directories(cache / "session-abc");
  test::writeFile(cache / "session-abc" / "live-000002.mcap", std::string(3000, 'x'));
  test::writeFile(cache / "session-abc" / "live-000001.mcap", std::string(2000, 'x'));
  fs::create_directories(cache / "someone-elses");
  test::writeFile(cache / "someone-elses" / "live-000001.mcap", "x");
  const auto leftovers = KeptFolder::leftovers(cache.path());
  ASSERT_EQ(leftovers.size(), 1U);
  ASSERT_EQ(leftovers[0].pieces.size(), 2U);
  EXPECT_EQ(leftovers[0].pieces[0].filename(), "live-000001.mcap");
  EXPECT_EQ(leftovers[0].bytes, 5000U);
  EXPECT_THAT(leftoversOffer(leftovers), testing::HasSubstr("rocinante view --leftovers"));
  EXPECT_THAT(leftoversText(leftovers), testing::HasSubstr("session-abc  2 logs, 5.0 kB"));
  EXPECT_TRUE(KeptFolder::forget(leftovers[0]).ok());
  EXPECT_FALSE(fs::exists(cache / "session-abc"));
  EXPECT_TRUE(fs::exists(cache / "someone-elses"));
  EXPECT_TRUE(leftoversOffer(KeptFolder::leftovers(cache.path())).empty());
}

TEST(KeptFolder, SaysWhyItCannotBeMade) {
  const test::TemporaryFolder cache;
  test::writeFile(cache / "file", "x");
  EXPECT_FALSE(KeptFolder::make(cache / "file" / "below").ok());
  EXPECT_FALSE(KeptFolder::make({}).ok());
  const test::Environment environment({{"XDG_CACHE_HOME", "relative"}, {"HOME", "also"}});
  EXPECT_TRUE(KeptFolder::ofUser().empty());
}

}  // namespace
}  // namespace rocinante
