#include "player/send/paced_sender.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/player/send/fake_send_port.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using test::FakeJournal;
using test::FakeSendPort;
using test::FakeStream;
using testing::ElementsAre;

FakeStream::Item item(Nanoseconds time, std::string payload) {
  return {Due{LogTime(time), 0, false}, std::move(payload)};
}

PlaybackClock clockAt(std::string_view speed) {
  return {LogTime{}, SteadyTime(1ms), PlaybackSpeed::parse(speed).value()};
}

TEST(SendOnSchedule, SendsEverythingInOrderAndNothingEarly) {
  FakeStream stream({item(0s, "a"), item(1ms, "b"), item(1ms, "c"), item(5s, "d")});
  FakeSendPort edge;
  FakeJournal journal;
  EXPECT_EQ(sendOnSchedule(stream, clockAt("1"), edge, journal).value(), SendEnd::finished);
  EXPECT_THAT(edge.sent, ElementsAre("a", "b", "c", "d"));
  EXPECT_EQ(journal.payloads, edge.sent);
  for (const auto& line : journal.lines) {
    EXPECT_GE(line.sent_at, line.deadline);
    EXPECT_LT(line.sent_at - line.deadline, 5us);
  }
  EXPECT_EQ(journal.lines.back().deadline, SteadyTime(5s + 1ms));
}

TEST(SendOnSchedule, WhatIsDueTogetherGoesInOneCall) {
  std::vector<FakeStream::Item> items;
  for (int i = 0; i < 100; ++i) items.push_back(item(1s, std::to_string(i)));
  FakeStream stream(items);
  FakeSendPort edge;
  FakeJournal journal;
  ASSERT_TRUE(sendOnSchedule(stream, clockAt("1"), edge, journal).ok());
  EXPECT_EQ(edge.sent.size(), 100U);
  EXPECT_EQ(edge.sends, 2U);
}

// 6,000 a second in the first second of every minute and at the very end of an hour: what a whole
// hour would show of rounding, in milliseconds.
class Hour : public DatagramStream {
 public:
  static constexpr Nanoseconds kLength = 1h;

