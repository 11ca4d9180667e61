#include <gmock/gmock.h>

#include "core/copy/log_edits.h"
#include "core/session/marks.h"
#include "tests/core/copy/copy_support.h"

namespace rocinante::test {
namespace {

using ::testing::HasSubstr;

ShiftOptions by(const char* distance, bool publish = false) { return {distance, {}, publish}; }
ShiftOptions to(const char* time) { return {{}, time, false}; }

TEST(LogShift, ThereAndBackAgainIsTheSameLog) {
  TemporaryFolder folder;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    const std::string name = std::to_string(seed);
    writeRandomLog(folder / "whole.mcap", seed);
    // A piece, so that the opening keyframe's times have to move too.
    SelectionOptions later;
    later.from = "3";
    const std::filesystem::path piece = folder / (name + ".mcap");
    const std::filesystem::path there = folder / (name + "there.mcap");
    const std::filesystem::path back = folder / (name + "back.mcap");
    ASSERT_TRUE(cutLog(folder / "whole.mcap", later, makeAt(piece), "cut").ok());
    ASSERT_TRUE(shiftLog(piece, by("-1h30m"), makeAt(there)).ok());
    ASSERT_TRUE(shiftLog(there, by("+1h30m"), makeAt(back)).ok());
    const std::vector<KeptMessage> after = messagesOf(back);
    const std::vector<KeptMessage> before = messagesOf(piece);
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t i = 0; i < after.size(); ++i) ASSERT_EQ(after[i], before[i]);
    EXPECT_EQ(openLogAt(back).summary().origin, openLogAt(piece).summary().origin);
    expectSameStates(piece, back, kSessionStart, kSessionStart + 3'600'000'000'000);
    if (::testing::Test::HasFatalFailure()) return;
  }
}

TEST(LogShift, MovesEveryLogTimeAndLeavesTheSendersTimesUnlessAsked) {
  TemporaryFolder folder;
  const std::filesystem::path log = folder / "log.mcap";
  writeRandomLog(log, 2);
  ASSERT_TRUE(addMark(log, {at(kSessionStart + 5), {}, "m"}).ok());
  const std::vector<KeptMessage> before = capturedOf(log);
  for (const bool publish : {false, true}) {
    const std::filesystem::path out = folder / (publish ? "publish.mcap" : "plain.mcap");
    ASSERT_TRUE(shiftLog(log, by("2s", publish), makeAt(out)).ok());
    const std::vector<KeptMessage> after = capturedOf(out);
    ASSERT_EQ(after.size(), before.size());
    constexpr std::int64_t kTwo = 2'000'000'000;
    for (std::size_t i = 0; i < after.size(); ++i) {
      EXPECT_EQ(after[i].log_time_ns, before[i].log_time_ns + kTwo);
      EXPECT_EQ(after[i].publish_time_ns, before[i].publish_time_ns + (publish ? kTwo : 0));
      EXPECT_EQ(after[i].payload, before[i].payload);
    }
    const LogReader a = openLogAt(log);
    const LogReader b = openLogAt(out);
    EXPECT_EQ(b.summary().origin, a.summary().origin + std::chrono::seconds(2));
    EXPECT_EQ(b.losses().front().from, a.losses().front().from + std::chrono::seconds(2));
    EXPECT_EQ(b.attachments().front().log_time,
              a.attachments().front().log_time + std::chrono::seconds(2));
    for (const KeptMessage& message : messagesOf(out)) {
      if (message.topic == "/rocinante/mark") {
        EXPECT_EQ(message.log_time_ns, kSessionStart + 5 + kTwo);
      }
      if (message.topic == "/rocinante/clock") {
        EXPECT_THAT(message.payload,
                    HasSubstr("\"noticed_ns\":" + std::to_string(message.log_time_ns)));
      }
    }
  }
}

TEST(LogShift, PutsTheOriginWhereItShallBe) {
  TemporaryFolder folder;
  writeRandomLog(folder / "log.mcap", 2);
  ASSERT_TRUE(
      shiftLog(folder / "log.mcap", to("2001-02-03T04:05:06.5Z"), makeAt(folder / "out.mcap"))
          .ok());
  EXPECT_EQ(rfcOf(openLogAt(folder / "out.mcap").summary().origin.time_since_epoch().count()),
            "2001-02-03T04:05:06.500000000Z");
}

TEST(LogShift, TimesThatALogCannotHoldAreRefused) {
  TemporaryFolder folder;
  writeRandomLog(folder / "log.mcap", 2);
  const auto refusal = [&](const ShiftOptions& shift) {
    const Result<CopyReport> report =
        shiftLog(folder / "log.mcap", shift, makeAt(folder / "out.mcap"));
    EXPECT_FALSE(report.ok());
    EXPECT_FALSE(std::filesystem::exists(folder / "out.mcap"));
    return report.ok() ? std::string() : report.error().text();
  };
  EXPECT_THAT(refusal(to("1960-01-01T00:00:00Z")), HasSubstr("before 1970"));
  EXPECT_THAT(refusal(by("-1770000001.5s")), HasSubstr("before 1970"));
  EXPECT_THAT(refusal(by("9000000000s")), HasSubstr("after 2262"));
  EXPECT_THAT(refusal(by("soon")), HasSubstr("soon"));
  // The first of all may become 0.
  EXPECT_TRUE(
      shiftLog(folder / "log.mcap", to("1970-01-01T00:00:02Z"), makeAt(folder / "out.mcap")).ok());
}

}  // namespace
}  // namespace rocinante::test
