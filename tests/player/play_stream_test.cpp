#include "player/play_stream.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/packet/packet_text.h"
#include "tests/player/written_log.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using test::WrittenMessage;
using testing::ElementsAre;

struct Sent {
  Due due;
  std::string payload;
};

std::vector<Sent> takeAll(PlayStream& stream, std::size_t most = 1'000) {
  std::vector<Sent> all;
  while (all.size() < most) {
    const auto due = stream.due().value();
    if (!due) break;
    all.push_back({*due, std::string(textOf(stream.take()))});
  }
  return all;
}

std::vector<std::string> playedPayloads(const std::vector<Sent>& all) {
  std::vector<std::string> played;
  for (const Sent& sent : all) {
    if (!sent.due.restated) played.push_back(sent.payload);
  }
  return played;
}

class PlayStreamTest : public testing::Test {
 protected:
  LogMerge open(const std::vector<WrittenMessage>& messages) {
    return LogMerge::open({test::writeLog(folder_ / "log", messages)}).value();
  }
  test::TemporaryFolder folder_;
};

PlayStream::Options spanOf(Nanoseconds from, Nanoseconds until, std::uint32_t turns = 1) {
  PlayStream::Options options;
  options.span = {LogTime(from), LogTime(until)};
  options.turns = turns;
  return options;
}

TEST_F(PlayStreamTest, PlaysASpanHalfOpen) {
  auto logs = open({{1s, "a"}, {2s, "b"}, {3s, "c"}, {4s, "d"}});
  auto options = spanOf(2s, 4s);
  options.restate = false;
  auto stream = PlayStream::open(logs, options).value();
  const auto all = takeAll(stream);
  EXPECT_THAT(playedPayloads(all), ElementsAre("b", "c"));
  EXPECT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].due.time, LogTime(2s));
}

TEST_F(PlayStreamTest, EveryTurnLiesOneSpanLaterAndSaysTheStateFirst) {
  auto logs = open({{1s, "RK1 a - -\nadd arm m\n"}, {2s, "RK1 a - -\njoints arm 1\n"}});
  auto stream = PlayStream::open(logs, spanOf(1s, 3s, 3)).value();
  const auto all = takeAll(stream);
  ASSERT_EQ(all.size(), 9U);
  for (std::uint32_t turn = 0; turn < 3; ++turn) {
    EXPECT_TRUE(all[turn * 3].due.restated);
    EXPECT_NE(all[turn * 3].payload.find("reset"), std::string::npos);
    EXPECT_NE(all[turn * 3].payload.find("by=play"), std::string::npos);
    for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(all[turn * 3 + i].due.span, turn);
    EXPECT_EQ(all[turn * 3 + 1].due.time, LogTime(1s + turn * 2s));
    EXPECT_EQ(all[turn * 3 + 2].due.time, LogTime(2s + turn * 2s));
  }
}

TEST_F(PlayStreamTest, EndlessTurnsGoOn) {
  auto logs = open({{1s, "a"}, {2s, "b"}});
  auto options = spanOf(1s, 2s + 1ns, 0);
  options.restate = false;
  auto stream = PlayStream::open(logs, options).value();
  EXPECT_EQ(takeAll(stream).size(), 1'000U);
}

TEST_F(PlayStreamTest, TheFirstRestatementLiesAhead) {
  auto logs = open({{1s, "RK1 a - -\nadd arm m\n"}});
  auto options = spanOf(1s, 3s, 2);
  options.restate_ahead = 5ms;
  auto stream = PlayStream::open(logs, options).value();
  const auto all = takeAll(stream);
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all[0].due.time, LogTime(1s - 5ms));
  EXPECT_EQ(all[2].due.time, LogTime(3s));
}

