#include "core/log/log_writer.h"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>

#include "core/base/atomic_file.h"
#include "tests/core/log/log_support.h"
#include "tests/support/temporary_folder.h"

namespace rocinante::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A disk with limited room: a write beyond it leaves the part that fits, and fails.
class FullSink final : public ByteSink {
 public:
  FullSink(Bytes& out, std::size_t room) : out_(out), room_(room) {}
  Status append(ByteView bytes) override {
    const std::size_t fits = std::min(bytes.size(), room_ - out_.size());
    out_.insert(out_.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(fits));
    if (fits == bytes.size()) return {};
    return Error{ErrorKind::unreadable, "cannot write to the file: No space left on device",
                 "full"};
  }
  Status truncate(std::uint64_t size) override {
    out_.resize(static_cast<std::size_t>(size));
    return {};
  }
  Status close() override { return {}; }
  const std::string& name() const override { return name_; }

 private:
  Bytes& out_;
  std::size_t room_;
  std::string name_ = "full";
};

struct FullDiskOutcome {
  Bytes file;
  std::uint64_t accepted = 0;
  std::uint64_t refused = 0;
  Status closed;
};

/// Writes forty messages of about 100 bytes, then a loss, to a disk with `room` bytes.
std::optional<FullDiskOutcome> recordOnto(std::size_t room) {
  FullDiskOutcome outcome;
  LogWriterOptions options;
  options.chunk_bytes = 700;
  options.compression = LogWriterOptions::Compression::none;
  Result<LogWriter> writer =
      LogWriter::createOn(std::make_unique<FullSink>(outcome.file, room), options, "s");
  if (!writer) return std::nullopt;
  const ChannelId channel = *writer->addChannel("/udp/1/a", "octets", {});
  const std::string payload(100, 'x');
  for (std::uint32_t i = 0; i < 40; ++i) {
    if (writer->write(channel, i, at(1000 + i), 0, bytesOf(payload)).ok()) ++outcome.accepted;
  }
  (void)writer->writeLoss({"udp://:1", at(1), at(2), {0, 0, 1, 0}});
  outcome.closed = writer->close("finished");
  for (const auto& [id, count] : writer->refusedByDisk()) {
    if (id == channel) outcome.refused += count;
  }
  return outcome;
}

TEST(LogWriter, ADiskThatFillsAtAnyByteLeavesAReadableLogAndAnExactAccount) {
  const std::optional<FullDiskOutcome> unlimited = recordOnto(1U << 20U);
  ASSERT_TRUE(unlimited.has_value());
  ASSERT_TRUE(unlimited->closed.ok());
  std::uint64_t finished_all_the_same = 0;
  for (std::size_t room = 0; room < unlimited->file.size(); room += 7) {
    SCOPED_TRACE(room);
    std::optional<FullDiskOutcome> outcome = recordOnto(room);
    if (!outcome) continue;  // no room for the header: refused at once
    ASSERT_FALSE(outcome->closed.ok());
    EXPECT_THAT(outcome->closed.error().text(), HasSubstr("No space left"));
    LogReader reader = openLog(outcome->file);
    std::uint64_t stored = 0;
    for (const KeptMessage& message : readAll(reader)) stored += message.topic == "/udp/1/a";
    EXPECT_EQ(stored + outcome->refused, 40U);
    if (reader.summary().complete) ++finished_all_the_same;
    // Nothing is torn: at most the missing end is reported.
    for (const DamageSpan& damage : reader.damage()) EXPECT_EQ(damage.from, damage.to);
  }
  EXPECT_GT(finished_all_the_same, 10U);
}

TEST(LogWriter, OntoAFullDeviceFailsWithTheSystemsReason) {
  LogWriterOptions options;
  options.overwrite = true;
  const Result<LogWriter> writer = LogWriter::create("/dev/full", options, "s");
  ASSERT_FALSE(writer.ok());
  EXPECT_EQ(writer.error().text(), "cannot write to the file: No space left on device (/dev/full)");
}

TEST(LogWriter, RefusesAnExistingFileUnlessToldToOverwrite) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "a.mcap";
  ASSERT_TRUE(writeFileWhole(path, bytesOf("precious"), false).ok());
  Result<LogWriter> refused = LogWriter::create(path, {}, "s");
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().kind, ErrorKind::refused);
  EXPECT_EQ(*readFile(path), "precious");
  LogWriterOptions options;
  options.overwrite = true;
  Result<LogWriter> writer = LogWriter::create(path, options, "s");
  ASSERT_TRUE(writer.ok());
  ASSERT_TRUE(writer->close("finished").ok());
  Result<LogReader> reader = LogReader::open(path);
  ASSERT_TRUE(reader.ok());
  EXPECT_TRUE(reader->summary().complete);
}

