// Messages that become signals: by the table, every type in every serialization, and by the names.

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <random>

#include "core/base/atomic_file.h"
#include "core/foreign/ros/frame_tree.h"
#include "core/foreign/ros/robot_description.h"
#include "core/foreign/ros/signal_messages.h"
#include "tests/core/foreign/ros/translation.h"

namespace rocinante::ros::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Key;
using testing::Not;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

void addStatus(MessageMaker& made, std::uint8_t level, const std::string& name,
               const std::string& message,
               const std::vector<std::pair<std::string, std::string>>& values) {
  made.number(level).string(name).string(message).string("");
  made.number(static_cast<std::uint32_t>(values.size()));
  for (const auto& [key, value] : values) made.string(key).string(value);
}

void addNumber(MessageMaker& made, Wire wire, double value) {
  switch (wire) {
    case Wire::boolean:
    case Wire::u8:
      made.number(static_cast<std::uint8_t>(value));
      break;
    case Wire::i8:
      made.number(static_cast<std::int8_t>(value));
      break;
    case Wire::i16:
      made.number(static_cast<std::int16_t>(value));
      break;
    case Wire::u16:
      made.number(static_cast<std::uint16_t>(value));
      break;
    case Wire::i32:
      made.number(static_cast<std::int32_t>(value));
      break;
    case Wire::u32:
      made.number(static_cast<std::uint32_t>(value));
      break;
    case Wire::i64:
      made.number(static_cast<std::int64_t>(value));
      break;
    case Wire::u64:
      made.number(static_cast<std::uint64_t>(value));
      break;
    case Wire::f32:
      made.number(static_cast<float>(value));
      break;
    default:
      made.number(value);
  }
}

/// A message of a row: every number 1, sequences of two.
Bytes messageOf(const SignalMessage& row, Kind kind) {
  MessageMaker made(kind);
  for (const SignalField& field : row.fields) {
    if (field.wire == Wire::header) {
      made.header(5, 0, "map");
    } else if (field.wire == Wire::text) {
      made.string("text");
    } else if (field.wire == Wire::layout) {
      made.number(std::uint32_t{1}).string("rows").number(std::uint32_t{2});
      made.number(std::uint32_t{2}).number(std::uint32_t{0});
    } else if (field.wire == Wire::status || field.wire == Wire::statuses) {
      if (field.wire == Wire::statuses) made.number(std::uint32_t{1});
      addStatus(made, 1, "motor", "warm", {{"load", "1"}, {"ready", "true"}});
    } else {
      std::size_t count = field.count == kSequence ? 2 : field.count;
      if (field.count == kSequence) made.number(std::uint32_t{2});
      if (!field.parts.empty()) count = field.parts.size();
      for (std::size_t i = 0; i < count; ++i) addNumber(made, field.wire, 1);
    }
  }
  return made.bytes();
}

TEST(SignalTranslation, EveryRowIsReadInEverySerializationAndNoFieldIsLost) {
  for (const SignalMessage& row : allSignalMessages()) {
    SCOPED_TRACE(row.type);
    for (const Kind kind : kKinds) {
      Translation translation;
      const Bytes bytes = messageOf(row, kind);
      const std::string text = translation.of("/t", row.type, bytes, layoutOf(kind));
      for (const SignalField& field : row.fields) {
        const bool is_signal = field.use == FieldUse::signal || field.use == FieldUse::boolean;
        if (!is_signal || field.wire >= Wire::header) continue;
        std::string name = " t";
        if (field.name != kWhole) name.append(".").append(field.name);
        EXPECT_THAT(text, HasSubstr(name)) << text;
        const std::string unit = field.unit.empty() ? "" : " 1 " + std::string(field.unit);
        EXPECT_THAT(text, HasSubstr(unit));
      }
      // Cut anywhere, or followed by something, it is none; or one of another definition.
      if (signalMessages(row.type).size() > 1) continue;
      for (std::size_t length = 0; length < bytes.size(); ++length) {
        const Bytes cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length));
        EXPECT_EQ(translation.of("/t", row.type, cut, layoutOf(kind)), "malformed") << length;
      }
      Bytes longer = bytes;
      longer.resize(bytes.size() + 8);
      EXPECT_EQ(translation.of("/t", row.type, longer, layoutOf(kind)), "malformed");
    }
  }
}

