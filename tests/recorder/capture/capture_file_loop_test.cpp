#include "recorder/capture/capture_file_loop.h"

#include <gtest/gtest.h>

#include <random>

#include "recorder/capture/stream_loop.h"
#include "tests/core/net/fake_source.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using test::FakeSource;

WallTime stamp(Nanoseconds since) { return WallTime(1'000s + since); }
LogTime moment(Nanoseconds since) { return LogTime(1'000s + since); }

TEST(CaptureTime, KeepsTheStampsAndTheGapsBetweenThem) {
  CaptureTime time;
  EXPECT_EQ(time.at(stamp(1ns)), moment(1ns));
  EXPECT_EQ(time.at(stamp(24h * 365 * 7)), moment(24h * 365 * 7));
  EXPECT_FALSE(time.takeStep().has_value());
}

TEST(CaptureTime, ALittleDisorderIsRaised) {
  CaptureTime time;
  EXPECT_EQ(time.at(stamp(30ms)), moment(30ms));
  EXPECT_EQ(time.at(stamp(10ms)), moment(30ms));
  EXPECT_EQ(time.at(stamp(31ms)), moment(31ms));
  EXPECT_FALSE(time.takeStep().has_value());
  EXPECT_EQ(time.at(stamp(31ms)), moment(31ms));
  EXPECT_EQ(time.at(stamp(26ms)), moment(31ms));
  EXPECT_EQ(accountSentence(time.leftOut()),
            "left out: 2 times (before that of the datagram in front, by at most 0.02 s: raised to "
            "it)");
}

TEST(CaptureTime, AClockThatWasSetBackIsAStepAndBendsNothingAfter) {
  CaptureTime time;
  EXPECT_EQ(time.at(stamp(1h)), moment(1h));
  EXPECT_EQ(time.at(stamp(0s)), moment(1h));
  const auto step = time.takeStep();
  ASSERT_TRUE(step.has_value());
  EXPECT_EQ(step->at, moment(1h));
  EXPECT_EQ(step->step, Nanoseconds(-1h));
  EXPECT_TRUE(time.leftOut().empty());
  EXPECT_EQ(time.at(stamp(5s)), moment(1h + 5s));
  EXPECT_FALSE(time.takeStep().has_value());
}

TEST(CaptureTime, NothingIsBefore1970) {
  CaptureTime time;
  EXPECT_EQ(time.at(WallTime(-5s)), LogTime(0s));
}

TEST(CaptureTime, StampsBeyondWhatNanosecondsCountAreAtTheLastMomentThereIs) {
  CaptureTime time;
  const LogTime last = time.at(WallTime::max());
  EXPECT_GT(last + 1h, last);
  // The clock is set back and forward to the end repeatedly: times must not overflow.
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(time.at(stamp(0s)), last);
    EXPECT_EQ(time.at(WallTime::max()), last);
  }
}

TEST(CaptureTime, NeverGoesBackWhateverTheStamps) {
  std::mt19937_64 random(4);
  CaptureTime time;
  LogTime before{};
  for (int i = 0; i < 20'000; ++i) {
    const auto scale = 1LL << random() % 50;
    const LogTime at = time.at(WallTime(Nanoseconds(static_cast<std::int64_t>(random()) % scale)));
    EXPECT_LE(before, at);
    before = at;
  }
}

struct Reading {
  explicit Reading(std::size_t max_blocks) : queue(max_blocks) {}
  FakeSource file{"pcap://./x.pcap"};
  HandOver queue;
  CaptureFileLoop loop{file, queue, LogTime{}};
};

TEST(CaptureFileLoop, DropsNothingWhenTheWriterIsSlow) {
  Reading reading(/*max_blocks=*/2);
  const SocketAddress to = SocketAddress::parse("10.0.0.9", 9).value();
  reading.file.watch(to);
  constexpr int kCount = 200;
  for (int i = 0; i < kCount; ++i) {
    std::string payload = std::to_string(i);
    payload.resize(60'000, ' ');
    reading.file.arrive({{payload, stamp(1ms * i)}, {std::to_string(i), stamp(1ms * i)}});
  }
  reading.file.end();
  int next = 0;
  int full = 0;
  const auto drain = [&] {
    TakenOver taken = reading.queue.take(0ns);
    for (auto& block : taken.blocks) {
      for (const Arrival& each : block->arrivals()) {
        EXPECT_EQ(std::stoi(std::string(textOf(block->payload(each)))), next / 2);
        EXPECT_EQ(each.time, moment(1ms * (next / 2)));
        EXPECT_LE(each.time, taken.drained_until - 20ms);
        EXPECT_EQ(block->destination(each), to);
        ++next;
      }
      reading.queue.giveBack(std::move(block));
    }
    EXPECT_TRUE(taken.losses.empty());
    return taken.finished;
  };
  while (!reading.loop.ended()) {
    const auto passed = reading.loop.pass();
    ASSERT_TRUE(passed.ok());
    if (*passed) continue;
    ++full;
    drain();
  }
  ASSERT_TRUE(reading.loop.finish().ok());
  EXPECT_TRUE(drain());
  EXPECT_EQ(next, 2 * kCount);
  EXPECT_GT(full, 10);
}

TEST(CaptureFileLoop, TellsStepsAndWhatTheCaptureCut) {
  Reading reading(4);
  reading.file.arrive({{"a", stamp(1h)}, {"b", stamp(0s), "10.0.0.1", 1, /*truncated=*/true}});
  reading.file.end();
  while (!reading.loop.ended()) ASSERT_TRUE(reading.loop.pass().ok());
  ASSERT_TRUE(reading.loop.finish().ok());
  const TakenOver taken = reading.queue.take(0ns);
  ASSERT_EQ(taken.steps.size(), 1U);
  EXPECT_EQ(taken.steps[0].step, Nanoseconds(-1h));
  ASSERT_EQ(taken.losses.size(), 1U);
  EXPECT_EQ(taken.losses[0].counts, (LossCounts{0, 0, 0, 1}));
}

TEST(CaptureFileLoop, KeepsWhatStandsBeforeABreak) {
  Reading reading(4);
  reading.file.arrive({{"kept", stamp(0s)}});
  ASSERT_TRUE(reading.loop.pass().ok());
  reading.file.fail();
  EXPECT_FALSE(reading.loop.pass().ok());
  ASSERT_TRUE(reading.loop.finish().ok());
  const TakenOver taken = reading.queue.take(0ns);
  ASSERT_EQ(taken.blocks.size(), 1U);
  EXPECT_EQ(taken.blocks[0]->arrivals().size(), 1U);
  EXPECT_TRUE(taken.finished);
}

TEST(StreamLoop, HandsOverAtOnceAndTellsTheSourceWhatIsSaved) {
  FakeSource stream{"jetstream://h/S"};
  HandOver queue(4);
  NoteBox notes;
  StreamLoop loop(stream, queue, moment(9h), notes);
  stream.arrive({{"a", stamp(0s)}, {"b", stamp(1s)}});
  stream.drop(3);
  stream.mend("connected again");
  ASSERT_TRUE(*loop.pass());
  ASSERT_FALSE(*loop.pass());
  ASSERT_EQ(notes.take().size(), 1U);
  TakenOver taken = queue.take(0ns);
  ASSERT_EQ(taken.blocks.size(), 1U);
  EXPECT_EQ(taken.blocks[0]->arrivals().size(), 2U);
  ASSERT_EQ(taken.losses.size(), 1U);
  EXPECT_EQ(taken.losses[0].from, moment(1s));
  EXPECT_EQ(taken.losses[0].counts.kernel, 3U);
  EXPECT_EQ(stream.confirmed(), 0U);
  loop.noteSaved(2);
  ASSERT_FALSE(*loop.pass());
  EXPECT_EQ(stream.confirmed(), 2U);
}

TEST(StreamLoop, WhatIsGoneBeforeAnythingCameIsALossAtTheBeginning) {
  FakeSource stream{"jetstream://h/S"};
  HandOver queue(4);
  NoteBox notes;
  StreamLoop loop(stream, queue, moment(9h), notes);
  stream.drop(2);
  ASSERT_FALSE(*loop.pass());
  ASSERT_TRUE(loop.finish().ok());
  const TakenOver taken = queue.take(0ns);
  ASSERT_EQ(taken.losses.size(), 1U);
  EXPECT_EQ(taken.losses[0].from, moment(9h));
}

}  // namespace
}  // namespace rocinante
