#include <gmock/gmock.h>
#include <sys/file.h>
#include <unistd.h>

#include "tests/core/log/growing_file.h"
#include "tests/core/log/log_support.h"
#include "tests/core/log/write_history.h"

namespace rocinante::test {
namespace {

class GrowingReader : public testing::TestWithParam<bool> {};

TEST_P(GrowingReader, KnowsAfterEachWriteWhatAFreshReaderKnows) {
  WriteHistory history(GetParam());
  history.beginOpenChunk();
  for (const int count : {1, 3, 2}) history.addMessages(count);
  history.endOpenChunk(2);
  history.addAttachment();
  history.addWholeChunk(4);
  history.beginOpenChunk();
  history.addMessages(5);
  history.endOpenChunk(1);
  history.finish();
  GrowingFile file;
  file.apply(history.writes().front());
  auto reader = LogReader::openGrowing(file.path());
  ASSERT_TRUE(reader.ok()) << reader.error().text();
  for (std::size_t done = 1; done < history.writes().size(); ++done) {
    SCOPED_TRACE(done);
    const WriteHistory::Write& write = history.writes()[done];
    file.apply(write);
    const auto grown = reader->refresh();
    ASSERT_TRUE(grown.ok());
    EXPECT_EQ(*grown, !write.offset.has_value());
    const Bytes whole = history.after(done + 1);
    LogReader fresh = openLog(whole);
    ASSERT_TRUE(reader->rewind().ok());
    const std::vector<KeptMessage> messages = readAll(*reader);
    EXPECT_EQ(messages, readAll(fresh));
    EXPECT_GE(messages.size(), write.messages);
    EXPECT_EQ(reader->summary().messages, fresh.summary().messages);
    EXPECT_EQ(reader->summary().start, fresh.summary().start);
    EXPECT_EQ(reader->summary().end, fresh.summary().end);
    EXPECT_EQ(reader->summary().closed, fresh.summary().closed);
    EXPECT_EQ(reader->attachments().size(), fresh.attachments().size());
  }
  EXPECT_TRUE(reader->summary().complete);
  EXPECT_FALSE(*reader->refresh());
}
INSTANTIATE_TEST_SUITE_P(Compressed, GrowingReader, testing::Bool());

TEST(GrowingReaderOfALockedFile, ItsMissingEndIsDamageOnlyWhenItsWriterIsGone) {
  WriteHistory history(true);
  history.beginOpenChunk();
  history.addMessages(5);
  GrowingFile file;
  for (const WriteHistory::Write& write : history.writes()) file.apply(write);
  const int writer = ::open(file.path().c_str(), O_RDWR | O_CLOEXEC);
  ASSERT_EQ(::flock(writer, LOCK_EX), 0);
  auto reader = LogReader::openGrowing(file.path());
  ASSERT_TRUE(reader.ok());
  EXPECT_TRUE(reader->growing());
  EXPECT_TRUE(reader->damage().empty()) << reader->damage().front().cause;
  EXPECT_EQ(reader->summary().messages, 5U);
  EXPECT_FALSE(*reader->refresh());
  ::close(writer);
  EXPECT_TRUE(*reader->refresh());
  EXPECT_FALSE(reader->growing());
  ASSERT_FALSE(reader->damage().empty());
  EXPECT_THAT(reader->damage().back().cause, testing::HasSubstr("without a summary"));
  EXPECT_EQ(reader->summary().messages, 5U);
}

TEST(GrowingReaderOfALockedFile, ABrokenChunkIsToldOnceWhileTheLogGrows) {
  WriteHistory history(false);
  history.addWholeChunk(2);
  const std::size_t second = history.writes().size();
  history.addWholeChunk(2);
  history.addWholeChunk(2);
  GrowingFile file;
  for (std::size_t i = 0; i < second; ++i) {
    WriteHistory::Write write = history.writes()[i];
    // A byte of the first chunk's payload.
    const std::size_t text = textOf(write.bytes).find("RK1");
    if (text != std::string_view::npos) write.bytes[text] ^= std::byte{1};
    file.apply(write);
  }
  const int writer = ::open(file.path().c_str(), O_RDWR | O_CLOEXEC);
  ASSERT_EQ(::flock(writer, LOCK_EX), 0);
  auto reader = LogReader::openGrowing(file.path());
  ASSERT_TRUE(reader.ok());
  for (std::size_t i = second; i < history.writes().size(); ++i) {
    file.apply(history.writes()[i]);
    ASSERT_TRUE(reader->refresh().ok());
    ASSERT_TRUE(reader->rewind().ok());
    (void)readAll(*reader);
  }
  EXPECT_EQ(payloads(*reader).size(), 0U);  // at the end
  ASSERT_TRUE(reader->rewind().ok());
  EXPECT_EQ(readAll(*reader).size(), 4U);
  EXPECT_EQ(std::ranges::count_if(reader->damage(),
                                  [](const DamageSpan& each) {
                                    return each.cause.find("checksum") != std::string::npos;
                                  }),
            1);
  ::close(writer);
}

/// Where, and what.
std::vector<std::pair<std::uint64_t, std::string>> listed(const LogReader& reader) {
  std::vector<std::pair<std::uint64_t, std::string>> all;
  for (const DamageSpan& each : reader.damage()) all.emplace_back(each.from, each.cause);
  std::ranges::sort(all);
  return all;
}

TEST(GrowingReaderOfALockedFile, BehindABreakItKnowsWhatAFreshReaderKnows) {
  WriteHistory history(false);
  for (int chunk = 0; chunk < 8; ++chunk) history.addWholeChunk(2);
  GrowingFile file;
  file.apply(history.writes().front());
  const int writer = ::open(file.path().c_str(), O_RDWR | O_CLOEXEC);
  ASSERT_EQ(::flock(writer, LOCK_EX), 0);
  auto reader = LogReader::openGrowing(file.path());
  ASSERT_TRUE(reader.ok());
  int chunks = 0;
  for (std::size_t i = 1; i < history.writes().size(); ++i) {
    SCOPED_TRACE(i);
    WriteHistory::Write write = history.writes()[i];
    const std::size_t text = textOf(write.bytes).find("RK1");
    if (text != std::string_view::npos) {
      ++chunks;
      // Bytes that are no record, in front of the third and the sixth.
      if (chunks % 3 == 0) file.append(Bytes(40));
      // The payload of the second, the third and the fifth.
      if (chunks == 2 || chunks == 3 || chunks == 5) write.bytes[text] ^= std::byte{1};
    }
    file.apply(write);
    ASSERT_TRUE(reader->refresh().ok());
    ASSERT_TRUE(reader->rewind().ok());
    const std::vector<KeptMessage> messages = readAll(*reader);
    auto fresh = LogReader::openGrowing(file.path());
    ASSERT_TRUE(fresh.ok());
    EXPECT_EQ(messages, readAll(*fresh));
    EXPECT_EQ(listed(*reader), listed(*fresh));
  }
  EXPECT_EQ(chunks, 8);
  EXPECT_EQ(listed(*reader).size(), 5U) << "three chunks, and two breaks";
  ::close(writer);
}

TEST(GrowingReaderOfALockedFile, ADamagedSummaryStaysDamagedWhenTheLogIsReadOn) {
  WriteHistory history(false);
  history.addWholeChunk(2);
  history.finish();
  Bytes whole = history.after(history.writes().size());
  // In the checksum of the footer.
  whole[whole.size() - mcap::magic().size() - 1] ^= std::byte{1};
  GrowingFile file(whole);
  auto reader = LogReader::follow(file.path());
  ASSERT_TRUE(reader.ok());
  const auto told = listed(*reader);
  ASSERT_FALSE(told.empty());
  file.append(Bytes(3));
  ASSERT_TRUE(reader->refresh().ok());
  EXPECT_THAT(listed(*reader), testing::IsSupersetOf(told));
}

TEST(GrowingReaderOfALockedFile, ATruncatedLogIsAnError) {
  WriteHistory history(true);
  history.addWholeChunk(3);
  GrowingFile file;
  for (const WriteHistory::Write& write : history.writes()) file.apply(write);
  auto reader = LogReader::openGrowing(file.path());
  ASSERT_TRUE(reader.ok());
  file.cutTo(20);
  const auto grown = reader->refresh();
  ASSERT_FALSE(grown.ok());
  EXPECT_EQ(grown.error().what, "the log was truncated while it was read");
}

}  // namespace
}  // namespace rocinante::test