TEST(SignalTranslation, ThePageHasEveryTypeFieldAndUnit) {
  const Result<std::string> page =
      readFile(std::filesystem::path(ROCINANTE_SOURCE_DIR) / "docs/other-formats.md", 1U << 20U);
  ASSERT_TRUE(page.ok());
  for (const SignalMessage& row : allSignalMessages()) {
    std::string type(row.type.substr(row.type.find('/') + 1));
    // `Int8` to `Int64`.
    if (type.ends_with("Int16") || type.ends_with("Int32")) type.replace(type.size() - 2, 2, "8");
    EXPECT_THAT(*page, testing::AnyOf(HasSubstr("`" + type + "`"), HasSubstr("/" + type + "`")));
    for (const SignalField& field : row.fields) {
      const bool is_signal = field.use == FieldUse::signal || field.use == FieldUse::boolean;
      if (!is_signal || field.wire >= Wire::header || field.name == kWhole) continue;
      EXPECT_THAT(*page, HasSubstr("`" + std::string(field.name))) << row.type;
      EXPECT_THAT(*page, HasSubstr(std::string(field.unit))) << row.type;
    }
  }
}

TEST(SignalTranslation, UnitsAreStatedOnce) {
  Translation translation;
  const auto say = [&](double x, std::string_view frame = "map") {
    MessageMaker made(Kind::cdr_little);
    made.header(1, 0, frame).doubles({x, 0, -0.0}).doubles({0, 0.5, 2});
    return translation.of("/arm/wrench", "geometry_msgs/msg/WrenchStamped", made.bytes());
  };
  EXPECT_EQ(say(1.5),
            "RK1 decoded:ros:arm:wrench - 1\nsignal - arm:wrench.force.x 1.5 N\n"
            "signal - arm:wrench.force.y 0 N\nsignal - arm:wrench.force.z 0 N\n"
            "signal - arm:wrench.torque.x 0 N.m\nsignal - arm:wrench.torque.y 0.5 N.m\n"
            "signal - arm:wrench.torque.z 2 N.m\n");
  // A value that was none gets its unit when it is one.
  EXPECT_EQ(say(kNaN),
            "RK1 decoded:ros:arm:wrench - 1\nsignals - arm:wrench.force.y=0 arm:wrench.force.z=0 "
            "arm:wrench.torque.x=0 arm:wrench.torque.y=0.5 arm:wrench.torque.z=2\n");
  Translation late;
  MessageMaker none(Kind::cdr_little), one(Kind::cdr_little);
  none.header(1, 0, "").doubles({kNaN, 0});
  one.header(1, 0, "").doubles({20.5, 0});
  EXPECT_EQ(late.of("/t", "sensor_msgs/Temperature", none.bytes()), "");
  EXPECT_EQ(late.of("/t", "sensor_msgs/Temperature", one.bytes()),
            "RK1 decoded:ros:t - 1\nsignal - t.temperature 20.5 degC\n");
  EXPECT_EQ(late.of("/t", "sensor_msgs/Temperature", one.bytes()),
            "RK1 decoded:ros:t - 1\nsignals - t.temperature=20.5\n");
  EXPECT_THAT(late.accountTexts(),
              Contains("1 value `temperature` (not a number, or infinite; at /t)"));
}

TEST(SignalTranslation, SignalsBelongToTheDeviceOrLinkOfTheirFrame) {
  const Result<DescribedRobot> robot = robotOf(kArm, {});
  ASSERT_TRUE(robot.ok());
  const auto pathOf = [&](const Cell* cell, std::string_view topic, std::string_view frame,
                          std::string device = "") {
    Translation translation(cell, std::move(device));
    MessageMaker made(Kind::ros1);
    made.header(1, 0, frame).doubles({20, 0});
    const std::string text =
        translation.of(topic, "sensor_msgs/Temperature", made.bytes(), FieldCursor::Layout::ros1);
    const std::size_t begin = text.find("signal ") + 7;
    return text.substr(begin, text.find(' ', begin) - begin);
  };
  EXPECT_EQ(pathOf(&robot->cell, "/t", "tool"), "arm/tool");
  EXPECT_EQ(pathOf(&robot->cell, "/t", "/arm/tool"), "arm/tool");
  EXPECT_EQ(pathOf(&robot->cell, "/t", "cell7/tool"), "arm/tool");
  EXPECT_EQ(pathOf(&robot->cell, "/t", "base"), "arm");
  EXPECT_EQ(pathOf(&robot->cell, "/t", "arm"), "arm");
  EXPECT_EQ(pathOf(&robot->cell, "/arm/t", "cooler"), "arm");
  EXPECT_EQ(pathOf(&robot->cell, "/t", "cooler"), "-");
  EXPECT_EQ(pathOf(&robot->cell, "/t", ""), "-");
  EXPECT_EQ(pathOf(&robot->cell, "/t", "cooler", "cell"), "cell");
  EXPECT_EQ(pathOf(nullptr, "/arm/t", "tool"), "-");
  EXPECT_EQ(pathOf(nullptr, "/arm/t", "tool", "-"), "%2D");
}

