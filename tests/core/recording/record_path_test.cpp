#include "core/recording/record_path.h"

#include <gtest/gtest.h>

#include "core/base/duration_text.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

const WallTime kRecordedAt = parseRfc3339("2026-02-03T04:05:06.789Z").value();

TEST(RecordPath, NamesTheSessionByItsStart) {
  EXPECT_EQ(recordPath("", kRecordedAt).value(), "session-20260203T040506Z.mcap");
}

TEST(RecordPath, TakesAFileAsItIs) {
  EXPECT_EQ(recordPath("logs/cell 7.mcap", kRecordedAt).value(), "logs/cell 7.mcap");
  EXPECT_EQ(recordPath("100%%.mcap", kRecordedAt).value(), "100%.mcap");
}

TEST(RecordPath, PutsTheDefaultNameIntoAFolder) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(recordPath(folder.path().string(), kRecordedAt).value(),
            folder / "session-20260203T040506Z.mcap");
  EXPECT_EQ(recordPath("not-there/", kRecordedAt).value(),
            "not-there/session-20260203T040506Z.mcap");
}

TEST(RecordPath, FillsAPattern) {
  EXPECT_EQ(recordPath("%F/%Y-%m-%d_%H%M%S_%j_%s.mcap", kRecordedAt).value(),
            "2026-02-03/2026-02-03_040506_034_1770091506.mcap");
}

TEST(RecordPath, RefusesWhatItDoesNotKnow) {
  for (const std::string_view pattern : {"a%", "a%q.mcap", "%T.mcap", "%-d"}) {
    SCOPED_TRACE(pattern);
    const auto path = recordPath(pattern, kRecordedAt);
    ASSERT_FALSE(path.ok());
    EXPECT_EQ(path.error().kind, ErrorKind::bad_argument);
  }
}

}  // namespace
}  // namespace rocinante
