#include "recorder/pieces/ring_recording.h"

#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "recorder/doctor/log_doctor.h"
#include "tests/recorder/pieces/capture_rig.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using test::CaptureRig;
using test::logTime;
using test::messagesOf;

namespace fs = std::filesystem;

RecordOptions ringOf(Nanoseconds span, Nanoseconds after = Nanoseconds(0)) {
  RecordOptions options;
  options.ring = RingRule{span, after};
  return options;
}

std::string numbered(int number, std::string_view more = "") {
  return "RK1 arm@r " + std::to_string(number) + " -\njoints arm " + std::to_string(number) + "\n" +
         std::string(more);
}

/// A hundred a second, from 0 up to `until`.
void talk(CaptureRig& rig, Nanoseconds from, Nanoseconds until) {
  for (Nanoseconds at = from; at < until; at += 10ms) {
    rig.arrive(at, numbered(static_cast<int>(at / 10ms)));
    if (at % 50ms == 40ms) rig.write(at);
  }
  rig.write(until - 1ns);
}

void expectSound(const fs::path& path) {
  const Result<DoctorReport> report = examineLog(path);
  ASSERT_TRUE(report.ok()) << report.error().text();
  EXPECT_TRUE(report->clean()) << doctorText(*report);
}

TEST(RingRecording, WritesNothingUntilItIsTriggered) {
  CaptureRig rig(ringOf(1s));
  talk(rig, 0s, 3s);
  const RecordedFiles files = rig.close();
  EXPECT_TRUE(files.pieces.empty());
  EXPECT_TRUE(fs::is_empty(rig.folder.path()));
}