TEST(SignalTranslation, SeveralFramesThatAreNoLinkAreTold) {
  Translation translation;
  for (const char* const frame : {"left", "right"}) {
    MessageMaker made(Kind::cdr_little);
    made.header(1, 0, frame).doubles({20, 0});
    EXPECT_NE(translation.of("/t", "sensor_msgs/Temperature", made.bytes()), "");
  }
  EXPECT_THAT(translation.notes("/t", FieldCursor::Layout::cdr),
              Contains(Key("values of several frames that are no link, as one signal")));
}

TEST(SignalTranslation, FramesBeyondTheirBoundAreNoStrangers) {
  const Result<DescribedRobot> robot = robotOf(kArm, {});
  ASSERT_TRUE(robot.ok());
  Translation translation(&robot->cell);
  const auto say = [&](const std::string& frame) {
    MessageMaker made(Kind::cdr_little);
    made.header(1, 0, frame).doubles({20, 0});
    return translation.of("/t", "sensor_msgs/Temperature", made.bytes());
  };
  EXPECT_THAT(say("arm"), HasSubstr("signal arm t.temperature 20 degC\n"));
  for (std::size_t i = 1; i < kMaxFrames; ++i) say("frame" + std::to_string(i));
  EXPECT_THAT(say("one more"), HasSubstr("signal - t.temperature 20 degC\n"));
  EXPECT_THAT(say("and another"), HasSubstr("signals - t.temperature=20\n"));
  EXPECT_THAT(say("arm"), HasSubstr("signals arm t.temperature=20\n"));
  EXPECT_THAT(translation.notes("/t", FieldCursor::Layout::cdr),
              Contains(Key("values of frames beyond 4096, as those of no frame")));
}

TEST(SignalTranslation, NoTwoTopicsHaveOneName) {
  Translation translation;
  std::map<std::string, std::string> topics;
  const std::string long_name(300, 'x');
  for (const std::string& topic :
       {std::string("/a/b"), std::string("a:b"), std::string("/a.b"), std::string("/a_b"),
        std::string("/a b"), std::string("/a_b:2"), std::string("/"), std::string("_"),
        "/" + long_name + "1", "/" + long_name + "2"}) {
    MessageMaker made(Kind::cdr_little);
    made.number(2.5);
    const std::string text = translation.of(topic, "std_msgs/msg/Float64", made.bytes());
    const std::string line = text.substr(text.find('\n'));
    EXPECT_TRUE(topics.emplace(line, topic).second) << topic << " and " << topics[line] << line;
  }
  EXPECT_THAT(translation.notes("/a/b", FieldCursor::Layout::cdr), IsEmpty());
  EXPECT_THAT(translation.notes("a:b", FieldCursor::Layout::cdr), Not(IsEmpty()));
}

TEST(SignalTranslation, AnImuMarksWhatItDoesNotKnow) {
  MessageMaker made(Kind::cdr_big);
  made.header(1, 0, "").doubles({0, 0, 0, 1}).doubles({-1, 0, 0, 0, 0, 0, 0, 0, 0});
  made.doubles({1, 2, 3}).doubles(std::vector<double>(9));
  made.doubles({0, 0, 9.81}).doubles(std::vector<double>(9, 0.5));
  Translation translation;
  const std::string text = translation.of("/imu", "sensor_msgs/Imu", made.bytes());
  EXPECT_THAT(text, Not(HasSubstr("orientation")));
  EXPECT_THAT(text, HasSubstr("signal - imu.angular_velocity.z 3 rad/s\n"));
  EXPECT_THAT(text, HasSubstr("signal - imu.linear_acceleration.z 9.81 m/s2\n"));
  EXPECT_THAT(translation.accountTexts(),
              testing::UnorderedElementsAre(
                  "1 value `orientation` (which the sender does not know: its covariance begins "
                  "with -1; at /imu)",
                  "1 value `covariance` (packets have no covariances; at /imu)"));
}

