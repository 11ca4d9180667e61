#include "core/session/timeline.h"

#include <gmock/gmock.h>

#include <random>

#include "core/packet/decoder.h"
#include "tests/core/log/log_support.h"

namespace rocinante::test {
namespace {

/// Two sources, restarts, late packets, a device that leaves: every 10 ns a packet from 1,000.
Bytes makeLog(int count) {
  Bytes file;
  LogWriterOptions options;
  options.chunk_bytes = 4096;
  LogWriter writer = makeWriter(file, options);
  const ChannelId a = *writer.addChannel("/udp/19960/a", "rk1", {});
  const ChannelId b = *writer.addChannel("/udp/19960/b", "rk1", {});
  const ChannelId other = *writer.addChannel("/udp/19960/_many", "octets", {});
  std::mt19937 random(7);
  for (int i = 0; i < count; ++i) {
    const std::int64_t time_ns = 1000 + 10 * (i / 2);  // ties of two
    const bool first = i % 3 == 0;
    const int sequence = static_cast<int>(random() % 10) == 0 ? i / 2 : i;  // some come late
    std::string text =
        std::string("RK1 ") + (first ? "a" : "b") + "@1 " + std::to_string(sequence) + " -\n";
    if (i % 500 == 250) {
      text += "remove arm" + std::to_string(random() % 4);
    } else if (i % 1000 == 700) {
      text += "event \"at " + std::to_string(i) + "\"";
    } else {
      text += "joints arm" + std::to_string(random() % 4) + " " + std::to_string(i) + " 2 3";
    }
    EXPECT_TRUE(
        writer.write(first ? a : b, static_cast<std::uint32_t>(i), at(time_ns), 0, bytesOf(text))
            .ok());
    if (i % 50 == 0) {
      EXPECT_TRUE(writer.write(other, 0, at(time_ns), 0, bytesOf("\x01\x02 not ours")).ok());
    }
  }
  EXPECT_TRUE(writer.close("finished").ok());
  return file;
}

std::string stateFromStart(const Bytes& file, LogTime moment) {
  LogReader reader = openLog(file);
  std::unique_ptr<Decoder> decoder = makeDecoder("rk1");
  SessionState state;
  while (true) {
    const Result<std::optional<LogMessage>> message = reader.next();
    if (!message.ok() || !*message || (*message)->log_time > moment) break;
    if ((*message)->channel->encoding != "rk1") continue;
    if (const Packet* packet = decoder->decode((*message)->payload)) {
      state.apply((*message)->log_time, *packet);
    }
  }
  return state.identityText();
}

TEST(Timeline, IsTheFoldFromTheStartWhateverTheOrderOfQuestions) {
  const Bytes file = makeLog(30'000);  // several snapshots
  Timeline timeline = Timeline::of(openLog(file));
  std::mt19937 random(11);
  std::vector<std::int64_t> moments = {999, 1000, 151'000, 1000, 150'990, 150'989, 0};
  for (int i = 0; i < 20; ++i) moments.push_back(900 + static_cast<int>(random() % 151'000));
  for (const std::int64_t moment : moments) {
    SCOPED_TRACE(moment);
    const Result<const SessionState*> state = timeline.stateAt(at(moment));
    ASSERT_TRUE(state.ok());
    EXPECT_EQ((*state)->identityText(), stateFromStart(file, at(moment)));
  }
}

TEST(Timeline, FoldsEveryMessageOfTheMomentItself) {
  const Bytes file = makeLog(100);
  Timeline timeline = Timeline::of(openLog(file));
  // 1,010 ns holds two packets; just before it there are the two of 1,000 ns.
  const std::string before = (*timeline.stateAt(at(1009)))->identityText();
  const std::string with_both = (*timeline.stateAt(at(1010)))->identityText();
  EXPECT_NE(before, with_both);
  EXPECT_EQ(with_both, (*timeline.stateAt(at(1019)))->identityText());
}

TEST(Timeline, TellsEveryEventOnceAndStaysRightAfterwards) {
  const Bytes file = makeLog(3000);
  Timeline timeline = Timeline::of(openLog(file));
  const std::string middle = (*timeline.stateAt(at(5000)))->identityText();
  const Result<const std::vector<Event>*> events = timeline.events();
  ASSERT_TRUE(events.ok());
  std::vector<std::string> texts;
  for (const Event& event : **events) texts.push_back(event.text);
  EXPECT_THAT(texts, ::testing::ElementsAre("at 700", "at 1700", "at 2700"));
  EXPECT_EQ((**events)[0].time, at(1000 + 10 * 350));
  EXPECT_EQ((*timeline.stateAt(at(5000)))->identityText(), middle);
}

TEST(Timeline, AnEmptyLogHasTheEmptyStateAtEveryMoment) {
  Bytes file;
  ASSERT_TRUE(makeWriter(file).close("signal").ok());
  Timeline timeline = Timeline::of(openLog(file));
  EXPECT_TRUE((*timeline.stateAt(at(0)))->devices().empty());
  EXPECT_TRUE((*timeline.events())->empty());
}

TEST(Timeline, OfAMissingFileIsNotFound) {
  const Result<Timeline> timeline = Timeline::open("no-such-log.mcap");
  ASSERT_FALSE(timeline.ok());
  EXPECT_EQ(timeline.error().kind, ErrorKind::not_found);
}

}  // namespace
}  // namespace rocinante::test