TEST(RingRecording, KeepsTheLastSpanWithTheStateBeforeIt) {
  CaptureRig rig(ringOf(1s));
  rig.arrive(0ms, "RK1 cell@r 1 -\nadd arm puma\npose arm 1 2 3 0 0 0 1\n");
  talk(rig, 10ms, 5s);
  rig.writer->trigger("signal");
  talk(rig, 5s, 6s);
  const RecordedFiles files = rig.close();
  ASSERT_EQ(files.pieces.size(), 1U);
  const PieceFacts& file = files.pieces[0];
  EXPECT_EQ(file.file.path.filename(), "log-001.mcap");
  EXPECT_FALSE(file.cut_short);
  EXPECT_EQ(file.triggers, 1U);
  // Triggered after everything before 5 s and the 20 ms of the window had come.
  EXPECT_EQ(*file.start, logTime(4'020ms));
  EXPECT_EQ(*file.end, logTime(5'010ms));
  EXPECT_EQ(messagesOf(file.file.path).size(), 100U);
  expectSound(file.file.path);
  auto timeline = Timeline::open(file.file.path).value();
  EXPECT_EQ(timeline.origin(), logTime(0ms));
  const SessionState* const state = timeline.stateAt(*file.start).value();
  ASSERT_TRUE(state->devices().contains("arm"));
  EXPECT_EQ(state->devices().at("arm").pose->value.pose.position.y, 2);
  EXPECT_EQ(state->devices().at("arm").joints->value, std::vector<double>{402});
}

TEST(RingRecording, GoesOnAfterTheTriggerAndInTheSameFileWhenTriggeredAgain) {
  CaptureRig rig(ringOf(1s, 500ms));
  rig.arrive(0ms, "x");
  talk(rig, 10ms, 2s);
  rig.writer->trigger("signal");
  talk(rig, 2s, 2'300ms);
  rig.writer->trigger("signal");
  talk(rig, 2'300ms, 5s);
  rig.writer->trigger("signal");
  talk(rig, 5s, 5'100ms);
  const RecordedFiles files = rig.close();
  ASSERT_EQ(files.pieces.size(), 2U);
  EXPECT_EQ(files.pieces[0].triggers, 2U);
  EXPECT_EQ(*files.pieces[0].start, logTime(1'020ms));
  EXPECT_EQ(*files.pieces[0].end, logTime(2'810ms));
  // The recording ended before the second file had its 500 ms.
  EXPECT_EQ(*files.pieces[1].end, logTime(5'090ms));
  for (const PieceFacts& each : files.pieces) expectSound(each.file.path);
}

TEST(RingRecording, AnEventTriggersIt) {
  RecordOptions options = ringOf(1s);
  options.ring_on = {Condition::parse("event=*collision*").value()};
  CaptureRig rig(options);
  talk(rig, 0s, 3s);
  rig.arrive(3s, numbered(300, "event \"a collision of arm and tray\"\n"));
  talk(rig, 3'010ms, 8s);
  rig.arrive(8s, numbered(800, "event \"another collision\"\n"));
  talk(rig, 8'010ms, 9s);
  const RecordedFiles files = rig.close();
  ASSERT_EQ(files.pieces.size(), 2U);
  EXPECT_EQ(files.pieces[0].why, "event=*collision*");
  EXPECT_EQ(*files.pieces[0].start, logTime(2s));
  EXPECT_EQ(*files.pieces[0].end, logTime(3s)) << "the event is the last";
  EXPECT_EQ(*files.pieces[1].triggered, logTime(8s));
}

TEST(RingRecording, ASilenceTriggersIt) {
  RecordOptions options = ringOf(2s);
  options.ring_on = {Condition::parse("silence=500ms").value()};
  CaptureRig rig(options);
  talk(rig, 0s, 3s);
  rig.write(10s);
  const RecordedFiles files = rig.close();
  ASSERT_EQ(files.pieces.size(), 1U);
  EXPECT_EQ(*files.pieces[0].triggered, logTime(2'990ms + 500ms));
  EXPECT_EQ(*files.pieces[0].start, logTime(1'490ms));
  EXPECT_EQ(*files.pieces[0].end, logTime(2'990ms));
}

TEST(RingRecording, AFindingTriggersIt) {
  RecordOptions options = ringOf(1s, 500ms);
  const test::TemporaryFolder models;
  std::ofstream(models.path() / "arm.urdf")
      << "<robot name=\"arm\"> <link name=\"base\"/> <link name=\"hand\"/> <joint name=\"turn\" "
         "type=\"prismatic\"> <parent link=\"base\"/> <child link=\"hand\"/> <limit lower=\"0\" "
         "upper=\"399.5\" effort=\"1\" velocity=\"9999\"/> </joint> </robot>";
  options.watch = std::make_shared<FindingTrigger>(loadCell(models.path() / "arm.urdf", {}).value(),
                                                   Severity::error, /*is_live=*/false);
  CaptureRig rig(options);
  // The joint is at 400 after 4 s, and stays beyond its limit: one finding, one file.
  talk(rig, 0s, 8s);
  const RecordedFiles files = rig.close();
  ASSERT_EQ(files.pieces.size(), 1U);
  expectSound(files.pieces[0].file.path);
  EXPECT_TRUE(files.pieces[0].why.starts_with("arm/turn is outside its limits"))
      << files.pieces[0].why;
  EXPECT_EQ(files.pieces[0].triggered, logTime(4s));
  EXPECT_EQ(messagesOf(files.pieces[0].file.path).size(), 151U) << "3 s to 4.5 s";
}

TEST(RingRecording, BeginsWhereNoRestatementIsUnfinished) {
  CaptureRig rig(ringOf(1s));
  const auto part = [](int number, int part_number) {
    return "RK1 cell@r " + std::to_string(number) +
           " - restated part=9:" + std::to_string(part_number) + "/2\npose d" +
           std::to_string(part_number) + " 0 0 0 0 0 0 1\n";
  };
  rig.arrive(0s, "RK1 cell@r 1 -\npose gone 0 0 0 0 0 0 1\n");
  talk(rig, 10ms, 1'990ms);
  // The second part comes only when the first has left the span.
  rig.arrive(1'990ms, part(2, 1));
  talk(rig, 2s, 2'100ms);
  rig.arrive(2'100ms, part(3, 2));
  talk(rig, 2'110ms, 3'030ms);
  rig.writer->trigger("signal");
  talk(rig, 3'030ms, 4s);
  const RecordedFiles files = rig.close();
  ASSERT_EQ(files.pieces.size(), 1U);
  EXPECT_EQ(*files.pieces[0].start, logTime(1'990ms));
  auto timeline = Timeline::open(files.pieces[0].file.path).value();
  EXPECT_TRUE((*timeline.stateAt(logTime(2s)))->devices().contains("gone"));
  EXPECT_FALSE((*timeline.stateAt(logTime(2'500ms)))->devices().contains("gone"));
  expectSound(files.pieces[0].file.path);
}

TEST(RingRecording, SaysWhenItsMemoryHeldLess) {
  RecordOptions options = ringOf(10s);
  options.ring->max_bytes = 4 * RingBuffer::kBlockBytes;
  CaptureRig rig(options);
  const std::string large(50'000, 'x');
  for (int i = 0; i < 200; ++i) {
    rig.arrive(10ms * i, large);
    if (i % 5 == 4) rig.write(10ms * i);
  }
  rig.write(2s);
  EXPECT_LT(rig.writer->held(), 1s);
  rig.writer->trigger("signal");
  rig.write(3s);
  const RecordedFiles files = rig.close();
  ASSERT_EQ(files.pieces.size(), 1U);
  EXPECT_TRUE(files.pieces[0].cut_short);
  EXPECT_GT(files.pieces[0].packets, 50U);
  EXPECT_LT(files.pieces[0].packets, 90U);
  std::string said;
  for (const NoteBox::Note& note : rig.notes.take()) said += note.text + "\n";
  EXPECT_NE(said.find("not 10 s: --ring-size 4.2 MB was full"), std::string::npos) << said;
}

/// Compared with a complete recording: for any trigger, a file holds the same messages in its span,
/// opens with the same state, and loses nothing while it is written.
TEST(RingRecording, AnyTriggerGivesAPartOfTheWholeSession) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    SCOPED_TRACE(seed);
    RecordOptions options = ringOf(700ms, seed % 2 == 0 ? 0ms : 300ms);
    options.ring->max_bytes = 4 * RingBuffer::kBlockBytes;
    CaptureRig ring(options);
    CaptureRig whole({});
    std::mt19937 random(seed);
    Nanoseconds at{};
    std::uint64_t sequence = 0;
    for (int i = 0; i < 4'000; ++i) {
      at += std::chrono::microseconds(random() % 2'000);
      std::string payload = "RK1 arm@r " + std::to_string(++sequence) + " -";
      if (i % 40 < 3)
        payload +=
            " restated part=" + std::to_string(i / 40) + ":" + std::to_string(i % 40 + 1) + "/3";
      payload += "\npose d" + std::to_string(random() % 60) + " 1 2 3 0 0 0 1\n# " +
                 std::string(random() % 900, 'x');
      for (CaptureRig* each : {&ring, &whole}) each->arrive(at, payload);
      if (i % 20 == 0) {
        ring.write(at - 1us);
        whole.write(at - 1us);
        if (random() % 20 == 0) ring.writer->trigger("signal");
      }
    }
    at += 1s;
    ring.write(at);
    whole.write(at);
    const fs::path all = whole.close().pieces.front().file.path;
    auto timeline = Timeline::open(all).value();
    const std::vector<test::ReadMessage> messages = messagesOf(all);
    const RecordedFiles files = ring.close();
    ASSERT_GT(files.pieces.size(), 1U);
    for (const PieceFacts& file : files.pieces) {
      SCOPED_TRACE(file.file.path.string());
      const std::vector<test::ReadMessage> kept = messagesOf(file.file.path);
      ASSERT_EQ(kept.size(), file.packets);
      std::size_t at_message = 0;
      while (messages[at_message].payload != kept.front().payload) ++at_message;
      // The next datagram may be two milliseconds away.
      EXPECT_LE(*file.start, std::max(*file.triggered - 700ms, messages.front().time) + 2ms);
      for (const test::ReadMessage& each : kept) {
        ASSERT_EQ(each.payload, messages[at_message].payload);
        ASSERT_EQ(each.sequence, messages[at_message].sequence);
        ++at_message;
      }
      auto part = Timeline::open(file.file.path).value();
      for (const LogTime moment : {*file.start, *file.end}) {
        EXPECT_EQ((*part.stateAt(moment))->identityText(),
                  (*timeline.stateAt(moment))->identityText());
      }
      expectSound(file.file.path);
    }
  }
}

TEST(RingRecording, AFileThatCannotBeMadeIsToldAndTheRingGoesOn) {
  CaptureRig rig(ringOf(1s));
  talk(rig, 0s, 2s);
  const fs::path moved = rig.folder.path().string() + "-moved";
  fs::rename(rig.folder.path(), moved);
  std::ofstream(rig.folder.path()) << "a file";
  rig.writer->trigger("signal");
  talk(rig, 2s, 3s);
  fs::remove(rig.folder.path());
  fs::rename(moved, rig.folder.path());
  rig.writer->trigger("signal");
  talk(rig, 3s, 4s);
  EXPECT_EQ(rig.close().pieces.size(), 1U);
  const std::vector<NoteBox::Note> notes = rig.notes.take();
  ASSERT_FALSE(notes.empty());
  EXPECT_TRUE(notes[0].is_trouble);
  EXPECT_NE(notes[0].text.find("cannot write the ring"), std::string::npos);
}

TEST(RingRecording, OfItsFilesTheNewestStay) {
  RecordOptions options = ringOf(100ms);
  options.limits.keep = 2;
  CaptureRig rig(options);
  for (int i = 0; i < 5; ++i) {
    talk(rig, 1s * i, 1s * (i + 1));
    rig.writer->trigger("signal");
  }
  talk(rig, 5s, 6s);
  const RecordedFiles files = rig.close();
  ASSERT_EQ(files.pieces.size(), 2U);
  EXPECT_EQ(files.deleted.count, 3U);
  EXPECT_EQ(files.pieces[1].file.path.filename(), "log-005.mcap");
}

TEST(RingRecording, AFolderThatCannotBeWrittenIsRefusedAtOnce) {
  RecordOptions options = ringOf(1s);
  options.log = "/proc/nowhere/ring-%n.mcap";
  CaptureRig rig(options);
  ASSERT_TRUE(rig.refusal);
  EXPECT_NE(rig.refusal->text().find("cannot create a file there"), std::string::npos);
}

}  // namespace
}  // namespace rocinante
