#include <gmock/gmock.h>

#include "core/copy/log_edits.h"
#include "core/copy/log_split.h"
#include "core/log/log_profile.h"
#include "core/session/marks.h"
#include "tests/core/copy/copy_support.h"

namespace rocinante::test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr const char* kCutTool = "rocinante log cut";

TEST(MultiLogReader, ThePiecesOfASessionMakeTheSessionAgain) {
  TemporaryFolder folder;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    const std::string name = std::to_string(seed);
    writeRandomLog(folder / "whole.mcap", seed);
    SplitOptions split;
    split.time = std::chrono::milliseconds(1700);
    const Result<SplitReport> pieces =
        splitLog(folder / "whole.mcap", split, makeAt(folder / (name + "p.mcap")));
    ASSERT_TRUE(pieces.ok()) << pieces.error().text();
    std::vector<std::filesystem::path> paths;
    for (const SplitPiece& piece : pieces->pieces) paths.push_back(piece.path);
    const Result<CopyReport> report = mergeLogs(paths, makeAt(folder / (name + "m.mcap")));
    ASSERT_TRUE(report.ok()) << report.error().text();
    EXPECT_THAT(report->notes, IsEmpty());
    EXPECT_EQ(report->session_id, "session-1");
    EXPECT_EQ(hashOf(folder / (name + "m.mcap")), hashOf(folder / "whole.mcap"));
    EXPECT_EQ(openLogAt(folder / (name + "m.mcap")).losses().size(),
              openLogAt(folder / "whole.mcap").losses().size());
    EXPECT_EQ(openLogAt(folder / (name + "m.mcap")).attachments().size(), 1U);
    expectSameStates(folder / "whole.mcap", folder / (name + "m.mcap"), kSessionStart,
                     kSessionStart + 3'600'000'000'000);
    if (::testing::Test::HasFatalFailure()) return;
  }
}

TEST(MultiLogReader, WhatOverlappingPiecesOfASessionBothHoldIsTakenOnce) {
  TemporaryFolder folder;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    const std::string name = std::to_string(seed);
    writeRandomLog(folder / "whole.mcap", seed);
    const std::vector<KeptMessage> whole = capturedOf(folder / "whole.mcap");
    SelectionOptions first;
    first.from = "0";
    first.until = rfcOf(whole[200].log_time_ns);
    SelectionOptions second;
    second.from = rfcOf(whole[120].log_time_ns);
    ASSERT_TRUE(
        cutLog(folder / "whole.mcap", first, makeAt(folder / (name + "a.mcap")), kCutTool).ok());
    ASSERT_TRUE(
        cutLog(folder / "whole.mcap", second, makeAt(folder / (name + "b.mcap")), kCutTool).ok());
    for (const bool swapped : {false, true}) {
      std::vector<std::filesystem::path> paths{folder / (name + "a.mcap"),
                                               folder / (name + "b.mcap")};
      if (swapped) std::swap(paths[0], paths[1]);
      const std::filesystem::path merged = folder / (name + (swapped ? "s" : "m") + ".mcap");
      const Result<CopyReport> report = mergeLogs(paths, makeAt(merged));
      ASSERT_TRUE(report.ok()) << report.error().text();
      EXPECT_GE(report->repeated, 70U);
      EXPECT_EQ(hashOf(merged), hashOf(folder / "whole.mcap"));
      expectSameStates(folder / "whole.mcap", merged, kSessionStart,
                       kSessionStart + 3'600'000'000'000);
      if (::testing::Test::HasFatalFailure()) return;
    }
  }
}

struct SmallLog {
  std::string session_id;
  std::string remote;
  std::vector<std::pair<std::int64_t, std::string>> messages;
};

void write(const std::filesystem::path& path, const SmallLog& log) {
  Result<LogWriter> writer = LogWriter::create(path, {}, log.session_id);
  ASSERT_TRUE(writer.ok());
  std::optional<ChannelId> channel;
  std::uint32_t sequence = 0;
  for (const auto& [time, payload] : log.messages) {
    if (!channel) channel = *writer->addChannel("/udp/1/x", "octets", {{"remote", log.remote}});
    ASSERT_TRUE(writer->write(*channel, sequence++, at(time), time, bytesOf(payload)).ok());
  }
  ASSERT_TRUE(writer->close("stopped").ok());
}

std::vector<std::string> payloadsOf(const std::filesystem::path& path) {
  std::vector<std::string> payloads;
  for (const KeptMessage& message : capturedOf(path)) payloads.push_back(message.payload);
  return payloads;
}

TEST(MultiLogReader, OfEqualTimesTheLogNamedFirstComesFirst) {
  TemporaryFolder folder;
  write(folder / "a.mcap", {"one", "h:1", {{10, "a10"}, {20, "a20"}, {20, "a20 again"}}});
  write(folder / "b.mcap", {"two", "h:2", {{5, "b5"}, {20, "b20"}, {30, "b30"}}});
  ASSERT_TRUE(mergeLogs({folder / "a.mcap", folder / "b.mcap"}, makeAt(folder / "ab.mcap")).ok());
  ASSERT_TRUE(mergeLogs({folder / "b.mcap", folder / "a.mcap"}, makeAt(folder / "ba.mcap")).ok());
  EXPECT_THAT(payloadsOf(folder / "ab.mcap"),
              ElementsAre("b5", "a10", "a20", "a20 again", "b20", "b30"));
  EXPECT_THAT(payloadsOf(folder / "ba.mcap"),
              ElementsAre("b5", "a10", "b20", "a20", "a20 again", "b30"));
}