TEST(SignalTranslation, BatteriesOfBothDefinitions) {
  for (const bool is_new : {true, false, true}) {
    MessageMaker made(Kind::cdr_little);
    made.header(1, 0, "");
    for (const float value : {24.5F, -1.25F}) {
      made.number(value);
      if (is_new && value > 0) made.number(31.0F);
    }
    for (int i = 0; i < 4; ++i) made.number(std::numeric_limits<float>::quiet_NaN());
    made.number(std::uint8_t{2}).number(std::uint8_t{9}).number(std::uint8_t{3});
    made.number(std::uint8_t{1}).number(std::uint32_t{2}).number(3.5F).number(3.75F);
    if (is_new) made.number(std::uint32_t{0});
    made.string("left").string("A \"7\"");
    Translation translation;
    const std::string text = translation.of("/b", "sensor_msgs/msg/BatteryState", made.bytes());
    EXPECT_EQ(text, std::string("RK1 decoded:ros:b - 1\nsignal - b.voltage 24.5 V\n") +
                        (is_new ? "signal - b.temperature 31 degC\n" : "") +
                        "signal - b.current -1.25 A\n"
                        "signal - b.power_supply_status \"discharging\"\n"
                        "signal - b.power_supply_health \"9\"\n"
                        "signal - b.power_supply_technology \"lipo\"\n"
                        "signal - b.cell_voltage.0 3.5 V\nsignal - b.cell_voltage.1 3.75 V\n"
                        "signal - b.location \"left\"\nsignal - b.serial_number \"A \\\"7\\\"\"\n"
                        "signals - b.present=true\n");
    EXPECT_THAT(translation.notes("/b", FieldCursor::Layout::cdr),
                Contains(Key("states that their type does not name, written as digits")));
    EXPECT_THAT(translation.accountTexts(),
                Contains("1 value `percentage` (not a number, or infinite; at /b)"));
  }
}

TEST(SignalTranslation, DiagnosticsNameTheirSignals) {
  MessageMaker made(Kind::cdr_little);
  made.header(1, 0, "").number(std::uint32_t{3});
  addStatus(
      made, 0, "/Motors/left: drive", "fine",
      {{"load", "12.5"}, {"ready", "True"}, {"level", "7"}, {"ratio", "nan"}, {"id", "0x1F"}});
  addStatus(made, 2, "Motors:left: drive", "hot", {{"a.b", "1"}, {"a_b", "2"}});
  addStatus(made, 9, "", "", {});
  Translation translation;
  EXPECT_EQ(translation.of("/diagnostics", "diagnostic_msgs/msg/DiagnosticArray", made.bytes()),
            "RK1 decoded:ros:diagnostics - 1\n"
            "signal - diagnostics.Motors:left:_drive.level \"OK\"\n"
            "signal - diagnostics.Motors:left:_drive.message \"fine\"\n"
            "signal - diagnostics.Motors:left:_drive.id \"0x1F\"\n"
            "signal - diagnostics.Motors:left:_drive:2.level \"ERROR\"\n"
            "signal - diagnostics.Motors:left:_drive:2.message \"hot\"\n"
            "signal - diagnostics._.level \"9\"\n"
            "signal - diagnostics._.message \"\"\n"
            "signals - diagnostics.Motors:left:_drive.load=12.5 "
            "diagnostics.Motors:left:_drive.ready=true "
            "diagnostics.Motors:left:_drive.level:2=7 diagnostics.Motors:left:_drive:2.a_b=1 "
            "diagnostics.Motors:left:_drive:2.a_b:2=2\n");
  EXPECT_THAT(translation.accountTexts(),
              Contains("1 value `values` (not a number, or infinite; at /diagnostics)"));
}

TEST(SignalTranslation, ATopicCannotNameWithoutEnd) {
  Translation translation;
  std::string all;
  for (int message = 0; message < 6; ++message) {
    MessageMaker made(Kind::cdr_little);
    made.header(1, 0, "").number(std::uint32_t{1000});
    for (int i = 0; i < 1000; ++i) {
      addStatus(made, 0, "s" + std::to_string(message * 1000 + i), "", {{"k", "1"}});
    }
    all += translation.of("/d", "diagnostic_msgs/DiagnosticArray", made.bytes());
  }
  EXPECT_THAT(all, Not(HasSubstr("s2000.")));
  EXPECT_THAT(translation.accountTexts(),
              Contains(HasSubstr("diagnostics beyond 4096 of a topic")));
}

