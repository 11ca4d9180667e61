#include "recorder/diff/replay_diff.h"

#include <gmock/gmock.h>

#include "tests/core/log/log_support.h"

namespace rocinante::test {
namespace {

using testing::HasSubstr;

struct SentMessage {
  std::int64_t time_ms;
  std::string source;  ///< empty: of none
  std::string payload;
  std::string port = "5000";
};

Bytes recordingOf(const std::vector<SentMessage>& messages) {
  Bytes file;
  LogWriter writer = makeWriter(file, {});
  std::map<std::string, ChannelId> channels;
  std::uint32_t sequence = 0;
  for (const SentMessage& each : messages) {
    const std::string topic =
        "/udp/" + each.port + "/" + (each.source.empty() ? "127.0.0.1" : each.source);
    if (!channels.contains(topic)) {
      std::map<std::string, std::string> metadata;
      if (!each.source.empty()) metadata["source"] = each.source;
      channels[topic] = *writer.addChannel(topic, "octets", metadata);
    }
    EXPECT_TRUE(writer
                    .write(channels[topic], sequence++, at(each.time_ms * 1'000'000), 0,
                           bytesOf(each.payload))
                    .ok());
  }
  EXPECT_TRUE(writer.close("finished").ok());
  return file;
}

ReplayOptions optionsOf(const char* speed, const std::vector<std::string>& maps = {}) {
  ReplayOptions options;
  options.speed = *PlaybackSpeed::parse(speed);
  for (const std::string& map : maps) options.maps.push_back(*RouteMap::parse(map));
  return options;
}

ReplayDiff replayOf(const std::vector<SentMessage>& a, const std::vector<SentMessage>& b,
                    const ReplayOptions& options = {}) {
  const Bytes file_a = recordingOf(a);
  const Bytes file_b = recordingOf(b);
  LogReader reader_a = openLog(file_a);
  LogReader reader_b = openLog(file_b);
  Result<ReplayDiff> diff = diffReplay(reader_a, reader_b, options);
  EXPECT_TRUE(diff.ok()) << diff.error().text();
  return std::move(*diff);
}

std::vector<SentMessage> twoSources(int count) {
  std::vector<SentMessage> messages;
  for (int i = 0; i < count; ++i) {
    messages.push_back({1000 + i * 40, i % 3 == 0 ? "arm" : "gantry", std::to_string(i)});
  }
  return messages;
}

/// The same messages replayed: another port, another start, `speed` times as fast.
std::vector<SentMessage> played(std::vector<SentMessage> messages, int speed) {
  const std::int64_t begin = messages.front().time_ms;
  for (SentMessage& each : messages) {
    each.time_ms = 70'000 + (each.time_ms - begin) / speed;
    each.port = "7000";
  }
  return messages;
}

TEST(ReplayDiff, AnotherPortAnotherDayAndAnotherSpeedAreTheSameReplay) {
  const std::vector<SentMessage> session = twoSources(60);
  const ReplayDiff diff = replayOf(session, played(session, 4), optionsOf("4"));
  EXPECT_TRUE(diff.same());
  EXPECT_EQ(diff.stream_a, diff.stream_b);
  ASSERT_EQ(diff.sources.size(), 2U);
  EXPECT_EQ(diff.sources[0].source, "arm");
  EXPECT_EQ(diff.sources[0].same, 20U);
  EXPECT_EQ(diff.sources[1].same, 40U);
  for (const ReplaySource& source : diff.sources) EXPECT_EQ(source.error_max_us, 0U);
  EXPECT_FALSE(diff.otherSpeed());
  EXPECT_THAT(replayText(diff), HasSubstr("replay   the same\n"));
}

TEST(ReplayDiff, AnotherSpeedThanWasSaidIsToldAndDecidesNothingByItself) {
  const std::vector<SentMessage> session = twoSources(60);
  ReplayOptions options;
  const ReplayDiff diff = replayOf(session, played(session, 4), options);
  EXPECT_TRUE(diff.same());
  EXPECT_TRUE(diff.otherSpeed());
  EXPECT_NEAR(*diff.measured_speed, 4, 0.01);
  EXPECT_GT(diff.sources[0].error_max_us, 1'000'000U);
  options.within = std::chrono::milliseconds(100);
  EXPECT_FALSE(replayOf(session, played(session, 4), options).same());
  options.speed = *PlaybackSpeed::parse("4");
  EXPECT_TRUE(replayOf(session, played(session, 4), options).same());
}

TEST(ReplayDiff, WhatIsMissingExtraChangedOrOutOfOrderIsCountedBySource) {
  const std::vector<SentMessage> session = twoSources(60);
  std::vector<SentMessage> replay = played(session, 1);
  std::swap(replay[3].payload, replay[9].payload);  // of the arm
  replay.erase(replay.begin() + 40);                // of the gantry
  replay.push_back({90'000, "arm", "one more", "7000"});
  replay.push_back({90'001, "", "nobody's", "7000"});
  const ReplayDiff diff = replayOf(session, replay);
  EXPECT_FALSE(diff.same());
  EXPECT_NE(diff.stream_a, diff.stream_b);
  ASSERT_EQ(diff.sources.size(), 3U);
  const ReplaySource& none = diff.sources[0];
  const ReplaySource& arm = diff.sources[1];
  const ReplaySource& gantry = diff.sources[2];
  EXPECT_EQ(none.extra, 1U);
  EXPECT_EQ(arm.missing, 0U);
  EXPECT_EQ(arm.extra, 1U);
  EXPECT_GT(arm.out_of_order, 0U);
  EXPECT_EQ(arm.same + arm.out_of_order, 20U);
  EXPECT_EQ(gantry.missing, 1U);
  EXPECT_EQ(gantry.extra, 0U);
  EXPECT_EQ(gantry.same, 39U);
  ASSERT_TRUE(gantry.first_a.has_value());
  EXPECT_EQ(gantry.first_a->payload, "40");
  EXPECT_THAT(replayText(diff), HasSubstr("replay   differs\n"));
  EXPECT_THAT(replayJson(diff), HasSubstr("\"out_of_order\": 2"));
}

TEST(ReplayDiff, MapsTellTwoPlacesOfOneSourceApart) {
  std::vector<SentMessage> session;
  for (int i = 0; i < 20; ++i) {
    session.push_back({i * 10, "arm", "a" + std::to_string(i), i % 2 == 0 ? "5000" : "5001"});
  }
  std::vector<SentMessage> replay = played(session, 1);
  for (std::size_t i = 0; i < replay.size(); ++i) replay[i].port = i % 2 == 0 ? "7000" : "7001";
  const ReplayOptions options = optionsOf("1", {"/udp/5001/*=127.0.0.1:7001"});
  const ReplayDiff diff = replayOf(session, replay, options);
  EXPECT_TRUE(diff.same());
  ASSERT_EQ(diff.sources.size(), 2U);
  EXPECT_EQ(diff.sources[1].to, "7001");
  EXPECT_EQ(diff.sources[1].same, 10U);
  // A message at the wrong place is missing in one and extra in the other.
  std::swap(replay[4].port, replay[5].port);
  const ReplayDiff wrong = replayOf(session, replay, options);
  EXPECT_FALSE(wrong.same());
  EXPECT_EQ(wrong.sources[0].missing, 1U);
  EXPECT_EQ(wrong.sources[1].extra, 1U);
}

TEST(ReplayDiff, TheFirstMessageMayBeMissing) {
  const std::vector<SentMessage> session = twoSources(60);
  std::vector<SentMessage> replay = played(session, 1);
  replay.erase(replay.begin());
  const ReplayDiff diff = replayOf(session, replay);
  EXPECT_EQ(diff.sources[0].missing, 1U);
  for (const ReplaySource& source : diff.sources) EXPECT_EQ(source.error_max_us, 0U);
}

}  // namespace
}  // namespace rocinante::test
