#include <fcntl.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <cerrno>
#include <tuple>

#include "core/base/atomic_file.h"
#include "core/mcap/file_sink.h"
#include "tests/core/log/log_support.h"
#include "tests/core/mcap/faulty_sink.h"
#include "tests/support/next_place.h"
#include "tests/support/stream_reader.h"
#include "tests/support/temporary_folder.h"

namespace rocinante::test {
namespace {

using ::testing::HasSubstr;

constexpr std::uint64_t kFaultMessages = 60;

struct Outcome {
  Bytes file;
  bool begun = false;  ///< there was room for the header
  std::uint64_t refused = 0;
  std::size_t writes = 0;
  Status closed;
};

std::string payloadOf(std::uint32_t i) {
  return std::to_string(i) + std::string(100, static_cast<char>('a' + i % 7));
}

enum class Pace { fast, slow, mixed };

/// Sixty messages on three channels, some of them late, then the steps of a recorder: the last
/// flush, a loss, the end. Slow: flushed after every message. Mixed: also chunks in one piece.
Outcome recordOnto(const DiskFaults& faults, Pace pace, LogWriterOptions::Compression compression) {
  Outcome outcome;
  LogWriterOptions options;
  options.chunk_bytes = 1500;
  options.compression = compression;
  options.closing_room_bytes = 1000;
  Result<LogWriter> writer = LogWriter::createOn(
      std::make_unique<FaultySink>(outcome.file, faults, outcome.writes), options, "s");
  if (!writer) return outcome;
  outcome.begun = true;
  std::vector<ChannelId> channels;
  SteadyTime now{};
  for (std::uint32_t i = 0; i < kFaultMessages; ++i) {
    if (i % 20 == 0) {
      channels.push_back(*writer->addChannel("/udp/1/" + std::to_string(i), "octets", {}));
    }
    const std::string payload = payloadOf(i);
    (void)writer->write(channels[i % channels.size()], i, at(1000 + i), 0, bytesOf(payload));
    now += options.sync;
    const bool flushes = pace == Pace::slow || (pace == Pace::mixed && i % 16 < 5);
    if (flushes) (void)writer->flushIfDue(now);
  }
  (void)writer->flushIfDue(now + options.sync);
  (void)writer->writeLoss({"udp://:1", at(1), at(2), {0, 0, 1, 0}});
  outcome.closed = writer->close("finished");
  for (const ChannelId channel : channels) {
    const auto found = writer->refusedByDisk().find(channel);
    if (found != writer->refusedByDisk().end()) outcome.refused += found->second;
  }
  return outcome;
}

/// The captured messages that a reader finds; each must be one that was written, whole.
std::uint64_t storedIn(const Bytes& file, bool* complete = nullptr) {
  const Bytes copy = cutAt(file, file.size());
  LogReader reader = openLog(copy);
  std::uint64_t stored = 0;
  for (const KeptMessage& message : readAll(reader)) {
    if (!message.topic.starts_with("/udp/")) continue;
    const std::uint32_t i = message.sequence;
    EXPECT_EQ(message.payload, payloadOf(i));
    ++stored;
  }
  if (complete != nullptr) {
    *complete = reader.summary().complete;
    if (*complete) {
      for (const DamageSpan& damage : reader.damage()) {
        ADD_FAILURE() << damage.cause << " from " << damage.from << " to " << damage.to;
      }
      EXPECT_EQ(reader.summary().messages, stored);
    }
  }
  return stored;
}

/// The file is strictly valid, from its first record to its footer.
void expectStrictlyWhole(const Bytes& file) {
  Result<test::StreamReader> reader = test::StreamReader::open(file);
  ASSERT_TRUE(reader.ok());
  while (true) {
    const Result<std::optional<mcap::Record>> record = reader->next();
    ASSERT_TRUE(record.ok()) << record.error().text();
    if (!*record) break;
  }
}

using Case = std::tuple<Pace, LogWriterOptions::Compression>;

class DiskFault : public ::testing::TestWithParam<Case> {
 protected:
  Outcome record(const DiskFaults& faults) const {
    return recordOnto(faults, std::get<0>(GetParam()), std::get<1>(GetParam()));
  }
};

INSTANTIATE_TEST_SUITE_P(
    Paces, DiskFault,
    ::testing::Combine(::testing::Values(Pace::fast, Pace::slow, Pace::mixed),
                       ::testing::Values(LogWriterOptions::Compression::none,
                                         LogWriterOptions::Compression::zstd)));

TEST_P(DiskFault, ADiskThatFillsAtAnyByteEndsInAWholeFile) {
  const Outcome unlimited = record({});
  ASSERT_TRUE(unlimited.closed.ok());
  ASSERT_EQ(storedIn(unlimited.file), kFaultMessages);
  std::uint64_t stored_before = 0;
  for (std::size_t room = 0; room < unlimited.file.size(); room += 5 * nextPlace()) {
    SCOPED_TRACE(room);
    DiskFaults faults;
    faults.room = room;
    const Outcome outcome = record(faults);
    if (!outcome.begun) continue;
    ASSERT_FALSE(outcome.closed.ok());
    EXPECT_THAT(outcome.closed.error().text(), HasSubstr("No space left on device"));
    EXPECT_LE(outcome.file.size(), room);
    bool complete = false;
    const std::uint64_t stored = storedIn(outcome.file, &complete);
    EXPECT_TRUE(complete);
    EXPECT_EQ(stored + outcome.refused, kFaultMessages);
    EXPECT_GE(stored, stored_before) << "more room, fewer messages";
    stored_before = stored;
    expectStrictlyWhole(outcome.file);
    // The file reports the loss: room for that was reserved too.
    LogReader reader = openLog(outcome.file);
    EXPECT_EQ(reader.losses().size(), 1U);
    EXPECT_EQ(reader.summary().end_reason, "finished");
  }
  EXPECT_GT(stored_before, 0U);
}

TEST_P(DiskFault, WithoutPreallocationAFullDiskLeavesAReadableFileAndAnExactCount) {
  const Outcome unlimited = record({});
  for (std::size_t room = 0; room < unlimited.file.size(); room += 5 * nextPlace()) {
    SCOPED_TRACE(room);
    DiskFaults faults;
    faults.room = room;
    faults.preallocates = false;
    const Outcome outcome = record(faults);
    if (!outcome.begun) continue;
    ASSERT_FALSE(outcome.closed.ok());
    EXPECT_EQ(storedIn(outcome.file) + outcome.refused, kFaultMessages);
  }
}

TEST_P(DiskFault, AnyOneWriteThatFailsLeavesAWholeFileAndAnExactCount) {
  const std::size_t writes = record({}).writes;
  for (std::size_t k = 0; k < writes; ++k) {
    for (const bool takes_half : {false, true}) {
      SCOPED_TRACE(::testing::Message() << "write " << k << (takes_half ? ", half" : ""));
      DiskFaults faults;
      faults.fails_at = k;
      faults.takes_half = takes_half;
      const Outcome outcome = record(faults);
      if (!outcome.begun) continue;
      ASSERT_FALSE(outcome.closed.ok());
      EXPECT_EQ(outcome.closed.error().text(),
                "cannot write to the file: Input/output error (disk)");
      bool complete = false;
      EXPECT_EQ(storedIn(outcome.file, &complete) + outcome.refused, kFaultMessages);
      // The disk works again, so only the last two are written: rocinante.end and the summary.
      EXPECT_EQ(complete, k + 2 < writes);
      if (complete) expectStrictlyWhole(outcome.file);
    }
  }
}

TEST_P(DiskFault, ADiskThatDisappearsAtAnyWriteLeavesWhatItHadAndAnExactCount) {
  const std::size_t writes = record({}).writes;
  for (std::size_t k = 0; k < writes; ++k) {
    for (const bool takes_half : {false, true}) {
      SCOPED_TRACE(::testing::Message() << "from write " << k << (takes_half ? ", half" : ""));
      DiskFaults faults;
      faults.fails_at = k;
      faults.fails_from_then_on = true;
      faults.takes_half = takes_half;
      const Outcome outcome = record(faults);
      if (!outcome.begun) continue;
      ASSERT_FALSE(outcome.closed.ok());
      EXPECT_EQ(storedIn(outcome.file) + outcome.refused, kFaultMessages);
    }
  }
}

TEST_P(DiskFault, WhatCannotBeTakenBackEitherIsNotCountedAsStored) {
  const std::size_t writes = record({}).writes;
  for (std::size_t k = 0; k < writes; ++k) {
    SCOPED_TRACE(k);
    DiskFaults faults;
    faults.fails_at = k;
    faults.fails_from_then_on = true;
    faults.takes_half = true;
    faults.truncates = false;
    const Outcome outcome = record(faults);
    if (!outcome.begun) continue;
    ASSERT_FALSE(outcome.closed.ok());
    // Half an addition is at the end: whole messages in it are a bonus.
    EXPECT_GE(storedIn(outcome.file) + outcome.refused, kFaultMessages);
  }
}

TEST(DiskFaults, ChannelsForWhichThereIsNoRoomAnyMoreAreLeftOutOfTheSummary) {
  for (const bool used : {false, true}) {
    SCOPED_TRACE(used ? "each with a message" : "most of them without");
    Bytes file;
    std::size_t writes = 0;
    DiskFaults faults;
    faults.room = 40'000;
    Result<LogWriter> writer =
        LogWriter::createOn(std::make_unique<FaultySink>(file, faults, writes), {}, "s");
    ASSERT_TRUE(writer.ok());
    const ChannelId first = *writer->addChannel("/udp/1/first", "octets", {});
    ASSERT_TRUE(writer->write(first, 0, at(1), 0, bytesOf("kept")).ok());
    ASSERT_TRUE(writer->flushIfDue(SteadyTime(std::chrono::seconds(1))).ok());
    // Their names alone exceed the disk.
    ChannelId last = 0;
    for (int i = 0; i < 1000; ++i) {
      last =
          *writer->addChannel("/udp/1/" + std::string(100, 'x') + std::to_string(i), "octets", {});
      if (used) (void)writer->write(last, 0, at(2), 0, bytesOf("not kept"));
    }
    (void)writer->write(last, 0, at(2), 0, bytesOf("not kept"));
    EXPECT_FALSE(writer->flushIfDue(SteadyTime(std::chrono::seconds(2))).ok());
    EXPECT_FALSE(writer->close("refused").ok());
    LogReader reader = openLog(file);
    EXPECT_TRUE(reader.summary().complete);
    EXPECT_TRUE(reader.damage().empty());
    EXPECT_EQ(readAll(reader).size(), 1U);
    EXPECT_EQ(reader.channels().size(), 1U);
    EXPECT_EQ(writer->refusedByDisk().contains(first), false);
    expectStrictlyWhole(file);
  }
}

TEST(DiskFaults, AnAttachmentThatDoesNotFitLeavesTheMessagesAsTheyAre) {
  Bytes file;
  std::size_t writes = 0;
  DiskFaults faults;
  faults.room = 40'000;
  Result<LogWriter> writer =
      LogWriter::createOn(std::make_unique<FaultySink>(file, faults, writes), {}, "s");
  ASSERT_TRUE(writer.ok());
  const ChannelId channel = *writer->addChannel("/udp/1/a", "octets", {});
  ASSERT_TRUE(writer->write(channel, 0, at(1), 0, bytesOf("kept")).ok());
  const std::string large(50'000, 'x');
  EXPECT_FALSE(writer->writeAttachment("a", "b", at(1), bytesOf(large)).ok());
  EXPECT_FALSE(writer->close("refused").ok());
  LogReader reader = openLog(file);
  EXPECT_TRUE(reader.summary().complete);
  EXPECT_EQ(readAll(reader).size(), 1U);
  EXPECT_TRUE(reader.attachments().empty());
  EXPECT_TRUE(writer->refusedByDisk().empty());
}

/// The real file sink over system calls that all fail from some write on, like those of a disk that
/// was unplugged.
TEST(DiskFaults, AFileWhoseDiskGoesAwayKeepsWhatItHad) {
  for (int works = 1; works < 60; works += 3) {
    SCOPED_TRACE(works);
    const TemporaryFolder folder;
    const std::filesystem::path path = folder / "a.mcap";
    FileCalls calls = FileCalls::system();
    int left = works;
    const auto gone = [&left] {
      errno = EIO;
      return --left < 0;
    };
    calls.pwrite = [gone](int file, const void* bytes, std::size_t size, off_t offset) -> ssize_t {
      return gone() ? -1 : ::pwrite(file, bytes, size, offset);
    };
    calls.ftruncate = [&left](int file, off_t size) {
      errno = EIO;
      return left < 0 ? -1 : ::ftruncate(file, size);
    };
    calls.fdatasync = [&left](int file) {
      errno = EIO;
      return left < 0 ? -1 : ::fdatasync(file);
    };
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
    ASSERT_GE(file, 0);
    LogWriterOptions options;
    options.chunk_bytes = 1000;
    Result<LogWriter> writer =
        LogWriter::createOn(makeFileSinkOn(file, "disk", calls), options, "s");
    ASSERT_TRUE(writer.ok());
    const ChannelId channel = *writer->addChannel("/udp/1/a", "octets", {});
    SteadyTime now{};
    for (std::uint32_t i = 0; i < kFaultMessages; ++i) {
      (void)writer->write(channel, i, at(i), 0, bytesOf(payloadOf(i)));
      now += options.sync;
      (void)writer->flushIfDue(now);
    }
    const Status closed = writer->close("finished");
    ASSERT_FALSE(closed.ok());
    EXPECT_EQ(closed.error().text(), "cannot write to the file: Input/output error (disk)");
    std::uint64_t refused = 0;
    for (const auto& [id, count] : writer->refusedByDisk()) refused += count;
    const std::string text = *readFile(path);
    EXPECT_EQ(storedIn(Bytes(bytesOf(text).begin(), bytesOf(text).end())) + refused,
              kFaultMessages);
  }
}

}  // namespace
}  // namespace rocinante::test
