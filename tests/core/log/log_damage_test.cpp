#include <gmock/gmock.h>
#include <zstd.h>

#include <algorithm>
#include <set>

#include "core/base/hash.h"
#include "core/mcap/chunk_expander.h"
#include "core/mcap/parse_record.h"
#include "core/mcap/record_stepper.h"
#include "core/mcap/records.h"
#include "tests/core/log/log_support.h"
#include "tests/support/next_place.h"

namespace rocinante::test {
namespace {

using ::testing::ElementsAreArray;
using ::testing::IsEmpty;
using ::testing::Not;

struct SmallLog {
  Bytes file;
  std::vector<KeptMessage> messages;
};

/// A few chunks, two channels, an attachment and a loss.
SmallLog smallLog(LogWriterOptions::Compression compression, std::size_t chunk_bytes = 900) {
  SmallLog log;
  LogWriterOptions options;
  options.compression = compression;
  options.chunk_bytes = chunk_bytes;
  LogWriter writer = makeWriter(log.file, options);
  const ChannelId a = *writer.addChannel("/udp/19960/arm", "rk1", {{"source", "arm"}});
  const ChannelId b = *writer.addChannel("/udp/19960/10.0.0.7", "octets", {});
  for (int i = 0; i < 24; ++i) {
    const std::string payload = "RK1 arm@7f " + std::to_string(i) + " -\njoints arm " +
                                std::to_string(i * i) + " 0.25 -1.5";
    EXPECT_TRUE(writer
                    .write(i % 4 == 3 ? b : a, static_cast<std::uint32_t>(i), at(1000 + i / 2), 7,
                           bytesOf(payload))
                    .ok());
    log.messages.push_back({i % 4 == 3 ? "/udp/19960/10.0.0.7" : "/udp/19960/arm",
                            static_cast<std::uint32_t>(i), 1000 + i / 2, 7, payload});
    if (i == 12) {
      EXPECT_TRUE(writer.writeAttachment("cell.toml", "text/plain", at(1), bytesOf("abc")).ok());
    }
  }
  EXPECT_TRUE(writer.writeLoss({"udp://127.0.0.1:19960", at(1000), at(1010), {1, 0, 0, 0}}).ok());
  EXPECT_TRUE(writer.close("finished").ok());
  return log;
}

/// Captured messages only, to leave out the recorder's own.
std::vector<KeptMessage> captured(LogReader& reader) {
  std::vector<KeptMessage> messages = readAll(reader);
  std::erase_if(messages, [](const KeptMessage& m) { return m.topic.starts_with("/rocinante/"); });
  return messages;
}

std::size_t wholeChunksBefore(const Bytes& file, std::size_t size, std::size_t* messages) {
  std::size_t chunks = 0;
  *messages = 0;
  mcap::ChunkExpander expander;
  mcap::Scratch scratch;
  for (std::uint64_t position = 8; position < size;) {
    const std::optional<mcap::Record> record = mcap::recordAt(file, position);
    if (!record || record->end() > size || record->opcode == mcap::Opcode::data_end) break;
    if (record->opcode == mcap::Opcode::chunk) {
      ++chunks;
      mcap::Chunk chunk;
      EXPECT_TRUE(mcap::parse(record->content, chunk));
      const Result<ByteView> records = expander.expand(chunk, scratch);
      EXPECT_TRUE(records.ok());
      for (std::uint64_t inside = 0; inside < records->size();) {
        const std::optional<mcap::Record> each = mcap::recordAt(*records, inside);
        mcap::Message message;
        // The loss message comes last, on channel 2.
        if (each->opcode == mcap::Opcode::message && mcap::parse(each->content, message) &&
            message.channel_id < 2) {
          ++*messages;
        }
        inside = each->end();
      }
    }
    position = record->end();
  }
  return chunks;
}

class CutLog : public ::testing::TestWithParam<LogWriterOptions::Compression> {};

TEST_P(CutLog, AtEveryByteGivesBackEveryWholeChunkAndSaysThatItWasCut) {
  const SmallLog log = smallLog(GetParam());
  std::size_t most_chunks = 0;
  for (std::size_t size = 0; size < log.file.size(); size += nextPlace()) {
    SCOPED_TRACE(size);
    const Bytes cut = cutAt(log.file, size);
    Result<LogReader> reader = LogReader::openBytes(cut, "cut.mcap");
    if (size < 8) {
      ASSERT_FALSE(reader.ok());
      EXPECT_EQ(reader.error().kind, ErrorKind::damaged);
      continue;
    }
    ASSERT_TRUE(reader.ok());
    std::size_t whole = 0;
    most_chunks = std::max(most_chunks, wholeChunksBefore(log.file, size, &whole));
    const std::vector<KeptMessage> read = captured(*reader);
    // At least every whole chunk, and always a prefix of what was written.
    ASSERT_GE(read.size(), whole);
    ASSERT_LE(read.size(), log.messages.size());
    ASSERT_THAT(read,
                ElementsAreArray(log.messages.begin(),
                                 log.messages.begin() + static_cast<std::ptrdiff_t>(read.size())));
    EXPECT_THAT(reader->damage(), Not(IsEmpty()));
    EXPECT_FALSE(reader->summary().complete && reader->damage().empty());
    EXPECT_EQ(reader->summary().messages, read.size());
  }
  EXPECT_GE(most_chunks, 3U);
}

TEST_P(CutLog, InsideAChunkGivesBackWholeMessagesOfIt) {
  const SmallLog log = smallLog(GetParam(), 1U << 20U);
  // The only chunk is cut at half of its bytes.
  const std::size_t chunk = 8 + 9;
  std::size_t most = 0;
  for (std::size_t size = chunk; size < log.file.size() / 2; ++size) {
    const Bytes cut = cutAt(log.file, size);
    LogReader reader = openLog(cut);
    const std::vector<KeptMessage> read = captured(reader);
    ASSERT_THAT(read,
                ElementsAreArray(log.messages.begin(),
                                 log.messages.begin() + static_cast<std::ptrdiff_t>(read.size())));
    most = std::max(most, read.size());
  }
  if (GetParam() == LogWriterOptions::Compression::none) {
    EXPECT_GT(most, 5U);
  }
}

/// The times of a cut log are as reliable as those of a whole one: seeking and reading backwards
/// work.
TEST_P(CutLog, AtEveryByteIsInOrderOfTimeBothWays) {
  const SmallLog log = smallLog(GetParam());
  for (std::size_t size = 8; size < log.file.size(); size += nextPlace()) {
    SCOPED_TRACE(size);
    const Bytes cut = cutAt(log.file, size);
    LogReader reader = openLog(cut);
    const std::vector<KeptMessage> read = readAll(reader);
    for (std::size_t i = read.size(); i-- > 0;) {
      const std::optional<LogMessage> message = *reader.previous();
      ASSERT_TRUE(message && keep(*message) == read[i]);
    }
    ASSERT_FALSE(reader.previous()->has_value());
    for (std::size_t i = 0; i < read.size(); i += 5) {
      const auto first =
          std::ranges::lower_bound(read, read[i].log_time_ns, {}, &KeptMessage::log_time_ns);
      ASSERT_TRUE(reader.seek(at(read[i].log_time_ns)).ok());
      const std::optional<LogMessage> message = *reader.next();
      ASSERT_TRUE(message && keep(*message) == *first);
    }
  }
}

/// From the end back to the beginning: the same messages.
::testing::AssertionResult goesBackTheSameWay(LogReader& reader,
                                              const std::vector<KeptMessage>& read) {
  std::vector<KeptMessage> back;
  while (const std::optional<LogMessage> message = *reader.previous()) {
    if (message->channel->captured()) back.push_back(keep(*message));
  }
  std::ranges::reverse(back);
  if (back == read) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << back.size() << " backwards, " << read.size();
}

/// Whatever bit is flipped: no crash, and every message read is one that was written, unless damage
/// is reported.
TEST_P(CutLog, AFlippedBitNeverChangesAPayloadSilently) {
  const SmallLog log = smallLog(GetParam());
  const std::set<KeptMessage> written(log.messages.begin(), log.messages.end());
  for (std::size_t byte = 0; byte < log.file.size(); byte += nextPlace()) {
    for (int bit = 0; bit < 8; ++bit) {
      SCOPED_TRACE(::testing::Message() << "byte " << byte << " bit " << bit);
      Bytes flipped = log.file;
      flipped[byte] ^= static_cast<std::byte>(1U << static_cast<unsigned>(bit));
      Result<LogReader> reader = LogReader::openBytes(flipped, "flipped.mcap");
      if (!reader.ok()) {
        ASSERT_LT(byte, 8U);
        continue;
      }
      const std::vector<KeptMessage> read = captured(*reader);
      for (const KeptMessage& message : read) {
        ASSERT_TRUE(written.contains(message)) << ::testing::PrintToString(message);
      }
      ASSERT_TRUE(std::ranges::is_sorted(read, {}, &KeptMessage::log_time_ns));
      if (read.size() < log.messages.size()) {
        ASSERT_THAT(reader->damage(), Not(IsEmpty()));
      }
      ASSERT_TRUE(goesBackTheSameWay(*reader, read));
    }
  }
}

/// The same without a summary: the recorder was killed, and then a bit flipped.
TEST_P(CutLog, AFlippedBitInAKilledLogNeverChangesAPayloadSilently) {
  const SmallLog log = smallLog(GetParam());
  const std::set<KeptMessage> written(log.messages.begin(), log.messages.end());
  std::uint64_t data_end = 8;
  while (true) {
    const std::optional<mcap::Record> record = mcap::recordAt(log.file, data_end);
    ASSERT_TRUE(record.has_value());
    if (record->opcode == mcap::Opcode::data_end) break;
    data_end = record->end();
  }
  const Bytes killed = cutAt(log.file, static_cast<std::size_t>(data_end));
  {
    LogReader reader = openLog(killed);
    ASSERT_THAT(captured(reader), ElementsAreArray(log.messages));
  }
  for (std::size_t byte = 8; byte < killed.size(); byte += nextPlace()) {
    for (int bit = 0; bit < 8; ++bit) {
      SCOPED_TRACE(::testing::Message() << "byte " << byte << " bit " << bit);
      Bytes flipped = killed;
      flipped[byte] ^= static_cast<std::byte>(1U << static_cast<unsigned>(bit));
      LogReader reader = openLog(flipped);
      const std::vector<KeptMessage> read = captured(reader);
      for (const KeptMessage& message : read) {
        ASSERT_TRUE(written.contains(message)) << ::testing::PrintToString(message);
      }
      ASSERT_TRUE(goesBackTheSameWay(reader, read));
      // "Never closed" is always reported; a loss must be reported in addition.
      if (read.size() < log.messages.size()) {
        ASSERT_GT(reader.damage().size(), 1U);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Compression, CutLog,
                         ::testing::Values(LogWriterOptions::Compression::none,
                                           LogWriterOptions::Compression::zstd),
                         [](const auto& each) {
                           return each.param == LogWriterOptions::Compression::none ? "none"
                                                                                    : "zstd";
                         });

/// A chunk of several zstd blocks, cut anywhere: returns every message that a decoder fed byte by
/// byte can restore, so no more could be read from these bytes.
TEST(LogDamage, OfACutCompressedChunkEveryMessageThatCanBeDecodedComesBack) {
  Bytes file;
  LogWriter writer = makeWriter(file);
  const ChannelId channel = *writer.addChannel("/udp/1/a", "octets", {});
  std::uint64_t random = 1;
  for (int i = 0; i < 4000; ++i) {
    std::string payload = "RK1 arm@7f " + std::to_string(i) + " -\njoints arm";
    for (int j = 0; j < 6; ++j) {
      random = random * 6364136223846793005U + 1442695040888963407U;
      payload += " 0." + std::to_string(random >> 45U);
    }
    ASSERT_TRUE(writer.write(channel, 0, at(1000 + i), 7, bytesOf(payload)).ok());
  }
  ASSERT_TRUE(writer.close("finished").ok());
  std::uint64_t chunk_offset = 8;
  mcap::Chunk chunk;
  while (true) {
    const std::optional<mcap::Record> record = mcap::recordAt(file, chunk_offset);
    if (record->opcode == mcap::Opcode::chunk && mcap::parse(record->content, chunk)) break;
    chunk_offset = record->end();
  }
  ASSERT_EQ(chunk.compression, "zstd");
  mcap::ChunkExpander expander;
  mcap::Scratch scratch;
  const Bytes records = [&] {
    const Result<ByteView> whole = expander.expand(chunk, scratch);
    return Bytes(whole->begin(), whole->end());
  }();
  std::vector<std::size_t> message_ends;
  for (std::uint64_t position = 0; position < records.size();) {
    const std::optional<mcap::Record> record = mcap::recordAt(records, position);
    position = record->end();
    if (record->opcode == mcap::Opcode::message) message_ends.push_back(position);
  }

  const std::size_t head = static_cast<std::size_t>(chunk.records.data() - file.data());
  ZSTD_DCtx* const zstd = ZSTD_createDCtx();
  Bytes made(records.size());
  ZSTD_outBuffer out{made.data(), made.size(), 0};
  std::size_t counts = 0;
  std::size_t last_count = 0;
  for (std::size_t size = 0; size < chunk.records.size(); ++size) {
    // The messages in `size` bytes; checked where their number grows, just before that, and now and
    // then.
    const std::size_t before = out.pos;
    ZSTD_inBuffer in{chunk.records.data() + size, 1, 0};
    if (size % 4999 == 0) {
      const Bytes cut = cutAt(file, head + size);
      LogReader reader = openLog(cut);
      const auto wanted =
          std::ranges::count_if(message_ends, [&](std::size_t end) { return end <= before; });
      ASSERT_EQ(readAll(reader).size(), static_cast<std::size_t>(wanted)) << size;
    }
    ASSERT_EQ(ZSTD_isError(ZSTD_decompressStream(zstd, &out, &in)), 0U);
    if (out.pos == before) continue;
    ++counts;
    for (const std::size_t there : {size, size + 1}) {
      const Bytes cut = cutAt(file, head + there);
      LogReader reader = openLog(cut);
      const std::size_t decoded = there == size ? before : out.pos;
      last_count = static_cast<std::size_t>(
          std::ranges::count_if(message_ends, [&](std::size_t end) { return end <= decoded; }));
      ASSERT_EQ(readAll(reader).size(), last_count) << there;
    }
  }
  ZSTD_freeDCtx(zstd);
  EXPECT_GE(counts, 3U) << "blocks";
  EXPECT_EQ(last_count, 4000U);
}

TEST(LogDamage, WhatTheRecorderAddedItselfIsNotCountedAsLost) {
  Bytes file;
  {
    LogWriterOptions options;
    options.compression = LogWriterOptions::Compression::none;
    LogWriter writer = *LogWriter::createOn(makeMemorySink(file), options, "s");
    const ChannelId keyframes = *writer.addChannel("/rocinante/keyframe", "rk1", {});
    const ChannelId arm = *writer.addChannel("/udp/1/arm", "rk1", {});
    ASSERT_TRUE(writer.write(keyframes, 0, LogTime{}, 0, bytesOf("keyframe")).ok());
    ASSERT_TRUE(writer.write(arm, 0, LogTime{}, 0, bytesOf("the one")).ok());
    ASSERT_TRUE(writer.close("end").ok());
  }
  file[textOf(file).find("the one")] = std::byte{'T'};
  LogReader reader = openLog(file);
  EXPECT_TRUE(captured(reader).empty());
  ASSERT_EQ(reader.damage().size(), 1U);
  EXPECT_EQ(reader.damage()[0].messages_lost, 1U);
}

TEST(LogDamage, AChunkThatFailsItsChecksumIsSkippedAndCounted) {
  SmallLog log = smallLog(LogWriterOptions::Compression::none);
  // The payload of the first message: "joints arm 0 0.25".
  const std::string_view text = textOf(log.file);
  const std::size_t place = text.find("0.25");
  log.file[place] = std::byte{'9'};
  LogReader reader = openLog(log.file);
  const std::vector<KeptMessage> read = captured(reader);
  ASSERT_EQ(reader.damage().size(), 1U);
  const DamageSpan& damage = reader.damage()[0];
  EXPECT_THAT(damage.cause, ::testing::HasSubstr("fails its checksum"));
  EXPECT_LE(damage.from, place);
  EXPECT_GT(damage.to, place);
  ASSERT_TRUE(damage.messages_lost.has_value());
  EXPECT_EQ(read.size() + *damage.messages_lost, log.messages.size());
  // Reading it again finds the same damage, and lists it once.
  ASSERT_TRUE(reader.rewind().ok());
  EXPECT_EQ(captured(reader), read);
  EXPECT_EQ(reader.damage().size(), 1U);
}

TEST(LogDamage, ABrokenIndexBehindABrokenChunkMakesItsLossNoSmaller) {
  SmallLog log = smallLog(LogWriterOptions::Compression::none);
  log.file[textOf(log.file).find("0.25")] = std::byte{'9'};
  LogReader whole = openLog(log.file);
  captured(whole);
  ASSERT_EQ(whole.damage().size(), 1U);
  const std::uint64_t lost = whole.damage()[0].messages_lost.value();
  const std::size_t begin = whole.damage()[0].to;
  mcap::RecordStepper steps(log.file, begin);
  while (steps.peek()->opcode == mcap::Opcode::message_index) steps.next();
  for (std::size_t place = begin; place < steps.position(); ++place) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      Bytes file = log.file;
      file[place] ^= static_cast<std::byte>(1U << bit);
      LogReader reader = openLog(file);
      captured(reader);
      ASSERT_TRUE(std::ranges::any_of(reader.damage(),
                                      [&](const DamageSpan& each) {
                                        return each.to == begin &&
                                               (!each.messages_lost || *each.messages_lost >= lost);
                                      }))
          << "byte " << place << ", bit " << bit;
      ASSERT_THAT(reader.unreadable(), Not(IsEmpty())) << "byte " << place << ", bit " << bit;
    }
  }
}

TEST(LogDamage, APieceMissingFromOneRecordToAnotherIsTold) {
  const SmallLog log = smallLog(LogWriterOptions::Compression::zstd);
  mcap::RecordStepper steps(log.file, mcap::magic().size());
  while (steps.peek()->opcode != mcap::Opcode::chunk) steps.next();
  const auto from = static_cast<std::ptrdiff_t>(steps.position());
  steps.next();
  while (steps.peek()->opcode == mcap::Opcode::message_index) steps.next();
  Bytes file = log.file;
  file.erase(file.begin() + from, file.begin() + static_cast<std::ptrdiff_t>(steps.position()));
  file.shrink_to_fit();
  LogReader reader = openLog(file);
  const std::vector<KeptMessage> read = captured(reader);
  ASSERT_LT(read.size(), log.messages.size());
  const auto told = std::ranges::find_if(reader.damage(), [](const DamageSpan& each) {
    return each.cause.ends_with("a piece of the file is missing");
  });
  ASSERT_NE(told, reader.damage().end());
  EXPECT_EQ(told->messages_lost, log.messages.size() - read.size());
  ASSERT_EQ(reader.unreadable().size(), 1U);
  EXPECT_EQ(reader.unreadable()[0].first.time, LogTime::min());
  EXPECT_EQ(reader.unreadable()[0].last.time, LogTime::max());
}

TEST(LogDamage, ADamagedAttachmentIsRefusedByItsChecksum) {
  SmallLog log = smallLog(LogWriterOptions::Compression::none);
  const std::size_t place = textOf(log.file).find("abc");
  log.file[place] = std::byte{'x'};
  LogReader reader = openLog(log.file);
  const Result<Bytes> data = reader.readAttachment(0);
  ASSERT_FALSE(data.ok());
  EXPECT_EQ(data.error().kind, ErrorKind::damaged);
}

TEST(LogDamage, WhatDoesNotBeginAsALogIsDamaged) {
  for (const std::string_view text : {"", "\x89MCAP", "hello, this is no log", "\x89MCAP1\r\n"}) {
    const Result<LogReader> reader = LogReader::openBytes(bytesOf(text), "not.mcap");
    ASSERT_FALSE(reader.ok());
    EXPECT_EQ(reader.error().kind, ErrorKind::damaged);
    EXPECT_THAT(reader.error().text(), ::testing::HasSubstr("not.mcap"));
  }
}

}  // namespace
}  // namespace rocinante::test
