#include "recorder/pieces/piece_sequence.h"

#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "core/copy/log_edits.h"
#include "core/copy/log_make.h"
#include "recorder/doctor/log_doctor.h"
#include "tests/recorder/pieces/capture_rig.h"
#include "tests/support/joint_packets.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using test::CaptureRig;
using test::logTime;
using test::messagesOf;
using test::ReadMessage;

namespace fs = std::filesystem;

/// Payloads of `pieces`, in order.
std::vector<ReadMessage> allMessages(const RecordedFiles& files) {
  std::vector<ReadMessage> all;
  for (const PieceFacts& piece : files.pieces) {
    const std::vector<ReadMessage> some = messagesOf(piece.file.path);
    EXPECT_EQ(some.size(), piece.packets) << piece.file.path;
    EXPECT_EQ(fs::file_size(piece.file.path), piece.bytes);
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

void expectSound(const RecordedFiles& files) {
  for (const PieceFacts& piece : files.pieces) {
    const Result<DoctorReport> report = examineLog(piece.file.path);
    ASSERT_TRUE(report.ok()) << report.error().text();
    EXPECT_TRUE(report->clean()) << doctorText(*report);
  }
}

std::string mergedContent(const RecordedFiles& files, const fs::path& folder) {
  std::vector<fs::path> logs;
  for (const PieceFacts& piece : files.pieces) logs.push_back(piece.file.path);
  MakeOptions make;
  make.output = folder / "merged.mcap";
  make.overwrite = true;
  const Result<CopyReport> merged = mergeLogs(logs, make);
  EXPECT_TRUE(merged.ok()) << merged.error().text();
  std::string content;
  messagesOf(make.output, &content);
  return content;
}

std::vector<std::string> namesOf(const RecordedFiles& files) {
  std::vector<std::string> names;
  for (const PieceFacts& each : files.pieces) names.push_back(each.file.path.filename().string());
  return names;
}

/// A session of three sources: joints, restatements in parts, octets; the same each time.
struct Session {
  struct Datagram {
    Nanoseconds at;
    std::string payload;
    std::uint16_t port;
  };
  explicit Session(int count) {
    std::mt19937 random(1996);
    Nanoseconds at{};
    for (int i = 0; i < count; ++i) {
      at += std::chrono::microseconds(random() % 3'000);
      if (i % 50 == 20) {
        for (int part = 1; part <= 3; ++part) {
          datagrams.push_back({at, restatement(i, part), 5'001});
          at += 1ms;
        }
      } else if (i % 7 == 3) {
        datagrams.push_back({at, std::string(random() % 200, static_cast<char>(random())), 5'002});
      } else {
        datagrams.push_back({at, test::jointPacket(static_cast<std::size_t>(i), 500), 5'000});
      }
    }
    end = at + 1s;
  }
  static std::string restatement(int round, int part) {
    return "RK1 plan@r " + std::to_string(round * 3 + part) +
           " - restated part=" + std::to_string(round) + ":" + std::to_string(part) +
           "/3\npose tray" + std::to_string(part + round % 40) + " 1 2 3 0 0 0 1\n";
  }

  RecordedFiles record(CaptureRig& rig) const {
    Nanoseconds written{};
    for (const Datagram& each : datagrams) {
      if (each.at - written > 40ms) {
        written = each.at;
        rig.write(each.at);
      }
      rig.arrive(each.at, each.payload, each.port);
    }
    rig.write(end);
    return rig.close();
  }

  std::vector<Datagram> datagrams;
  Nanoseconds end{};
};

std::string contentOfOne(const Session& session) {
  CaptureRig rig({});
  const RecordedFiles files = session.record(rig);
  EXPECT_EQ(namesOf(files), std::vector<std::string>{"log.mcap"});
  std::string content;
  messagesOf(files.pieces.front().file.path, &content);
  return content;
}

/// Everything sent is in the pieces, once and in order; each is self-contained; together they are
/// the session again.
void expectWholeSession(const Session& session, CaptureRig& rig, const RecordedFiles& files) {
  EXPECT_FALSE(rig.writer->trouble());
  const std::vector<ReadMessage> all = allMessages(files);
  ASSERT_EQ(all.size(), session.datagrams.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    ASSERT_EQ(all[i].payload, session.datagrams[i].payload) << i;
    ASSERT_EQ(all[i].time, logTime(session.datagrams[i].at)) << i;
  }
  expectSound(files);
  EXPECT_EQ(mergedContent(files, rig.folder.path()), contentOfOne(session));
}

TEST(PieceSequence, PartsByTimeCountedFromTheOrigin) {
  const Session session(3'000);
  RecordOptions options;
  options.split.time = 500ms;
  CaptureRig rig(options);
  const RecordedFiles files = session.record(rig);
  EXPECT_GE(files.pieces.size(), 6U);
  expectWholeSession(session, rig, files);
  const LogTime origin = *files.pieces.front().start;
  std::int64_t last = -1;
  for (const PieceFacts& piece : files.pieces) {
    const std::int64_t cell = (*piece.start - origin) / 500ms;
    EXPECT_GT(cell, last);
    // An unfinished restatement may extend the piece by its three milliseconds.
    EXPECT_LT(*piece.end - origin, (cell + 1) * 500ms + 4ms);
    last = cell;
  }
}

TEST(PieceSequence, PartsBySize) {
  const Session session(20'000);
  RecordOptions options;
  options.split.size_bytes = 100'000;
  CaptureRig rig(options);
  const RecordedFiles files = session.record(rig);
  EXPECT_GE(files.pieces.size(), 5U);
  expectWholeSession(session, rig, files);
  for (std::size_t i = 0; i + 1 < files.pieces.size(); ++i) {
    EXPECT_GT(files.pieces[i].bytes, 75'000U);
    EXPECT_LT(files.pieces[i].bytes, 110'000U);
  }
}

TEST(PieceSequence, EveryPieceOpensWithTheStateBeforeIt) {
  const Session session(3'000);
  RecordOptions options;
  options.split.time = 300ms;
  CaptureRig rig(options);
  const RecordedFiles files = session.record(rig);
  CaptureRig whole({});
  const RecordedFiles one = session.record(whole);
  auto timeline = Timeline::open(one.pieces.front().file.path).value();
  for (const PieceFacts& piece : files.pieces) {
    SCOPED_TRACE(piece.file.path.string());
    auto part = Timeline::open(piece.file.path);
    ASSERT_TRUE(part.ok());
    EXPECT_EQ(part->origin(), timeline.origin());
    EXPECT_EQ(part->log().summary().session_id,
              LogReader::open(files.pieces.front().file.path)->summary().session_id);
    for (const LogTime moment :
         {*piece.start, *piece.start + (*piece.end - *piece.start) / 2, *piece.end}) {
      const auto expected = timeline.stateAt(moment);
      const auto found = part->stateAt(moment);
      ASSERT_TRUE(expected.ok() && found.ok());
      EXPECT_EQ((*found)->identityText(), (*expected)->identityText());
    }
  }
}

TEST(PieceSequence, WhatCameAtOneTimeStaysTogether) {
  RecordOptions options;
  CaptureRig rig(options);
  rig.arrive(1ms, "a");
  rig.write(2ms);
  rig.arrive(5ms, "b");
  rig.write(5ms);
  rig.writer->askForSeam();
  rig.arrive(5ms, "c");
  rig.arrive(5ms, "d");
  rig.arrive(6ms, "e");
  rig.write(10ms);
  const RecordedFiles files = rig.close();
  ASSERT_EQ(files.pieces.size(), 2U);
  EXPECT_EQ(files.pieces[0].packets, 4U);
  EXPECT_EQ(files.pieces[1].packets, 1U);
  EXPECT_EQ(namesOf(files), (std::vector<std::string>{"log.mcap", "log-002.mcap"}));
}

TEST(PieceSequence, AskedBeforeAnythingCameItGoesOn) {
  CaptureRig rig({});
  rig.writer->askForSeam();
  rig.arrive(1ms, "a");
  rig.arrive(2ms, "b");
  rig.write(10ms);
  EXPECT_EQ(rig.close().pieces.size(), 1U);
}

TEST(PieceSequence, ASeamWaitsForAnUnfinishedRestatementButNotForEver) {
  CaptureRig rig({});
  rig.arrive(0ms, "RK1 other@r 1 -\njoints arm 1\n");
  rig.arrive(1ms, Session::restatement(1, 1), 5'001);
  rig.write(2ms);
  rig.writer->askForSeam();
  rig.arrive(3ms, "RK1 other@r 2 -\njoints arm 1\n");
  rig.arrive(4ms, Session::restatement(1, 2), 5'001);
  rig.arrive(5ms, Session::restatement(1, 3), 5'001);
  rig.arrive(6ms, "RK1 other@r 3 -\njoints arm 1\n");
  // Never finished: it is abandoned a second after its beginning.
  rig.arrive(7ms, Session::restatement(2, 1), 5'001);
  rig.write(8ms);
  rig.writer->askForSeam();
  rig.arrive(500ms, "RK1 other@r 4 -\njoints arm 1\n");
  rig.arrive(1s + 8ms, "RK1 other@r 5 -\njoints arm 1\n");
  rig.write(2s);
  const RecordedFiles files = rig.close();
  ASSERT_EQ(files.pieces.size(), 3U);
  EXPECT_EQ(files.pieces[1].start, logTime(6ms));
  EXPECT_EQ(files.pieces[2].start, logTime(1s + 8ms));
  expectSound(files);
}

TEST(PieceSequence, LossesAndClockStepsStandInThePieceOfTheirTime) {
  RecordOptions options;
  options.split.time = 100ms;
  CaptureRig rig(options);
  rig.arrive(0ms, "a");
  rig.arrive(50ms, "b");
  rig.arrive(120ms, "c");
  rig.lose(60ms, 90ms, 3);
  rig.lose(125ms, 130ms, 4);
  rig.taken.steps.push_back({logTime(70ms), 5s});
  rig.taken.steps.push_back({logTime(130ms), 6s});
  // All in one write: the seam lies within it.
  rig.write(200ms);
  const RecordedFiles files = rig.close();
  ASSERT_EQ(files.pieces.size(), 2U);
  std::vector<std::uint64_t> losses;
  for (const PieceFacts& piece : files.pieces) {
    auto log = LogReader::open(piece.file.path).value();
    std::uint64_t lost = 0;
    for (const LossSpan& each : log.losses()) lost += each.counts.kernel;
    losses.push_back(lost);
    int steps = 0;
    for (auto message = log.next(); message && *message; message = log.next()) {
      if ((*message)->channel->topic == "/rocinante/clock") ++steps;
    }
    EXPECT_EQ(steps, 1);
  }
  EXPECT_EQ(losses, (std::vector<std::uint64_t>{3, 4}));
  expectSound(files);
}

TEST(PieceSequence, TheNewestNStay) {
  const Session session(3'000);
  RecordOptions options;
  options.split.time = 300ms;
  options.limits.keep = 3;
  CaptureRig rig(options);
  const RecordedFiles files = session.record(rig);
  ASSERT_EQ(files.pieces.size(), 3U);
  EXPECT_GT(files.deleted.count, 3U);
  EXPECT_EQ(files.deleted.packets + allMessages(files).size(), session.datagrams.size());
  expectSound(files);
  std::size_t there = 0;
  for (const auto& each : fs::directory_iterator(rig.folder.path())) there += each.exists() ? 1 : 0;
  EXPECT_EQ(there, 3U);
}

TEST(PieceSequence, TheQuotaHoldsForAllTogether) {
  const Session session(40'000);
  RecordOptions options;
  options.limits.disk_quota_bytes = 400'000;
  CaptureRig rig(options);
  const RecordedFiles files = session.record(rig);
  std::uint64_t bytes = 0;
  for (const PieceFacts& each : files.pieces) bytes += each.bytes;
  EXPECT_LE(bytes, 410'000U);
  EXPECT_GT(bytes, 300'000U);
  EXPECT_GT(files.deleted.count, 0U);
  EXPECT_EQ(files.deleted.packets + allMessages(files).size(), session.datagrams.size());
}

TEST(PieceSequence, DeletesNothingThatItDidNotWrite) {
  RecordOptions options;
  options.split.time = 10ms;
  options.limits.keep = 1;
  CaptureRig rig(options);
  rig.arrive(0ms, "a");
  rig.write(1ms);
  // Another program replaced the piece with a file of the same name.
  fs::rename(rig.folder / "log-001.mcap", rig.folder / "mine.mcap");
  std::ofstream(rig.folder / "log-001.mcap") << "precious";
  std::ofstream(rig.folder / "log-002.mcap") << "precious too";
  rig.arrive(20ms, "b");
  rig.arrive(40ms, "c");
  rig.write(50ms);
  const RecordedFiles files = rig.close();
  EXPECT_EQ(namesOf(files), (std::vector<std::string>{"log-004.mcap"}));
  EXPECT_EQ(files.deleted.count, 1U);
  EXPECT_EQ(fs::file_size(rig.folder / "log-001.mcap"), 8U);
  EXPECT_EQ(fs::file_size(rig.folder / "log-002.mcap"), 12U);
  EXPECT_EQ(messagesOf(rig.folder / "mine.mcap").size(), 1U);
}

TEST(PieceSequence, WhereTheNextPieceCannotBeMadeTheOldOneGoesOn) {
  RecordOptions options;
  options.split.time = 100ms;
  CaptureRig rig(options);
  // The folder was replaced by one in which no file can be created.
  rig.arrive(0ms, "a");
  rig.write(1ms);
  const fs::path moved = rig.folder.path().string() + "-moved";
  fs::rename(rig.folder.path(), moved);
  std::ofstream(rig.folder.path()) << "a file";
  rig.arrive(150ms, "b");
  rig.arrive(250ms, "c");
  rig.write(300ms);
  EXPECT_FALSE(rig.writer->over());
  fs::remove(rig.folder.path());
  fs::rename(moved, rig.folder.path());
  rig.arrive(2s, "d");
  rig.write(3s);
  const RecordedFiles files = rig.close();
  ASSERT_EQ(files.pieces.size(), 2U);
  EXPECT_EQ(files.pieces[0].packets, 3U);
  EXPECT_EQ(files.pieces[1].packets, 1U);
  EXPECT_EQ(namesOf(files)[1], "log-002.mcap");
  std::vector<std::string> warnings;
  for (const NoteBox::Note& note : rig.notes.take()) {
    if (note.is_trouble) warnings.push_back(note.text);
  }
  ASSERT_EQ(warnings.size(), 1U) << "told once";
  EXPECT_NE(warnings[0].find("cannot create the next piece; recording continues in "),
            std::string::npos)
      << warnings[0];
}

TEST(PieceSequence, TheOldPieceThatGoesOnIsFlushedInItsTime) {
  RecordOptions options;
  options.split.time = 100ms;
  const test::TemporaryFolder folder;
  options.log = folder / "gone" / "log.mcap";
  CaptureRig rig(options);
  rig.arrive(0ms, "one");
  rig.write(50ms);
  fs::rename(folder / "gone", folder / "away");
  std::ofstream(folder / "gone") << "no folder";
  // The seam that is due here fails after a flush.
  rig.arrive(150ms, "two");
  rig.write(160ms);
  const std::uint64_t before = rig.writer->logBytes();
  rig.arrive(170ms, "three");
  rig.write(200ms);
  rig.write(300ms);
  EXPECT_GT(rig.writer->logBytes(), before);
  (void)rig.close();
}

TEST(PieceSequence, APieceThatIsDeletedWhileItIsWrittenIsToldOnce) {
  for (const bool at_the_end : {false, true}) {
    RecordOptions options;
    options.split.time = 1s;
    CaptureRig rig(options);
    rig.arrive(0ms, "one");
    rig.write(500ms);
    rig.arrive(1'500ms, "two");
    rig.write(2s);
    fs::remove(rig.folder / "log-002.mcap");
    if (!at_the_end) {
      rig.arrive(2'500ms, "three");
      rig.write(4s);
      rig.write(6s);
    }
    const RecordedFiles files = rig.close();
    EXPECT_FALSE(rig.writer->trouble()) << rig.writer->trouble()->text();
    ASSERT_GE(files.pieces.size(), 2U);
    for (const PieceFacts& each : files.pieces) {
      const bool deleted = each.file.path.filename() == "log-002.mcap";
      EXPECT_EQ(each.trouble.has_value(), deleted) << each.file.path;
    }
    std::size_t told = 0;
    for (const NoteBox::Note& note : rig.notes.take()) {
      if (note.is_trouble) ++told;
    }
    EXPECT_EQ(told, 1U);
  }
}

TEST(PieceSequence, TheCellGoesIntoEachPieceOrOnce) {
  auto cell = std::make_shared<CellBundle>();
  cell->manifest.main = "a.cell.toml";
  for (const bool once : {false, true}) {
    SCOPED_TRACE(once);
    RecordOptions options;
    options.split.time = 10ms;
    options.cell = cell;
    options.attach_once = once;
    CaptureRig rig(options);
    rig.arrive(0ms, "a");
    rig.arrive(20ms, "b");
    rig.arrive(40ms, "c");
    rig.write(50ms);
    const RecordedFiles files = rig.close();
    ASSERT_EQ(files.pieces.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto log = LogReader::open(files.pieces[i].file.path).value();
      EXPECT_EQ(log.attachments().size(), i == 0 || !once ? 1U : 0U);
    }
  }
}

TEST(PieceSequence, PiecesThatNothingFitsIntoAreRefusedAtOnce) {
  auto cell = std::make_shared<CellBundle>();
  cell->contents.emplace_back(10'000);
  RecordOptions options;
  options.cell = cell;
  options.split.size_bytes = 8'000;
  CaptureRig small(options);
  ASSERT_TRUE(small.refusal);
  EXPECT_NE(small.refusal->text().find("the cell takes 10.0 kB of each piece"), std::string::npos);
  options.split.size_bytes = 0;
  options.limits.disk_quota_bytes = 9'000;
  CaptureRig tight(options);
  ASSERT_TRUE(tight.refusal);
  EXPECT_NE(tight.refusal->text().find("is too small for one log"), std::string::npos);
}

}  // namespace
}  // namespace rocinante