TEST(SignalTranslation, ArraysTextsAndWholeNumbersHaveBounds) {
  Translation translation;
  MessageMaker joy(Kind::cdr_little);
  joy.header(1, 0, "").number(std::uint32_t{70});
  for (int i = 0; i < 70; ++i) joy.number(0.5F);
  joy.number(std::uint32_t{2}).number(std::int32_t{0}).number(std::int32_t{5});
  const std::string text = translation.of("/joy", "sensor_msgs/Joy", joy.bytes());
  EXPECT_THAT(text, HasSubstr(" joy.axes.63=0.5 joy.buttons.0=false joy.buttons.1=true\n"));
  EXPECT_THAT(
      translation.accountTexts(),
      Contains("6 values `axes` (elements beyond the 64th of an array; the first at /joy)"));
  const auto say = [&](std::string_view words) {
    return translation.of("/chatter", "std_msgs/String",
                          MessageMaker(Kind::cdr_little).string(words).bytes());
  };
  EXPECT_EQ(say("a\nb"), "RK1 decoded:ros:chatter - -\nsignal - chatter \"a\\nb\"\n");
  EXPECT_NE(say(std::string(4096, 'x')), "");
  EXPECT_EQ(say(std::string(4097, 'x')), "");
  EXPECT_EQ(say(std::string(1366, '\xff')), "");
  EXPECT_NE(say(std::string(1365, '\xff')), "");
  const auto whole = [&](std::uint64_t number) {
    return translation.of("/ticks", "std_msgs/UInt64",
                          MessageMaker(Kind::cdr_little).number(number).bytes());
  };
  EXPECT_THAT(whole(std::uint64_t{1} << 53U), HasSubstr("ticks=9007199254740992\n"));
  EXPECT_THAT(translation.notes("/ticks", FieldCursor::Layout::cdr), IsEmpty());
  EXPECT_NE(whole(~std::uint64_t{0}), "");
  EXPECT_THAT(translation.notes("/ticks", FieldCursor::Layout::cdr),
              Contains(Key("whole numbers above 2^53, rounded")));
}

TEST(SignalTranslation, AnyBytesGivePacketsWithoutFaults) {
  std::mt19937 random(20261129);
  for (const SignalMessage& row : allSignalMessages()) {
    for (const Kind kind : kKinds) {
      Translation translation;
      const Bytes sound = messageOf(row, kind);
      for (int round = 0; round < 60; ++round) {
        Bytes bytes = sound;
        for (std::size_t i = 0; i <= random() % 6; ++i) {
          bytes[random() % bytes.size()] = static_cast<std::byte>(random());
        }
        // translation.of() decodes the text and expects no fault.
        (void)translation.of("/t", row.type, bytes, layoutOf(kind));
      }
    }
  }
}

/// The packets of a topic whose channel has this metadata.
std::vector<std::string> saidBy(RosTranslator& translator, std::string_view topic,
                                const std::map<std::string, std::string>& metadata,
                                const std::vector<double>& numbers) {
  const auto place =
      translator.addTopic(topic, "std_msgs/msg/Float64", FieldCursor::Layout::cdr, metadata);
  std::vector<std::string> said;
  for (const double number : numbers) {
    Translated made;
    const Bytes message = MessageMaker(Kind::cdr_little).number(number).bytes();
    EXPECT_EQ(translator.translate(*place, LogTime{}, message, made),
              RosTranslator::Outcome::packet);
    said.emplace_back(made.text.substr(made.text.find('\n') + 1));
  }
  return said;
}

TEST(SignalTranslation, AChannelOfAnExportNamesItsSignalAndUnit) {
  const DeviceFinder devices(nullptr, "");
  RosTranslator translator(devices);
  const std::map<std::string, std::string> kilograms = {
      {"rocinante.path", "arm%201/tool0"}, {"rocinante.name", "a%20b"}, {"rocinante.unit", "kg"}};
  // Each number with its unit: another channel may have said the same signal in another one.
  EXPECT_THAT(saidBy(translator, "/signals/arm_1/tool0/a_b", kilograms, {0.5, 5e-324}),
              testing::ElementsAre("signal arm%201/tool0 a%20b 0.5 kg\n",
                                   "signal arm%201/tool0 a%20b 5e-324 kg\n"));
  EXPECT_THAT(saidBy(translator, "/signals/estop",
                     {{"rocinante.path", "-"}, {"rocinante.name", "level"}}, {1}),
              testing::ElementsAre("signal - level 1\n"));
}

TEST(SignalTranslation, AChannelThatNamesWhatNoPacketSaysIsASignalOfItsTopic) {
  const DeviceFinder devices(nullptr, "");
  RosTranslator translator(devices);
  EXPECT_THAT(saidBy(translator, "/load",
                     {{"rocinante.path", "arm\nremove arm"}, {"rocinante.name", "x"}}, {1}),
              testing::ElementsAre("signals - load=1\n"));
  EXPECT_THAT(translator.notes(0),
              Contains(Key("a channel whose metadata names what no packet can say")));
}

}  // namespace
}  // namespace rocinante::ros::test
