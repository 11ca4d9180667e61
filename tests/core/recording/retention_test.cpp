#include "core/recording/retention.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

PieceFacts piece(const std::string& name, std::uint64_t bytes) {
  PieceFacts facts;
  facts.file.path = name;
  facts.bytes = bytes;
  facts.packets = bytes / 10;
  return facts;
}

std::string surplus(Retention& retention, std::optional<std::uint64_t> current_bytes) {
  std::string names;
  for (const PieceFacts& each : retention.surplus(current_bytes)) names += each.file.path.string();
  return names;
}

TEST(Retention, WithoutLimitsAllStay) {
  Retention retention({});
  for (const char* name : {"a", "b", "c"}) retention.add(piece(name, 1'000'000));
  EXPECT_EQ(surplus(retention, 1'000'000'000), "");
}

TEST(Retention, TheOneBeingWrittenIsAmongThoseKept) {
  Retention retention({.keep = 2, .disk_quota_bytes = std::nullopt});
  for (const char* name : {"a", "b", "c"}) retention.add(piece(name, 100));
  EXPECT_EQ(surplus(retention, 5), "ab");
  EXPECT_EQ(surplus(retention, 5), "");
  EXPECT_EQ(surplus(retention, std::nullopt), "");
}

TEST(Retention, KeepingOneLeavesTheOneBeingWritten) {
  Retention retention({.keep = 1, .disk_quota_bytes = std::nullopt});
  retention.add(piece("a", 100));
  EXPECT_EQ(surplus(retention, 0), "a");
}

TEST(Retention, TheOldestGoUntilTheRestFitsTheQuota) {
  Retention retention({.keep = std::nullopt, .disk_quota_bytes = 350});
  for (const char* name : {"a", "b", "c"}) retention.add(piece(name, 100));
  EXPECT_EQ(surplus(retention, 50), "");
  EXPECT_EQ(surplus(retention, 51), "a");
  EXPECT_EQ(retention.bytes(), 200U);
  // The closed piece is larger than before: it has its summary now.
  retention.settle(piece("c", 240));
  EXPECT_EQ(surplus(retention, 10), "");
  EXPECT_EQ(surplus(retention, 1'000), "bc");
  EXPECT_EQ(surplus(retention, 1'000), "");
}

TEST(Retention, TheNewestStaysHoweverLarge) {
  Retention retention({.keep = std::nullopt, .disk_quota_bytes = 50});
  retention.add(piece("a", 100));
  retention.add(piece("b", 100));
  EXPECT_EQ(surplus(retention, std::nullopt), "a");
}

TEST(Retention, CountsWhatIsGone) {
  Retention retention({});
  retention.countDeleted(piece("a", 100));
  retention.countDeleted(piece("b", 50));
  EXPECT_EQ(retention.deleted().count, 2U);
  EXPECT_EQ(retention.deleted().packets, 15U);
  EXPECT_EQ(retention.deleted().bytes, 150U);
}

}  // namespace
}  // namespace rocinante