  Result<std::optional<Due>> due() override {
    if (over_) return std::optional<Due>();
    return std::optional(Due{LogTime(time()), 0, false});
  }
  ByteView take() override {
    over_ = time() == kLength;
    if (++index_ % 6'000 == 0) index_ += 59 * 6'000;
    return bytesOf("packet");
  }

 private:
  Nanoseconds time() const { return Nanoseconds(index_ * 1'000'000'000 / 6'000); }

  std::int64_t index_ = 0;
  bool over_ = false;
};

TEST(SendOnSchedule, AnHourOfSixThousandASecondEndsOnTheExactNanosecond) {
  const std::pair<const char*, Nanoseconds> ends[] = {
      {"0.1", 10h},     {"1", 1h}, {"2", 30min}, {"3", 20min}, {"7", 3'600'000'000'000ns / 7},
      {"10", 360'000ms}};
  struct Last final : SendJournal {
    void sent(const Due&, ByteView, SteadyTime deadline, SteadyTime sent_at) override {
      ++count;
      early += sent_at < deadline;
      latest = std::max(latest, sent_at - deadline);
      last = deadline;
    }
    int count = 0, early = 0;
    Nanoseconds latest{};
    SteadyTime last{};
  };
  for (const auto& [speed, end] : ends) {
    SCOPED_TRACE(speed);
    Hour hour;
    FakeSendPort edge;
    edge.keep_payloads = false;
    edge.look_costs = 2us;
    edge.wakes_late = 15us;
    Last last;
    EXPECT_EQ(sendOnSchedule(hour, clockAt(speed), edge, last).value(), SendEnd::finished);
    EXPECT_EQ(last.count, 60 * 6'000 + 1);
    EXPECT_EQ(last.early, 0);
    EXPECT_LT(last.latest, 200us);
    EXPECT_EQ(last.last.time_since_epoch() - 1ms, end);
  }
}

TEST(SendOnSchedule, SpinsLessThanHalfOfTheTime) {
  // 60,000 a second: spinning before each would leave no sleep.
  std::vector<FakeStream::Item> items;
  for (int i = 0; i < 60'000; ++i) items.push_back(item(i * 1'000'000'000ns / 60'000, "x"));
  FakeStream stream(items);
  FakeSendPort edge;
  edge.wakes_late = 2us;
  FakeJournal journal;
  ASSERT_TRUE(sendOnSchedule(stream, clockAt("1"), edge, journal).ok());
  EXPECT_GT(edge.slept, 500ms);
  EXPECT_EQ(edge.sent.size(), 60'000U);
}

TEST(SendOnSchedule, WhenItCannotKeepUpNothingIsDroppedOrReordered) {
  std::vector<FakeStream::Item> items;
  std::vector<std::string> expected;
  for (int i = 0; i < 5'000; ++i) {
    items.push_back(item(i * 1us, std::to_string(i)));
    expected.push_back(std::to_string(i));
  }
  FakeStream stream(items);
  FakeSendPort edge;
  edge.send_costs = 10us;
  FakeJournal journal;
  EXPECT_EQ(sendOnSchedule(stream, clockAt("1"), edge, journal).value(), SendEnd::finished);
  EXPECT_EQ(edge.sent, expected);
  EXPECT_GT(journal.lines.back().sent_at - journal.lines.back().deadline, 40ms);
}

TEST(SendOnSchedule, AStopEndsItBeforeTheNextDatagram) {
  FakeStream stream({item(0s, "a"), item(1s, "b"), item(2s, "c")});
  FakeSendPort edge;
  edge.stop_after_sends = 2;
  FakeJournal journal;
  EXPECT_EQ(sendOnSchedule(stream, clockAt("1"), edge, journal).value(), SendEnd::stopped);
  EXPECT_THAT(edge.sent, ElementsAre("a", "b"));
}

TEST(SendOnSchedule, WaitsInSleepsThatAStopCanEnd) {
  FakeStream stream({item(0s, "a"), item(1h, "b")});
  FakeSendPort edge;
  FakeJournal journal;
  ASSERT_TRUE(sendOnSchedule(stream, clockAt("1"), edge, journal).ok());
  EXPECT_LE(edge.longest_sleep, 100ms);
}

TEST(SendOnSchedule, AnErrorOfTheStreamComesAfterWhatWasReadBeforeIt) {
  FakeStream stream({item(0s, "a"), item(1s, "b"), item(2s, "c")});
  stream.fail_at = 2;
  FakeSendPort edge;
  FakeJournal journal;
  const auto end = sendOnSchedule(stream, clockAt("1"), edge, journal);
  ASSERT_FALSE(end.ok());
  EXPECT_EQ(end.error().text(), "chunk 7 fails its checksum (x.mcap)");
  EXPECT_EQ(edge.sent.front(), "a");
}

TEST(SendOnSchedule, AnErrorOfTheSocketEndsIt) {
  FakeStream stream({item(0s, "a"), item(1s, "b")});
  FakeSendPort edge;
  edge.fail_send = 2;
  FakeJournal journal;
  const auto end = sendOnSchedule(stream, clockAt("1"), edge, journal);
  ASSERT_FALSE(end.ok());
  EXPECT_EQ(end.error().kind, ErrorKind::refused);
  EXPECT_THAT(journal.payloads, ElementsAre("a"));
}

TEST(SendOnSchedule, AnEmptyStreamIsFinishedAtOnce) {
  FakeStream stream({});
  FakeSendPort edge;
  FakeJournal journal;
  EXPECT_EQ(sendOnSchedule(stream, clockAt("1"), edge, journal).value(), SendEnd::finished);
  EXPECT_EQ(edge.sends, 0U);
}

}  // namespace
}  // namespace rocinante
