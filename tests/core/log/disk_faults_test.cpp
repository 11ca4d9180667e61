#include <gmock/gmock.h>

#include "core/log/mcap_stream_reader.h"
#include "tests/core/log/faulty_sink.h"
#include "tests/core/log/log_support.h"

namespace rocinante::test {
namespace {

using ::testing::HasSubstr;

constexpr std::uint64_t kMessages = 60;

struct Outcome {
  Bytes file;
  bool begun = false;  ///< there was room for the header
  std::uint64_t refused = 0;
  std::size_t writes = 0;
  Status closed;
};

enum class Pace { fast, slow, mixed };

/// Sixty messages on three channels, some of which come later, then what a recorder does: the last
/// flush, a loss, the end. Slow: flushed after every message. Mixed: chunks in one piece too.
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
  for (std::uint32_t i = 0; i < kMessages; ++i) {
    if (i % 20 == 0) {
      channels.push_back(*writer->addChannel("/udp/1/" + std::to_string(i), "octets", {}));
    }
    const std::string payload =
        std::to_string(i) + std::string(100, static_cast<char>('a' + i % 7));
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

/// Captured messages that a reader finds; each must be one that was written, whole.
std::uint64_t storedIn(const Bytes& file, bool* complete = nullptr) {
  const Bytes copy = cutAt(file, file.size());
  LogReader reader = openLog(copy);
  std::uint64_t stored = 0;
  for (const KeptMessage& message : readAll(reader)) {
    if (!message.topic.starts_with("/udp/")) continue;
    const std::uint32_t i = message.sequence;
    EXPECT_EQ(message.payload,
              std::to_string(i) + std::string(100, static_cast<char>('a' + i % 7)));
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

/// The file is whole by the letter of the format, from its first record to its footer.
void expectStrictlyWhole(const Bytes& file) {
  Result<mcap::StreamReader> reader = mcap::StreamReader::open(file);
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
  ASSERT_EQ(storedIn(unlimited.file), kMessages);
  std::uint64_t stored_before = 0;
  for (std::size_t room = 0; room < unlimited.file.size(); room += 5) {
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
    EXPECT_EQ(stored + outcome.refused, kMessages);
    EXPECT_GE(stored, stored_before) << "more room, fewer messages";
    stored_before = stored;
    expectStrictlyWhole(outcome.file);
    // What was lost is told in the file: the room for that was kept too.
    LogReader reader = openLog(outcome.file);
    EXPECT_EQ(reader.losses().size(), 1U);
    EXPECT_EQ(reader.summary().end_reason, "finished");
  }
  EXPECT_GT(stored_before, 0U);
}

TEST_P(DiskFault, WithoutPreallocationAFullDiskLeavesAReadableFileAndAnExactCount) {
  const Outcome unlimited = record({});
  for (std::size_t room = 0; room < unlimited.file.size(); room += 5) {
    SCOPED_TRACE(room);
    DiskFaults faults;
    faults.room = room;
    faults.preallocates = false;
    const Outcome outcome = record(faults);
    if (!outcome.begun) continue;
    ASSERT_FALSE(outcome.closed.ok());
    EXPECT_EQ(storedIn(outcome.file) + outcome.refused, kMessages);
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
                "cannot write to the log: Input/output error (disk)");
      bool complete = false;
      EXPECT_EQ(storedIn(outcome.file, &complete) + outcome.refused, kMessages);
      // The disk works again, so all but the last two come to be: rocinante.end and the summary.
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
      EXPECT_EQ(storedIn(outcome.file) + outcome.refused, kMessages);
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
    // Half an addition stands at the end: whole messages in it are a gift.
    EXPECT_GE(storedIn(outcome.file) + outcome.refused, kMessages);
  }
}

}  // namespace
}  // namespace rocinante::test
