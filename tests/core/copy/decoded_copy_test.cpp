#include <gmock/gmock.h>

#include "core/copy/log_edits.h"
#include "core/copy/log_split.h"
#include "core/log/octets_before.h"
#include "recorder/doctor/log_doctor.h"
#include "tests/core/copy/copy_support.h"

namespace rocinante::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr const char* kOctetsTopic = "/udp/1/10.0.0.1";
constexpr const char* kPacketTopic = "/rocinante/decoded/udp/1/10.0.0.1";

struct DecodedLogOptions {
  std::string session_id = "session-1";
  std::string decoder = "hash-1";
  std::string remote = "10.0.0.1:9";
  std::int64_t start_ns = kSessionStart;
};

/// 200 octets of two senders' devices, each with its packet; every tenth without one; between them
/// a talker of packet text at the very same times.
void writeDecodedLog(const std::filesystem::path& path, const DecodedLogOptions& options = {}) {
  LogWriterOptions writing;
  writing.chunk_bytes = 1500;
  Result<LogWriter> log = LogWriter::create(path, writing, options.session_id);
  ASSERT_TRUE(log.ok());
  SessionWriter session(std::move(*log), {true, 30, std::chrono::seconds(10)});
  std::map<std::string, std::string> metadata{{"remote", options.remote}};
  const ChannelId octets = *session.addChannel(kOctetsTopic, "octets", metadata);
  metadata["source"] = "decoded:robot";
  metadata["decoder"] = options.decoder;
  const ChannelId packets = *session.addChannel(kPacketTopic, "rk1", metadata);
  const ChannelId talk = *session.addChannel("/udp/1/talker", "rk1", {{"source", "talker"}});
  for (std::uint32_t i = 0; i < 200; ++i) {
    const std::int64_t time = options.start_ns + std::int64_t{i / 2} * 10'000'000;
    const std::string raw = "\x01 raw " + std::to_string(i);
    ASSERT_TRUE(session.write(octets, i, at(time), time, bytesOf(raw)).ok());
    if (i % 10 != 9) {
      const std::string text = "RK1 decoded:robot - -\njoints " +
                               std::string(i % 2 == 0 ? "arm " : "tray ") + std::to_string(i);
      ASSERT_TRUE(session.write(packets, i, at(time), time, bytesOf(text)).ok());
    }
    const std::string text = "RK1 talker " + std::to_string(i) + " -\njoints lamp 0.5";
    ASSERT_TRUE(session.write(talk, i, at(time), time, bytesOf(text)).ok());
  }
  ASSERT_TRUE(session.log().close("stopped").ok());
}

/// Expects every decoded packet directly behind its octets, and every rule of the format kept.
void expectPairs(const std::filesystem::path& path, std::size_t octets, std::size_t packets) {
  LogReader reader = openLogAt(path);
  OctetsBefore before;
  std::size_t octets_found = 0, packets_found = 0;
  while (true) {
    const Result<std::optional<LogMessage>> message = reader.next();
    ASSERT_TRUE(message.ok());
    if (!*message) break;
    EXPECT_TRUE(before.take(**message)) << (*message)->sequence;
    octets_found += (*message)->channel->topic == kOctetsTopic ? 1U : 0U;
    packets_found += (*message)->channel->decoded() ? 1U : 0U;
  }
  EXPECT_EQ(octets_found, octets);
  EXPECT_EQ(packets_found, packets);
  const Result<DoctorReport> report = examineLog(path, {});
  ASSERT_TRUE(report.ok());
  EXPECT_THAT(report->breaches(), IsEmpty());
}

TEST(DecodedCopy, AWrittenLogKeepsPacketsBehindTheirOctetsBesideKeyframes) {
  TemporaryFolder folder;
  writeDecodedLog(folder / "whole.mcap");
  expectPairs(folder / "whole.mcap", 200, 180);
  LogReader reader = openLogAt(folder / "whole.mcap");
  EXPECT_EQ(reader.summary().messages, 400U) << "decoded packets are not counted";
  const Result<SessionHashes> hashes = sessionHashes(reader);
  ASSERT_TRUE(hashes.ok());
  EXPECT_EQ(hashes->decoded.size(), 64U);
  EXPECT_NE(hashes->decoded, hashes->content);
}

TEST(DecodedCopy, FilteringByDeviceChoosesOctetsByTheirPacket) {
  TemporaryFolder folder;
  writeDecodedLog(folder / "whole.mcap");
  SelectionOptions selection;
  selection.devices = {"arm"};
  ASSERT_TRUE(cutLog(folder / "whole.mcap", selection, makeAt(folder / "arm.mcap"), "test").ok());
  expectPairs(folder / "arm.mcap", 100, 100);
}

