#include "player/source/log_stream.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "player/logs/tape_finder.h"
#include "tests/player/logs/written_log.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;

constexpr LogTime kStreamEpoch(1'000s);

class LogStreamTest : public testing::Test {
 protected:
  struct Sent {
    LogTime time;
    bool restated;
    std::string text;
  };

  /// Opens `path` as a source would: [from, until) after the log's zero, or all of it.
  LogStream& open(const std::filesystem::path& path, LogStream::Options options,
                  std::optional<PlayedSpan> span = std::nullopt) {
    reader_.emplace(MultiLogReader::open({path}).value());
    options.span = span.value_or(PlayedSpan{reader_->start(), reader_->end() + Nanoseconds(1)});
    options.run = "new";
    options.epoch_ns = kStreamEpoch.time_since_epoch().count();
    auto before =
        TapeFinder::open({path}, {}).value().stateBefore(TapePosition::at(options.span.from));
    stream_.emplace(LogStream::open(*reader_, before.value(), std::move(options)).value());
    return *stream_;
  }

  static std::vector<Sent> takeAll(LogStream& stream, std::size_t most = 100'000) {
    std::vector<Sent> all;
    while (all.size() < most) {
      const auto due = stream.due().value();
      if (!due) break;
      all.push_back({due->time, due->restated, std::string(textOf(stream.take()))});
    }
    return all;
  }

  static std::vector<std::string> textsOf(const std::vector<Sent>& all) {
    std::vector<std::string> texts;
    for (const Sent& sent : all) texts.push_back(sent.text);
    return texts;
  }

  std::filesystem::path written(const std::vector<test::WrittenMessage>& messages) {
    return test::writeLog(folder_ / ("log" + std::to_string(++logs_)), messages);
  }

  test::TemporaryFolder folder_;
  int logs_ = 0;
  std::optional<MultiLogReader> reader_;
  std::optional<LogStream> stream_;
};

/// The items of a state: its identity without sources and last writes.
std::string itemsOf(const SessionState& state) {
  std::string items;
  const std::string text = state.identityText();
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at) + 1;
    if (text.compare(at, 5, "item ") == 0) items += text.substr(at, end - at);
    at = end;
  }
  return items;
}

TEST_F(LogStreamTest, SendsTheLinesAsRecordedUnderANewRunWithTheTimeOfNow) {
  const auto log = written({{5s, "RK1 a@old 70 3\njoints  a +1.50 2e0\n# remark\nevent \"go\"\n"},
                            {6s, "RK1 a@old 71 4 via=r:9\n\tjoints a 3 4\nnonsense\n"}});
  EXPECT_THAT(textsOf(takeAll(open(log, {}))),
              ElementsAre("RK1 a@new 0 1000\njoints  a +1.50 2e0\nevent \"go\"\n",
                          "RK1 a@new 1 1001\n\tjoints a 3 4\n"));
}

