#include "core/copy/log_split.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <array>
#include <fstream>
#include <random>

#include "tests/core/copy/copy_support.h"

namespace rocinante::test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Expects the pieces' captured messages in order to be the log's, and each piece to have the log's
/// states in its time.
void expectSplit(const std::filesystem::path& log, const SplitReport& report) {
  std::vector<KeptMessage> together;
  std::vector<LossSpan> losses;
  for (std::size_t i = 0; i < report.pieces.size(); ++i) {
    SCOPED_TRACE(report.pieces[i].path);
    const std::vector<KeptMessage> messages = capturedOf(report.pieces[i].path);
    EXPECT_EQ(messages.size(), report.pieces[i].counts.messages);
    together.insert(together.end(), messages.begin(), messages.end());
    const LogReader reader = openLogAt(report.pieces[i].path);
    losses.insert(losses.end(), reader.losses().begin(), reader.losses().end());
    if (messages.empty()) continue;
    const std::vector<KeptMessage> next = i + 1 < report.pieces.size()
                                              ? capturedOf(report.pieces[i + 1].path)
                                              : std::vector<KeptMessage>{};
    const std::int64_t until =
        next.empty() ? messages.back().log_time_ns + 1 : next.front().log_time_ns;
    expectSameStates(log, report.pieces[i].path, messages.front().log_time_ns, until);
  }
  EXPECT_EQ(together, capturedOf(log));
  EXPECT_EQ(losses.size(), openLogAt(log).losses().size());
}

TEST(LogSplit, PiecesByTimeStandAloneAndTogetherAreTheLog) {
  TemporaryFolder folder;
  for (std::uint64_t seed = 1; seed <= 15; ++seed) {
    SCOPED_TRACE(seed);
    writeRandomLog(folder / "whole.mcap", seed);
    SplitOptions split;
    split.time = std::chrono::milliseconds(1500);
    const Result<SplitReport> report =
        splitLog(folder / "whole.mcap", split,
                 makeAt(folder / ("piece-" + std::to_string(seed) + "-%n.mcap")));
    ASSERT_TRUE(report.ok()) << report.error().text();
    EXPECT_THAT(report->whole.notes, IsEmpty());
    EXPECT_GT(report->pieces.size(), 2U);
    expectSplit(folder / "whole.mcap", *report);
    // Counted from the origin: no piece holds messages of two spans.
    const LogTime origin = openLogAt(folder / "whole.mcap").summary().origin;
    for (const SplitPiece& piece : report->pieces) {
      if (piece.counts.messages == 0) continue;
      EXPECT_EQ((piece.counts.start - origin) / split.time,
                (piece.counts.end - origin) / split.time);
    }
    if (::testing::Test::HasFatalFailure()) return;
  }
}

TEST(LogSplit, PiecesByEventBeginThere) {
  TemporaryFolder folder;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(seed);
    writeRandomLog(folder / "whole.mcap", seed);
    SplitOptions split;
    split.event = "e";
    const Result<SplitReport> report = splitLog(
        folder / "whole.mcap", split, makeAt(folder / ("p" + std::to_string(seed) + "-%n.mcap")));
    ASSERT_TRUE(report.ok()) << report.error().text();
    EXPECT_GT(report->pieces.size(), 3U);
    expectSplit(folder / "whole.mcap", *report);
    if (::testing::Test::HasFatalFailure()) return;
  }
}

TEST(LogSplit, PiecesBySizeAreHardlyLarger) {
  TemporaryFolder folder;
  writeRandomLog(folder / "whole.mcap", 3, {.count = 4000, .chunk_bytes = 1U << 16U});
  SplitOptions split;
  split.size_bytes = 40'000;
  MakeOptions make = makeAt(folder / "piece.mcap");
  make.log.chunk_bytes = 1U << 20U;
  make.keyframes = {};
  const Result<SplitReport> report = splitLog(folder / "whole.mcap", split, make);
  ASSERT_TRUE(report.ok()) << report.error().text();
  EXPECT_EQ(report->pieces.front().path, folder / "piece-001.mcap");
  EXPECT_GT(report->pieces.size(), 3U);
  for (const SplitPiece& piece : report->pieces) {
    EXPECT_EQ(std::filesystem::file_size(piece.path), piece.counts.bytes);
    EXPECT_LT(piece.counts.bytes, split.size_bytes * 11 / 10);
    if (&piece != &report->pieces.back()) {
      EXPECT_GT(piece.counts.bytes, split.size_bytes * 7 / 10);
    }
  }
  expectSplit(folder / "whole.mcap", *report);
}