TEST(LogWriter, OneThatCannotBeBegunLeavesTheOlderLogAlone) {
  const TemporaryFolder folder;
  const std::string old(200, 'x');
  ASSERT_TRUE(writeFileWhole(folder / "a.mcap", bytesOf(old), false).ok());
  struct rlimit before {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  struct rlimit limit = before;
  limit.rlim_cur = 100;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
  LogWriterOptions options;
  options.overwrite = true;
  const Result<LogWriter> writer = LogWriter::create(folder / "a.mcap", options, "s");
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  EXPECT_FALSE(writer.ok());
  EXPECT_EQ(*readFile(folder / "a.mcap"), old);
}

TEST(LogWriter, FlushedNowItIsFlushedInItsTimeAfterwards) {
  Bytes file;
  LogWriter writer = makeWriter(file);
  const ChannelId channel = *writer.addChannel("/udp/1/a", "octets", {});
  const SteadyTime start{std::chrono::hours(1)};
  const auto put = [&](int at_ms) {
    const LogTime time{std::chrono::milliseconds(at_ms)};
    ASSERT_TRUE(writer.write(channel, 0, time, 0, bytesOf("message")).ok());
  };
  ASSERT_TRUE(writer.flushIfDue(start).ok());
  put(1);
  std::uint64_t bytes = writer.bytesWritten();
  ASSERT_TRUE(writer.flush().ok());
  EXPECT_GT(writer.bytesWritten(), bytes);
  bytes = writer.bytesWritten();
  put(2);
  ASSERT_TRUE(writer.flushIfDue(start + std::chrono::milliseconds(60)).ok());
  EXPECT_GT(writer.bytesWritten(), bytes);
}

TEST(LogWriter, IntoAReadOnlyFolderFailsWithTheSystemsReason) {
  const TemporaryFolder folder;
  ASSERT_EQ(::chmod(folder.path().c_str(), 0555), 0);
  // Root may write anywhere, so the test runs as nobody here.
  const bool was_root = ::geteuid() == 0;
  if (was_root) {
    ASSERT_EQ(::seteuid(65534), 0);
  }
  const Result<LogWriter> writer = LogWriter::create(folder / "a.mcap", {}, "s");
  if (was_root) {
    ASSERT_EQ(::seteuid(0), 0);
  }
  ASSERT_EQ(::chmod(folder.path().c_str(), 0700), 0);
  ASSERT_FALSE(writer.ok());
  EXPECT_THAT(writer.error().text(), HasSubstr("Permission denied"));
}

TEST(LogWriter, WithoutRoomForAnEmptyLogLeavesNoFile) {
  const TemporaryFolder folder;
  struct rlimit before {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  struct rlimit limit = before;
  limit.rlim_cur = 100;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
  const Result<LogWriter> writer = LogWriter::create(folder / "a.mcap", {}, "s");
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  ASSERT_FALSE(writer.ok());
  EXPECT_THAT(writer.error().text(), HasSubstr("File too large"));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(LogWriter, IntoAFolderThatDoesNotExistFails) {
  const TemporaryFolder folder;
  const Result<LogWriter> writer = LogWriter::create(folder / "no" / "a.mcap", {}, "s");
  ASSERT_FALSE(writer.ok());
  EXPECT_THAT(writer.error().text(), HasSubstr("No such file or directory"));
}

TEST(LogWriter, ALogThatIsDroppedWithoutCloseIsReadableAndSaysSo) {
  Bytes file;
  {
    LogWriter writer = makeWriter(file);
    const ChannelId channel = *writer.addChannel("/udp/1/a", "octets", {});
    ASSERT_TRUE(writer.write(channel, 0, at(5), 0, bytesOf("x")).ok());
  }
  LogReader reader = openLog(file);
  EXPECT_EQ(readAll(reader).size(), 1U);
  EXPECT_EQ(reader.summary().end_reason, "abandoned");
}

TEST(LogWriter, RefusesWhatCannotBeWritten) {
  Bytes file;
  LogWriter writer = makeWriter(file);
  EXPECT_FALSE(writer.write(0, 0, at(5), 0, bytesOf("x")).ok()) << "a channel never added";
  const ChannelId channel = *writer.addChannel("/udp/1/a", "octets", {});
  EXPECT_FALSE(writer.write(channel, 0, at(-1), 0, bytesOf("x")).ok()) << "before 1970";
  ASSERT_TRUE(writer.close("finished").ok());
  LogReader reader = openLog(file);
  EXPECT_THAT(readAll(reader), IsEmpty());
}

TEST(LogWriter, TakesTheLastChannelIdAndRefusesTheNext) {
  Bytes file;
  LogWriter writer = makeWriter(file);
  for (int i = 0; i < 65536; ++i) ASSERT_TRUE(writer.addChannel("/udp/1/a", "octets", {}).ok());
  EXPECT_FALSE(writer.addChannel("/udp/1/a", "octets", {}).ok());
  ASSERT_TRUE(writer.write(65535, 0, at(5), 0, bytesOf("x")).ok());
  ASSERT_TRUE(writer.close("finished").ok());
  LogReader reader = openLog(file);
  EXPECT_EQ(readAll(reader).size(), 1U);
  EXPECT_EQ(reader.channels().size(), 65536U);
}

}  // namespace
}  // namespace rocinante::test