TEST_F(LogStreamTest, EveryMessageIsDueWhereTheLogHasItAndTimeAdvancesInRealTime) {
  const auto log = written({{5s, "RK1 a 0 -"}, {5'250ms, "RK1 a 1 -"}, {7s, "RK1 a 2 -"}});
  LogStream::Options options;
  options.speed = PlaybackSpeed::parse("2").value();
  const auto all = takeAll(open(log, options));
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[1].time, LogTime(5'250ms));
  EXPECT_EQ(all[2].time, LogTime(7s));
  EXPECT_EQ(all[1].text, "RK1 a@new 1 1000.125\n");
  EXPECT_EQ(all[2].text, "RK1 a@new 2 1001\n");
}

TEST_F(LogStreamTest, WhatNewestWinsDropsIsNotSentAndNothingThatIsNoPacket) {
  const auto log = written({{1s, "RK1 a 5 -\njoints a 5"},
                            {2s, "RK1 a 4 -\njoints a 4"},
                            {3s, "not a packet"},
                            {4s, "RK1 a 6 -\njoints a 6"}});
  EXPECT_THAT(textsOf(takeAll(open(log, {}))),
              ElementsAre("RK1 a@new 0 1000\njoints a 5\n", "RK1 a@new 1 1003\njoints a 6\n"));
}

TEST_F(LogStreamTest, ARecordedRestatementBecomesOrdinaryPacketsWithoutEventsOfOthers) {
  const auto log =
      written({{1s, "RK1 a 1 - restated part=x:1/2\njoints a 1"},
               {2s, "RK1 a 1 - restated by=relay\njoints a 1\nseen a 5\nevent \"again\"\n"}});
  EXPECT_THAT(textsOf(takeAll(open(log, {}))),
              ElementsAre("RK1 a@new 0 1000 restated\njoints a 1\n",
                          "RK1 a@new 1 1001 restated\njoints a 1\n"));
}

TEST_F(LogStreamTest, ChoosesSourcesAndDevicesAndRenames) {
  const auto log =
      written({{1s, "RK1 a 0 -\njoints arm 1\njoints tray 2\nhide layer/x\n", "/udp/1/a"},
               {2s, "RK1 b 0 -\njoints arm 3\n", "/udp/1/b"},
               {3s, "RK1 a 1 -\njoints tray 4\nevent \"done\"\nerase p\n", "/udp/1/a"},
               {4s, "RK1 a 2 -\njoints tray 5\n", "/udp/1/a"},
               {5s, "RK1 a 3 -\n", "/udp/1/a"}});
  LogStream::Options options;
  options.choice.sources = {"[a]"};
  options.choice.devices = {"ar*"};
  options.choice.names = {{"a", "left arm"}};
  LogStream& stream = open(log, options);
  EXPECT_THAT(stream.names(), ElementsAre("left arm"));
  EXPECT_THAT(textsOf(takeAll(stream)),
              ElementsAre("RK1 left%20arm@new 0 1000\njoints arm 1\n",
                          "RK1 left%20arm@new 1 1002\nevent \"done\"\nerase p\n",
                          "RK1 left%20arm@new 2 1004\n"));
}

TEST_F(LogStreamTest, TwoSourcesOfOneNameAreRefused) {
  const auto log = written({{1s, "RK1 a 0 -", "/udp/1/a"}, {2s, "RK1 b 0 -", "/udp/1/b"}});
  MultiLogReader reader = MultiLogReader::open({log}).value();
  LogStream::Options options;
  options.span = {LogTime(1s), LogTime(3s)};
  options.choice.names = {{"a", "b"}};
  const auto stream = LogStream::open(reader, {}, options);
  ASSERT_FALSE(stream.ok());
  EXPECT_EQ(stream.error().kind, ErrorKind::bad_argument);
}

TEST_F(LogStreamTest, WithoutAPacketThereIsNothingToSend) {
  const auto log = written({{1s, "octets"}, {2s, "more"}});
  MultiLogReader reader = MultiLogReader::open({log}).value();
  LogStream::Options options;
  options.span = {LogTime(1s), LogTime(3s)};
  options.turns = 0;
  const auto stream = LogStream::open(reader, {}, options);
  ASSERT_FALSE(stream.ok());
  EXPECT_EQ(stream.error().kind, ErrorKind::not_found);
}

TEST_F(LogStreamTest, EachSourceRestatesItselfOncePerPeriodOneAfterTheOther) {
  std::vector<test::WrittenMessage> messages;
  for (int i = 0; i < 100; ++i) {
    for (const char* name : {"a", "b", "c", "d"}) {
      const std::string n(name);
      messages.push_back({i * 100ms,
                          "RK1 " + n + " " + std::to_string(i) + " -\njoints " + n + " 1\n",
                          "/udp/1/" + n});
    }
  }
  LogStream::Options options;
  options.restate = 2s;
  options.turns = 2;
  std::map<std::string, std::vector<LogTime>> restated;
  std::map<LogTime, int> at_once;
  for (const Sent& sent : takeAll(open(written(messages), options))) {
    if (!sent.restated) continue;
    restated[sent.text.substr(4, 1)].push_back(sent.time);
    ++at_once[sent.time];
  }
  // All four together only where the second turn begins.
  EXPECT_EQ(std::count_if(at_once.begin(), at_once.end(), [](auto& at) { return at.second > 1; }),
            1);
  ASSERT_EQ(restated.size(), 4U);
  for (const auto& [name, times] : restated) {
    SCOPED_TRACE(name);
    ASSERT_GE(times.size(), 9U);
    EXPECT_LE(times.front(), LogTime(2s));
    for (std::size_t i = 1; i < times.size(); ++i) EXPECT_LE(times[i] - times[i - 1], 2s);
  }
}

TEST_F(LogStreamTest, ASilentSourceRestatesItselfTooAndALargeStateIsSpread) {
  std::vector<test::WrittenMessage> messages;
  for (int i = 0; i < 300; ++i) {
    const std::string n = std::to_string(i);
    messages.push_back({1s + i * 1us, "RK1 a " + n + " -\nlabel l" + n + " 0 0 0 \"" +
                                          std::string(1'000, 'x') + "\"\n"});
  }
  messages.push_back({10s, "RK1 a 300 -\n"});
  LogStream::Options options;
  options.restate = 2s;
  std::map<LogTime, int> at_once;
  for (const Sent& sent : takeAll(open(written(messages), options))) {
    if (sent.restated) ++at_once[sent.time];
  }
  // 300 datagrams at 3, 5, 7 and 9 s, each time in five bursts.
  EXPECT_EQ(at_once.size(), 20U);
  for (const auto& [time, count] : at_once) EXPECT_LE(count, 64);
  EXPECT_TRUE(at_once.contains(LogTime(3s) + 10ms));
}

TEST_F(LogStreamTest, ASpanBeginsWithTheStateBeforeItAndATurnForgetsWhatTheLastAdded) {
  const auto log = written({{1s, "RK1 a 0 -\njoints arm 1\n", "/udp/1/a"},
                            {3s, "RK1 a 1 -\njoints arm 2\nlabel l 0 0 0 \"x\"\n", "/udp/1/a"},
                            {4s, "RK1 b 0 -\nadd tray box\n", "/udp/1/b"},
                            {9s, "RK1 a 2 -\n", "/udp/1/a"}});
  LogStream::Options options;
  options.turns = 2;
  LogStream& stream = open(log, options, PlayedSpan{LogTime(2s), LogTime(5s)});
  EXPECT_THAT(textsOf(takeAll(stream)),
              ElementsAre("RK1 a@new 0 1000 restated part=r1:1/1\norder arm\njoints arm 1\n",
                          "RK1 a@new 1 1001\njoints arm 2\nlabel l 0 0 0 \"x\"\n",
                          "RK1 b@new 0 1002\nadd tray box\n",
                          "RK1 a@new 2 1003 restated part=r2:1/1\norder arm\njoints arm 1\n",
                          "RK1 b@new 1 1003 restated part=r1:1/1\n",
                          "RK1 a@new 3 1004\njoints arm 2\nlabel l 0 0 0 \"x\"\n",
                          "RK1 b@new 2 1005\nadd tray box\n"));
}

TEST_F(LogStreamTest, AnEndlessLoopNeverEndsAndNeverLosesItsPeriod) {
  const auto log = written({{1s, "RK1 a 0 -\njoints arm 1\n"}, {2s, "RK1 a 1 -\njoints arm 2\n"}});
  LogStream::Options options;
  options.turns = 0;
  LogStream& stream = open(log, options, PlayedSpan{LogTime(1s), LogTime(3s)});
  std::vector<LogTime> first;
  for (const Sent& sent : takeAll(stream, 3'000)) {
    if (!sent.restated && sent.text.find("arm 1\n") != std::string::npos) {
      first.push_back(sent.time);
    }
  }
  ASSERT_EQ(first.size(), 1'000U);
  for (std::size_t i = 0; i < first.size(); ++i) {
    ASSERT_EQ(first[i], LogTime(1s) + 2s * static_cast<int>(i));
  }
}

TEST_F(LogStreamTest, PacketsThatGrowBeyondTheMtuAreSentAsSeveral) {
  std::string payload = "RK1 a 0 -\n";
  for (int i = 0; i < 20; ++i) payload += "joint arm j" + std::to_string(i) + "=1\n";
  LogStream::Options options;
  options.mtu_bytes = 100;
  const auto all = takeAll(open(written({{1s, payload}}), options));
  EXPECT_GT(all.size(), 2U);
  PacketTextDecoder decoder;
  SessionState state;
  for (const Sent& sent : all) {
    EXPECT_LE(sent.text.size(), 100U);
    EXPECT_EQ(state.apply(LogTime(1s), *decoder.decode(bytesOf(sent.text))), Applied::yes);
  }
  EXPECT_EQ(state.devices().at("arm").named_joints.size(), 20U);
}

/// Sends `log` three times and compares, at each `every`th packet, what a receiver that heard all
/// knows with the log's own state there; and at the end what one knows that heard only the last
/// part.
void expectSameItems(LogStream& stream, const std::filesystem::path& log, Nanoseconds turn,
                     LogTime from, std::uint64_t every) {
  Timeline timeline = Timeline::open(log).value();
  PacketTextDecoder decoder;
  SessionState heard;
  SessionState late;
  std::optional<Due> due = stream.due().value();
  LogTime last = from;
  std::uint64_t packets = 0;
  while (due) {
    const LogTime time = due->time;
    const std::string text(textOf(stream.take()));
    const Packet* packet = decoder.decode(bytesOf(text));
    ASSERT_NE(packet, nullptr);
    ASSERT_TRUE(packet->faults.empty()) << text;
    ASSERT_EQ(heard.apply(time, *packet), Applied::yes) << text;
    if (time >= from + 2 * turn + 3s) late.apply(time, *packet);
    last = time;
    due = stream.due().value();
    const LogTime in_log = from + (time - from) % turn;
    // Not while packets of the same moment are missing.
    if ((due && due->time == time) || ++packets % every != 0) continue;
    ASSERT_EQ(itemsOf(heard), itemsOf(**timeline.stateAt(in_log)))
        << (time - from).count() << " ns";
  }
  EXPECT_GT(last, from + 2 * turn + 6s);
  EXPECT_EQ(itemsOf(late), itemsOf(heard));
  for (const auto& [source, counts] : heard.counts()) {
    EXPECT_EQ(counts.gap, 0U);
    EXPECT_EQ(counts.restarts, 0U);
  }
}

TEST_F(LogStreamTest, WhoHearsAllHasTheItemsOfTheLogAtEachMomentOfEachTurn) {
  const auto log = std::filesystem::path(ROCINANTE_SOURCE_DIR) / "examples/demo/session.mcap";
  LogStream::Options options;
  options.turns = 3;
  options.restate = 2s;
  const LogTime origin = MultiLogReader::open({log}).value().origin();
  const PlayedSpan span{origin + 3s, origin + 13s};
  expectSameItems(open(log, options, span), log, span.until - span.from, span.from, 50);
}

TEST_F(LogStreamTest, SourcesThatShareADeviceDoNotUndoEachOther) {
  std::vector<test::WrittenMessage> messages;
  for (int i = 0; i < 100; ++i) {
    const std::string n = std::to_string(i);
    messages.push_back({i * 100ms, "RK1 a " + n + " -\njoints arm " + n + " 0\n", "/udp/1/a"});
    messages.push_back(
        {i * 100ms + 1ms, "RK1 b " + n + " -\njoint arm grip=" + n + "\n", "/udp/1/b"});
    if (i == 40)
      messages.push_back({i * 100ms + 1ms, "RK1 b 0 -\npose arm 1 2 3 0 0 0 1\n", "/udp/1/b"});
    if (i == 41) messages.push_back({i * 100ms + 1ms, "RK1 b 1 -\njoint rail x=1\n", "/udp/1/b"});
    if (i == 40) messages.push_back({i * 100ms + 2ms, "RK1 c 0 -\njoints rail 5\n", "/udp/1/c"});
    if (i == 50) messages.push_back({i * 100ms + 2ms, "RK1 c 1 -\nremove tray\n", "/udp/1/c"});
    if (i == 60) messages.push_back({i * 100ms + 2ms, "RK1 c 2 -\nadd tray box\n", "/udp/1/c"});
  }
  const auto log = written(messages);
  LogStream::Options options;
  options.turns = 3;
  options.restate = 1s;
  const PlayedSpan span{LogTime(0s), LogTime(10s)};
  expectSameItems(open(log, options, span), log, 10s, LogTime(0s), 1);
}

}  // namespace
}  // namespace rocinante