TEST(LogSplit, AttachmentsGoIntoEveryPieceOrTheFirstAlone) {
  TemporaryFolder folder;
  writeRandomLog(folder / "whole.mcap", 1);
  SplitOptions split;
  split.time = std::chrono::seconds(2);
  for (const bool once : {false, true}) {
    split.attach_once = once;
    const std::string stem = once ? "once" : "each";
    const Result<SplitReport> report =
        splitLog(folder / "whole.mcap", split, makeAt(folder / (stem + ".mcap")));
    ASSERT_TRUE(report.ok());
    for (const SplitPiece& piece : report->pieces) {
      const bool first = &piece == &report->pieces.front();
      EXPECT_EQ(openLogAt(piece.path).attachments().size(), first || !once ? 1U : 0U);
    }
  }
}

TEST(LogSplit, MessagesOfOneTimeAreNotParted) {
  TemporaryFolder folder;
  {
    Result<LogWriter> writer = LogWriter::create(folder / "log.mcap", {}, "s");
    ASSERT_TRUE(writer.ok());
    const ChannelId channel = *writer->addChannel("/udp/1/x", "octets", {});
    const std::string payload(1000, 'x');
    for (std::uint32_t i = 0; i < 60; ++i) {
      ASSERT_TRUE(writer->write(channel, i, at(1000 + i / 20), 0, bytesOf(payload)).ok());
    }
    ASSERT_TRUE(writer->close("stopped").ok());
  }
  SplitOptions split;
  split.size_bytes = 10'000;
  MakeOptions make = makeAt(folder / "p.mcap");
  make.log.compression = LogWriterOptions::Compression::none;
  const Result<SplitReport> report = splitLog(folder / "log.mcap", split, make);
  ASSERT_TRUE(report.ok()) << report.error().text();
  ASSERT_EQ(report->pieces.size(), 3U);
  for (const SplitPiece& piece : report->pieces) EXPECT_EQ(piece.counts.messages, 20U);
}

TEST(LogSplit, AllPiecesAppearOrNone) {
  TemporaryFolder folder;
  writeRandomLog(folder / "log.mcap", 1);
  { std::ofstream(folder / "p-002.mcap") << "mine"; }
  SplitOptions split;
  split.time = std::chrono::seconds(1);
  const Result<SplitReport> report =
      splitLog(folder / "log.mcap", split, makeAt(folder / "p-%n.mcap"));
  ASSERT_FALSE(report.ok());
  EXPECT_THAT(report.error().text(), HasSubstr("p-002.mcap"));
  std::size_t files = 0;
  for (const auto& each : std::filesystem::directory_iterator(folder.path())) {
    files += each.exists() ? 1U : 0U;
  }
  EXPECT_EQ(files, 2U);
  split.time = Nanoseconds(0);
  split.event = "never";
  const Result<SplitReport> none = splitLog(folder / "log.mcap", split, makeAt(folder / "q.mcap"));
  ASSERT_FALSE(none.ok());
  EXPECT_THAT(none.error().text(), HasSubstr("no event matches (never)"));
  EXPECT_FALSE(splitLog(folder / "log.mcap", split, makeAt(folder / "new-folder")).ok());
  EXPECT_FALSE(std::filesystem::exists(folder / "new-folder"));
}

std::uint64_t bytesIn(const std::filesystem::path& folder) {
  std::uint64_t bytes = 0;
  for (const auto& each : std::filesystem::directory_iterator(folder)) bytes += each.file_size();
  return bytes;
}

/// Restatements of two sources, a part every 4 ms, never complete, of text that does not compress:
/// a piece would repeat everything before it to finish them.
void writeOverlappingRestatements(const std::filesystem::path& path, int parts) {
  Result<LogWriter> writer = LogWriter::create(path, {}, "s");
  ASSERT_TRUE(writer.ok());
  const std::array channels = {*writer->addChannel("/udp/1/a", "rk1", {{"source", "a"}}),
                               *writer->addChannel("/udp/1/b", "rk1", {{"source", "b"}})};
  std::mt19937_64 random(1);
  for (int i = 0; i < parts; ++i) {
    std::string text = fmt::format("RK1 {}@r {} - restated part=p{}:1/2\njoints puma{}",
                                   i % 2 == 0 ? 'a' : 'b', i, i, i % 2);
    for (int joint = 0; joint < 60; ++joint) {
      text += fmt::format(" {}", static_cast<double>(random() >> 12U));
    }
    ASSERT_TRUE(writer
                    ->write(channels[static_cast<std::size_t>(i % 2)],
                            static_cast<std::uint32_t>(i), at(kSessionStart + i * 4'000'000LL), 0,
                            bytesOf(text))
                    .ok());
  }
  ASSERT_TRUE(writer->close("stopped").ok());
}

