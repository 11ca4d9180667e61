#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>

#include "core/base/atomic_file.h"
#include "core/copy/log_edits.h"
#include "core/log/log_profile.h"
#include "core/mcap/parse_record.h"
#include "core/session/marks.h"
#include "tests/core/copy/copy_support.h"
#include "tests/support/next_place.h"
#include "tests/support/stream_reader.h"

namespace rocinante::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

Bytes bytesOfFile(const std::filesystem::path& path) {
  const Result<std::string> text = readFile(path);
  EXPECT_TRUE(text.ok());
  const ByteView view = bytesOf(*text);
  return {view.begin(), view.end()};
}

void putFile(const std::filesystem::path& path, ByteView bytes) {
  ASSERT_TRUE(writeFileWhole(path, bytes, true).ok());
}

Result<CopyReport> recoverInto(Bytes& out, ByteView bytes) {
  LogWriterOptions log;
  log.chunk_bytes = 600;
  return recoverBytes(bytes, "cut.mcap", {}, makeMemorySink(out), log, {true, 10, {}}, {});
}

/// Reads strictly by the MCAP format; returns the messages of other channels than ours.
std::vector<std::string> strictPayloads(ByteView file) {
  std::vector<std::string> payloads;
  Result<test::StreamReader> reader = test::StreamReader::open(file);
  EXPECT_TRUE(reader.ok());
  std::map<std::uint16_t, std::string> topics;
  while (reader.ok()) {
    const Result<std::optional<mcap::Record>> record = reader->next();
    EXPECT_TRUE(record.ok()) << record.error().text();
    if (!record.ok() || !*record) break;
    mcap::Channel channel;
    mcap::Message message;
    if ((*record)->opcode == mcap::Opcode::channel && mcap::parse((*record)->content, channel)) {
      topics[channel.id] = channel.topic;
    } else if ((*record)->opcode == mcap::Opcode::message &&
               mcap::parse((*record)->content, message)) {
      if (topics[message.channel_id].starts_with("/rocinante/")) continue;
      payloads.emplace_back(textOf(message.data));
    }
  }
  return payloads;
}

std::vector<KeptMessage> captured(ByteView bytes) {
  Result<LogReader> reader = LogReader::openBytes(bytes, "log");
  std::vector<KeptMessage> messages;
  if (!reader.ok()) return messages;
  for (KeptMessage& each : readAll(*reader)) {
    if (!each.topic.starts_with("/rocinante/")) messages.push_back(std::move(each));
  }
  return messages;
}

TEST(LogRecover, ALogThatIsCutAnywhereGivesBackAllThatWasWholeInAFileByTheLetter) {
  TemporaryFolder folder;
  writeRandomLog(folder / "log.mcap", 4,
                 {.count = 60, .keyframe_packets = 25, .chunk_bytes = 1500});
  const Bytes whole = bytesOfFile(folder / "log.mcap");
  std::size_t last = 0;
  for (std::size_t size = whole.size() % nextPlace(); size <= whole.size(); size += nextPlace()) {
    SCOPED_TRACE(size);
    const Bytes cut = cutAt(whole, size);
    const std::vector<KeptMessage> readable = captured(cut);
    Bytes out;
    const Result<CopyReport> report = recoverInto(out, cut);
    if (!report.ok()) {
      EXPECT_TRUE(readable.empty());
      continue;
    }
    EXPECT_EQ(captured(out), readable);
    std::vector<std::string> payloads;
    for (const KeptMessage& message : readable) payloads.push_back(message.payload);
    EXPECT_EQ(strictPayloads(out), payloads);
    LogReader reader = openLog(out);
    EXPECT_TRUE(reader.summary().complete);
    EXPECT_THAT(reader.damage(), IsEmpty());
    last = readable.size();
    if (HasFailure()) return;
  }
  EXPECT_EQ(last, captured(whole).size());
}

