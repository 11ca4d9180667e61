#include "core/foreign/ros/ros_translator.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "core/base/atomic_file.h"
#include "core/foreign/ros/robot_description.h"
#include "core/packet/packet_text.h"
#include "tests/core/foreign/ros/message_maker.h"

namespace rocinante::ros::test {
namespace {

using Outcome = RosTranslator::Outcome;
using testing::Contains;
using testing::Key;

constexpr Kind kKinds[] = {Kind::cdr_little, Kind::cdr_big, Kind::cdr2_little, Kind::ros1};

constexpr const char* kArm =
    "<robot name=\"arm\"><link name=\"base\"/><link name=\"upper\"/><link name=\"tool\"/>"
    "<joint name=\"a\" type=\"continuous\"><parent link=\"base\"/><child link=\"upper\"/></joint>"
    "<joint name=\"b\" type=\"continuous\"><parent link=\"upper\"/><child link=\"tool\"/>"
    "<mimic joint=\"a\"/></joint></robot>";

/// What one message became; "" when nothing, "malformed" when it is.
class Translation {
 public:
  explicit Translation(const Cell* cell = nullptr, std::string device = "")
      : devices_(cell, std::move(device)), translator_(devices_) {}

  std::string of(std::string_view topic, MessageType type, const Bytes& message,
                 FieldCursor::Layout layout = FieldCursor::Layout::cdr, std::int64_t time_s = 0) {
    const auto key = std::pair(std::string(topic), layout);
    if (!topics_.contains(key)) topics_[key] = translator_.addTopic(topic, type, layout);
    Translated made;
    const LogTime time{std::chrono::seconds(time_s)};
    switch (translator_.translate(topics_[key], time, message, made)) {
      case Outcome::malformed:
        return "malformed";
      case Outcome::nothing:
        return "";
      case Outcome::packet:
        break;
    }
    if (made.packet != nullptr) expectSame(made);
    PacketTextDecoder decoder;
    const Packet* const packet = decoder.decode(bytesOf(made.text));
    EXPECT_TRUE(packet != nullptr && packet->faults.empty()) << made.text;
    return std::string(made.text);
  }

  const TranslationNotes& notes(std::string_view topic, FieldCursor::Layout layout) {
    return translator_.notes(topics_[std::pair(std::string(topic), layout)]);
  }

 private:
  /// A packet that was made beside the text is what decoding the text gives.
  static void expectSame(const Translated& made) {
    PacketTextWriter again(made.packet->header);
    for (const Statement& statement : made.packet->statements) again.add(statement);
    EXPECT_EQ(again.text(), made.text);
    PacketTextDecoder decoder;
    const Packet* const decoded = decoder.decode(bytesOf(made.text));
    ASSERT_NE(decoded, nullptr);
    ASSERT_EQ(decoded->statements.size(), made.packet->statements.size());
    for (std::size_t i = 0; i < decoded->statements.size(); ++i) {
      const Statement& a = decoded->statements[i];
      const Statement& b = made.packet->statements[i];
      EXPECT_EQ(a.line, b.line);
      EXPECT_TRUE(std::ranges::equal(a.names, b.names));
      EXPECT_EQ(0, std::memcmp(a.numbers.data(), b.numbers.data(), a.numbers.size_bytes()));
    }
  }

