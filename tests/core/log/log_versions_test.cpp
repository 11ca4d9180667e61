#include <gmock/gmock.h>

#include "core/log/log_reader.h"
#include "tests/core/log/log_support.h"

namespace rocinante::test {
namespace {

std::filesystem::path keptLog(const char* name) {
  return std::filesystem::path(ROCINANTE_SOURCE_DIR) / "tests" / "data" / "logs" / name;
}

/// Made by the first writer. It must read the same for ever: never regenerate it.
TEST(LogVersions, TheFirstFormatReadsForEver) {
  Result<LogReader> reader = LogReader::open(keptLog("version-1.mcap"));
  ASSERT_TRUE(reader.ok()) << reader.error().text();
  constexpr std::int64_t kOrigin = 1'770'091'506'000'000'000;
  const LogSummary& summary = reader->summary();
  EXPECT_EQ(summary.session_id, "b1946ac92492d2347c6235b4d2611184");
  EXPECT_EQ(summary.origin, at(kOrigin));
  EXPECT_EQ(summary.start, at(kOrigin));
  EXPECT_EQ(summary.end, at(kOrigin + 950'000'000));
  EXPECT_EQ(summary.messages, 22U);
  EXPECT_TRUE(summary.complete);
  EXPECT_EQ(summary.end_reason, "stopped");

  ASSERT_EQ(reader->channels().size(), 4U);
  const LogChannel& arm = reader->channels()[0];
  EXPECT_EQ(arm.topic, "/udp/19960/arm");
  EXPECT_EQ(arm.encoding, "rk1");
  EXPECT_EQ(arm.metadata.at("remote"), "127.0.0.1:40001");
  EXPECT_EQ(reader->channels()[3].topic, "/rocinante/loss");

  const std::vector<KeptMessage> messages = readAll(*reader);
  ASSERT_EQ(messages.size(), 23U);  // and one loss
  EXPECT_EQ(messages[0], (KeptMessage{"/udp/19960/arm", 0, kOrigin, kOrigin - 1'500'000,
                                      "RK1 arm@7f 0 1770091505.998500000\nadd arm puma\n"
                                      "joints arm 0e-2 0.5 -0.25 0 1.5 0"}));
  EXPECT_EQ(messages[6].payload, "RK1 planner - -\nevent \"picked 5\"\n");
  EXPECT_EQ(messages[13].payload, std::string("\x00\x01\xfe\xff", 4));
  EXPECT_EQ(*contentSha256(*reader),
            "7bf653d59eabb1d1a3e86089adf4742ef9723d06ea4887d013102e7571ba8b60");

  ASSERT_EQ(reader->losses().size(), 1U);
  EXPECT_EQ(reader->losses()[0].endpoint, "udp://127.0.0.1:19960");
  EXPECT_EQ(reader->losses()[0].counts.kernel, 1U);
  ASSERT_EQ(reader->attachments().size(), 1U);
  EXPECT_EQ(textOf(*reader->readAttachment(0)), "format = 1\n");
  EXPECT_THAT(reader->damage(), ::testing::IsEmpty());
}

/// Logs of the first format whose recorders were killed in an open chunk, the second one of each
/// log, after several flushes. Never regenerate them.
TEST(LogVersions, AKilledRecordersLogOfTheFirstFormatReadsForEver) {
  constexpr std::int64_t kOrigin = 1'770'091'506'000'000'000;
  for (const char* name : {"version-1-killed-plain.mcap", "version-1-killed-zstd.mcap"}) {
    SCOPED_TRACE(name);
    Result<LogReader> reader = LogReader::open(keptLog(name));
    ASSERT_TRUE(reader.ok()) << reader.error().text();
    const LogSummary& summary = reader->summary();
    EXPECT_EQ(summary.session_id, "6f8db599de986fab7a21625b7916589c");
    EXPECT_EQ(summary.origin, at(kOrigin));
    EXPECT_EQ(summary.end, at(kOrigin + 1'550'000'000));
    EXPECT_EQ(summary.messages, 32U);
    EXPECT_FALSE(summary.complete);
    EXPECT_EQ(reader->storage().chunks, 2U);

    const std::vector<KeptMessage> messages = readAll(*reader);
    ASSERT_EQ(messages.size(), 32U);
    EXPECT_EQ(messages[5].payload, std::string("\x00\x01\xfe\x05", 4));
    EXPECT_EQ(messages[5].topic, "/udp/19960/127.0.0.1");
    EXPECT_EQ(messages[31].payload, "RK1 arm@7f 31 -\njoints arm 31e-2 0.5 -0.25 0 1.5 0");
    EXPECT_EQ(*contentSha256(*reader),
              "65b4da7b3ae74dc2778d336369c6d6001310237aad19d82d0aa87f396491d556");

    ASSERT_EQ(reader->damage().size(), 2U);
    EXPECT_THAT(reader->damage()[0].cause, ::testing::HasSubstr("never finished"));
    EXPECT_EQ(reader->damage()[0].to, std::filesystem::file_size(keptLog(name)));
    EXPECT_THAT(reader->damage()[1].cause, ::testing::HasSubstr("never closed"));
  }
}

}  // namespace
}  // namespace rocinante::test
