#include "core/log/octets_before.h"

#include <gtest/gtest.h>

#include "core/log/log_profile.h"

namespace rocinante {
namespace {

LogChannel channelOn(std::string topic, std::string encoding) {
  return {0, std::move(topic), std::move(encoding), {}};
}

LogMessage messageOn(const LogChannel& channel, std::uint32_t sequence, std::int64_t time_ns) {
  LogMessage message;
  message.channel = &channel;
  message.sequence = sequence;
  message.log_time = LogTime(Nanoseconds(time_ns));
  message.publish_time_ns = time_ns;
  return message;
}

const LogChannel kOctets = channelOn("/udp/1/10.0.0.1", "octets");
const LogChannel kPackets = channelOn("/rocinante/decoded/udp/1/10.0.0.1", "rk1");
const LogChannel kOthers = channelOn("/rocinante/decoded/udp/2/10.0.0.1", "rk1");

TEST(OctetsBefore, APacketFitsDirectlyBehindItsOctetsOnly) {
  OctetsBefore before;
  EXPECT_FALSE(before.take(messageOn(kPackets, 0, 5))) << "nothing is before it";
  EXPECT_TRUE(before.take(messageOn(kOctets, 0, 5)));
  EXPECT_TRUE(before.take(messageOn(kPackets, 0, 5)));
  EXPECT_FALSE(before.take(messageOn(kPackets, 0, 5))) << "octets have one packet";
  EXPECT_TRUE(before.take(messageOn(kOctets, 1, 6)));
  EXPECT_FALSE(before.take(messageOn(kPackets, 2, 6))) << "another sequence";
  EXPECT_TRUE(before.take(messageOn(kOctets, 1, 6)));
  EXPECT_FALSE(before.take(messageOn(kPackets, 1, 7))) << "another time";
  EXPECT_TRUE(before.take(messageOn(kOctets, 1, 6)));
  EXPECT_FALSE(before.take(messageOn(kOthers, 1, 6))) << "another topic";
}

TEST(OctetsBefore, MovesWithItsOwner) {
  OctetsBefore before;
  before.take(messageOn(kOctets, 3, 9));
  const OctetsBefore moved = std::move(before);
  EXPECT_TRUE(moved.areOf(messageOn(kPackets, 3, 9)));
}

TEST(LogChannels, TellWhoMadeThem) {
  EXPECT_TRUE(kPackets.decoded());
  EXPECT_TRUE(kPackets.folded());
  EXPECT_FALSE(kPackets.captured());
  EXPECT_FALSE(kPackets.received());
  EXPECT_TRUE(kOctets.received());
  EXPECT_FALSE(channelOn("/rocinante/decodedudp/1", "rk1").decoded());
  EXPECT_TRUE(channelOn("/rocinante/restated/udp/1/arm", "rk1").received());
  const LogChannel orphans = channelOn("/rocinante/restated/rocinante/decoded/udp/1", "rk1");
  EXPECT_TRUE(orphans.folded());
  EXPECT_FALSE(orphans.received());
  LogChannel imported = channelOn("/joint_states", "cdr");
  EXPECT_FALSE(imported.imported());
  imported.metadata["imported"] = "ros2";
  EXPECT_TRUE(imported.imported());
}

TEST(Profile, FindsTheCapturedTopic) {
  EXPECT_EQ(profile::capturedTopic("/udp/1/a"), "/udp/1/a");
  EXPECT_EQ(profile::capturedTopic("/rocinante/restated/udp/1/a"), "/udp/1/a");
  EXPECT_EQ(profile::capturedTopic("/rocinante/decoded/udp/1/a"), "/udp/1/a");
  EXPECT_EQ(profile::capturedTopic("/rocinante/restated/rocinante/decoded/udp/1/a"), "/udp/1/a");
  EXPECT_EQ(profile::capturedTopic("/rocinante/keyframe"), "/rocinante/keyframe");
  EXPECT_EQ(profile::capturedTopic("/rocinante/restated"), "/rocinante/restated");
}

}  // namespace
}  // namespace rocinante
