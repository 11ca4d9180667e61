#include "core/foreign/ros/bag_import.h"

#include <gmock/gmock.h>

#include "core/log/import_record.h"
#include "core/log/log_profile.h"
#include "core/mcap/lz4_frame.h"
#include "core/mcap/writer.h"
#include "core/session/keyframe.h"
#include "core/session/message_folder.h"
#include "tests/core/foreign/ros/message_maker.h"
#include "tests/core/foreign/ros/ros_bags.h"
#include "tests/core/session/session_support.h"
#include "tests/support/shared_data.h"

namespace rocinante::ros::test {
namespace {

using rocinante::test::KeptMessage;
using rocinante::test::openLog;
using rocinante::test::readAll;
using rocinante::test::sharedData;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// An MCAP as rosbag2 writes it: a joint state every millisecond from one second on, a topic that
/// nobody knows, and one that looks like our own.
Bytes ros2Bag(std::size_t messages) {
  Bytes out;
  Result<mcap::Writer> writer =
      mcap::Writer::start(makeMemorySink(out), mcap::WriterOptions{}, {"ros2", "test"});
  EXPECT_TRUE(writer.ok());
  writer->addSchema({1, "sensor_msgs/msg/JointState", "ros2msg", bytesIn("float64[] position")});
  writer->addChannel({1, 1, "/joint_states", "cdr", {{"offered_qos_profiles", "- depth: 1"}}});
  writer->addChannel({2, 0, "/camera", "cdr", {}});
  writer->addChannel({3, 0, "/rocinante/loss", "json", {}});
  for (std::size_t i = 0; i < messages; ++i) {
    const Bytes payload =
        jointState(Kind::cdr_little, 1, {"a", "b"}, {0.25 * static_cast<double>(i), -1});
    mcap::Message message;
    message.channel_id = i % 10 == 3 ? 2 : i % 10 == 7 ? 3 : 1;
    message.sequence = static_cast<std::uint32_t>(i);
    message.log_time = 1'000'000'000 + i * 1'000'000;
    message.publish_time = message.log_time - 5;
    message.data = payload;
    EXPECT_TRUE(writer->write(message).ok());
  }
  EXPECT_TRUE(writer->finish().ok());
  return out;
}

struct Imported {
  ImportReport report;
  Bytes log;
};

Result<Imported> imported(std::unique_ptr<BagReader> bag, const ImportOptions& options = {}) {
  Imported made;
  std::vector<std::unique_ptr<BagReader>> bags;
  bags.push_back(std::move(bag));
  Result<ImportReport> report =
      importBags(std::move(bags), makeMemorySink(made.log), "session", options);
  if (!report) return report.error();
  made.report = std::move(*report);
  return made;
}

const LogChannel& channelOf(const LogReader& reader, std::string_view topic) {
  for (const LogChannel& channel : reader.channels()) {
    if (channel.topic == topic) return channel;
  }
  ADD_FAILURE() << "no channel " << topic;
  return reader.channels().front();
}

TEST(BagImport, KeepsEveryMessageAndPutsItsPacketBehindIt) {
  const Bytes bag = ros2Bag(20);
  LogReader original = openLog(bag);
  const std::vector<KeptMessage> before = readAll(original);
  Result<Imported> made = imported(*openMcapBytes(bag, "bag.mcap"));
  ASSERT_TRUE(made.ok()) << made.error().text();
  EXPECT_TRUE(made->report.lostNothing());
  EXPECT_EQ(made->report.messages, 20U);
  EXPECT_EQ(made->report.packets, 16U);
  LogReader reader = openLog(made->log);
  EXPECT_TRUE(reader.summary().complete);
  EXPECT_EQ(reader.summary().messages, 20U);
  std::size_t next = 0;
  const KeptMessage* last = nullptr;
  for (const KeptMessage& message : readAll(reader)) {
    if (message.topic == profile::kKeyframeTopic) continue;
    if (message.topic.starts_with(profile::kDecodedPrefix)) {
      ASSERT_NE(last, nullptr);
      EXPECT_EQ(message.topic, "/rocinante/decoded" + last->topic);
      EXPECT_EQ(message.log_time_ns, last->log_time_ns);
      EXPECT_EQ(message.publish_time_ns, last->publish_time_ns);
      EXPECT_EQ(message.sequence, last->sequence);
      EXPECT_THAT(message.payload, HasSubstr("joint robot a="));
      last = nullptr;
      continue;
    }
    KeptMessage expected = before[next++];
    if (expected.topic == "/rocinante/loss") expected.topic = "/imported/rocinante/loss";
    EXPECT_EQ(message, expected);
    last = &before[next - 1];
  }
  EXPECT_EQ(next, before.size());
  const LogChannel& joints = channelOf(reader, "/joint_states");
  EXPECT_EQ(joints.encoding, "cdr");
  EXPECT_EQ(joints.metadata.at("imported"), "ros2-mcap");
  EXPECT_EQ(joints.metadata.at("offered_qos_profiles"), "- depth: 1");
  ASSERT_NE(joints.schema, nullptr);
  EXPECT_EQ(joints.schema->name, "sensor_msgs/msg/JointState");
  EXPECT_EQ(joints.schema->data, bytesIn("float64[] position"));
  EXPECT_EQ(channelOf(reader, "/camera").schema, nullptr);
}

TEST(BagImport, TheStateIsThatOfThePacketsWithKeyframes) {
  ImportOptions options;
  options.keyframes.packets = 50;
  Result<Imported> made = imported(*openMcapBytes(ros2Bag(2000), "bag.mcap"), options);
  ASSERT_TRUE(made.ok());
  LogReader reader = openLog(made->log);
  MessageFolder folder;
  SessionState state;
  std::size_t keyframes = 0;
  KeyframeReader keyframe_reader;
  while (true) {
    const Result<std::optional<LogMessage>> message = reader.next();
    ASSERT_TRUE(message.ok());
    if (!*message) break;
    if (isKeyframeChannel(*(*message)->channel)) {
      ++keyframes;
      const Result<SessionState> told =
          keyframe_reader.read((*message)->payload, (*message)->log_time);
      ASSERT_TRUE(told.ok());
      EXPECT_TRUE(told->sameAs(state));
      continue;
    }
    folder.fold(state, **message);
  }
  EXPECT_GT(keyframes, 3U);
  EXPECT_THAT(state.identityText(),
              HasSubstr("item decoded:ros:joint_states joint robot a=499.75\n"));
}

TEST(BagImport, ReadsRos1BagsInOrderOfTime) {
  const Bytes connection = bagConnection(4, "/arm/joint_states", "sensor_msgs/JointState");
  Bytes records = connection;
  for (const std::uint32_t second : {5U, 3U}) {
    mcap::appendBytes(records, bagMessage(4, second, jointState(Kind::ros1, 1, {"a"}, {0.5})));
  }
  const Bytes bag = bagOf(records, connection, "none", records);
  Result<Imported> made = imported(*openRos1Bytes(bag, "a.bag"));
  ASSERT_TRUE(made.ok()) << made.error().text();
  EXPECT_THAT(made->report.damage, IsEmpty());
  LogReader reader = openLog(made->log);
  const std::vector<KeptMessage> messages = readAll(reader);
  ASSERT_THAT(messages, SizeIs(4));
  EXPECT_EQ(messages[0].log_time_ns, 3'000'000'000);
  EXPECT_EQ(messages[1].payload, "RK1 decoded:ros:arm:joint_states - 1.5\njoint arm a=0.5\n");
  EXPECT_EQ(messages[2].log_time_ns, 5'000'000'000);
  EXPECT_EQ(messages[2].sequence, 1U);
  EXPECT_EQ(channelOf(reader, "/arm/joint_states").schema->encoding, "ros1msg");
}

TEST(BagImport, TellsWhereABagWasCut) {
  const Bytes connection = bagConnection(4, "/joint_states", "sensor_msgs/JointState");
  Bytes records = connection;
  mcap::appendBytes(records, bagMessage(4, 3, jointState(Kind::ros1, 1, {"a"}, {0.5})));
  const Bytes bag = bagOf(records, connection, "none", records);
  const std::size_t chunk_end = bag.size() - connection.size();
  for (std::size_t length = 0; length < bag.size(); ++length) {
    SCOPED_TRACE(length);
    const Bytes cut = rocinante::test::cutAt(bag, length);
    Result<std::unique_ptr<BagReader>> reader = openRos1Bytes(cut, "a.bag");
    if (!reader) continue;
    std::size_t messages = 0;
    while (*(*reader)->next()) ++messages;
    EXPECT_EQ(messages, length < chunk_end ? 0U : 1U);
    EXPECT_FALSE((*reader)->damage().empty());
  }
}

TEST(BagImport, ReadsARos1ChunkUpToWhereItWasCut) {
  const Bytes connection = bagConnection(4, "/joint_states", "sensor_msgs/JointState");
  Bytes records = connection;
  for (std::uint32_t second = 1; second <= 3; ++second) {
    mcap::appendBytes(records, bagMessage(4, second, jointState(Kind::ros1, 1, {"a"}, {0.5})));
  }
  const Bytes bag = bagOf(records, connection, "none", records);
  const Bytes cut = rocinante::test::cutAt(bag, bag.size() - connection.size() - 1);
  Result<Imported> made = imported(*openRos1Bytes(cut, "a.bag"));
  ASSERT_TRUE(made.ok()) << made.error().text();
  EXPECT_EQ(made->report.packets, 2U);
  EXPECT_FALSE(made->report.lostNothing());
}

TEST(BagImport, NamesTheZerosAndTheRestThatAreNoRecords) {
  const Bytes connection = bagConnection(4, "/joint_states", "sensor_msgs/JointState");
  Bytes records = connection;
  mcap::appendBytes(records, bagMessage(4, 3, jointState(Kind::ros1, 1, {"a"}, {0.5})));
  const Bytes closed = bagOf(records, connection, "none", records);
  Bytes killed(closed.begin(), closed.end() - static_cast<std::ptrdiff_t>(connection.size()));
  // As it was written first: the bag has no index yet.
  const std::size_t index = textOf(killed).find("index_pos=") + 10;
  std::fill_n(killed.begin() + static_cast<std::ptrdiff_t>(index), 8, std::byte{0});
  const std::string place = "(a.bag, byte " + std::to_string(killed.size()) + ")";
  const auto damageWith = [&](std::size_t zeros, std::byte last) {
    Bytes bag = killed;
    bag.resize(bag.size() + zeros);
    bag.push_back(last);
    Result<Imported> made = imported(*openRos1Bytes(bag, "a.bag"));
    EXPECT_EQ(made->report.packets, 1U);
    return made->report.damage.back();
  };
  EXPECT_EQ(damageWith(4095, std::byte{0}),
            "no records follow: the last 4096 bytes of the bag are zeros " + place);
  EXPECT_EQ(
      damageWith(99, std::byte{7}),
      "the bag ends inside a record, or its lengths are wrong: 100 bytes are not read " + place);
}

TEST(BagImport, SaysWhatACutBagWithoutAMessageLacks) {
  const Bytes connection = bagConnection(4, "/joint_states", "sensor_msgs/JointState");
  const Bytes bag = bagOf(connection, connection, "lz4", connection);
  const Bytes cut = rocinante::test::cutAt(bag, bag.size() - connection.size() - 1);
  const Result<Imported> made = imported(*openRos1Bytes(cut, "a.bag"));
  ASSERT_FALSE(made.ok());
  EXPECT_NE(made.error().text().find("the bag has no index: it was not closed"), std::string::npos)
      << made.error().text();
}

TEST(BagImport, ReadsRos1ChunksOfLz4) {
  if (!mcap::canExpandLz4()) GTEST_SKIP() << "this build has no liblz4";
  const Bytes connection = bagConnection(4, "/joint_states", "sensor_msgs/JointState");
  Bytes records = connection;
  mcap::appendBytes(records, bagMessage(4, 3, jointState(Kind::ros1, 1, {"a"}, {0.5})));
  // A frame of LZ4: magic, flags and block size with their checksum, one stored block, end mark.
  Bytes frame;
  for (const int byte : {0x04, 0x22, 0x4D, 0x18, 0x60, 0x40, 0x82}) {
    frame.push_back(static_cast<std::byte>(byte));
  }
  mcap::appendNumber(frame, static_cast<std::uint32_t>(records.size()) | 0x8000'0000U);
  mcap::appendBytes(frame, records);
  mcap::appendNumber(frame, std::uint32_t{0});
  Result<Imported> made =
      imported(*openRos1Bytes(bagOf(records, connection, "lz4", frame), "a.bag"));
  ASSERT_TRUE(made.ok()) << made.error().text();
  EXPECT_TRUE(made->report.lostNothing());
  EXPECT_EQ(made->report.packets, 1U);
}

TEST(BagImport, TellsWhereAnMcapBagWasCut) {
  const Bytes bag = ros2Bag(3);
  for (std::size_t length = 0; length < bag.size(); ++length) {
    SCOPED_TRACE(length);
    const Bytes cut = rocinante::test::cutAt(bag, length);
    Result<std::unique_ptr<BagReader>> reader = openMcapBytes(cut, "bag.mcap");
    if (!reader) continue;
    std::size_t messages = 0;
    while (true) {
      const auto message = (*reader)->next();
      if (!message.ok() || !*message) break;
      ++messages;
    }
    // The messages of a cut chunk are read as far as they are whole.
    EXPECT_LE(messages, 3U);
    const Result<Imported> made = imported(*openMcapBytes(cut, "bag.mcap"));
    EXPECT_EQ(made.ok(), messages > 0);
    if (made.ok()) {
      EXPECT_EQ(made->report.messages, messages);
    }
  }
}

TEST(BagImport, RefusesChunksThatLie) {
  const Bytes connection = bagConnection(4, "/joint_states", "sensor_msgs/JointState");
  for (const char* const compression : {"none", "lz4", "bz2", "rar"}) {
    Bytes bag = bagOf(Bytes(1000), connection, compression, bytesIn("no such frame"));
    Result<std::unique_ptr<BagReader>> reader = openRos1Bytes(bag, "a.bag");
    ASSERT_TRUE(reader.ok());
    EXPECT_FALSE((*(*reader)->next()).has_value());
    EXPECT_THAT((*reader)->damage(), SizeIs(1));
  }
}

TEST(BagImport, NothingToImportIsAnError) {
  const Result<Imported> made = imported(*openMcapBytes(ros2Bag(0), "bag.mcap"));
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().kind, ErrorKind::not_found);
}

TEST(BagImport, NamesWhatTheReaderLeftOut) {
  ImportReport report;
  EXPECT_THAT(importWarnings(report), IsEmpty());
  report.account.leaveOut({.kind = "column",
                           .name = "note",
                           .reason = "text",
                           .first = "t.csv:1",
                           .count = 1,
                           .severity = Severity::note});
  EXPECT_THAT(importWarnings(report), IsEmpty());
  EXPECT_TRUE(report.lostNothing());
  EXPECT_EQ(accountSentence(accountOfLines(importLeftOutOf({warningsRecord(report)}))),
            "left out: 1 column `note` (text; at t.csv:1)");
}

TEST(BagImport, OurOwnLogsAreNoBags) {
  Bytes log;
  {
    SessionWriter session = rocinante::test::makeSession(log, {});
    const ChannelId channel = *session.addChannel("/udp/1/a", "rk1", {});
    ASSERT_TRUE(session.write(channel, 0, rocinante::test::at(5), 5, bytesOf("RK1 a 1 -\n")).ok());
    ASSERT_TRUE(session.log().close("end").ok());
  }
  const Result<std::unique_ptr<BagReader>> bag = openMcapBytes(log, "log.mcap");
  ASSERT_FALSE(bag.ok());
  EXPECT_THAT(bag.error().what, HasSubstr("is a log already"));
}

TEST(BagImport, ReadsRealBags) {
  ROCINANTE_NEEDS_SHARED_DATA("bags");
  struct Case {
    const char* file;
    std::uint64_t messages, packets;
  };
  // Counted with sqlite3, @mcap/core and by the chunk infos of the ROS 1 bag.
  const Case cases[] = {
      {"rosbag2_test_0.db3", 4695, 4695},
      {"topics_and_services.db3", 13, 0},
      {"multiple_files_1.mcap", 1324, 1324},
      {"fake_joint_state.bag", 2725, 2725},
  };
  for (const Case& each : cases) {
    SCOPED_TRACE(each.file);
    Result<std::unique_ptr<BagReader>> bag = openBag(sharedData("bags") / each.file);
    if (!bag && bag.error().kind == ErrorKind::unsupported) continue;
    ASSERT_TRUE(bag.ok()) << bag.error().text();
    Result<Imported> made = imported(std::move(*bag));
    ASSERT_TRUE(made.ok()) << made.error().text();
    EXPECT_EQ(made->report.messages, each.messages);
    EXPECT_EQ(made->report.packets, each.packets);
    EXPECT_TRUE(made->report.lostNothing());
    EXPECT_EQ(openLog(made->log).summary().messages, each.messages);
  }
}

}  // namespace
}  // namespace rocinante::ros::test
