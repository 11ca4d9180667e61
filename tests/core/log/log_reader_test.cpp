#include "core/log/log_reader.h"

#include <gmock/gmock.h>
#include <zstd.h>

#include <limits>

#include "core/base/hash.h"
#include "core/mcap/append_record.h"
#include "core/mcap/byte_cursor.h"
#include "core/mcap/chunk_compressor.h"
#include "core/mcap/chunk_expander.h"
#include "core/mcap/lz4_frame.h"
#include "core/mcap/parse_record.h"
#include "core/mcap/writer.h"
#include "tests/core/log/log_support.h"
#include "tests/core/mcap/file_maker.h"

namespace rocinante::test {
namespace {

using ::testing::ElementsAre;
using ::testing::ElementsAreArray;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

mcap::Channel channel(std::uint16_t id, const char* topic) { return {id, 0, topic, "octets", {}}; }

TEST(LogReader, MergesChunksThatOverlapAndComeOutOfOrder) {
  Bytes a, b, c;
  const Bytes file = FileMaker()
                         .add(makeChunk(a, {{50, "a50"}, {10, "a10"}, {30, "a30"}}))
                         .add(makeChunk(b, {{30, "b30"}, {31, "b31"}, {90, "b90"}}))
                         .add(makeChunk(c, {{5, "c5"}, {30, "c30"}, {50, "c50"}}))
                         .end();
  LogReader reader = openLog(file);
  // Ties (30, 50) in the file's order.
  EXPECT_THAT(payloads(reader),
              ElementsAre("c5", "a10", "a30", "b30", "c30", "b31", "a50", "c50", "b90"));
  ASSERT_TRUE(reader.seek(at(30)).ok());
  EXPECT_THAT(payloads(reader), ElementsAre("a30", "b30", "c30", "b31", "a50", "c50", "b90"));
  ASSERT_TRUE(reader.seek(at(91)).ok());
  EXPECT_THAT(payloads(reader), IsEmpty());
  EXPECT_EQ(reader.summary().start, at(5));
  EXPECT_EQ(reader.summary().end, at(90));
  EXPECT_THAT(reader.damage(), IsEmpty());
}

TEST(LogReader, TiesInsideAChunkKeepTheirOrder) {
  Bytes a;
  const Bytes file =
      FileMaker().add(makeChunk(a, {{7, "x"}, {7, "y"}, {3, "w"}, {7, "z"}, {3, "v"}})).end();
  LogReader reader = openLog(file);
  std::vector<std::uint64_t> order;
  std::vector<std::string> text;
  while (true) {
    const Result<std::optional<LogMessage>> message = reader.next();
    ASSERT_TRUE(message.ok());
    if (!*message) break;
    text.emplace_back(textOf((*message)->payload));
    order.push_back((*message)->file_offset);
  }
  EXPECT_THAT(text, ElementsAre("w", "v", "x", "y", "z"));
  EXPECT_LT(order[0], order[1]);
  EXPECT_LT(order[2], order[3]);
  EXPECT_LT(order[3], order[4]);
}

TEST(LogReader, ReadsMessagesThatLieOutsideChunks) {
  const std::string one = "one", two = "two", three = "three";
  const Bytes file = FileMaker()
                         .add(channel(1, "/udp/1/a"))
                         .add(mcap::Message{1, 0, 20, 20, bytesOf(two)})
                         .add(mcap::Metadata{"note", {}})
                         .add(mcap::Message{1, 0, 10, 10, bytesOf(one)})
                         .addUnknown(0x7E, 12)
                         .addUnknown(0xC1, 3)
                         .add(mcap::Message{1, 0, 30, 30, bytesOf(three)})
                         .end();
  LogReader reader = openLog(file);
  EXPECT_THAT(payloads(reader), ElementsAre("one", "two", "three"));
  EXPECT_THAT(reader.damage(), IsEmpty());
  EXPECT_EQ(reader.summary().messages, 3U);
  // Another writer's file is complete when it ends with the footer and the magic.
  EXPECT_TRUE(reader.summary().closed);
  EXPECT_TRUE(reader.summary().complete);
}

TEST(LogReader, AMessageOnAnUnknownChannelIsDamageAndLeftOut) {
  const std::string one = "one", lost = "lost";
  const Bytes file = FileMaker()
                         .add(channel(1, "/udp/1/a"))
                         .add(mcap::Message{1, 0, 20, 20, bytesOf(one)})
                         .add(mcap::Message{9, 0, 21, 21, bytesOf(lost)})
                         .end();
  LogReader reader = openLog(file);
  EXPECT_THAT(payloads(reader), ElementsAre("one"));
  ASSERT_EQ(reader.damage().size(), 1U);
  EXPECT_THAT(reader.damage()[0].cause, HasSubstr("an undefined channel"));
  EXPECT_EQ(reader.damage()[0].messages_lost, 1U);
}

TEST(LogReader, AChannelDefinedTwiceDifferentlyIsDamageAndTheFirstCounts) {
  const std::string one = "one";
  const Bytes file = FileMaker()
                         .add(channel(1, "/udp/1/a"))
                         .add(channel(1, "/udp/1/a"))  // repeating it is legal
                         .add(mcap::Message{1, 0, 20, 20, bytesOf(one)})
                         .add(channel(1, "/udp/1/other"))
                         .end();
  LogReader reader = openLog(file);
  EXPECT_EQ(readAll(reader)[0].topic, "/udp/1/a");
  ASSERT_EQ(reader.damage().size(), 1U);
  EXPECT_THAT(reader.damage()[0].cause, HasSubstr("defined again"));
}

TEST(LogReader, LargeChunksThatAlternateMessageByMessageAreReadInTime) {
  // More than the initial limit: without raising it each message would mean an expansion, hours of
  // it.
  constexpr std::size_t kChunks = 6;
  constexpr std::uint64_t kInEachChunk = 200'000;
  const std::string payload(32, 'x');
  FileMaker file;
  std::vector<Bytes> stored(kChunks);
  for (std::size_t i = 0; i < kChunks; ++i) {
    std::vector<std::pair<std::uint64_t, std::string>> messages;
    messages.reserve(kInEachChunk);
    for (std::uint64_t k = 0; k < kInEachChunk; ++k)
      messages.emplace_back(k * kChunks + i, payload);
    Bytes records;
    mcap::Chunk chunk = makeChunk(records, messages);
    stored[i].resize(ZSTD_compressBound(records.size()));
    stored[i].resize(
        ZSTD_compress(stored[i].data(), stored[i].size(), records.data(), records.size(), 1));
    chunk.compression = "zstd";
    chunk.records = stored[i];
    file.add(chunk);
  }
  const Bytes bytes = file.end();
  LogReader reader = openLog(bytes);
  LogTime last{Nanoseconds(-1)};
  std::uint64_t count = 0;
  while (true) {
    const Result<std::optional<LogMessage>> message = reader.next();
    ASSERT_TRUE(message.ok());
    if (!*message) break;
    ASSERT_GT((*message)->log_time, last);
    last = (*message)->log_time;
    ++count;
  }
  EXPECT_EQ(count, kChunks * kInEachChunk);
  EXPECT_THAT(reader.damage(), IsEmpty());
}

TEST(LogReader, ManyBombsTogetherAreExpandedWithinABudget) {
  Bytes records;
  const std::string zeros(std::size_t{60} << 20U, '\0');
  mcap::Chunk bomb = makeChunk(records, {{10, zeros}});
  Bytes small(ZSTD_compressBound(records.size()));
  small.resize(ZSTD_compress(small.data(), small.size(), records.data(), records.size(), 1));
  bomb.compression = "zstd";
  bomb.records = small;
  FileMaker file;
  constexpr std::size_t kBombs = 12;
  for (std::size_t i = 0; i < kBombs; ++i) file.add(bomb);
  Bytes last;
  const Bytes bytes = file.add(makeChunk(last, {{20, "after them"}})).end();
  const std::uint64_t fit =
      (mcap::ExpansionBudget::kFreeBytes + bytes.size() * mcap::ExpansionBudget::kMaxGrowth) /
      records.size();
  ASSERT_LT(fit, kBombs);
  LogReader reader = openLog(bytes);
  // Chunks within the budget are read, and uncompressed ones too.
  EXPECT_EQ(readAll(reader).size(), fit + 1);
  std::uint64_t refused = 0;
  for (const DamageSpan& span : reader.damage()) {
    if (span.cause.find("is not expanded") != std::string::npos) ++refused;
  }
  EXPECT_EQ(refused, kBombs - fit);
}

TEST(LogReader, TheLastMomentIsOneBeforeTheLastNumber) {
  Bytes a;
  const auto last = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()) - 1;
  const Bytes file =
      FileMaker().add(makeChunk(a, {{0, "first"}, {last, "last"}, {last + 1, "beyond"}})).end();
  LogReader reader = openLog(file);
  EXPECT_THAT(payloads(reader), ElementsAre("first", "last"));
  EXPECT_EQ(reader.summary().start, LogTime{});
  EXPECT_EQ(reader.summary().end, kLastLogTime);
  ASSERT_EQ(reader.damage().size(), 1U);
  EXPECT_THAT(reader.damage()[0].cause, HasSubstr("beyond the last"));
  EXPECT_EQ(reader.damage()[0].messages_lost, 1U);
}

TEST(LogReader, AFormatThatIsNotKnownIsDamage) {
  for (const char* format : {"1", "9"}) {
    Bytes a;
    const Bytes file =
        FileMaker("rocinante")
            .add(mcap::Metadata{"rocinante.session", {{"format", format}, {"session_id", "s"}}})
            .add(makeChunk(a, {{10, "ten"}}))
            .end();
    LogReader reader = openLog(file);
    EXPECT_THAT(payloads(reader), ElementsAre("ten"));
    EXPECT_EQ(reader.summary().format, format);
    EXPECT_EQ(reader.damage().empty(), std::string(format) == "1");
    // Our files are closed by rocinante.end.
    EXPECT_TRUE(reader.summary().closed);
    EXPECT_FALSE(reader.summary().complete);
  }
}

TEST(LogReader, AZipBombIsRefusedBeforeItIsExpanded) {
  Bytes a, b;
  mcap::Chunk bomb = makeChunk(a, {{10, "ten"}});
  bomb.uncompressed_size = std::uint64_t{1} << 40U;
  bomb.compression = "zstd";
  mcap::Chunk small_bomb = bomb;
  small_bomb.uncompressed_size = 200U << 20U;  // within the limit, but not out of these bytes
  const Bytes file =
      FileMaker().add(bomb).add(small_bomb).add(makeChunk(b, {{20, "twenty"}})).end();
  LogReader reader = openLog(file);
  EXPECT_THAT(payloads(reader), ElementsAre("twenty"));
  ASSERT_EQ(reader.damage().size(), 2U);
  EXPECT_THAT(reader.damage()[0].cause, HasSubstr("claims to hold"));
  EXPECT_THAT(reader.damage()[1].cause, HasSubstr("more than zstd can produce"));
}

TEST(LogReader, ReadsChunksThatLz4Compressed) {
  if (!mcap::canExpandLz4()) GTEST_SKIP() << "built without liblz4";
  Bytes plain, stored;
  mcap::Chunk chunk = makeChunk(plain, {{10, "ten"}});
  // One frame of one block that is stored as it is: magic, flags and their hash, length, end mark.
  for (const int byte : {0x04, 0x22, 0x4D, 0x18, 0x60, 0x40, 0x82})
    stored.push_back(std::byte(byte));
  mcap::appendNumber(stored, static_cast<std::uint32_t>(plain.size()) | 0x80000000U);
  mcap::appendBytes(stored, plain);
  mcap::appendNumber(stored, std::uint32_t{0});
  chunk.compression = "lz4";
  chunk.records = stored;
  const Bytes file = FileMaker().add(chunk).end();
  LogReader reader = openLog(file);
  EXPECT_THAT(payloads(reader), ElementsAre("ten"));
  EXPECT_TRUE(reader.damage().empty());
}

TEST(LogReader, AnLz4ChunkThatIsNoneIsDamageAndTheRestIsRead) {
  Bytes a, b;
  mcap::Chunk other = makeChunk(a, {{10, "ten"}});
  other.compression = "lz4";
  const Bytes file = FileMaker().add(other).add(makeChunk(b, {{20, "twenty"}})).end();
  LogReader reader = openLog(file);
  EXPECT_THAT(payloads(reader), ElementsAre("twenty"));
  ASSERT_EQ(reader.damage().size(), 1U);
  EXPECT_THAT(reader.damage()[0].cause,
              HasSubstr(mcap::canExpandLz4() ? "does not decompress" : "\"lz4\""));
}

TEST(LogReader, AChunkWhoseSizeOrTimesLieIsDamage) {
  Bytes a, b;
  mcap::Chunk short_chunk = makeChunk(a, {{10, "ten"}});
  short_chunk.uncompressed_size += 1;
  mcap::Chunk late = makeChunk(b, {{20, "twenty"}});
  late.message_start_time = 21;
  late.message_end_time = 22;
  const Bytes file = FileMaker().add(short_chunk).add(late).end();
  LogReader reader = openLog(file);
  EXPECT_THAT(payloads(reader), ElementsAre("twenty"));
  ASSERT_EQ(reader.damage().size(), 2U);
  EXPECT_THAT(reader.damage()[0].cause, HasSubstr("where its header says"));
  EXPECT_THAT(reader.damage()[1].cause, HasSubstr("are not those of its messages"));
  EXPECT_EQ(reader.summary().start, at(20));
}

TEST(LogReader, RecordsOfALaterVersionWithMoreFieldsAreRead) {
  // A Channel and a Chunk with three bytes after their known fields.
  Bytes records;
  const mcap::Chunk chunk = makeChunk(records, {{10, "ten"}});
  Bytes grown;
  append(grown, chunk);
  std::uint64_t length = grown.size() - mcap::kPrefixBytes + 3;
  std::memcpy(grown.data() + 1, &length, sizeof(length));
  grown.resize(grown.size() + 3, std::byte{0xFF});
  Bytes file(mcap::magic().begin(), mcap::magic().end());
  append(file, mcap::Header{});
  file.insert(file.end(), grown.begin(), grown.end());
  append(file, mcap::DataEnd{});
  append(file, mcap::Footer{});
  file.insert(file.end(), mcap::magic().begin(), mcap::magic().end());
  LogReader reader = openLog(file);
  EXPECT_THAT(payloads(reader), ElementsAre("ten"));
  EXPECT_THAT(reader.damage(), IsEmpty());
}

/// Far more overlapping chunks than may be held expanded: they are released and expanded again.
TEST(LogReader, VeryManyOverlappingChunksAreReadInOrderInBoundedMemory) {
  FileMaker maker;
  constexpr int kChunks = 24;
  const std::string filler(1U << 20U, 'x');
  std::vector<Bytes> records(kChunks);
  for (int i = 0; i < kChunks; ++i) {
    std::vector<std::pair<std::uint64_t, std::string>> messages;
    for (std::uint64_t j = 0; j < 4; ++j) {
      messages.emplace_back(1000 * j + static_cast<std::uint64_t>(i), filler);
    }
    mcap::Chunk chunk = makeChunk(records[static_cast<std::size_t>(i)], messages);
    Bytes compressed;
    ASSERT_TRUE(mcap::ChunkCompressor(1).compressInto(chunk.records, compressed));
    chunk.compression = "zstd";
    chunk.records = compressed;
    maker.add(chunk);
  }
  const Bytes file = maker.end();
  ASSERT_LT(file.size(), 1U << 20U);
  LogReader reader = openLog(file);
  std::int64_t last = -1;
  int count = 0;
  while (true) {
    const Result<std::optional<LogMessage>> message = reader.next();
    ASSERT_TRUE(message.ok());
    if (!*message) break;
    const std::int64_t time = (*message)->log_time.time_since_epoch().count();
    ASSERT_GT(time, last);
    ASSERT_EQ((*message)->payload.size(), filler.size());
    last = time;
    ++count;
  }
  EXPECT_EQ(count, kChunks * 4);
  EXPECT_THAT(reader.damage(), IsEmpty());
}

TEST(LogReader, ASummaryThatForgetsAChunkIsNotBelieved) {
  Bytes file;
  mcap::WriterOptions options;
  options.chunk_bytes = 64;
  Result<mcap::Writer> writer =
      mcap::Writer::start(makeMemorySink(file), options, {"rocinante", ""});
  ASSERT_TRUE(writer.ok());
  writer->addChannel(channel(1, "/udp/1/a"));
  const std::string payload(40, 'x');
  for (std::uint64_t i = 0; i < 6; ++i) {
    ASSERT_TRUE(writer->write({1, 0, i, i, bytesOf(payload)}).ok());
  }
  ASSERT_TRUE(writer->finish().ok());
  // The summary of a file with three chunks, behind six of them.
  Bytes shorter;
  Result<mcap::Writer> other =
      mcap::Writer::start(makeMemorySink(shorter), options, {"rocinante", ""});
  other->addChannel(channel(1, "/udp/1/a"));
  for (std::uint64_t i = 0; i < 3; ++i) {
    ASSERT_TRUE(other->write({1, 0, i, i, bytesOf(payload)}).ok());
  }
  ASSERT_TRUE(other->finish().ok());
  const auto startOf = [](const Bytes& bytes) {
    mcap::Footer footer;
    mcap::parse(ByteView(bytes).last(28).first(20), footer);
    return footer.summary_start;
  };
  Bytes mixed(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(startOf(file)));
  Bytes tail(shorter.begin() + static_cast<std::ptrdiff_t>(startOf(shorter)),
             shorter.end() - 28 - 9);
  mcap::Footer footer;
  footer.summary_start = mixed.size();
  mixed.insert(mixed.end(), tail.begin(), tail.end());
  append(mixed, footer);
  const std::size_t from = static_cast<std::size_t>(footer.summary_start);
  const std::uint32_t crc = crc32(ByteView(mixed).subspan(from, mixed.size() - from - 4));
  std::memcpy(mixed.data() + mixed.size() - 4, &crc, 4);
  mixed.insert(mixed.end(), mcap::magic().begin(), mcap::magic().end());
  LogReader reader = openLog(mixed);
  EXPECT_EQ(readAll(reader).size(), 6U);
  ASSERT_THAT(reader.damage(), ::testing::SizeIs(1));
  EXPECT_THAT(reader.damage()[0].cause, HasSubstr("summary does not agree"));
}

/// Every part of a summary, and the message indexes, may be missing from a valid file.
TEST(LogReader, ReadsFilesWhoseWriterLeftAnythingOut) {
  for (unsigned parts = 0; parts < 256; ++parts) {
    SCOPED_TRACE(parts);
    mcap::WriterOptions options;
    options.chunk_bytes = 300;
    options.chunked = (parts & 1U) != 0;
    options.message_indexes = (parts & 2U) != 0;
    options.chunk_indexes = (parts & 4U) != 0;
    options.attachment_indexes = (parts & 8U) != 0;
    options.metadata_indexes = (parts & 16U) != 0;
    options.statistics = (parts & 32U) != 0;
    options.repeat_channels = (parts & 64U) != 0;
    options.summary_offsets = (parts & 128U) != 0;
    Bytes file;
    Result<mcap::Writer> writer = mcap::Writer::start(makeMemorySink(file), options, {"", ""});
    ASSERT_TRUE(writer.ok());
    writer->addChannel(channel(1, "/udp/1/a"));
    writer->addChannel(channel(2, "/udp/1/b"));
    std::vector<std::string> written;
    for (std::uint32_t i = 0; i < 12; ++i) {
      written.push_back("message " + std::to_string(i));
      const auto id = static_cast<std::uint16_t>(i % 3 == 2 ? 2 : 1);
      ASSERT_TRUE(writer->write({id, i, 100 + i, 1, bytesOf(written.back())}).ok());
      if (i == 5) {
        mcap::Attachment attachment;
        attachment.name = "note";
        attachment.data = bytesOf(written[0]);
        ASSERT_TRUE(writer->writeAttachment(attachment).ok());
        ASSERT_TRUE(writer->writeMetadata({"remark", {{"a", "b"}}}).ok());
      }
    }
    ASSERT_TRUE(writer->finish().ok());
    LogReader reader = openLog(file);
    EXPECT_THAT(payloads(reader), ElementsAreArray(written));
    EXPECT_EQ(reader.summary().messages, 12U);
    EXPECT_EQ(reader.summary().start, at(100));
    EXPECT_EQ(reader.summary().end, at(111));
    ASSERT_EQ(reader.attachments().size(), 1U);
    EXPECT_EQ(textOf(*reader.readAttachment(0)), written[0]);
    ASSERT_EQ(reader.metadata().size(), 1U);
    EXPECT_EQ(reader.metadata()[0].name, "remark");
    EXPECT_EQ(textOf((*reader.lastOf(2, at(110)))->payload), "message 8");
    // Messages outside chunks are damage only beside chunks.
    EXPECT_THAT(reader.damage(), IsEmpty());
  }
}

/// Chunks whose times overlap, and whose messages are not in time order.
TEST(LogReader, GoesBackwardsOverChunksThatOverlapAndComeOutOfOrder) {
  Bytes a, b, c;
  const Bytes file = FileMaker()
                         .add(makeChunk(a, {{50, "a50"}, {10, "a10"}, {30, "a30"}}))
                         .add(makeChunk(b, {{30, "b30"}, {31, "b31"}, {90, "b90"}}))
                         .add(makeChunk(c, {{5, "c5"}, {30, "c30"}, {50, "c50"}}))
                         .end();
  LogReader reader = openLog(file);
  ASSERT_TRUE(reader.seek(LogTime::max()).ok());
  std::vector<std::string> back;
  while (const std::optional<LogMessage> message = *reader.previous()) {
    back.emplace_back(textOf(message->payload));
  }
  EXPECT_THAT(back, ElementsAre("b90", "c50", "a50", "b31", "c30", "b30", "a30", "a10", "c5"));
}

}  // namespace
}  // namespace rocinante::test