TEST(LogRecover, AWholeLogComesOutWithoutALoss) {
  TemporaryFolder folder;
  writeRandomLog(folder / "log.mcap", 4);
  ASSERT_TRUE(addMark(folder / "log.mcap", {at(kSessionStart + 1), {}, "m"}).ok());
  const Result<CopyReport> report = recoverLog(folder / "log.mcap", makeAt(folder / "out.mcap"));
  ASSERT_TRUE(report.ok()) << report.error().text();
  EXPECT_THAT(report->gaps, IsEmpty());
  EXPECT_EQ(hashOf(folder / "out.mcap"), hashOf(folder / "log.mcap"));
  const LogReader before = openLogAt(folder / "log.mcap");
  const LogReader after = openLogAt(folder / "out.mcap");
  EXPECT_EQ(after.losses().size(), before.losses().size());
  EXPECT_EQ(after.attachments().size(), 1U);
  EXPECT_EQ(after.summary().end_reason, "stopped");
  EXPECT_EQ(after.summary().session_id, "session-1");
  EXPECT_EQ(report->counts.marks, 1U);
  expectSameStates(folder / "log.mcap", folder / "out.mcap", kSessionStart,
                   kSessionStart + 3'600'000'000'000);
}

TEST(LogRecover, AChunkThatFailsItsChecksumIsLeftOutAndNamed) {
  TemporaryFolder folder;
  writeRandomLog(folder / "log.mcap", 4);
  const Bytes whole = bytesOfFile(folder / "log.mcap");
  std::vector<KeptMessage> before = capturedOf(folder / "log.mcap");
  std::ranges::sort(before);
  std::size_t lossy = 0;
  for (std::size_t place = 700; place < whole.size(); place += 611) {
    SCOPED_TRACE(place);
    Bytes bytes = whole;
    bytes[place] ^= std::byte{0x10};
    Bytes out;
    const Result<CopyReport> report = recoverInto(out, bytes);
    ASSERT_TRUE(report.ok()) << report.error().text();
    EXPECT_FALSE(report->gaps.empty());
    const std::vector<KeptMessage> after = captured(out);
    std::uint64_t lost = 0;
    for (const CopyGap& gap : report->gaps) lost += gap.span.messages_lost.value_or(0);
    if (after.size() < before.size()) {
      ++lossy;
      EXPECT_TRUE(std::ranges::any_of(report->gaps, [&](const CopyGap& gap) {
        return gap.costs && gap.span.from <= place && place < gap.span.to;
      }));
      EXPECT_GE(lost, before.size() - after.size());
    }
    std::vector<KeptMessage> sorted = after;
    std::ranges::sort(sorted);
    EXPECT_TRUE(std::ranges::includes(before, sorted));
    EXPECT_EQ(strictPayloads(out).size(), after.size());
  }
  EXPECT_GT(lossy, 5U);
}

TEST(LogRecover, BytesThatNoChunkCoversAreJudgedByTheChecksumOfAll) {
  TemporaryFolder folder;
  writeRandomLog(folder / "log.mcap", 4);
  Bytes bytes = bytesOfFile(folder / "log.mcap");
  const std::string_view text = textOf(bytes);
  const std::size_t name = text.find("Amelie");
  ASSERT_NE(name, text.npos);
  bytes[name] = std::byte{'E'};
  putFile(folder / "bad.mcap", bytes);
  const Result<CopyReport> report = recoverLog(folder / "bad.mcap", makeAt(folder / "out.mcap"));
  ASSERT_TRUE(report.ok());
  ASSERT_EQ(report->gaps.size(), 1U);
  EXPECT_TRUE(report->gaps.front().costs);
  EXPECT_THAT(report->gaps.front().span.cause, HasSubstr("data section fails its checksum"));
}