  DeviceFinder devices_;
  RosTranslator translator_;
  std::map<std::pair<std::string, FieldCursor::Layout>, std::size_t> topics_;
};

FieldCursor::Layout layoutOf(Kind kind) { return MessageMaker(kind).layout(); }

TEST(RosTranslator, SaysJointStatesOfEverySerialization) {
  for (const Kind kind : kKinds) {
    Translation translation;
    for (int round = 0; round < 3; ++round) {
      EXPECT_EQ(translation.of("/arm/joint_states", MessageType::joint_state,
                               jointState(kind, 17, {"shoulder", "el bow"}, {0.1 * round, -2}),
                               layoutOf(kind)),
                "RK1 decoded:ros:arm:joint_states - 17.5\njoint arm shoulder=" +
                    std::string(round == 0   ? "0"
                                : round == 1 ? "0.1"
                                             : "0.2") +
                    " el%20bow=-2\n");
    }
  }
}

TEST(RosTranslator, FollowsNamesThatChange) {
  Translation translation;
  const auto say = [&](const std::vector<std::string>& names, const std::vector<double>& values) {
    return translation.of("/joint_states", MessageType::joint_state,
                          jointState(Kind::cdr_little, 1, names, values));
  };
  EXPECT_EQ(say({"a", "b"}, {1, 2}), "RK1 decoded:ros:joint_states - 1.5\njoint robot a=1 b=2\n");
  EXPECT_EQ(say({"a"}, {3}), "RK1 decoded:ros:joint_states - 1.5\njoint robot a=3\n");
  EXPECT_EQ(say({"b", "a"}, {1, 2}), "RK1 decoded:ros:joint_states - 1.5\njoint robot b=1 a=2\n");
  EXPECT_EQ(say({"a", "b"}, {1}), "malformed");
  EXPECT_EQ(say({"a", "b"}, {}), "");
  EXPECT_EQ(say({}, {}), "");
}

TEST(RosTranslator, LeavesOutWhatIsNotFinite) {
  Translation translation;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(translation.of("/joint_states", MessageType::joint_state,
                           jointState(Kind::cdr_little, 1, {"a", "b", "c"}, {nan, -0.0, 1})),
            "RK1 decoded:ros:joint_states - 1.5\njoint robot b=0 c=1\n");
  EXPECT_EQ(translation.of("/joint_states", MessageType::joint_state,
                           jointState(Kind::cdr_little, 1, {"a"}, {-INFINITY})),
            "");
  EXPECT_THAT(translation.notes("/joint_states", FieldCursor::Layout::cdr),
              Contains(Key("joint states with values that are not finite")));
}

TEST(RosTranslator, FindsTheDeviceOfAModel) {
  const Result<DescribedRobot> robot = robotOf(kArm, {});
  ASSERT_TRUE(robot.ok()) << robot.error().text();
  EXPECT_EQ(robot->cell.devices.front().name, "arm");
  Translation translation(&robot->cell);
  // A mimic joint is not sent; an unknown one goes with those that are known.
  EXPECT_EQ(translation.of("/joint_states", MessageType::joint_state,
                           jointState(Kind::cdr_little, 1, {"b", "x", "a"}, {1, 2, 3})),
            "RK1 decoded:ros:joint_states - 1.5\njoint arm x=2 a=3\n");
  EXPECT_EQ(translation.of("/others", MessageType::joint_state,
                           jointState(Kind::cdr_little, 1, {"x"}, {1})),
            "");
  EXPECT_THAT(
      translation.notes("/others", FieldCursor::Layout::cdr),
      Contains(Key("joint states with joints of no device; `log import --device` names one")));
}

TEST(RosTranslator, PlacesTheRootsOfDevices) {
  const Result<DescribedRobot> robot = robotOf(kArm, {});
  ASSERT_TRUE(robot.ok());
  for (const Kind kind : kKinds) {
    Translation translation(&robot->cell);
    const auto say = [&](const std::vector<TestTransform>& all) {
      return translation.of("/tf", MessageType::transforms, transforms(kind, all), layoutOf(kind));
    };
    // The root of the chain is not known to move the device before its last part comes.
    EXPECT_EQ(say({{"map", "odom", {1, 0, 0, 0, 0, 0, 1}}}), "");
    EXPECT_EQ(
        say({{"/odom", "base", {0, 2, 0, 0, 0, 0, 2}}, {"base", "upper", {9, 9, 9, 0, 0, 0, 1}}}),
        "RK1 decoded:ros:tf - 7\npose arm 1 2 0 0 0 0 1\n");
    EXPECT_EQ(say({{"map", "odom", {3, 0, 0, 0, 0, 1, 0}}}),
              "RK1 decoded:ros:tf - 7\npose arm 3 -2 0 0 0 1 0\n");
    EXPECT_EQ(say({{"map", "elsewhere", {3, 0, 0, 0, 0, 1, 0}}}), "");
    EXPECT_EQ(say({{"odom", "base", {0, 0, 0, 0, 0, 0, 0}}}), "");
    // A loop has no place.
    EXPECT_EQ(say({{"base", "map", {0, 0, 0, 0, 0, 0, 1}}}), "");
  }
}

TEST(RosTranslator, MakesDevicesOfFramesWithoutAModel) {
  Translation translation;
  EXPECT_EQ(translation.of("/tf", MessageType::transforms,
                           transforms(Kind::cdr_little, {{"map", "cart", {1, 0, 0, 0, 0, 0, 1}},
                                                         {"cart", "lamp", {0, 0, 2, 0, 0, 0, 1}}})),
            "RK1 decoded:ros:tf - 7\npose cart 1 0 0 0 0 0 1\npose lamp 1 0 2 0 0 0 1\n");
}

TEST(RosTranslator, TransformsOverruleOdometry) {
  Translation translation;
  const auto odometry = [&](double x) {
    MessageMaker made(Kind::cdr_little);
    made.header(3, 0, "odom").string("base").doubles({x, 0, 0, 0, 0, 0, 1});
    made.doubles(std::vector<double>(36 + 6 + 36));
    return translation.of("/odom", MessageType::odometry, made.bytes());
  };
  EXPECT_EQ(odometry(1), "RK1 decoded:ros:odom - 3\npose base 1 0 0 0 0 0 1\n");
  EXPECT_EQ(translation.of("/tf", MessageType::transforms,
                           transforms(Kind::cdr_little, {{"odom", "base", {5, 0, 0, 0, 0, 0, 1}}})),
            "RK1 decoded:ros:tf - 7\npose base 5 0 0 0 0 0 1\n");
  EXPECT_EQ(odometry(2), "");
}

TEST(RosTranslator, PosesADeviceByItsTopic) {
  const Result<DescribedRobot> robot = robotOf(kArm, {});
  ASSERT_TRUE(robot.ok());
  MessageMaker made(Kind::cdr_big);
  made.header(0, 0, "map").doubles({1, 2, 3, 0, 0, 0, 1});
  Translation with_model(&robot->cell), without;
  EXPECT_EQ(with_model.of("/arm/pose", MessageType::pose_stamped, made.bytes()),
            "RK1 decoded:ros:arm:pose - -\npose arm 1 2 3 0 0 0 1\n");
  EXPECT_EQ(with_model.of("/goal", MessageType::pose_stamped, made.bytes()), "");
  EXPECT_EQ(without.of("/drone/pose", MessageType::pose_stamped, made.bytes()),
            "RK1 decoded:ros:drone:pose - -\npose drone 1 2 3 0 0 0 1\n");
}

TEST(RosTranslator, DrawsLinesPointsAndText) {
  const Result<DescribedRobot> robot = robotOf(kArm, {});
  ASSERT_TRUE(robot.ok());
  for (const Kind kind : kKinds) {
    for (const bool textured : {true, false}) {
      Translation translation(&robot->cell);
      const auto say = [&](TestMarker one, std::int64_t time_s = 0) {
        one.textured = textured;
        return translation.of("/plan", MessageType::marker, marker(kind, one), layoutOf(kind),
                              time_s);
      };
      const std::string head = "RK1 decoded:ros:plan - 9\n";
      EXPECT_EQ(say({.frame = "tool", .pose = {0, 0, 1, 0, 0, 0, 1}, .points = {0, 0, 0, 1, 0, 0}}),
                head + "line plan%2F3 #ff8000 in arm/tool 0 0 1 1 0 1\n");
      EXPECT_EQ(say({.id = 4, .type = 8, .points = {1, 2, 3}, .lifetime_s = 2}),
                head + "points plan%2F4 #ff8000 1 2 3\n");
      EXPECT_EQ(say({.space = "", .id = 5, .type = 9, .text = "say \"hi\""}),
                head + "label 5 0 0 0 \"say \\\"hi\\\"\"\n");
      // Segments that touch are one line; the lifetime of the points is over.
      EXPECT_EQ(
          say({.type = 5, .points = {0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 0, 5, 5, 5, 6, 6, 6}}, 2),
          head +
              "erase plan%2F4\nline plan%2F3 #ff8000 0 0 0 1 0 0 1 1 0\n"
              "line plan%2F3%2F2 #ff8000 5 5 5 6 6 6\n");
      EXPECT_EQ(say({.type = 4, .points = {0, 0, 0}}, 3),
                head + "line plan%2F3 #ff8000 0 0 0\nerase plan%2F3%2F2\n");
      EXPECT_EQ(say({.action = 2}, 3), head + "erase plan%2F3\n");
      EXPECT_EQ(say({.action = 3}, 3), head + "erase *\n");
      EXPECT_EQ(say({.type = 1}, 3), "");
    }
  }
}

TEST(RosTranslator, MakesEventsOfLogs) {
  MessageMaker two(Kind::cdr_little), one(Kind::ros1);
  two.number(std::int32_t{4}).number(std::uint32_t{0}).number(std::uint8_t{30});
  two.string("nav").string("slow").string("f.cpp").string("run").number(std::uint32_t{7});
  one.header(4, 0, "").number(std::uint8_t{8}).string("/nav").string("stop");
  one.string("f.cpp").string("run").number(std::uint32_t{7}).strings({"/a"});
  Translation translation;
  EXPECT_EQ(translation.of("/rosout", MessageType::log_ros2, two.bytes()),
            "RK1 decoded:ros:rosout - 4\nevent \"WARN nav: slow\"\n");
  EXPECT_EQ(
      translation.of("/rosout", MessageType::log_ros1, one.bytes(), FieldCursor::Layout::ros1),
      "RK1 decoded:ros:rosout - 4\nevent \"ERROR /nav: stop\"\n");
}

TEST(RosTranslator, RefusesMessagesThatAreCutAnywhere) {
  struct Case {
    MessageType type;
    Bytes bytes;
    Kind kind;
  };
  for (const Kind kind : kKinds) {
    MessageMaker markers(kind);
    markers.number(std::uint32_t{2});
    addMarker(markers, {.points = {0, 0, 0, 1, 0, 0}});
    addMarker(markers, {.id = 4, .type = 9, .text = "x"});
    const Case cases[] = {
        {MessageType::joint_state, jointState(kind, 1, {"a", "b"}, {1, 2}), kind},
        {MessageType::transforms, transforms(kind, {{"m", "c", {1, 0, 0, 0, 0, 0, 1}}}), kind},
        {MessageType::marker_array, markers.bytes(), kind},
    };
    for (const Case& each : cases) {
      Translation translation;
      EXPECT_NE(translation.of("/t", each.type, each.bytes, layoutOf(kind)), "malformed");
      for (std::size_t length = 0; length < each.bytes.size(); ++length) {
        SCOPED_TRACE(length);
        const Bytes cut(each.bytes.begin(),
                        each.bytes.begin() + static_cast<std::ptrdiff_t>(length));
        EXPECT_EQ(translation.of("/t", each.type, cut, layoutOf(kind)), "malformed");
      }
    }
  }
}

TEST(RosTranslator, AllocatesNothingForLengthsThatLie) {
  for (const MessageType type : {MessageType::joint_state, MessageType::transforms,
                                 MessageType::marker_array, MessageType::log_ros2}) {
    for (std::size_t place = 4; place + 4 <= 64; ++place) {
      Bytes message(64, std::byte{0});
      message[1] = std::byte{1};
      for (std::size_t i = 0; i < 4; ++i) message[place + i] = std::byte{0xFF};
      Translation translation;
      (void)translation.of("/t", type, message);
    }
  }
}

}  // namespace
}  // namespace rocinante::ros::test