TEST(MultiLogReader, TwoSessionsMakeANewOneThatTheirIdsName) {
  TemporaryFolder folder;
  write(folder / "a.mcap", {"one", "h:1", {{10, "a"}}});
  write(folder / "b.mcap", {"two", "h:1", {{5, "b"}}});
  const auto merged = [&](const char* first, const char* second, const char* out) {
    const Result<CopyReport> report =
        mergeLogs({folder / first, folder / second}, makeAt(folder / out));
    EXPECT_TRUE(report.ok());
    return openLogAt(folder / out).summary();
  };
  const LogSummary ab = merged("a.mcap", "b.mcap", "1.mcap");
  EXPECT_EQ(ab.session_id.size(), 32U);
  EXPECT_EQ(ab.origin, at(5));
  EXPECT_EQ(merged("a.mcap", "b.mcap", "2.mcap").session_id, ab.session_id);
  EXPECT_NE(merged("b.mcap", "a.mcap", "3.mcap").session_id, ab.session_id);
  // Equal channels are one; equal messages of two sessions are two.
  EXPECT_EQ(openLogAt(folder / "1.mcap").channels().size(), 1U);
  write(folder / "c.mcap", {"three", "h:1", {{10, "a"}}});
  (void)merged("a.mcap", "c.mcap", "4.mcap");
  EXPECT_THAT(payloadsOf(folder / "4.mcap"), ElementsAre("a", "a"));
}

TEST(MultiLogReader, ALogWithoutMessagesChangesNothing) {
  TemporaryFolder folder;
  write(folder / "a.mcap", {"one", "h:1", {{10, "a"}}});
  write(folder / "empty.mcap", {"two", "h:1", {}});
  ASSERT_TRUE(
      mergeLogs({folder / "empty.mcap", folder / "a.mcap"}, makeAt(folder / "out.mcap")).ok());
  EXPECT_EQ(openLogAt(folder / "out.mcap").summary().session_id, "one");
  EXPECT_EQ(openLogAt(folder / "out.mcap").summary().origin, at(10));
  ASSERT_TRUE(mergeLogs({folder / "empty.mcap"}, makeAt(folder / "still.mcap")).ok());
  EXPECT_TRUE(openLogAt(folder / "still.mcap").summary().complete);
}

TEST(MultiLogReader, WhatALaterPieceOpensWithIsSaidAgain) {
  TemporaryFolder folder;
  // One in whose hole no source counts anew without a new RUN (docs/log-format.md, "Keyframes").
  writeRandomLog(folder / "whole.mcap", 4);
  writeRandomLog(folder / "other.mcap", 6, {.session_id = "session-2", .remote = "h:2"});
  const std::vector<KeptMessage> whole = capturedOf(folder / "whole.mcap");
  // Two pieces with a hole between them: the second has the state of the hole.
  SelectionOptions first;
  first.until = rfcOf(whole[100].log_time_ns);
  SelectionOptions second;
  second.from = rfcOf(whole[200].log_time_ns);
  ASSERT_TRUE(cutLog(folder / "whole.mcap", first, makeAt(folder / "a.mcap"), kCutTool).ok());
  ASSERT_TRUE(cutLog(folder / "whole.mcap", second, makeAt(folder / "b.mcap"), kCutTool).ok());
  ASSERT_TRUE(mergeLogs({folder / "a.mcap", folder / "b.mcap"}, makeAt(folder / "m.mcap")).ok());
  const std::vector<KeptMessage> merged = messagesOf(folder / "m.mcap");
  EXPECT_GT(countOn(merged, profile::kRestatedKeyframeTopic), 0U);
  Result<Timeline> expected = Timeline::open(folder / "b.mcap");
  Result<Timeline> actual = Timeline::open(folder / "m.mcap");
  ASSERT_TRUE(expected.ok() && actual.ok());
  const LogTime moment = at(whole[210].log_time_ns);
  const SessionState& in_b = **expected->stateAt(moment);
  const SessionState& in_m = **actual->stateAt(moment);
  // Except for last writes, everything in the piece's state is there.
  EXPECT_EQ(in_m.drawings(), in_b.drawings());
  EXPECT_EQ(in_m.colors(), in_b.colors());
  for (const auto& [name, device] : in_b.devices()) {
    const auto found = in_m.devices().find(name);
    ASSERT_NE(found, in_m.devices().end()) << name;
    EXPECT_EQ(found->second.pose, device.pose) << name;
    EXPECT_EQ(found->second.joints, device.joints) << name;
  }
}

TEST(MultiLogReader, MarksOfAllAreBakedInOnce) {
  TemporaryFolder folder;
  write(folder / "a.mcap", {"one", "h:1", {{10, "a"}}});
  write(folder / "b.mcap", {"two", "h:1", {{30, "b"}}});
  for (const char* log : {"a.mcap", "b.mcap"}) {
    ASSERT_TRUE(addMark(folder / log, {at(20), {}, "both"}).ok());
  }
  ASSERT_TRUE(addMark(folder / "b.mcap", {at(20), {}, "b alone"}).ok());
  const Result<CopyReport> report =
      mergeLogs({folder / "a.mcap", folder / "b.mcap"}, makeAt(folder / "out.mcap"));
  ASSERT_TRUE(report.ok());
  EXPECT_EQ(report->counts.marks, 2U);
  EXPECT_EQ(countOn(messagesOf(folder / "out.mcap"), "/rocinante/mark"), 2U);
}

}  // namespace
}  // namespace rocinante::test
