#include "core/session/timeline.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>

#include "core/packet/decoder.h"
#include "core/session/keyframe.h"
#include "tests/core/session/keyframed_log.h"

namespace rocinante::test {
namespace {

/// Two sources, restarts, late packets, a device that is removed: a packet every 10 ns from 1,000.
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
    const int sequence = static_cast<int>(random() % 10) == 0 ? i / 2 : i;  // some are late
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

TEST(Timeline, EndsAQueryWhenItIsStoppedAndCanBeAskedAgain) {
  const Bytes file = makeLog(30'000);
  Timeline timeline = Timeline::of(openLog(file));
  std::stop_source stop;
  timeline.useStop(stop.get_token());
  ASSERT_TRUE(timeline.stateAt(at(40'000)).ok());
  stop.request_stop();
  const auto stopped = timeline.stateAt(at(150'000));
  ASSERT_FALSE(stopped.ok());
  EXPECT_EQ(stopped.error().kind, ErrorKind::refused);
  timeline.useStop({});
  EXPECT_EQ((*timeline.stateAt(at(150'000)))->identityText(), stateFromStart(file, at(150'000)));
}

TEST(Timeline, TellsHowFarItHasReadForEventsAndOfOnesThatWereStoppedNoneTwice) {
  const Bytes file = makeLog(100'000);
  Timeline timeline = Timeline::of(openLog(file));
  std::stop_source stop;
  timeline.useStop(stop.get_token());
  std::vector<std::uint64_t> told;
  const TellLoadProgress tell = [&](const LoadProgress& now) {
    EXPECT_EQ(now.bytes_total, file.size());
    told.push_back(now.bytes_done);
    if (told.size() == 2) stop.request_stop();
  };
  StateDamage none;
  ASSERT_FALSE(timeline.events(&none, tell).ok());
  EXPECT_EQ(told.size(), 2U);
  timeline.useStop({});
  const auto events = timeline.events(&none, tell);
  ASSERT_TRUE(events.ok());
  EXPECT_GT(told.size(), 4U);
  EXPECT_EQ(told.back(), file.size());
  Timeline other = Timeline::of(openLog(file));
  const auto at_once = other.events();
  ASSERT_TRUE(at_once.ok());
  const auto texts_of = [](const std::vector<Event>& found) {
    std::vector<std::string> texts;
    for (const Event& event : found) texts.push_back(event.text);
    return texts;
  };
  EXPECT_EQ((*events)->size(), 100U);
  EXPECT_EQ(texts_of(**events), texts_of(**at_once));
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

/// Queries a timeline at `moments` in this order; each state must be the fold by hand.
void expectTheFold(Timeline& timeline, const KeyframedLog& log, std::vector<LogTime> moments,
                   const SessionState& preceding = {}) {
  std::map<LogTime, SessionState> expected;
  std::vector<LogTime> sorted = moments;
  std::sort(sorted.begin(), sorted.end());
  HandFold fold;
  std::size_t next = 0;
  for (const LogTime moment : sorted) {
    if (next == 0 && log.datagrams.front().time <= moment) fold.state = preceding;
    for (; next < log.datagrams.size() && log.datagrams[next].time <= moment; ++next) {
      fold.fold(log.datagrams[next].time, bytesOf(log.datagrams[next].text));
    }
    expected[moment] = fold.state;
  }
  for (const LogTime moment : moments) {
    SCOPED_TRACE(moment.time_since_epoch().count());
    const Result<const SessionState*> state = timeline.stateAt(moment);
    ASSERT_TRUE(state.ok());
    EXPECT_TRUE((*state)->sameAs(expected[moment]));
    ASSERT_EQ((*state)->identityText(), expected[moment].identityText());
  }
}

TEST(Timeline, BeforeAMessageIsTheFoldOfThoseInFrontOfItInAnyOrder) {
  const KeyframedLog log = makeKeyframedLog(3, 300);
  struct Expected {
    LogPosition place;
    std::string identity;
  };
  std::vector<Expected> expected;
  HandFold fold;
  LogReader reader = openLog(log.file);
  while (true) {
    const Result<std::optional<LogMessage>> message = reader.next();
    ASSERT_TRUE(message.ok());
    if (!*message) break;
    if (!(*message)->channel->folded()) continue;
    expected.push_back({(*message)->place(), fold.state.identityText()});
    fold.fold((*message)->log_time, (*message)->payload);
  }
  ASSERT_GT(expected.size(), 250U);
  std::shuffle(expected.begin(), expected.end(), std::mt19937(5));
  Timeline timeline = Timeline::of(openLog(log.file));
  for (const Expected& each : expected) {
    SCOPED_TRACE(each.place.time.time_since_epoch().count());
    ASSERT_EQ((*timeline.stateBefore(each.place))->identityText(), each.identity);
  }
}

std::vector<LogTime> momentsOf(const KeyframedLog& log) {
  std::vector<LogTime> moments = {at(0), log.datagrams.back().time + Nanoseconds(1)};
  for (const TimedDatagram& said : log.datagrams) {
    moments.push_back(said.time);
    moments.push_back(said.time - Nanoseconds(1));
  }
  return moments;
}

TEST(Timeline, FromKeyframesIsTheFoldFromTheStartInAnyOrder) {
  std::uint64_t keyframes = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(seed);
    const KeyframedLog log = makeKeyframedLog(seed, 200);
    keyframes += log.keyframes;
    std::vector<LogTime> moments = momentsOf(log);
    std::mt19937_64 random(seed);
    std::shuffle(moments.begin(), moments.end(), random);
    Timeline timeline = Timeline::of(openLog(log.file));
    expectTheFold(timeline, log, moments);
    std::sort(moments.begin(), moments.end(), std::greater<>());
    Timeline backwards = Timeline::of(openLog(log.file));
    expectTheFold(backwards, log, moments);
    std::reverse(moments.begin(), moments.end());
    expectTheFold(backwards, log, moments);
    EXPECT_TRUE(timeline.keyframeFaults().empty());
    EXPECT_TRUE(timeline.log().damage().empty());
  }
  EXPECT_GE(keyframes, 60U);
}

TEST(Timeline, OfAPieceGoesOnFromWhatPreceded) {
  HandFold before;
  for (const TimedDatagram& said : randomDatagrams(77, 300)) {
    before.fold(at(said.time.time_since_epoch().count() / 1000), bytesOf(said.text));
  }
  // A log cannot express this: the cut abandons an unfinished restatement.
  const std::string text = keyframeText(before.state);
  const SessionState preceding = KeyframeReader().read(bytesOf(text), at(999'999'999)).value();
  const KeyframedLog log = makeKeyframedLog(5, 200, preceding);
  Timeline timeline = Timeline::of(openLog(log.file));
  std::vector<LogTime> moments = momentsOf(log);
  std::shuffle(moments.begin(), moments.end(), std::mt19937_64(5));
  expectTheFold(timeline, log, moments, preceding);
}

/// One source sends `value` for its arm.
std::string say(int sequence, int value) {
  return "RK1 arm - -\njoints arm" + std::to_string(sequence) + " " + std::to_string(value);
}

struct HandLog {
  explicit HandLog(LogWriterOptions options = {}) : writer(makeWriter(file, options)) {
    packets = *writer.addChannel("/udp/1/arm", "rk1", {});
    keyframes = *writer.addChannel("/rocinante/keyframe", "rk1-keyframe", {});
  }
  void put(ChannelId channel, std::int64_t time_ns, const std::string& text) {
    EXPECT_TRUE(writer.write(channel, 0, at(time_ns), 0, bytesOf(text)).ok());
  }
  Timeline close() {
    EXPECT_TRUE(writer.close("finished").ok());
    return Timeline::of(openLog(file));
  }
  Bytes file;
  LogWriter writer;
  ChannelId packets = 0;
  ChannelId keyframes = 0;
};

constexpr const char* kLie =
    "RK1 liar - - restated part=k:1/1 by=keyframe\njoints arm9 9\nseen arm9 5\n";

TEST(Timeline, BeforeAMessageOfAMomentThatOthersShare) {
  HandLog log;
  log.put(log.packets, 10, say(1, 1));
  log.put(log.packets, 10, say(2, 2));
  log.put(log.packets, 10, say(3, 3));
  Timeline timeline = log.close();
  std::vector<LogPosition> places;
  LogReader reader = openLog(log.file);
  for (int i = 0; i < 3; ++i) places.push_back((**reader.next()).place());
  for (const std::size_t devices : {2U, 0U, 1U}) {
    EXPECT_EQ((*timeline.stateBefore(places[devices]))->devices().size(), devices);
  }
  EXPECT_EQ((*timeline.stateBefore({at(10), 0}))->devices().size(), 0U);
  EXPECT_EQ((*timeline.stateBefore({LogTime::min(), 0}))->devices().size(), 0U);
  EXPECT_EQ((*timeline.stateAt(at(10)))->devices().size(), 3U);
}

TEST(Timeline, AKeyframeIsBelievedInEveryDirection) {
  // The lie cannot be detected; but the answer must not depend on the path.
  HandLog log;
  log.put(log.packets, 10, say(1, 1));
  log.put(log.keyframes, 20, kLie);
  log.put(log.packets, 30, say(2, 2));
  Timeline timeline = log.close();
  const std::string forwards =
      ((void)timeline.stateAt(at(10)), (*timeline.stateAt(at(30)))->identityText());
  const std::string back =
      ((void)timeline.stateAt(at(15)), (*timeline.stateAt(at(30)))->identityText());
  Timeline fresh = Timeline::of(openLog(log.file));
  EXPECT_EQ((*fresh.stateAt(at(30)))->identityText(), forwards);
  EXPECT_EQ(back, forwards);
  EXPECT_EQ((*fresh.stateAt(at(30)))->devices().size(), 2U);
  EXPECT_EQ((*fresh.stateAt(at(19)))->devices().count("arm1"), 1U);
}

TEST(Timeline, AMalformedKeyframeIsToldAndPassedOver) {
  const char* const bad[] = {
      "no packet at all",
      "RK1 arm - -\njoints arm9 1\n",
      "RK1 arm - - restated part=k:1/2 by=keyframe\njoints arm9 9\nseen arm9 5\n",
      "RK1 arm - - restated part=k:1/1 by=keyframe\njoints arm9 9\n",
      "RK1 arm - - restated part=k:1/1 by=keyframe\njoints arm9 nine\nseen arm9 5\n",
      "RK1 arm - - restated part=k:1/1 by=keyframe reset\njoints arm9 9\nseen arm9 5\n",
      "RK1 a - - restated part=k:1/1 by=k\n\nRK1 a - - restated part=k:1/1 by=k\n",
  };
  for (const char* const text : bad) {
    SCOPED_TRACE(text);
    HandLog log;
    log.put(log.packets, 10, say(1, 1));
    log.put(log.keyframes, 20, text);
    log.put(log.packets, 30, say(2, 2));
    Timeline timeline = log.close();
    const Result<const SessionState*> state = timeline.stateAt(at(30));
    ASSERT_TRUE(state.ok());
    EXPECT_EQ((*state)->devices().size(), 2U);
    EXPECT_EQ((*state)->devices().count("arm9"), 0U);
    ASSERT_EQ(timeline.keyframeFaults().size(), 1U);
    EXPECT_EQ(timeline.keyframeFaults()[0].time, at(20));
    (void)timeline.stateAt(at(10));
    (void)timeline.stateAt(at(30));
    EXPECT_EQ(timeline.keyframeFaults().size(), 1U);
  }
}

TEST(Timeline, AKeyframeWithAnEarlierMessageBehindItDoesNotCount) {
  for (const std::size_t chunk_bytes : {std::size_t{1}, std::size_t{1} << 20U}) {
    LogWriterOptions options;
    options.chunk_bytes = chunk_bytes;  // each message a chunk, or all in one
    HandLog log(options);
    log.put(log.packets, 10, say(1, 1));
    log.put(log.keyframes, 20, kLie);
    log.put(log.packets, 15, say(2, 2));
    log.put(log.packets, 30, say(3, 3));
    Timeline timeline = log.close();
    const Result<const SessionState*> state = timeline.stateAt(at(30));
    ASSERT_TRUE(state.ok());
    EXPECT_EQ((*state)->devices().size(), 3U);
    EXPECT_EQ((*state)->devices().count("arm9"), 0U);
    ASSERT_EQ(timeline.keyframeFaults().size(), 1U);
  }
}

TEST(Timeline, SeveralChannelsOfKeyframesAreNone) {
  HandLog log;
  const ChannelId other =
      *log.writer.addChannel("/rocinante/keyframe", "rk1-keyframe", {{"a", "b"}});
  log.put(log.packets, 10, say(1, 1));
  log.put(log.keyframes, 20, kLie);
  log.put(other, 21, kLie);
  log.put(log.packets, 30, say(2, 2));
  Timeline timeline = log.close();
  EXPECT_EQ((*timeline.stateAt(at(30)))->devices().size(), 2U);
  EXPECT_EQ(timeline.keyframeFaults().size(), 1U);
}

TEST(Timeline, ManyKeyframesThatDoNotCountAreNoTrap) {
  HandLog log;
  log.put(log.packets, 10, say(1, 1));
  for (int i = 0; i < 500; ++i) log.put(log.keyframes, 20 + i, "nonsense");
  log.put(log.packets, 2000, say(2, 2));
  Timeline timeline = log.close();
  EXPECT_EQ((*timeline.stateAt(at(2000)))->devices().size(), 2U);
  EXPECT_EQ((*timeline.stateAt(at(400)))->devices().size(), 1U);
  EXPECT_LE(timeline.keyframeFaults().size(), 100U);
}

TEST(Timeline, GoesOnAfterDamageFromTheNextKeyframe) {
  KeyframedLog log = makeKeyframedLog(9, 400);
  // One byte of what a chunk in the middle compressed: the chunk fails its checksum, and is lost.
  constexpr std::array kZstd = {std::byte{0x28}, std::byte{0xB5}, std::byte{0x2F}, std::byte{0xFD}};
  const auto middle = log.file.begin() + static_cast<std::ptrdiff_t>(log.file.size() / 3);
  const auto records = std::search(middle, log.file.end(), kZstd.begin(), kZstd.end());
  ASSERT_GT(log.file.end() - records, 1000);
  *(records + 100) ^= std::byte{0x40};
  Timeline fresh = Timeline::of(openLog(log.file));
  const LogTime last = log.datagrams.back().time;
  expectTheFold(fresh, log, {last});
  // The same result by another path: through the damage.
  Timeline through = Timeline::of(openLog(log.file));
  StateDamage damage;
  for (const TimedDatagram& said : log.datagrams) {
    ASSERT_TRUE(through.stateAt(said.time, &damage).ok());
  }
  EXPECT_EQ(damage.parts().size(), 1U);
  EXPECT_FALSE(through.log().damage().empty());
  expectTheFold(through, log, {last});
}

}  // namespace
}  // namespace rocinante::test