TEST(DecodedCopy, FilteringBySourceChannelAndEncodingKeepsPairs) {
  TemporaryFolder folder;
  writeDecodedLog(folder / "whole.mcap");
  SelectionOptions selection;
  selection.sources = {"decoded:robot"};
  ASSERT_TRUE(cutLog(folder / "whole.mcap", selection, makeAt(folder / "s.mcap"), "test").ok());
  expectPairs(folder / "s.mcap", 180, 180);
  selection = {};
  selection.channels = {kOctetsTopic};
  ASSERT_TRUE(cutLog(folder / "whole.mcap", selection, makeAt(folder / "c.mcap"), "test").ok());
  expectPairs(folder / "c.mcap", 200, 180);
  selection = {};
  selection.encodings = {"octets"};
  ASSERT_TRUE(cutLog(folder / "whole.mcap", selection, makeAt(folder / "e.mcap"), "test").ok());
  expectPairs(folder / "e.mcap", 200, 180);
  selection = {};
  selection.sources = {"talker"};
  ASSERT_TRUE(cutLog(folder / "whole.mcap", selection, makeAt(folder / "t.mcap"), "test").ok());
  expectPairs(folder / "t.mcap", 0, 0);
}

TEST(DecodedCopy, PiecesBySizeNeverPartAPair) {
  TemporaryFolder folder;
  writeDecodedLog(folder / "whole.mcap");
  SplitOptions split;
  split.size_bytes = 9000;
  const Result<SplitReport> pieces =
      splitLog(folder / "whole.mcap", split, makeAt(folder / "piece-%n.mcap"));
  ASSERT_TRUE(pieces.ok()) << pieces.error().text();
  ASSERT_GT(pieces->pieces.size(), 2U);
  std::vector<std::filesystem::path> paths;
  for (const SplitPiece& piece : pieces->pieces) paths.push_back(piece.path);
  ASSERT_TRUE(mergeLogs(paths, makeAt(folder / "again.mcap")).ok());
  expectPairs(folder / "again.mcap", 200, 180);
  LogReader whole = openLogAt(folder / "whole.mcap");
  LogReader again = openLogAt(folder / "again.mcap");
  EXPECT_EQ(sessionHashes(whole)->decoded, sessionHashes(again)->decoded);
}

TEST(DecodedCopy, LogsOfOneDecoderMergeAndOfTwoAreRefused) {
  TemporaryFolder folder;
  writeDecodedLog(folder / "a.mcap");
  DecodedLogOptions other;
  other.session_id = "session-2";
  other.remote = "10.0.0.1:10";
  writeDecodedLog(folder / "b.mcap", other);
  ASSERT_TRUE(mergeLogs({folder / "a.mcap", folder / "b.mcap"}, makeAt(folder / "ab.mcap")).ok());
  expectPairs(folder / "ab.mcap", 400, 360);
  other.decoder = "hash-2";
  writeDecodedLog(folder / "c.mcap", other);
  const Result<CopyReport> refused =
      mergeLogs({folder / "a.mcap", folder / "c.mcap"}, makeAt(folder / "ac.mcap"));
  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(refused.error().what, HasSubstr("/udp/1/10.0.0.1 has packets of another decoder"));
  EXPECT_FALSE(std::filesystem::exists(folder / "ac.mcap"));
}

TEST(DecodedCopy, APacketWithoutItsOctetsIsRestated) {
  TemporaryFolder folder;
  {
    Result<LogWriter> log = LogWriter::create(folder / "orphan.mcap", {}, "session-1");
    ASSERT_TRUE(log.ok());
    SessionWriter session(std::move(*log), {});
    const ChannelId packets = *session.addChannel(
        kPacketTopic, "rk1", {{"source", "decoded:robot"}, {"decoder", "hash-1"}});
    const ChannelId talk = *session.addChannel("/udp/1/talker", "rk1", {{"source", "talker"}});
    ASSERT_TRUE(
        session.write(talk, 0, at(kSessionStart), 0, bytesOf("RK1 talker 0 -\njoints lamp 1"))
            .ok());
    ASSERT_TRUE(session
                    .write(packets, 7, at(kSessionStart + 1), 0,
                           bytesOf("RK1 decoded:robot - -\njoints arm 7"))
                    .ok());
    ASSERT_TRUE(session.log().close("stopped").ok());
  }
  const Result<DoctorReport> before = examineLog(folder / "orphan.mcap", {});
  ASSERT_TRUE(before.ok());
  EXPECT_TRUE(before->broke("decoded-place"));
  ASSERT_TRUE(recoverLog(folder / "orphan.mcap", makeAt(folder / "whole.mcap")).ok());
  expectPairs(folder / "whole.mcap", 0, 0);
  expectSameStates(folder / "orphan.mcap", folder / "whole.mcap", kSessionStart,
                   kSessionStart + 10);
  EXPECT_EQ(
      countOn(messagesOf(folder / "whole.mcap"), std::string("/rocinante/restated") + kPacketTopic),
      1U);
}

}  // namespace
}  // namespace rocinante::test
