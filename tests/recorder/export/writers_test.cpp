#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "core/foreign/foxglove/foxglove_format.h"
#include "core/foreign/foxglove/signal_json.h"
#include "core/foreign/proto/proto_schema.h"
#include "core/foreign/proto/proto_writer.h"
#include "core/foreign/session/exported_mcap.h"
#include "core/foreign/session/given_names.h"
#include "core/foreign/session/session_format.h"
#include "core/packet/packet_text.h"
#include "recorder/pcap/pcap_file.h"
#include "recorder/ros_out/cdr_writer.h"
#include "recorder/ros_out/ros2_format.h"

namespace rocinante {
namespace {

std::string hex(ByteView bytes) {
  constexpr const char* kDigits = "0123456789ABCDEF";
  std::string text;
  for (const std::byte byte : bytes) {
    text += kDigits[std::to_integer<unsigned>(byte) >> 4U];
    text += kDigits[std::to_integer<unsigned>(byte) & 15U];
  }
  return text;
}

TEST(ExportedMcap, ChannelsBeyondWhatAFileHoldsAreLeftOutAndNamed) {
  Bytes file;
  auto out = ExportedMcap::start(makeMemorySink(file), "ros2");
  ASSERT_TRUE(out.ok()) << out.error().text();
  const Bytes message(8);
  for (std::size_t i = 0; i < ExportedMcap::kMostChannels + 3; ++i) {
    const std::string topic = "/signals/arm/s" + std::to_string(i);
    const Status written =
        out->write(topic, ros2Schema("std_msgs/msg/Float64"), LogTime(Nanoseconds(i)), message);
    ASSERT_TRUE(written) << written.error().text();
  }
  ASSERT_TRUE(out->write("/signals/arm/s0", ros2Schema("std_msgs/msg/Float64"),
                         LogTime(std::chrono::seconds(1)), message));
  ASSERT_TRUE(out->finish());
  EXPECT_EQ(out->topics().size(), ExportedMcap::kMostChannels);
  EXPECT_EQ(out->topics().at("/signals/arm/s0").messages, 2U);
  Account account;
  out->addLeftOut(account);
  ASSERT_EQ(account.leftOut().size(), 1U);
  EXPECT_EQ(account.leftOut()[0].count, 3U);
  EXPECT_EQ(account.leftOut()[0].first, "/signals/arm/s65535");
}

TEST(ProtoWriter, WritesEachKindOfField) {
  Bytes out;
  ProtoWriter writer(out);
  writer.number(1, 300);
  writer.number(2, 0);  // left out
  writer.index(3, 0);
  writer.fixed32(4, 0x01020304);
  writer.real(5, 1);
  writer.real(6, 0);  // left out
  writer.presentReal(7, 0);
  writer.text(8, "hi");
  writer.text(9, "");  // left out
  writer.element(10, "");
  writer.number(16, 1);
  EXPECT_EQ(hex(out),
            "08AC02"
            "1800"
            "2504030201"
            "29000000000000F03F"
            "390000000000000000"
            "42026869"
            "5200"
            "800101");
}

TEST(ProtoWriter, MessagesHaveLengthsOfAnySize) {
  for (const std::size_t size : {0U, 125U, 126U, 127U, 128U, 16'384U, 3'000'000U}) {
    SCOPED_TRACE(size);
    Bytes plain;
    const std::string text(size, 'x');
    ProtoWriter(plain).text(1, text);
    Bytes nested;
    ProtoWriter(nested).message(2, [&](ProtoWriter& inner) { inner.text(1, text); });
    // The same as the bytes of the message in a field of bytes.
    Bytes expected;
    ProtoWriter(expected).element(2, textOf(plain));
    EXPECT_TRUE(nested == expected);
  }
}

TEST(ProtoSchema, IsAFileForEachMessageAfterThoseItNeeds) {
  constexpr ProtoMessage kMessages[] = {
      {"B", "repeated A a=2; optional double x=3; E e=4", "E ZERO=0 ONE=1"},
      {"A", "string s=1", ""}};
  const Bytes set = fileDescriptorSet("p", kMessages, "B");
  // Field by field, as descriptor.proto numbers them: the file of A, then that of B, whose optional
  // field is a oneof of its own.
  EXPECT_EQ(hex(set),
            "0A260A09702F412E70726F746F120170220E0A014112090A0173180120012809620670726F746F33"
            "0A780A09702F422E70726F746F1201701A09702F412E70726F746F22550A0142120F0A0161180220"
            "03280B32042E702E41120E0A0178180320012801480088010112110A016518042001280E32062E70"
            "2E422E4522160A014512080A045A45524F100012070A034F4E45100142040A025F78620670726F74"
            "6F33");
}

TEST(FoxgloveSchemas, HoldWhatTheyReferTo) {
  for (const char* name : {"FrameTransforms", "JointStates", "SceneUpdate", "PointCloud", "Log"}) {
    const MessageSchema& schema = foxgloveSchema(name);
    EXPECT_EQ(schema.name, std::string("foxglove.") + name);
    const std::string_view text = textOf(schema.data);
    EXPECT_NE(text.find("google/protobuf/timestamp.proto"), text.npos) << name;
  }
}

TEST(CdrWriter, AlignsFromBehindItsHeader) {
  Bytes out;
  CdrWriter writer(out);
  writer.put(std::uint8_t{7});
  writer.put(std::uint32_t{1});
  writer.text("ab");
  writer.put(1.0);
  writer.put(true);
  EXPECT_EQ(hex(out),
            "00010000"
            "07000000"
            "01000000"
            "03000000616200"
            "00"
            "000000000000F03F"
            "01");
}

TEST(RosNames, AreLettersDigitsAndUnderscores) {
  EXPECT_EQ(rosName("arm"), "arm");
  EXPECT_EQ(rosName("left-arm.2"), "left_arm_2");
  EXPECT_EQ(rosName("2nd"), "_2nd");
  EXPECT_EQ(rosName("\xC3\xA9"), "__");
}

SignalValue number(double value) { return {SignalKind::number, value, {}, {}}; }

TEST(SignalJson, APointInANameNests) {
  KnownSignals known;
  PacketTextDecoder decoder;
  known.notice(*decoder.decode(
      bytesOf("RK1 s 0 -\nsignals arm j1.velocity=1 j1.effort=2 a=3 a.b=4 a.b.c=5 x..y=6 .z=7\n"
              "signal arm load 1 kg\nsignal arm mode \"auto\"\nsignal arm on true\n"
              "signal arm gone default\n")));
  const SignalJson json(known.byOwner().at({"arm", ""}));
  EXPECT_EQ(json.schema(),
            R"({"properties":{".z":{"type":"number"},"a":{"type":"number"},)"
            R"("a.b":{"type":"number"},"a.b.c":{"type":"number"},)"
            R"("j1":{"properties":{"effort":{"type":"number"},"velocity":{"type":"number"}},)"
            R"("type":"object"},"load":{"description":"kg","type":"number"},)"
            R"("mode":{"type":"string"},"on":{"type":"boolean"},"x..y":{"type":"number"}},)"
            R"("type":"object"})");
  const SignalValue one = number(1), tiny = number(1e-12);
  const SignalValue yes{SignalKind::boolean, 1, {}, {}}, text{SignalKind::text, 0, "a \"b\"", {}};
  const std::vector<StatedSignal> said = {{"a", &one},     {"a.b", &tiny}, {"j1.velocity", &one},
                                          {"mode", &text}, {"on", &yes},   {"unknown", &one}};
  EXPECT_EQ(json.message(said),
            R"({"a":1.0,"a.b":1e-12,"j1":{"velocity":1.0},"mode":"a \"b\"","on":true})");
  EXPECT_EQ(json.message({}), "{}");
}

/// Notes topics, types and messages.
class NotingSink final : public MessageSink {
 public:
  Status write(std::string_view topic, const MessageSchema& schema, LogTime, ByteView message,
               const std::map<std::string, std::string>&) override {
    notes.push_back(std::string(topic) + " " + schema.name + " " + hex(message.subspan(4)));
    return {};
  }
  std::vector<std::string> notes;
};

TEST(Ros2Signals, HaveATopicOfOneTypeEach) {
  const auto format = makeRos2Format();
  NotingSink sink;
  const SignalValue one = number(1);
  const SignalValue yes{SignalKind::boolean, 1, {}, {}}, text{SignalKind::text, 0, "a", {}};
  const auto say = [&](const SignalOwner& owner, const StatedSignal& said) {
    ASSERT_TRUE(format->signals(sink, LogTime{}, owner, std::span(&said, 1), false).ok());
  };
  say({"arm", "tool0"}, {"a b", &one, true});
  say({"", ""}, {"estop", &yes, true});
  say({"arm", ""}, {"mode", &text, true});
  say({"arm", ""}, {"mode", &one, true});              // another type
  say({"arm", "tool0"}, {"a_b", &one, true});          // the same letters
  say({"arm", ""}, {"mode", &text, false});            // not said now
  say({"arm", ""}, {"j.velocity", &one, true, true});  // in the joint states
  EXPECT_THAT(sink.notes, testing::ElementsAre(
                              "/signals/arm/tool0/a_b std_msgs/msg/Float64 000000000000F03F",
                              "/signals/estop std_msgs/msg/Bool 01",
                              "/signals/arm/mode std_msgs/msg/String 020000006100",
                              "/signals/arm/mode_2 std_msgs/msg/Float64 000000000000F03F",
                              "/signals/arm/tool0/a_b_2 std_msgs/msg/Float64 000000000000F03F"));
  Account account;
  format->addLeftOut(account);
  EXPECT_EQ(accountSentence(account),
            "left out: 1 topic `/signals/arm/mode` (it is of another type: `arm mode` is on "
            "/signals/arm/mode_2), 1 topic `/signals/arm/tool0/a_b` (it is another signal's: "
            "`arm/tool0 a_b` is on /signals/arm/tool0/a_b_2)");
}

TEST(Ros2Signals, HaveATopicForEachUnitAndTheirNamesBesideIt) {
  /// Notes what the channel says.
  class NamingSink final : public MessageSink {
   public:
    Status write(std::string_view topic, const MessageSchema&, LogTime, ByteView,
                 const std::map<std::string, std::string>& metadata) override {
      std::string& note = notes.emplace_back(topic);
      for (const auto& [key, value] : metadata) note += " " + key + "=" + value;
      return {};
    }
    std::vector<std::string> notes;
  };
  const auto format = makeRos2Format();
  NamingSink sink;
  for (const char* unit : {"kg", "g", "kg"}) {
    const SignalValue value{SignalKind::number, 1, {}, unit};
    const StatedSignal said{"a b", &value, true};
    ASSERT_TRUE(
        format->signals(sink, LogTime{}, {"arm", "tool0"}, std::span(&said, 1), false).ok());
  }
  const std::vector<NamedValue> joints = {{"a", 1}};
  ASSERT_TRUE(format->joints(sink, LogTime{}, "arm 1", joints).ok());
  const std::string kilograms =
      "/signals/arm/tool0/a_b rocinante.name=a%20b rocinante.path=arm/tool0 rocinante.unit=kg";
  EXPECT_THAT(sink.notes,
              testing::ElementsAre(kilograms,
                                   "/signals/arm/tool0/a_b_2 rocinante.name=a%20b "
                                   "rocinante.path=arm/tool0 rocinante.unit=g",
                                   kilograms, "/arm_1/joint_states rocinante.path=arm%201"));
}

TEST(Ros2Signals, SayWhyTheirTopicHasANumber) {
  const auto format = makeRos2Format();
  NotingSink sink;
  const auto say = [&](std::string_view name, const SignalValue& value) {
    const StatedSignal said{name, &value, true};
    ASSERT_TRUE(format->signals(sink, LogTime{}, {"arm", ""}, std::span(&said, 1), false).ok());
  };
  say("load", {SignalKind::number, 1, {}, "kg"});
  say("load", {SignalKind::number, 1, {}, "N"});
  say("load", {SignalKind::number, 1, {}, ""});
  say("load", {SignalKind::boolean, 1, {}, {}});
  say("load_2", {SignalKind::number, 1, {}, "N"});  // the topic that the newtons got
  Account account;
  format->addLeftOut(account);
  std::vector<std::string> reasons;
  for (const LeftOut& each : account.leftOut()) reasons.push_back(each.name + ": " + each.reason);
  EXPECT_THAT(
      reasons,
      testing::ElementsAre(
          "/signals/arm/load: it is in another unit: `arm load` in N is on /signals/arm/load_2",
          "/signals/arm/load: it is in another unit: `arm load` without one is on "
          "/signals/arm/load_3",
          "/signals/arm/load: it is of another type: `arm load` is on /signals/arm/load_4",
          "/signals/arm/load_2: it is another signal's: `arm load_2` is on "
          "/signals/arm/load_2_2"));
}

/// Which topics there are.
class TopicSink final : public MessageSink {
 public:
  Status write(std::string_view topic, const MessageSchema&, LogTime, ByteView,
               const std::map<std::string, std::string>&) override {
    topics.emplace(topic);
    return {};
  }
  std::set<std::string> topics;
};

TEST(Ros2Signals, BeyondTheChannelsOfAFileNoTopicIsKept) {
  const auto format = makeRos2Format();
  TopicSink sink;
  constexpr std::size_t kMore = ExportedMcap::kMostChannels + 1'000;
  for (std::size_t i = 0; i < kMore; ++i) {
    const SignalValue value{SignalKind::number, 1, {}, "u" + std::to_string(i)};
    const StatedSignal said{"load", &value, true};
    ASSERT_TRUE(format->signals(sink, LogTime{}, {"arm", ""}, std::span(&said, 1), false).ok());
  }
  EXPECT_EQ(sink.topics.size(), ExportedMcap::kMostChannels + 1)
      << "all that are beyond come on one topic, which is no channel's: the file counts them";
  EXPECT_TRUE(sink.topics.contains("/signals/arm/load_65535"));
  EXPECT_TRUE(sink.topics.contains("/signals/arm/load_65536"));
  Account account;
  format->addLeftOut(account);
  EXPECT_EQ(account.total(), ExportedMcap::kMostChannels - 1)
      << "none is said to be on a topic that the file has not";
}

TEST(Ros2Joints, BeyondTheChannelsOfAFileNoDeviceIsKept) {
  const auto format = makeRos2Format();
  TopicSink sink;
  const std::vector<NamedValue> joints = {{"a", 1}};
  for (std::size_t i = 0; i < ExportedMcap::kMostChannels + 1'000; ++i) {
    std::string name;  // ROS writes all of them alike
    for (std::size_t bit = 0; bit < 17; ++bit) name += (i >> bit & 1U) != 0 ? '-' : '.';
    ASSERT_TRUE(format->joints(sink, LogTime{}, name, joints).ok());
  }
  EXPECT_EQ(sink.topics.size(), ExportedMcap::kMostChannels + 1);
}

TEST(GivenNames, CostTheSameHoweverManyAreAlike) {
  GivenNames names;
  EXPECT_EQ(names.take("load_3"), "load_3");
  EXPECT_EQ(names.take("load"), "load");
  EXPECT_EQ(names.free("load"), "load_2");
  EXPECT_EQ(names.take("load"), "load_2");
  EXPECT_EQ(names.take("load"), "load_4");
  EXPECT_EQ(names.take("load_3"), "load_3_2");
  const std::uint64_t before = names.lookups();
  for (int i = 5; i < 2'000; ++i) EXPECT_EQ(names.take("load"), "load_" + std::to_string(i));
  EXPECT_LE(names.lookups() - before, 3U * 2'000U);
  EXPECT_EQ(names.free("load"), "load_2000");
  EXPECT_EQ(names.size(), 2'000U);
}

/// Owners and names that are one text when they are written behind each other.
const std::vector<std::pair<SignalOwner, std::string>> kAlike = {
    {{"arm", ""}, "1 load"}, {{"arm 1", ""}, "load"}, {{"a", "b"}, "x"}, {{"a/b", ""}, "x"}};

TEST(Ros2Signals, OfOwnersThatAreWrittenAlikeHaveTopicsOfTheirOwn) {
  const auto format = makeRos2Format();
  NotingSink sink;
  const SignalValue one = number(1);
  for (const auto& [owner, name] : kAlike) {
    const StatedSignal said{name, &one, true};
    ASSERT_TRUE(format->signals(sink, LogTime{}, owner, std::span(&said, 1), false).ok());
  }
  const std::string rest = " std_msgs/msg/Float64 000000000000F03F";
  EXPECT_THAT(sink.notes,
              testing::ElementsAre("/signals/arm/_1_load" + rest, "/signals/arm_1/load" + rest,
                                   "/signals/a/b/x" + rest, "/signals/a_b/x" + rest));
}

/// Notes topics and messages of text.
class TextSink final : public MessageSink {
 public:
  Status write(std::string_view topic, const MessageSchema& schema, LogTime, ByteView message,
               const std::map<std::string, std::string>&) override {
    EXPECT_EQ(schema.name, "rocinante" + std::string(topic));
    notes.push_back(std::string(topic) + " " + std::string(textOf(message)));
    return {};
  }
  std::vector<std::string> notes;
};

TEST(FoxgloveSignals, OfOwnersThatAreWrittenAlikeHaveTopicsOfTheirOwn) {
  const auto format = makeFoxgloveFormat();
  KnownSignals known;
  PacketTextDecoder decoder;
  known.notice(*decoder.decode(bytesOf("RK1 s 0 -\nsignals a/b x=1\nsignals a%2Fb x=1\n")));
  EXPECT_TRUE(format->knowSignals(known));
  TextSink sink;
  const SignalValue one = number(1);
  const StatedSignal said{"x", &one, true};
  for (const SignalOwner& owner : {SignalOwner("a", "b"), SignalOwner("a/b", "")}) {
    ASSERT_TRUE(format->signals(sink, LogTime{}, owner, std::span(&said, 1), false).ok());
  }
  EXPECT_THAT(sink.notes,
              testing::ElementsAre(R"(/signals/a/b {"x":1.0})", R"(/signals/a/b_2 {"x":1.0})"));
  Account account;
  format->addLeftOut(account);
  EXPECT_EQ(accountSentence(account),
            "left out: 1 topic `/signals/a/b` (it is another owner's: the signals of device `a/b` "
            "are on /signals/a/b_2)");
}

TEST(FoxgloveSignals, AMessageHasWhatIsNewOrAll) {
  const auto format = makeFoxgloveFormat();
  KnownSignals known;
  PacketTextDecoder decoder;
  known.notice(*decoder.decode(bytesOf("RK1 s 0 -\nsignals arm a=1 b=1\n")));
  EXPECT_TRUE(format->knowSignals(known));
  TextSink sink;
  const SignalValue one = number(1);
  const auto say = [&](const std::vector<StatedSignal>& said, bool all_requested) {
    ASSERT_TRUE(format->signals(sink, LogTime{}, {"arm", ""}, said, all_requested).ok());
  };
  const StatedSignal former{"a", &one, false}, recent{"b", &one, true}, unknown{"c", &one, true};
  say({former, recent}, true);
  say({former, recent}, false);
  say({former, unknown}, false);  // nothing to say
  say({}, true);
  EXPECT_THAT(sink.notes, testing::ElementsAre(R"(/signals/arm {"a":1.0,"b":1.0})",
                                               R"(/signals/arm {"b":1.0})", "/signals/arm {}"));
}

TEST(KnownSignals, WhatIsBeyondTheirBoundIsCounted) {
  KnownSignals known;
  PacketTextDecoder decoder;
  for (std::size_t packet = 0; packet < KnownSignals::kMost / 1024; ++packet) {
    std::string text = "RK1 s 0 -\nsignals arm";
    for (std::size_t i = 0; i < 1024; ++i) text += " n" + std::to_string(packet * 1024 + i) + "=1";
    known.notice(*decoder.decode(bytesOf(text)));
  }
  EXPECT_EQ(known.beyond().values, 0U);
  known.notice(*decoder.decode(
      bytesOf("RK1 s 1 -\nsignal arm n7 1 kg\nsignal arm more 1 kg\nsignals other a=1 b=2\n")));
  EXPECT_EQ(known.beyond().values, 3U);
  EXPECT_EQ(known.beyond().units, 1U);
  ASSERT_EQ(known.byOwner().size(), 1U);
  EXPECT_EQ(known.byOwner().begin()->second.at("n7").unit, "kg");
  EXPECT_EQ(known.byOwner().begin()->second.size(), KnownSignals::kMost);

  const auto told = [&](SessionFormat& format) {
    format.knowSignals(known);
    Account account;
    format.addLeftOut(account);
    return accountSentence(account);
  };
  EXPECT_EQ(
      told(*makeFoxgloveFormat()),
      "left out: 3 values `signal` (of signals beyond the first 65,536, which have no field)");
  EXPECT_THAT(told(*makeRos2Format()),
              testing::HasSubstr("1 unit (of signals beyond the first 65,536)"));
}

TEST(Ros2Signals, SpeedsAndEffortsAreThoseOfTheJoints) {
  DeviceState state;
  const auto say = [&](const char* name, SignalValue value) {
    state.signals[{"", name}].value = std::move(value);
  };
  say("b.velocity", number(3));
  say("x.velocity", number(4));
  say("a.effort", {SignalKind::text, 0, "none", {}});
  std::vector<NamedValue> values = {{"a", 1}, {"b", 2}};
  EXPECT_THAT(addSpeedsAndEfforts(state, values), testing::ElementsAre("b.velocity"));
  NotingSink sink;
  ASSERT_TRUE(makeRos2Format()->joints(sink, LogTime{}, "arm", values).ok());
  // Names, positions, NaN and 3, and no effort.
  EXPECT_THAT(sink.notes[0], testing::EndsWith("02000000000000000000F03F0000000000000040"
                                               "0200000000000000000000000000F87F0000000000000840"
                                               "00000000"));
}

TEST(Ros2Signals, AreThoseOfTheFirstValueOfAName) {
  DeviceState state;
  state.signals[{"", "1.velocity"}].value = number(3);
  state.signals[{"tip", "2.velocity"}].value = number(4);  // of a link: no joint's
  std::vector<NamedValue> values = {{"1", 0}, {"2", 0}, {"1", 0}};
  EXPECT_THAT(addSpeedsAndEfforts(state, values), testing::ElementsAre("1.velocity"));
  EXPECT_EQ(values[0].velocity, 3);
  EXPECT_TRUE(std::isnan(values[1].velocity));
  EXPECT_TRUE(std::isnan(values[2].velocity));
}

TEST(ConnectedRuns, AGapEndsARun) {
  Drawing drawing;
  using Part = std::vector<double>;
  drawing.parts = {Part{0, 0, 0}, Part{1, 1, 1}, std::nullopt,
                   std::nullopt,  Part{2, 2, 2}, std::nullopt};
  EXPECT_EQ(connectedRuns(drawing), (std::vector<Part>{{0, 0, 0, 1, 1, 1}, {2, 2, 2}}));
  drawing.parts = {std::nullopt};
  EXPECT_TRUE(connectedRuns(drawing).empty());
}

class PcapFileTest : public testing::Test {
 protected:
  Status write(std::int64_t time_ns, const char* from, const char* to, std::string_view text) {
    return file_.write(LogTime(Nanoseconds(time_ns)), SocketAddress::parse(from, 4000).value(),
                       SocketAddress::parse(to, 19960).value(), bytesOf(text));
  }

  Bytes bytes_;
  PcapFile file_{[this](ByteView bytes) -> Status {
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    return {};
  }};
};

TEST_F(PcapFileTest, IsNanosecondRawIpToTheByte) {
  ASSERT_TRUE(file_.begin().ok());
  ASSERT_TRUE(write(1'000'000'002, "127.0.0.1", "239.255.19.96", "RK1 a 0 0").ok());
  EXPECT_EQ(hex(bytes_),
            "4D3CB2A1"
            "02000400"
            "00000000"
            "00000000"
            "00000400"
            "65000000"
            "01000000"
            "02000000"
            "25000000"
            "25000000"
            "45000025"
            "00000000"
            "4011"
            "F867"
            "7F000001"
            "EFFF1360"
            "0FA0"
            "4DF8"
            "0011"
            "DB26"
            "524B31206120302030");
}

TEST_F(PcapFileTest, WritesIpv6AndRefusesOtherCenturies) {
  ASSERT_TRUE(write(0, "::1", "ff02::1", "x").ok());
  EXPECT_EQ(hex(ByteView(bytes_).subspan(16, 8)), "6000000000091140");
  EXPECT_EQ(bytes_.size(), 16U + 40 + 8 + 1);
  EXPECT_FALSE(write(-1, "127.0.0.1", "127.0.0.1", "x").ok());
  EXPECT_FALSE(write(std::int64_t{4'294'967'296} * 1'000'000'000, "::1", "::1", "x").ok());
}

TEST_F(PcapFileTest, HoldsTheLongestDatagram) {
  EXPECT_TRUE(write(0, "127.0.0.1", "127.0.0.1", std::string(kMaxPcapDatagramBytes, 'x')).ok());
  EXPECT_EQ(bytes_.size(), 16U + 65'535);
}

}  // namespace
}  // namespace rocinante
