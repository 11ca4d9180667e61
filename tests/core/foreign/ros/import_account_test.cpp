// What an import makes no packets of is in its account, and messages that are compressed one by one
// are read (docs/decisions/034).

#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <random>

#include "core/foreign/ros/bag_import.h"
#include "core/foreign/ros/robot_description.h"
#include "core/log/import_record.h"
#include "core/mcap/writer.h"
#include "tests/core/foreign/ros/message_maker.h"
#include "tests/core/foreign/ros/ros_bags.h"
#include "tests/core/log/log_support.h"

namespace rocinante::ros::test {
namespace {

using rocinante::test::openLog;
using rocinante::test::readAll;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

constexpr const char* kMimicArm =
    "<robot name=\"arm\"><link name=\"base\"/><link name=\"upper\"/><link name=\"tool\"/>"
    "<joint name=\"a\" type=\"continuous\"><parent link=\"base\"/><child link=\"upper\"/></joint>"
    "<joint name=\"b\" type=\"continuous\"><parent link=\"upper\"/><child link=\"tool\"/>"
    "<mimic joint=\"a\"/></joint></robot>";

/// A message of a bag of a test.
struct Held {
  std::string topic, type, encoding = "cdr";
  Bytes payload;
  std::uint64_t time = 1;
};

/// An MCAP of these, in this order.
Bytes bagOfMessages(const std::vector<Held>& all) {
  Bytes out;
  Result<mcap::Writer> writer =
      mcap::Writer::start(makeMemorySink(out), mcap::WriterOptions{}, {"ros2", "test"});
  EXPECT_TRUE(writer.ok());
  std::map<std::string, std::uint16_t> channels;
  for (const Held& held : all) {
    const auto [found, is_new] =
        channels.emplace(held.topic, static_cast<std::uint16_t>(channels.size() + 1));
    if (is_new) {
      writer->addSchema({found->second, held.type, "ros2msg", {}});
      writer->addChannel({found->second, found->second, held.topic, held.encoding, {}});
    }
    mcap::Message message;
    message.channel_id = found->second;
    message.log_time = message.publish_time = held.time * 1'000'000'000;
    message.data = held.payload;
    EXPECT_TRUE(writer->write(message).ok());
  }
  EXPECT_TRUE(writer->finish().ok());
  return out;
}

struct AccountedImport {
  ImportReport report;
  Bytes log;

  /// The packets of the log, each as text.
  std::vector<std::string> packets() const {
    std::vector<std::string> texts;
    LogReader reader = openLog(log);
    for (const auto& message : readAll(reader)) {
      if (message.topic.starts_with("/rocinante/decoded/")) texts.push_back(message.payload);
    }
    return texts;
  }
};

AccountedImport importedFrom(const Bytes& bag, const Cell* cell = nullptr) {
  AccountedImport made;
  std::vector<std::unique_ptr<BagReader>> bags;
  Result<std::unique_ptr<BagReader>> reader = openMcapBytes(bag, "bag.mcap");
  EXPECT_TRUE(reader.ok());
  bags.push_back(std::move(*reader));
  ImportOptions options;
  options.cell = cell;
  Result<ImportReport> report =
      importBags(std::move(bags), makeMemorySink(made.log), "session", options);
  EXPECT_TRUE(report.ok());
  if (report) made.report = std::move(*report);
  return made;
}

std::vector<std::string> textsOf(const Account& account) {
  std::vector<std::string> texts;
  for (const LeftOut& one : account.leftOut()) texts.push_back(one.text());
  return texts;
}

class ImportAccount : public testing::Test {
 protected:
  ImportAccount() {
    Result<DescribedRobot> robot = robotOf(kMimicArm, {});
    EXPECT_TRUE(robot.ok());
    cell_ = std::move(robot->cell);
  }

  static Held joints(const std::string& topic, const std::vector<double>& positions,
                     const std::vector<double>& velocities = {}) {
    MessageMaker made(Kind::cdr_little);
    made.header(1, 0, "").strings({"a", "b"}).numbers(positions).numbers(velocities).numbers({});
    return {topic, "sensor_msgs/msg/JointState", "cdr", made.bytes(), 1};
  }
  static Held frames(const std::vector<TestTransform>& all) {
    return {"/tf", "tf2_msgs/msg/TFMessage", "cdr", transforms(Kind::cdr_little, all), 1};
  }