TEST_F(PlayStreamTest, EverySourceIsResetEvenOneThatSpeaksLater) {
  auto logs = open(
      {{1s, "RK1 a - -\nadd arm m\n", "/udp/1/a"}, {5s, "RK1 b - -\nadd hand m\n", "/udp/1/b"}});
  auto stream = PlayStream::open(logs, spanOf(1s, 9s)).value();
  const auto all = takeAll(stream);
  ASSERT_EQ(all.size(), 4U);
  EXPECT_TRUE(all[0].due.restated && all[1].due.restated);
  EXPECT_TRUE(all[0].payload.starts_with("RK1 a - - "));
  EXPECT_TRUE(all[1].payload.starts_with("RK1 b - - "));
}

/// What a receiver shows after hearing `packets`; when is not compared, since it heard them later.
SessionState foldAll(const std::vector<std::string>& packets) {
  SessionState state;
  PacketTextDecoder decoder;
  for (const std::string& text : packets) {
    const Packet* packet = decoder.decode(bytesOf(text));
    EXPECT_NE(packet, nullptr);
    if (packet != nullptr) state.apply(LogTime{}, *packet);
  }
  return state;
}

TEST_F(PlayStreamTest, FromTheMiddleAReceiverSeesWhatItWouldHaveSeen) {
  const std::vector<std::string> packets{"RK1 a@r 0 1\nadd arm m\norder arm x y\njoints arm 1 2\n",
                                         "RK1 b@q 7 2\nadd hand n\npose hand 1 2 3 0 0 0 1 in "
                                         "arm/tip\nline plan #ff0000 0 0 0 1 1 1\n",
                                         "RK1 a@r 1 3\njoints arm 3 4\ncolor arm #00ff00\n",
                                         "RK1 b@q 8 4\nerase plan\nhide hand\n",
                                         "RK1 a@r 2 5\njoints arm 5 6\n"};
  std::vector<WrittenMessage> messages;
  for (std::size_t i = 0; i < packets.size(); ++i) {
    messages.push_back({(static_cast<int>(i) + 1) * 1s, packets[i],
                        packets[i][4] == 'a' ? "/udp/1/a" : "/udp/1/b"});
  }
  auto logs = open(messages);
  for (int from = 1; from <= 5; ++from) {
    SCOPED_TRACE(from);
    auto stream = PlayStream::open(logs, spanOf(from * 1s, 9s)).value();
    // Somebody who listened before the player went back to an earlier moment.
    std::vector<std::string> heard = packets;
    for (const Sent& sent : takeAll(stream)) heard.push_back(sent.payload);
    EXPECT_EQ(foldAll(heard).identityText(), foldAll(packets).identityText());
    // And right after the restatement alone.
    std::vector<std::string> early = packets;
    auto again = PlayStream::open(logs, spanOf(from * 1s, 9s)).value();
    for (const Sent& sent : takeAll(again)) {
      if (sent.due.restated) early.push_back(sent.payload);
    }
    const std::vector<std::string> before(packets.begin(), packets.begin() + from - 1);
    const SessionState seen = foldAll(early);
    const SessionState wanted = foldAll(before);
    EXPECT_EQ(seen.drawings(), wanted.drawings());
    EXPECT_EQ(seen.visibility(), wanted.visibility());
    EXPECT_EQ(seen.colors(), wanted.colors());
    for (const auto& [name, device] : wanted.devices()) {
      ASSERT_TRUE(seen.devices().contains(name));
      EXPECT_EQ(seen.devices().at(name), device);
    }
    for (const auto& [name, device] : seen.devices()) {
      if (!wanted.devices().contains(name)) {
        EXPECT_FALSE(device.presence || device.pose || device.joints);
      }
    }
  }
}

TEST_F(PlayStreamTest, OctetsHaveNothingToRestate) {
  auto logs = open({{1s, std::string("\x01\x00\xff", 3)}, {2s, "plain"}});
  const auto before = stateBefore(logs, LogTime(9s)).value();
  EXPECT_TRUE(before.state.devices().empty());
  auto stream = PlayStream::open(logs, spanOf(1s, 9s)).value();
  EXPECT_THAT(playedPayloads(takeAll(stream)),
              ElementsAre(std::string("\x01\x00\xff", 3), "plain"));
}

}  // namespace
}  // namespace rocinante
