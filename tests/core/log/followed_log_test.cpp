#include <gmock/gmock.h>
#include <zstd.h>

#include <fstream>

#include "core/mcap/append_record.h"
#include "tests/core/log/growing_file.h"
#include "tests/core/log/log_support.h"
#include "tests/core/log/write_history.h"
#include "tests/core/mcap/file_maker.h"
#include "tests/support/next_place.h"

namespace rocinante::test {
namespace {

LogReader follow(const GrowingFile& file) {
  Result<LogReader> reader = LogReader::follow(file.path());
  EXPECT_TRUE(reader.ok()) << reader.error().text();
  return std::move(*reader);
}

/// Adds what nextInFile() gives now to `messages`.
void drain(LogReader& reader, std::vector<KeptMessage>& messages) {
  while (true) {
    const Result<std::optional<LogMessage>> message = reader.nextInFile();
    ASSERT_TRUE(message.ok()) << message.error().text();
    if (!*message) return;
    messages.push_back(keep(**message));
  }
}

/// The same after a look at the file; why it cannot go on, or nothing.
std::string look(LogReader& reader, std::vector<KeptMessage>& messages) {
  const Result<bool> grown = reader.refresh();
  if (!grown.ok()) return grown.error().text();
  drain(reader, messages);
  return {};
}

class FollowedLog : public testing::TestWithParam<bool> {};

TEST_P(FollowedLog, GivesEveryMessageAsSoonAsItIsWholeAndNeverHalfOfOne) {
  WriteHistory history(GetParam());
  record(history);
  GrowingFile file;
  LogReader reader = follow(file);
  std::vector<KeptMessage> messages;
  const std::vector<KeptMessage>& all = history.messages();
  for (const WriteHistory::Write& write : history.writes()) {
    ASSERT_FALSE(reader.ended());
    if (write.offset) {
      file.apply(write);
    } else {
      for (const std::byte byte : write.bytes) {
        file.append({byte});
        const std::size_t before = messages.size();
        ASSERT_EQ(look(reader, messages), "");
        ASSERT_LE(messages.size(), all.size());
        for (std::size_t i = before; i < messages.size(); ++i) ASSERT_EQ(messages[i], all[i]);
        ASSERT_TRUE(reader.damage().empty()) << reader.damage().front().cause;
      }
    }
    EXPECT_GE(messages.size(), write.messages);
  }
  EXPECT_EQ(messages, all);
  EXPECT_TRUE(reader.ended());
  EXPECT_TRUE(reader.summary().complete);
  EXPECT_EQ(reader.summary().origin, at(1000));
}

TEST_P(FollowedLog, GivesTheSameWhereverOneComesIn) {
  WriteHistory history(GetParam());
  record(history);
  for (std::size_t done = 0; done < history.writes().size(); ++done) {
    const WriteHistory::Write& next = history.writes()[done];
    // Of the next write only a part, as between two pages of memory.
    for (std::size_t part = 0; part < next.bytes.size(); part += 3 * nextPlace()) {
      SCOPED_TRACE(std::to_string(done) + " writes and " + std::to_string(part));
      GrowingFile file(history.after(done));
      file.apply({next.offset, cutAt(next.bytes, part)});
      LogReader from_start = follow(file);
      LogReader from_now = follow(file);
      from_now.skipInFile();
      std::vector<KeptMessage> whole;
      std::vector<KeptMessage> fresh;
      drain(from_start, whole);
      drain(from_now, fresh);
      EXPECT_THAT(fresh, testing::IsEmpty());
      const std::size_t there = whole.size();
      EXPECT_GE(there, done == 0 ? 0 : history.writes()[done - 1].messages);

      if (next.offset) {
        file.apply(next);
      } else {
        file.append(
            Bytes(next.bytes.begin() + static_cast<std::ptrdiff_t>(part), next.bytes.end()));
      }
      for (std::size_t i = done + 1; i < history.writes().size(); ++i) {
        file.apply(history.writes()[i]);
      }
      ASSERT_EQ(look(from_start, whole), "");
      ASSERT_EQ(look(from_now, fresh), "");
      EXPECT_EQ(whole, history.messages());
      EXPECT_EQ(fresh, std::vector<KeptMessage>(
                           history.messages().begin() + static_cast<std::ptrdiff_t>(there),
                           history.messages().end()));
      for (const LogReader* const reader : {&from_start, &from_now}) {
        EXPECT_TRUE(reader->ended());
        EXPECT_TRUE(reader->damage().empty()) << reader->damage().front().cause;
      }
    }
  }
}

TEST_P(FollowedLog, NoticesAHeaderThatIsNotThatOfTheChunk) {
  WriteHistory history(GetParam());
  history.beginOpenChunk();
  history.addMessages(2);
  history.endOpenChunk(1);
  history.finish();
  // Offsets in the header: end of the uncompressed size, checksum, length of the records.
  for (const std::size_t wrong : {25U, 33U, GetParam() ? 45U : 41U}) {
    SCOPED_TRACE(wrong);
    GrowingFile file;
    LogReader reader = follow(file);
    std::vector<KeptMessage> messages;
    for (WriteHistory::Write write : history.writes()) {
      if (write.offset) write.bytes[wrong] ^= std::byte{1};
      file.apply(write);
      ASSERT_EQ(look(reader, messages), "");
    }
    EXPECT_EQ(messages, history.messages());
    EXPECT_TRUE(reader.ended());
    EXPECT_FALSE(reader.damage().empty());
  }
}

TEST_P(FollowedLog, ReadsAHeaderWhoseCompletionWasTorn) {
  WriteHistory history(GetParam());
  history.beginOpenChunk();
  history.addMessages(2);
  history.endOpenChunk(1);
  history.finish();
  // One field still has its value from the beginning: length, end time, uncompressed size.
  for (const std::ptrdiff_t open : {1, 17, 25}) {
    SCOPED_TRACE(open);
    GrowingFile file;
    for (WriteHistory::Write write : history.writes()) {
      if (write.offset) std::fill_n(write.bytes.begin() + open, 8, std::byte{0xFF});
      file.apply(write);
    }
    LogReader reader = follow(file);
    std::vector<KeptMessage> messages;
    drain(reader, messages);
    EXPECT_EQ(messages, history.messages());
    EXPECT_TRUE(reader.ended());
    EXPECT_THAT(reader.damage(),
                testing::Contains(
                    testing::Field(&DamageSpan::cause, testing::HasSubstr("was never finished"))));
  }
}

TEST_P(FollowedLog, BearsEveryFlippedBit) {
  WriteHistory history(GetParam());
  record(history);
  const Bytes whole = history.after(history.writes().size());
  const auto half = static_cast<std::ptrdiff_t>(whole.size() / 2);
  for (std::size_t bit = 0; bit < whole.size() * 8; bit += 7 * nextPlace()) {
    Bytes bytes = whole;
    bytes[bit / 8] ^= static_cast<std::byte>(1U << (bit % 8));
    GrowingFile file(Bytes(bytes.begin(), bytes.begin() + half));
    Result<LogReader> reader = LogReader::follow(file.path());
    if (!reader.ok()) continue;
    std::vector<KeptMessage> messages;
    drain(*reader, messages);
    file.append(Bytes(bytes.begin() + half, bytes.end()));
    (void)look(*reader, messages);
    // Every message returned was written, in this order: checksums cover them all.
    std::size_t next = 0;
    for (const KeptMessage& message : messages) {
      while (next < history.messages().size() && history.messages()[next] != message) ++next;
      EXPECT_LT(next++, history.messages().size()) << "changed, bit " << bit;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Compressed, FollowedLog, testing::Bool());

TEST(FollowedLog, GivesTheOrderOfWritingAlsoWhereTimesAreLate) {
  const TemporaryFolder folder;
  Result<LogWriter> writer = LogWriter::create(folder / "log.mcap", {.chunk_bytes = 300}, "s");
  ASSERT_TRUE(writer.ok());
  const ChannelId channel = *writer->addChannel("/udp/1/a", "rk1", {});
  Result<LogReader> reader = LogReader::follow(folder / "log.mcap");
  ASSERT_TRUE(reader.ok());
  std::vector<KeptMessage> messages;
  for (std::uint32_t i = 0; i < 60; ++i) {
    const std::string payload = "payload " + std::to_string(i);
    const LogTime time = at(i % 7 == 3 ? 1000 : 1000 + 10 * i);
    ASSERT_TRUE(writer->write(channel, i, time, i, bytesOf(payload)).ok());
    if (i % 4 != 0) continue;
    ASSERT_TRUE(writer->flush().ok());
    ASSERT_EQ(look(*reader, messages), "");
    ASSERT_EQ(messages.size(), i + 1);
  }
  ASSERT_TRUE(writer->close("finished").ok());
  ASSERT_EQ(look(*reader, messages), "");
  ASSERT_EQ(messages.size(), 60U);
  for (std::uint32_t i = 0; i < 60; ++i) EXPECT_EQ(messages[i].sequence, i);
  ASSERT_TRUE(reader->rewind().ok());
  std::vector<KeptMessage> in_time = readAll(*reader);
  EXPECT_TRUE(std::ranges::is_sorted(in_time, {}, &KeptMessage::log_time_ns));
  EXPECT_TRUE(std::ranges::is_permutation(in_time, messages));
}

TEST(FollowedLog, LeavesABrokenChunkOutAndGoesOn) {
  WriteHistory history(false);
  history.addWholeChunk(2);
  const std::size_t second = history.writes().size();
  history.addWholeChunk(2);
  history.finish();
  Bytes first = history.after(second);
  // A byte of the first chunk's payload.
  first[textOf(first).find("RK1")] ^= std::byte{1};
  GrowingFile file(first);
  LogReader reader = follow(file);
  std::vector<KeptMessage> messages;
  drain(reader, messages);
  for (std::size_t i = second; i < history.writes().size(); ++i) {
    file.apply(history.writes()[i]);
    ASSERT_EQ(look(reader, messages), "");
  }
  EXPECT_EQ(messages.size(), 2U);
  EXPECT_TRUE(reader.ended());
  ASSERT_EQ(reader.damage().size(), 1U);
  EXPECT_THAT(reader.damage()[0].cause, testing::HasSubstr("fails its checksum"));
}

TEST(FollowedLog, GivesWhatIsBehindABrokenChunkOnce) {
  WriteHistory history(false);
  history.addWholeChunk(2);
  const std::size_t of_first = history.after(history.writes().size()).size();
  history.addWholeChunk(2);
  history.beginOpenChunk();
  history.addMessages(3);
  const std::size_t open = history.writes().size();
  history.endOpenChunk(0);
  history.addWholeChunk(1);
  history.finish();
  Bytes begun = history.after(open);
  // A byte of the second chunk's payload.
  begun[textOf(begun).find("RK1", of_first)] ^= std::byte{1};
  GrowingFile file(begun);
  LogReader reader = follow(file);
  std::vector<KeptMessage> messages;
  drain(reader, messages);
  for (std::size_t i = open; i < history.writes().size(); ++i) {
    file.apply(history.writes()[i]);
    ASSERT_EQ(look(reader, messages), "");
  }
  std::vector<KeptMessage> sound = history.messages();
  sound.erase(sound.begin() + 2, sound.begin() + 4);
  EXPECT_EQ(messages, sound);
}

TEST(FollowedLog, GoesOnBehindBytesThatAreNoRecord) {
  WriteHistory history(false);
  history.addWholeChunk(2);
  const std::size_t second = history.writes().size();
  history.addWholeChunk(2);
  GrowingFile file(history.after(second));
  file.append(Bytes(40));
  LogReader reader = follow(file);
  std::vector<KeptMessage> messages;
  drain(reader, messages);
  EXPECT_EQ(messages.size(), 2U);
  EXPECT_TRUE(reader.damage().empty()) << "the file system may show its length first";
  for (std::size_t i = second; i < history.writes().size(); ++i) file.apply(history.writes()[i]);
  ASSERT_EQ(look(reader, messages), "");
  EXPECT_EQ(messages, history.messages());
  ASSERT_FALSE(reader.damage().empty());
  EXPECT_THAT(reader.damage()[0].cause, testing::HasSubstr("bytes that are not a record"));
}

TEST(FollowedLog, ALogInAnAttachmentIsNoPartOfItWhileTheAttachmentIsWritten) {
  WriteHistory other(false);
  other.addWholeChunk(5);
  other.finish();
  const Bytes log = other.after(other.writes().size());
  mcap::Attachment attachment;
  attachment.name = "other.mcap";
  attachment.data = log;
  Bytes record;
  mcap::append(record, attachment);
  WriteHistory history(false);
  history.addWholeChunk(2);
  GrowingFile file(history.after(history.writes().size()));
  LogReader reader = follow(file);
  std::vector<KeptMessage> messages;
  drain(reader, messages);
  for (const std::byte byte : record) {
    file.append({byte});
    ASSERT_EQ(look(reader, messages), "");
    ASSERT_EQ(messages.size(), 2U);
  }
  EXPECT_EQ(reader.attachments().size(), 1U);
}

TEST(FollowedLog, SaysWhenTheFileWasMadeShorter) {
  WriteHistory history(true);
  history.beginOpenChunk();
  history.addMessages(3);
  const Bytes all = history.after(history.writes().size());
  GrowingFile file(all);
  LogReader reader = follow(file);
  std::vector<KeptMessage> messages;
  drain(reader, messages);
  EXPECT_EQ(messages.size(), 3U);
  file.cutTo(all.size() - 1);
  EXPECT_EQ(look(reader, messages),
            "the log was truncated while it was read (" + file.path().string() + ")");
}

TEST(FollowedLog, BearsAWriteThatTheDiskCutShortAndThatWasTakenBack) {
  for (const bool compressed : {false, true}) {
    WriteHistory history(compressed);
    history.beginOpenChunk();
    history.addMessages(1);
    const std::size_t done = history.writes().size();
    history.addMessages(1);
    history.endOpenChunk(0);
    history.finish();
    const Bytes before = history.after(done);
    GrowingFile file(before);
    LogReader reader = follow(file);
    std::vector<KeptMessage> messages;
    drain(reader, messages);
    // Of the next message, the beginning.
    file.append(cutAt(history.writes()[done].bytes, 7));
    ASSERT_EQ(look(reader, messages), "");
    file.cutTo(before.size());
    ASSERT_EQ(look(reader, messages), "");
    for (std::size_t i = done; i < history.writes().size(); ++i) {
      file.apply(history.writes()[i]);
      ASSERT_EQ(look(reader, messages), "");
    }
    EXPECT_EQ(messages, history.messages());
    EXPECT_TRUE(reader.ended());
    EXPECT_TRUE(reader.damage().empty());
  }
}

TEST(FollowedLog, SaysWhenAnotherFileTookItsPlace) {
  WriteHistory history(false);
  history.addWholeChunk(2);
  const Bytes bytes = history.after(history.writes().size());
  GrowingFile file(bytes);
  LogReader reader = follow(file);
  std::vector<KeptMessage> messages;
  drain(reader, messages);
  EXPECT_EQ(messages.size(), 2U);
  std::filesystem::remove(file.path());
  EXPECT_EQ(look(reader, messages), "") << "its recorder may go on without a name";
  std::ofstream(file.path(), std::ios::binary) << textOf(bytes);
  EXPECT_THAT(look(reader, messages),
              testing::HasSubstr("another file replaced the one that is followed"));
}

TEST(FollowedLog, EndsWithItsMessagesAlsoWhereTheSummaryIsCut) {
  WriteHistory history(true);
  history.addWholeChunk(2);
  history.finish();
  Bytes bytes = history.after(history.writes().size());
  bytes.resize(bytes.size() - 20);
  const GrowingFile file(bytes);
  LogReader reader = follow(file);
  std::vector<KeptMessage> messages;
  drain(reader, messages);
  EXPECT_EQ(messages.size(), 2U);
  EXPECT_TRUE(reader.ended());
  EXPECT_FALSE(reader.summary().closed);
}

TEST(FollowedLog, RefusesWhatIsNoLog) {
  for (const std::string text : {"M", "\x89MCAP1\r\n", "not a log at all"}) {
    const GrowingFile file(Bytes(bytesOf(text).begin(), bytesOf(text).end()));
    const Result<LogReader> reader = LogReader::follow(file.path());
    ASSERT_FALSE(reader.ok()) << text;
    EXPECT_EQ(reader.error().kind, ErrorKind::damaged);
  }
  GrowingFile file;
  LogReader reader = follow(file);
  file.append(Bytes(1));
  std::vector<KeptMessage> messages;
  EXPECT_THAT(look(reader, messages), testing::HasSubstr("does not start with the MCAP magic"));
  EXPECT_EQ(LogReader::follow("no-such-file.mcap").error().kind, ErrorKind::not_found);
  EXPECT_EQ(LogReader::follow("/").error().kind, ErrorKind::unreadable);
  EXPECT_EQ(LogReader::follow("/dev/zero").error().kind, ErrorKind::unreadable);
}

}  // namespace
}  // namespace rocinante::test
