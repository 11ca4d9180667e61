#include <gmock/gmock.h>

#include "core/log/content_hash.h"
#include "tests/core/log/log_support.h"

namespace rocinante::test {
namespace {

using ::testing::ElementsAreArray;
using ::testing::IsEmpty;

std::string payloadOf(int i) { return "RK1 arm@7f " + std::to_string(i) + " -\njoints arm 1 2 3"; }

/// `count` messages on two channels, one every 10 ns from 1,000.
std::vector<KeptMessage> writeMessages(LogWriter& writer, int count) {
  const ChannelId arm = *writer.addChannel("/udp/19960/arm", "rk1", {{"source", "arm"}});
  const ChannelId tank = *writer.addChannel("/udp/19960/tank", "rk1", {{"source", "tank"}});
  std::vector<KeptMessage> written;
  for (int i = 0; i < count; ++i) {
    const std::int64_t time_ns = 1000 + 10 * i;
    const bool even = i % 2 == 0;
    const std::string payload = payloadOf(i);
    EXPECT_TRUE(writer
                    .write(even ? arm : tank, static_cast<std::uint32_t>(i), at(time_ns),
                           time_ns - 3, bytesOf(payload))
                    .ok());
    written.push_back({even ? "/udp/19960/arm" : "/udp/19960/tank", static_cast<std::uint32_t>(i),
                       time_ns, time_ns - 3, payload});
  }
  return written;
}

TEST(LogRoundTrip, GivesBackEveryMessageByteForByteInOrder) {
  for (const auto compression :
       {LogWriterOptions::Compression::none, LogWriterOptions::Compression::zstd}) {
    LogWriterOptions options;
    options.compression = compression;
    options.chunk_bytes = 4096;
    Bytes file;
    LogWriter writer = makeWriter(file, options);
    const std::vector<KeptMessage> written = writeMessages(writer, 1000);
    ASSERT_TRUE(writer.close("finished").ok());

    LogReader reader = openLog(file);
    EXPECT_THAT(readAll(reader), ElementsAreArray(written));
    EXPECT_THAT(reader.damage(), IsEmpty());
  }
}

TEST(LogRoundTrip, SeeksToTheFirstMessageAtOrAfterAMoment) {
  LogWriterOptions options;
  options.chunk_bytes = 2048;
  Bytes file;
  LogWriter writer = makeWriter(file, options);
  const std::vector<KeptMessage> written = writeMessages(writer, 500);
  ASSERT_TRUE(writer.close("finished").ok());
  LogReader reader = openLog(file);
  for (const std::int64_t moment : {5995, 0, 1000, 1001, 3333, 5990, 5991, 1010}) {
    SCOPED_TRACE(moment);
    ASSERT_TRUE(reader.seek(at(moment)).ok());
    std::vector<KeptMessage> expected;
    for (const KeptMessage& message : written) {
      if (message.log_time_ns >= moment) expected.push_back(message);
    }
    EXPECT_THAT(readAll(reader), ElementsAreArray(expected));
  }
  ASSERT_TRUE(reader.rewind().ok());
  EXPECT_THAT(readAll(reader), ElementsAreArray(written));
}

TEST(LogRoundTrip, SummaryCountsCapturedMessagesOnly) {
  Bytes file;
  LogWriter writer = makeWriter(file);
  const ChannelId clock = *writer.addChannel("/rocinante/clock", "json", {});
  ASSERT_TRUE(writer.write(clock, 0, at(500), 500, bytesOf("{}")).ok());
  writeMessages(writer, 3);
  ASSERT_TRUE(writer.write(clock, 1, at(9000), 9000, bytesOf("{}")).ok());
  ASSERT_TRUE(writer.close("duration").ok());

  const LogReader reader = openLog(file);
  const LogSummary& summary = reader.summary();
  EXPECT_EQ(summary.session_id, "session-1");
  EXPECT_EQ(summary.messages, 3U);
  EXPECT_EQ(summary.origin, at(1000));
  EXPECT_EQ(summary.start, at(1000));
  EXPECT_EQ(summary.end, at(1020));
  EXPECT_TRUE(summary.complete);
  EXPECT_EQ(summary.end_reason, "duration");
}

TEST(LogRoundTrip, KeepsTheOriginThatAToolCopies) {
  Bytes file;
  LogWriter writer = makeWriter(file);
  writer.setOrigin(at(400));
  writeMessages(writer, 2);
  ASSERT_TRUE(writer.close("cut").ok());
  const LogReader reader = openLog(file);
  EXPECT_EQ(reader.summary().origin, at(400));
  EXPECT_EQ(reader.summary().start, at(1000));
}

TEST(LogRoundTrip, ALogWithoutMessagesIsWholeAndEmpty) {
  Bytes file;
  LogWriter writer = makeWriter(file);
  ASSERT_TRUE(writer.close("signal").ok());
  LogReader reader = openLog(file);
  EXPECT_THAT(readAll(reader), IsEmpty());
  EXPECT_TRUE(reader.summary().complete);
  EXPECT_EQ(reader.summary().messages, 0U);
  EXPECT_THAT(reader.damage(), IsEmpty());
}

TEST(LogRoundTrip, LossesAttachmentsAndMetadataComeBack) {
  Bytes file;
  LogWriter writer = makeWriter(file);
  writeMessages(writer, 4);
  const LossSpan loss{"udp://127.0.0.1:19960", at(1000), at(1020), {1, 2, 3, 4}};
  ASSERT_TRUE(writer.writeLoss(loss).ok());
  ASSERT_TRUE(
      writer.writeAttachment("cell.toml", "application/toml", at(77), bytesOf("format = 1")).ok());
  ASSERT_TRUE(writer.writeMetadata({"site", {{"place", "hall 3"}}}).ok());
  ASSERT_TRUE(writer.close("finished").ok());

  const LogReader reader = openLog(file);
  ASSERT_EQ(reader.losses().size(), 1U);
  EXPECT_EQ(reader.losses()[0].endpoint, loss.endpoint);
  EXPECT_EQ(reader.losses()[0].from, loss.from);
  EXPECT_EQ(reader.losses()[0].until, loss.until);
  EXPECT_EQ(reader.losses()[0].counts, loss.counts);
  ASSERT_EQ(reader.attachments().size(), 1U);
  EXPECT_EQ(reader.attachments()[0].name, "cell.toml");
  EXPECT_EQ(reader.attachments()[0].media_type, "application/toml");
  EXPECT_EQ(reader.attachments()[0].log_time, at(77));
  const Result<Bytes> data = reader.readAttachment(0);
  ASSERT_TRUE(data.ok());
  EXPECT_EQ(textOf(*data), "format = 1");
  EXPECT_FALSE(reader.readAttachment(1).ok());
  ASSERT_EQ(reader.metadata().size(), 3U);
  EXPECT_EQ(reader.metadata()[1].name, "site");
  EXPECT_EQ(reader.metadata()[1].entries.at("place"), "hall 3");
}

TEST(LogRoundTrip, WhatWaitsForHalfOfSyncIsBroughtIntoTheFile) {
  LogWriterOptions options;
  options.sync = std::chrono::milliseconds(100);
  Bytes file;
  LogWriter writer = makeWriter(file, options);
  const SteadyTime start{std::chrono::seconds(5)};
  ASSERT_TRUE(writer.flushIfDue(start).ok());
  writeMessages(writer, 2);
  ASSERT_TRUE(writer.flushIfDue(start + std::chrono::milliseconds(49)).ok());
  {
    const Bytes killed = cutAt(file, file.size());
    LogReader reader = openLog(killed);
    EXPECT_THAT(readAll(reader), IsEmpty());
  }
  ASSERT_TRUE(writer.flushIfDue(start + std::chrono::milliseconds(50)).ok());
  const Bytes killed = cutAt(file, file.size());
  LogReader reader = openLog(killed);
  EXPECT_EQ(readAll(reader).size(), 2U);
  EXPECT_FALSE(reader.summary().complete);
  EXPECT_EQ(reader.summary().messages, 2U);
  EXPECT_EQ(reader.channels().size(), 2U);
}

TEST(ContentSha256, DependsOnTopicTimeAndPayloadAlone) {
  const auto hashOf = [](const LogWriterOptions& options, const char* topic, std::int64_t time_ns,
                         const char* payload, bool with_others) {
    Bytes file;
    LogWriter writer = makeWriter(file, options);
    const ChannelId channel = *writer.addChannel(topic, "octets", {});
    EXPECT_TRUE(writer.write(channel, 1, at(time_ns), 0, bytesOf(payload)).ok());
    if (with_others) {
      EXPECT_TRUE(writer.writeLoss({"e", at(1), at(2), {}}).ok());
      EXPECT_TRUE(writer.writeAttachment("a", "b", at(1), bytesOf("c")).ok());
    }
    EXPECT_TRUE(writer.close("finished").ok());
    LogReader reader = openLog(file);
    return *contentSha256(reader);
  };
  LogWriterOptions plain;
  plain.compression = LogWriterOptions::Compression::none;
  const std::string hash = hashOf({}, "/udp/1/a", 7, "hello", false);
  // sha256 of: 8 as u64, "/udp/1/a", 7 as u64, 5 as u64, "hello" (docs/log-format.md).
  EXPECT_EQ(hash, "f177a6d8cadef8d36121cb9bcf2fbd7de76bcabf0c9d39833f0ef6271f5a5a41");
  EXPECT_EQ(hash, hashOf(plain, "/udp/1/a", 7, "hello", true));
  EXPECT_NE(hash, hashOf({}, "/udp/1/b", 7, "hello", false));
  EXPECT_NE(hash, hashOf({}, "/udp/1/a", 8, "hello", false));
  EXPECT_NE(hash, hashOf({}, "/udp/1/a", 7, "hellp", false));
}

}  // namespace
}  // namespace rocinante::test