TEST(LogRecover, AFileWhoseFirstBytesAreWrongIsRecoveredWhole) {
  TemporaryFolder folder;
  writeRandomLog(folder / "log.mcap", 4);
  Bytes bytes = bytesOfFile(folder / "log.mcap");
  bytes[3] = std::byte{'?'};
  putFile(folder / "bad.mcap", bytes);
  ASSERT_FALSE(LogReader::open(folder / "bad.mcap").ok());
  const Result<CopyReport> report = recoverLog(folder / "bad.mcap", makeAt(folder / "out.mcap"));
  ASSERT_TRUE(report.ok()) << report.error().text();
  EXPECT_EQ(hashOf(folder / "out.mcap"), hashOf(folder / "log.mcap"));
  EXPECT_FALSE(report->gaps.front().costs);
  EXPECT_EQ(bytesOfFile(folder / "bad.mcap"), bytes);
}

TEST(LogRecover, WhereNothingCanBeReadNothingIsMade) {
  TemporaryFolder folder;
  const auto refusal = [&](const std::string& content) {
    putFile(folder / "in.mcap", bytesOf(content));
    const Result<CopyReport> report = recoverLog(folder / "in.mcap", makeAt(folder / "out.mcap"));
    EXPECT_FALSE(report.ok());
    EXPECT_FALSE(std::filesystem::exists(folder / "out.mcap"));
    return report.ok() ? std::string() : report.error().text();
  };
  EXPECT_THAT(refusal(""), HasSubstr("empty"));
  EXPECT_THAT(refusal("notes of a day"), HasSubstr("nothing in the log can be read"));
  EXPECT_THAT(refusal(std::string(100'000, '\x05')), HasSubstr("nothing in the log can be read"));
  writeRandomLog(folder / "log.mcap", 4, {.attach = false});
  const std::string begin(textOf(bytesOfFile(folder / "log.mcap")).substr(0, 60));
  EXPECT_THAT(refusal(begin), HasSubstr("nothing in the log can be read"));
  const Result<CopyReport> missing = recoverLog(folder / "no.mcap", makeAt(folder / "out.mcap"));
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().kind, ErrorKind::not_found);
  EXPECT_FALSE(recoverLog(folder.path(), makeAt(folder / "out.mcap")).ok());
}

TEST(LogRecover, MarksThatCannotBeReadAreLeftOutAndTold) {
  TemporaryFolder folder;
  writeRandomLog(folder / "log.mcap", 4);
  { std::ofstream(marksPath(folder / "log.mcap")) << "no mark\n"; }
  const Result<CopyReport> report = recoverLog(folder / "log.mcap", makeAt(folder / "out.mcap"));
  ASSERT_TRUE(report.ok());
  ASSERT_EQ(report->notes.size(), 1U);
  EXPECT_THAT(report->notes.front(), HasSubstr("marks"));
}

/// A disk with room for a number of bytes.
class SmallDisk final : public ByteSink {
 public:
  SmallDisk(std::unique_ptr<ByteSink> below, std::size_t room)
      : below_(std::move(below)), room_(room) {}
  Status append(ByteView bytes) override {
    if (bytes.size() > room_) {
      return Error{ErrorKind::unreadable, "cannot write to the file: No space left", "disk"};
    }
    room_ -= bytes.size();
    return below_->append(bytes);
  }
  Status truncate(std::uint64_t size) override { return below_->truncate(size); }
  Status close() override { return below_->close(); }
  const std::string& name() const override { return below_->name(); }

 private:
  std::unique_ptr<ByteSink> below_;
  std::size_t room_;
};

TEST(LogRecover, AFullDiskIsAnErrorWhereverItComes) {
  TemporaryFolder folder;
  writeRandomLog(folder / "log.mcap", 4, {.count = 60});
  const Bytes bytes = bytesOfFile(folder / "log.mcap");
  for (std::size_t room = 0; room < 4000; room += 37) {
    SCOPED_TRACE(room);
    Bytes out;
    const Result<CopyReport> report = recoverBytes(
        bytes, "log.mcap", {}, std::make_unique<SmallDisk>(makeMemorySink(out), room), {}, {}, {});
    ASSERT_FALSE(report.ok());
    EXPECT_THAT(report.error().text(), HasSubstr("No space left"));
  }
}

}  // namespace
}  // namespace rocinante::test
