#include "core/foreign/ros/ros_translator.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "core/base/atomic_file.h"
#include "core/foreign/ros/robot_description.h"
#include "tests/core/foreign/ros/translation.h"

namespace rocinante::ros::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Key;
using testing::Pair;
using testing::SizeIs;
using testing::StartsWith;
using testing::UnorderedElementsAre;

TEST(RosTranslator, SaysJointStatesOfEverySerialization) {
  for (const Kind kind : kKinds) {
    Translation translation;
    for (int round = 0; round < 3; ++round) {
      EXPECT_EQ(translation.of("/arm/joint_states", "sensor_msgs/JointState",
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
    return translation.of("/joint_states", "sensor_msgs/JointState",
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
  EXPECT_EQ(translation.of("/joint_states", "sensor_msgs/JointState",
                           jointState(Kind::cdr_little, 1, {"a", "b", "c"}, {nan, -0.0, 1})),
            "RK1 decoded:ros:joint_states - 1.5\njoint robot b=0 c=1\n");
  EXPECT_EQ(translation.of("/joint_states", "sensor_msgs/JointState",
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
  EXPECT_EQ(translation.of("/joint_states", "sensor_msgs/JointState",
                           jointState(Kind::cdr_little, 1, {"b", "x", "a"}, {1, 2, 3})),
            "RK1 decoded:ros:joint_states - 1.5\njoint arm x=2 a=3\n");
  EXPECT_EQ(translation.of("/others", "sensor_msgs/JointState",
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
      return translation.of("/tf", "tf2_msgs/TFMessage", transforms(kind, all), layoutOf(kind));
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

/// The pose of a message on a topic of its own; then its notes.
TranslationNotes notesOfPose(const std::vector<double>& pose, std::string_view frame = "map") {
  Translation translation;
  MessageMaker made(Kind::cdr_little);
  made.header(3, 0, frame).doubles(pose);
  translation.of("/pose", "geometry_msgs/PoseStamped", made.bytes());
  translation.of("/pose", "geometry_msgs/PoseStamped", made.bytes());
  return translation.notes("/pose", FieldCursor::Layout::cdr);
}

TEST(RosTranslator, NamesQuaternionsThatItNormalises) {
  constexpr const char* kOff =
      "poses whose quaternion is off unit length by more than 0.001, normalised (the first: ";
  EXPECT_THAT(notesOfPose({1, 2, 3, 5, 6, 7, 8}),
              ElementsAre(Pair(std::string(kOff) + "5 6 7 8, of length 13.1909)", 2)));
  EXPECT_THAT(notesOfPose({1, 2, 3, 0, 0, 0, 0.5}),
              ElementsAre(Pair(std::string(kOff) + "0 0 0 0.5, of length 0.5)", 2)));
  // As in packet text, what a sender rounded is not named.
  EXPECT_THAT(notesOfPose({1, 2, 3, 0, 0, 0, 1.0009}), IsEmpty());
  EXPECT_THAT(notesOfPose({1, 2, 3, 0, 0, 0, 0.9989}), SizeIs(1));

  Translation translation;
  translation.of("/tf", "tf2_msgs/TFMessage",
                 transforms(Kind::cdr_little, {{"map", "cart", {1, 0, 0, 0, 0, 0, 2}}}));
  EXPECT_THAT(translation.notes("/tf", FieldCursor::Layout::cdr),
              ElementsAre(Pair(StartsWith("transforms whose quaternion is off unit length"), 1)));
  MessageMaker odometry(Kind::cdr_little);
  odometry.header(3, 0, "odom").string("base").doubles({0, 0, 0, 0, 0, 0, 2});
  odometry.doubles(std::vector<double>(36 + 6 + 36));
  translation.of("/odom", "nav_msgs/Odometry", odometry.bytes());
  EXPECT_THAT(translation.notes("/odom", FieldCursor::Layout::cdr),
              ElementsAre(Pair(StartsWith("odometry whose quaternion is off unit length"), 1)));
}

TEST(RosTranslator, TellsApartWhyAPoseHasNoPlace) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(
      notesOfPose({1, 2, 3, 0, 0, 0, 0}),
      ElementsAre(Pair("poses whose rotation is zero or not finite (the first: 0 0 0 0)", 2)));
  EXPECT_THAT(
      notesOfPose({1, 2, 3, 0, 0, nan, 1}),
      ElementsAre(Pair("poses whose rotation is zero or not finite (the first: 0 0 nan 1)", 2)));
  EXPECT_THAT(notesOfPose({1, INFINITY, 3, 0, 0, 0, 1}),
              ElementsAre(Pair("poses whose position is not finite (the first: 1 inf 3)", 2)));

  Translation translation;
  const auto say = [&](const TestTransform& one) {
    translation.of("/tf", "tf2_msgs/TFMessage", transforms(Kind::cdr_little, {one}));
  };
  say({"ring", "other", {0, 0, 0, 0, 0, 0, 1}});
  say({"other", "ring", {0, 0, 0, 0, 0, 0, 1}});
  MessageMaker pose(Kind::cdr_little);
  pose.header(3, 0, "ring").doubles({0, 0, 0, 0, 0, 0, 1});
  translation.of("/pose", "geometry_msgs/PoseStamped", pose.bytes());
  EXPECT_THAT(translation.notes("/pose", FieldCursor::Layout::cdr),
              ElementsAre(Pair("poses in a frame without a place (the first: ring)", 1)));

  say({"a", "a", {0, 0, 0, 0, 0, 0, 1}});
  say({"a", std::string(256, 'b'), {0, 0, 0, 0, 0, 0, 1}});
  say({"a", "c", {0, 0, nan, 0, 0, 0, 1}});
  say({"a", "c", {0, 0, 0, 0, 0, 0, 0}});
  EXPECT_THAT(translation.notes("/tf", FieldCursor::Layout::cdr),
              UnorderedElementsAre(
                  Pair("transforms of a frame in itself (the first: a)", 1),
                  Pair("transforms with a frame whose name no packet can have (the first: " +
                           std::string(64, 'b') + ")",
                       1),
                  Pair("transforms whose position is not finite (the first: 0 0 nan)", 1),
                  Pair("transforms whose rotation is zero or not finite (the first: 0 0 0 0)", 1)));
}

TEST(RosTranslator, MakesDevicesOfFramesWithoutAModel) {
  Translation translation;
  EXPECT_EQ(translation.of("/tf", "tf2_msgs/TFMessage",
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
    return translation.of("/odom", "nav_msgs/Odometry", made.bytes());
  };
  EXPECT_EQ(odometry(1),
            "RK1 decoded:ros:odom - 3\npose base 1 0 0 0 0 0 1\n"
            "signal base odom.linear.x 0 m/s\nsignal base odom.linear.y 0 m/s\n"
            "signal base odom.linear.z 0 m/s\nsignal base odom.angular.x 0 rad/s\n"
            "signal base odom.angular.y 0 rad/s\nsignal base odom.angular.z 0 rad/s\n");
  EXPECT_EQ(translation.of("/tf", "tf2_msgs/TFMessage",
                           transforms(Kind::cdr_little, {{"odom", "base", {5, 0, 0, 0, 0, 0, 1}}})),
            "RK1 decoded:ros:tf - 7\npose base 5 0 0 0 0 0 1\n");
  // Its speeds count all the same.
  EXPECT_EQ(odometry(2),
            "RK1 decoded:ros:odom - 3\nsignals base odom.linear.x=0 odom.linear.y=0 "
            "odom.linear.z=0 odom.angular.x=0 odom.angular.y=0 odom.angular.z=0\n");
}

TEST(RosTranslator, PosesADeviceByItsTopic) {
  const Result<DescribedRobot> robot = robotOf(kArm, {});
  ASSERT_TRUE(robot.ok());
  MessageMaker made(Kind::cdr_big);
  made.header(0, 0, "map").doubles({1, 2, 3, 0, 0, 0, 1});
  Translation with_model(&robot->cell), without;
  EXPECT_EQ(with_model.of("/arm/pose", "geometry_msgs/PoseStamped", made.bytes()),
            "RK1 decoded:ros:arm:pose - -\npose arm 1 2 3 0 0 0 1\n");
  EXPECT_EQ(with_model.of("/goal", "geometry_msgs/PoseStamped", made.bytes()), "");
  EXPECT_EQ(without.of("/drone/pose", "geometry_msgs/PoseStamped", made.bytes()),
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
        return translation.of("/plan", "visualization_msgs/Marker", marker(kind, one),
                              layoutOf(kind), time_s);
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
  EXPECT_EQ(translation.of("/rosout", "rcl_interfaces/Log", two.bytes()),
            "RK1 decoded:ros:rosout - 4\nevent \"WARN nav: slow\"\n");
  EXPECT_EQ(translation.of("/rosout", "rosgraph_msgs/Log", one.bytes(), FieldCursor::Layout::ros1),
            "RK1 decoded:ros:rosout - 4\nevent \"ERROR /nav: stop\"\n");
}

TEST(RosTranslator, RefusesMessagesThatAreCutAnywhere) {
  struct Case {
    std::string_view type;
    Bytes bytes;
    Kind kind;
  };
  for (const Kind kind : kKinds) {
    MessageMaker markers(kind);
    markers.number(std::uint32_t{2});
    addMarker(markers, {.points = {0, 0, 0, 1, 0, 0}});
    addMarker(markers, {.id = 4, .type = 9, .text = "x"});
    const Case cases[] = {
        {"sensor_msgs/JointState", jointState(kind, 1, {"a", "b"}, {1, 2}), kind},
        {"tf2_msgs/TFMessage", transforms(kind, {{"m", "c", {1, 0, 0, 0, 0, 0, 1}}}), kind},
        {"visualization_msgs/MarkerArray", markers.bytes(), kind},
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
  for (const std::string_view type : translatedTypes()) {
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