  Cell cell_;
};

TEST_F(ImportAccount, NamesTopicsWithoutPacketsAndWhy) {
  const AccountedImport made =
      importedFrom(bagOfMessages({joints("/joint_states", {1, 1}),
                                  {"/camera", "sensor_msgs/msg/Image", "cdr", Bytes(8), 2},
                                  {"/camera", "sensor_msgs/msg/Image", "cdr", Bytes(8), 3},
                                  {"/states", "foxglove.JointStates", "json", bytesIn("{}"), 4},
                                  {"/empty", "sensor_msgs/msg/JointState", "cdr",
                                   jointState(Kind::cdr_little, 1, {"a"}, {}), 5}}),
                   &cell_);
  EXPECT_THAT(textsOf(made.report.account),
              UnorderedElementsAre(
                  "1 topic `/camera` (2 messages of sensor_msgs/msg/Image, which do not become "
                  "packets)",
                  "1 topic `/states` (1 message of foxglove.JointStates as json, which do not "
                  "become packets)",
                  "1 topic `/empty` (1 message; the warnings of the import say why)",
                  "1 value `position` (of fixed and mimic joints, which the model moves; at "
                  "/joint_states)"));
  EXPECT_TRUE(made.report.lostNothing());
  // Programs that read the log later find it there.
  LogReader reader = openLog(made.log);
  const Account again = accountOfLines(importLeftOutOf(reader.metadata()));
  EXPECT_EQ(textsOf(again), textsOf(made.report.account));
  EXPECT_EQ(again.leftOut()[2].severity, Severity::warning);
  EXPECT_EQ(again.leftOut()[0].severity, Severity::note);
}

TEST_F(ImportAccount, CountsTheFieldsThatNoPacketSays) {
  MessageMaker odometry(Kind::cdr_little);
  odometry.header(3, 0, "odom").string("base").doubles({1, 0, 0, 0, 0, 0, 1});
  odometry.doubles(std::vector<double>(36, 0.1)).doubles({0, 0, 0, 0, 0, 2});
  odometry.doubles(std::vector<double>(36));
  const AccountedImport made =
      importedFrom(bagOfMessages({joints("/joint_states", {1, 1}, {0.1, 0.2}),
                                  joints("/joint_states", {1, 1}, {0.1, 0.2}),
                                  {"/odom", "nav_msgs/msg/Odometry", "cdr", odometry.bytes(), 2}}),
                   &cell_);
  const auto texts = textsOf(made.report.account);
  EXPECT_THAT(made.packets(), Contains(HasSubstr(".velocity=0.1")));
  EXPECT_THAT(texts,
              Contains("2 values `velocity` (of fixed and mimic joints, which the model moves; "
                       "the first at /joint_states)"));
  EXPECT_THAT(made.packets(), Contains(HasSubstr("signal arm odom.angular.z 2 rad/s\n")));
  EXPECT_THAT(texts, Contains("1 value `covariance` (packets have no covariances; at /odom)"));
}

TEST_F(ImportAccount, CountsTransformsThatMoveNothing) {
  const AccountedImport made =
      importedFrom(bagOfMessages({frames({{"map", "base", {1, 0, 0, 0, 0, 0, 1}},
                                          {"base", "upper", {0, 0, 1, 0, 0, 0, 1}},
                                          {"base", "lamp", {0, 0, 1, 0, 0, 0, 1}}})}),
                   &cell_);
  EXPECT_THAT(made.packets(), ElementsAre("RK1 decoded:ros:tf - 7\npose arm 1 0 0 0 0 0 1\n"));
  EXPECT_THAT(textsOf(made.report.account),
              ElementsAre("1 transform `arm` (of links within the device, which its joints move; "
                          "at upper)",
                          "1 transform `lamp` (no device's root, and nothing hangs on the frame)"));
}

TEST_F(ImportAccount, ThePrefixOfFramesIsThatOfTheFirst) {
  for (const std::string prefix : {"r1/", "/r1/", "fleet/r1/"}) {
    SCOPED_TRACE(prefix);
    const AccountedImport made = importedFrom(
        bagOfMessages({frames({{prefix + "odom", prefix + "base", {1, 2, 0, 0, 0, 0, 1}}}),
                       frames({{"map", "r2/base", {5, 0, 0, 0, 0, 0, 1}}})}),
        &cell_);
    EXPECT_THAT(made.packets(), ElementsAre("RK1 decoded:ros:tf - 7\npose arm 1 2 0 0 0 0 1\n"));
    EXPECT_THAT(textsOf(made.report.account),
                ElementsAre(HasSubstr("1 transform `r2/base` (the frame has another prefix than "
                                      "the first frame of arm")));
    EXPECT_EQ(made.report.account.leftOut()[0].severity, Severity::warning);
  }
}

TEST_F(ImportAccount, ADeviceThatThePrefixNamesIsMeant) {
  Cell two = cell_;
  CellDevice other = two.devices.front();
  other.name = "r2";
  two.devices.push_back(other);
  const AccountedImport made =
      importedFrom(bagOfMessages({frames({{"map", "fleet/r2/base", {1, 0, 0, 0, 0, 0, 1}},
                                          {"map", "fleet/arm/base", {2, 0, 0, 0, 0, 0, 1}},
                                          {"map", "fleet/r3/base", {3, 0, 0, 0, 0, 0, 1}}})}),
                   &two);
  EXPECT_THAT(made.packets(), ElementsAre("RK1 decoded:ros:tf - 7\npose r2 1 0 0 0 0 0 1\n"
                                          "pose arm 2 0 0 0 0 0 1\n"));
  EXPECT_THAT(textsOf(made.report.account), ElementsAre(HasSubstr("`fleet/r3/base`")));
}

/// A message of 256 bytes to 64 KiB as `--compression-mode message` stores it: a zstd frame with
/// its size, here of one block that is not compressed.
Bytes compressed(const Bytes& message) {
  Bytes frame = bytesIn("\x28\xb5\x2f\xfd\x60");
  mcap::appendNumber(frame, static_cast<std::uint16_t>(message.size() - 256));
  const auto head = static_cast<std::uint32_t>(message.size() << 3U | 1U);
  for (const unsigned shift : {0U, 8U, 16U}) {
    frame.push_back(static_cast<std::byte>(head >> shift & 0xFFU));
  }
  mcap::appendBytes(frame, message);
  return frame;
}

Bytes longJointState() {
  std::vector<std::string> names;
  for (int i = 0; i < 20; ++i) names.push_back("a_joint_with_a_long_name_" + std::to_string(i));
  return jointState(Kind::cdr_little, 1, names, std::vector<double>(20, 0.5));
}

TEST(CompressedMessages, BecomeWhatTheyWere) {
  const Bytes plain = longJointState();
  const std::string type = "sensor_msgs/msg/JointState";
  const AccountedImport expected =
      importedFrom(bagOfMessages({{"/joint_states", type, "cdr", plain, 1}}));
  const AccountedImport made =
      importedFrom(bagOfMessages({{"/joint_states", type, "cdr", compressed(plain), 1},
                                  {"/other", "my/msg/Own", "cdr", compressed(plain), 2},
                                  // Not a message of ROS: whatever it is stays as it is.
                                  {"/raw", "my.Own", "protobuf", compressed(plain), 3}}));
  EXPECT_TRUE(made.report.lostNothing());
  EXPECT_EQ(made.packets(), expected.packets());
  LogReader reader = openLog(made.log);
  std::vector<std::size_t> sizes;
  for (const auto& message : readAll(reader)) {
    if (!message.topic.starts_with("/rocinante/")) sizes.push_back(message.payload.size());
  }
  EXPECT_THAT(sizes, ElementsAre(plain.size(), plain.size(), compressed(plain).size()));
}

TEST(CompressedMessages, ThatLieAreDamage) {
  const Bytes frame = compressed(longJointState());
  Bytes cut = frame;
  cut.resize(cut.size() / 2);
  // A frame of one segment that claims 2^62 bytes, 200 MiB, and one.
  const auto claims = [&](std::uint64_t size) {
    Bytes lies = bytesIn("\x28\xb5\x2f\xfd\xe0");
    mcap::appendNumber(lies, size);
    lies.insert(lies.end(), frame.begin() + 7, frame.end());
    return lies;
  };
  for (const Bytes& bad : {cut, claims(std::uint64_t{1} << 62U), claims(200U << 20U), claims(1),
                           bytesIn("\x28\xb5\x2f\xfd")}) {
    const AccountedImport made = importedFrom(
        bagOfMessages({{"/joint_states", "sensor_msgs/msg/JointState", "cdr", bad, 1}}));
    EXPECT_EQ(made.report.messages, 1U);
    EXPECT_THAT(made.report.damage,
                ElementsAre(HasSubstr("1 message compressed with zstd not expanded")));
    EXPECT_FALSE(made.report.lostNothing());
  }
}

/// DESIGN's property: something unknown that is put in, or something used that is taken out,
/// changes the packets or the account.
TEST_F(ImportAccount, NoMutationIsSilent) {
  std::mt19937 random(20261128);
  const auto pick = [&](std::size_t below) { return random() % below; };
  const std::vector<Held> whole = {
      joints("/joint_states", {0.5, 1}),
      frames({{"map", "base", {1, 0, 0, 0, 0, 0, 1}}}),
      {"/plan", "visualization_msgs/msg/Marker", "cdr",
       marker(Kind::cdr_little, {.frame = "tool", .points = {0, 0, 0, 1, 0, 0}}), 2}};
  const AccountedImport before = importedFrom(bagOfMessages(whole), &cell_);
  ASSERT_EQ(before.packets().size(), 3U);
  for (int round = 0; round < 300; ++round) {
    std::vector<Held> mutated = whole;
    const std::size_t kind = pick(8);
    const auto at = mutated.begin() + static_cast<std::ptrdiff_t>(pick(mutated.size()));
    switch (kind) {
      case 0:  // a topic of a type that nobody knows
        mutated.insert(at,
                       {"/x" + std::to_string(pick(9)), "my/msg/Own", "cdr", Bytes(pick(30)), 1});
        break;
      case 1:  // one that is known, in an encoding that is not read
        mutated.insert(at, {"/x", "sensor_msgs/msg/JointState", "json", bytesIn("{}"), 1});
        break;
      case 2:
        mutated.erase(at);
        break;
      case 3:
        mutated[0] = joints("/joint_states", {0.5, 1}, {1, 1});
        break;
      case 4:
        mutated[0] = joints("/joint_states", {std::nan(""), 1});
        break;
      case 5:  // a frame that nothing hangs on
        mutated[1] = frames({{"map", "base", {1, 0, 0, 0, 0, 0, 1}},
                             {pick(2) == 0 ? "map" : "tool",
                              "f" + std::to_string(pick(9)),
                              {1, 0, 0, 0, 0, 0, 1}}});
        break;
      case 6:  // a shape that is not drawn
        mutated.push_back({"/plan", "visualization_msgs/msg/Marker", "cdr",
                           marker(Kind::cdr_little, {.id = 9, .type = 1}), 3});
        break;
      default:  // a message that is cut, or followed by something
        if (pick(2) == 0) {
          at->payload.resize(pick(at->payload.size()));
        } else {
          at->payload.resize(at->payload.size() + 4 + pick(9));
        }
    }
    const AccountedImport after = importedFrom(bagOfMessages(mutated), &cell_);
    const bool is_told = textsOf(after.report.account) != textsOf(before.report.account) ||
                         importWarnings(after.report) != importWarnings(before.report);
    EXPECT_TRUE(is_told || after.packets() != before.packets()) << "mutation of kind " << kind;
  }
}

TEST_F(ImportAccount, MessagesOfEqualStampsKeepTheOrderOfTheFile) {
  std::vector<Held> all;
  for (int i = 0; i < 5; ++i) all.push_back(joints("/joint_states", {0.125 * i, 0}));
  const AccountedImport made = importedFrom(bagOfMessages(all), &cell_);
  const auto packets = made.packets();
  ASSERT_EQ(packets.size(), 5U);
  EXPECT_THAT(packets.front(), HasSubstr("a=0\n"));
  EXPECT_THAT(packets.back(), HasSubstr("a=0.5\n"));
}

}  // namespace
}  // namespace rocinante::ros::test