TEST(LogSplit, RestatementsThatOverlapWithoutAnEndAreNotRepeatedWithoutAnEnd) {
  TemporaryFolder folder;
  writeOverlappingRestatements(folder / "log.mcap", 1500);
  const std::uint64_t whole = std::filesystem::file_size(folder / "log.mcap");
  for (const bool by_size : {true, false}) {
    SCOPED_TRACE(by_size);
    SplitOptions split;
    if (by_size) {
      split.size_bytes = 40'000;
    } else {
      split.time = std::chrono::milliseconds(60);
    }
    std::filesystem::create_directory(folder / "pieces");
    const Result<SplitReport> report =
        splitLog(folder / "log.mcap", split, makeAt(folder / "pieces/"));
    ASSERT_TRUE(report.ok()) << report.error().text();
    EXPECT_LT(bytesIn(folder / "pieces"), 3 * whole + (std::uint64_t{16} << 20U));
    if (by_size) {
      EXPECT_LT(report->pieces.size(), 2 * whole / split.size_bytes + 3);
      EXPECT_THAT(report->whole.notes, Contains(HasSubstr("start of piece 2 was cut off")));
    }
    EXPECT_LE(report->whole.notes.size(), 11U);
    std::vector<KeptMessage> together;
    for (const SplitPiece& piece : report->pieces) {
      if (by_size) {
        EXPECT_LT(piece.counts.bytes, split.size_bytes * 5 / 4);
      }
      const std::vector<KeptMessage> messages = capturedOf(piece.path);
      together.insert(together.end(), messages.begin(), messages.end());
    }
    EXPECT_EQ(together, capturedOf(folder / "log.mcap"));
    std::filesystem::remove_all(folder / "pieces");
  }
}

TEST(LogSplit, ASizeThatWhatIsRepeatedHardlyFitsIntoIsRefused) {
  TemporaryFolder folder;
  {
    Result<LogWriter> writer = LogWriter::create(folder / "log.mcap", {}, "s");
    ASSERT_TRUE(writer.ok());
    const ChannelId channel = *writer->addChannel("/udp/1/a", "rk1", {{"source", "a"}});
    for (std::uint32_t i = 0; i < 4000; ++i) {
      // A device more with each: the state grows until nothing else fits.
      const std::string text =
          fmt::format("RK1 a@r {} -\njoints device_{} {}\n", i, i * 2654435761U, i * 40503U);
      ASSERT_TRUE(
          writer->write(channel, i, at(kSessionStart + i * 1'000'000LL), 0, bytesOf(text)).ok());
    }
    ASSERT_TRUE(writer->close("stopped").ok());
  }
  SplitOptions split;
  split.size_bytes = 20'000;
  const Result<SplitReport> report =
      splitLog(folder / "log.mcap", split, makeAt(folder / "pieces/"));
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().kind, ErrorKind::refused);
  EXPECT_THAT(report.error().what, HasSubstr("--size must be at least"));
  EXPECT_FALSE(std::filesystem::exists(folder / "pieces"));
}

TEST(LogSplit, PiecesAreNamedByAPatternAFolderOrTheOutput) {
  TemporaryFolder folder;
  EXPECT_EQ(pieceName("p-%n.mcap", "log.mcap", 7), "p-007.mcap");
  EXPECT_EQ(pieceName("50%%-%n%x", "log.mcap", 1234), "50%-1234%x");
  EXPECT_EQ(pieceName("a/out.mcap", "log.mcap", 1), "a/out-001.mcap");
  EXPECT_EQ(pieceName("no-such-place", "log.mcap", 1), "no-such-place/log-001.mcap");
  EXPECT_EQ(pieceName("some/", "x/log.mcap", 2), "some/log-002.mcap");
  EXPECT_EQ(pieceName(folder.path().string(), "log.mcap", 2), (folder / "log-002.mcap").string());
}

}  // namespace
}  // namespace rocinante::test
