#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "core/packet/packet_text.h"
#include "tests/core/packet/fold_text.h"

namespace rocinante {
namespace {

using test::faultsOf;
using ::testing::ElementsAre;

class StatementText : public ::testing::Test {
 protected:
  /// The only statement of `line`, which must not have a fault.
  const Statement& read(const std::string& line) {
    text_ = "RK1 me - -\n" + line;
    const Packet* const packet = decoder_.decode(bytesOf(text_));
    static const Statement kNone;
    if (packet == nullptr || !packet->faults.empty() || packet->statements.size() != 1) {
      ADD_FAILURE() << line << "\n" << faultsOf(text_);
      return kNone;
    }
    return packet->statements[0];
  }
  std::string text_;
  PacketTextDecoder decoder_;
};

TEST_F(StatementText, JointsOrderAndJoint) {
  const Statement& joints = read("joints arm 0 -1.5 +2e-3 .5 5.");
  EXPECT_EQ(joints.kind, StatementKind::joints);
  EXPECT_EQ(joints.name, "arm");
  EXPECT_THAT(joints.numbers, ElementsAre(0, -1.5, 2e-3, 0.5, 5));

  const Statement& order = read("order arm shoulder pan%20tilt");
  EXPECT_EQ(order.kind, StatementKind::order);
  EXPECT_THAT(order.names, ElementsAre("shoulder", "pan tilt"));
  EXPECT_TRUE(read("order arm").names.empty());

  const Statement& joint = read("joint arm a=1 b%3D=-2.25");
  EXPECT_EQ(joint.kind, StatementKind::joint);
  EXPECT_THAT(joint.names, ElementsAre("a", "b="));
  EXPECT_THAT(joint.numbers, ElementsAre(1, -2.25));
}

TEST_F(StatementText, JointsUnderANamedOrder) {
  const Statement& joints = read("joints arm @09B0af70 1 -2");
  EXPECT_EQ(joints.order_tag, 0x09b0af70U);
  EXPECT_THAT(joints.numbers, ElementsAre(1, -2));
  EXPECT_EQ(statementText(joints), "joints arm @09b0af70 1 -2");
  EXPECT_FALSE(read("joints arm 1 -2").order_tag);
  for (const char* tag : {"@", "@9b0af70", "@009b0af70", "@09b0af7g", "@-9b0af70"}) {
    EXPECT_EQ(faultsOf("RK1 m - -\njoints arm " + std::string(tag) + " 1\n"), "2 12 bad_number\n");
  }
  EXPECT_EQ(faultsOf("RK1 m - -\njoints arm @09b0af70\n"), "2 21 missing_field\n");
  EXPECT_EQ(faultsOf("RK1 m - -\njoints arm 1 @09b0af70\n"), "2 14 bad_number\n");
  EXPECT_EQ(faultsOf("RK1 m - -\njoints @09b0af70 1\n"), "2 8 bad_name\n");
}

TEST_F(StatementText, PoseWithAndWithoutCarrier) {
  const Statement& pose = read("pose part 1 2 3 0 0 0.6 0.8 in arm/tool%2F0");
  EXPECT_EQ(pose.kind, StatementKind::pose);
  EXPECT_THAT(pose.numbers, ElementsAre(1, 2, 3, 0, 0, 0.6, 0.8));
  EXPECT_EQ(pose.carrier.first, "arm");
  EXPECT_EQ(pose.carrier.second, "tool/0");
  EXPECT_EQ(read("pose part 1 2 3 0 0 0 1").carrier.first, "");
}

TEST_F(StatementText, QuaternionsAreNormalisedOnceAndStaySo) {
  EXPECT_THAT(read("pose p 0 0 0 0 0 0 1.0005").numbers, ElementsAre(0, 0, 0, 0, 0, 0, 1));
  EXPECT_EQ(faultsOf("RK1 m - -\npose p 0 0 0 0 0 0 1.002"), "2 14 unnormalised_quaternion\n");
  for (const char* const q : {"3 0 4 0", "1e300 -1e300 0 0", "5e-324 0 0 0", "0.1 0.2 0.3 0.4",
                              "-1e-310 1e308 1e308 1e308",
                              "0.1825741858350554 0.3651483716701107 "
                              "0.5477225575051661 0.7302967433402214"}) {
    SCOPED_TRACE(q);
    const std::string text = "RK1 m - -\npose p 0 0 0 " + std::string(q);
    const Packet* packet = decoder_.decode(bytesOf(text));
    ASSERT_EQ(packet->statements.size(), 1U);
    const std::vector<double> once(packet->statements[0].numbers.begin(),
                                   packet->statements[0].numbers.end());
    double squared = 0;
    for (std::size_t i = 3; i < 7; ++i) squared += once[i] * once[i];
    EXPECT_NEAR(squared, 1, 1e-14);
    const std::string again = statementText(packet->statements[0]);
    EXPECT_EQ(std::vector<double>(read(again).numbers.begin(), read(again).numbers.end()), once);
  }
}

TEST_F(StatementText, AddAndRemove) {
  const Statement& add = read("add arm puma560 kin=00ff00FF00ff00ff");
  EXPECT_EQ(add.kind, StatementKind::add);
  EXPECT_EQ(add.name, "arm");
  EXPECT_EQ(add.text, "puma560");
  EXPECT_EQ(add.kinematics, 0x00ff00ff00ff00ffU);
  EXPECT_FALSE(read("add arm puma560").kinematics);
  EXPECT_EQ(read("remove arm").kind, StatementKind::remove);
}

TEST_F(StatementText, PathsNameDevicesLinksAndLayers) {
  const Statement& whole = read("show arm");
  EXPECT_EQ(whole.kind, StatementKind::show);
  EXPECT_EQ(whole.path.first, "arm");
  EXPECT_EQ(whole.path.second, "");
  EXPECT_FALSE(whole.path.is_layer || whole.is_default);
  EXPECT_TRUE(read("show arm/l1 default").is_default);
  EXPECT_EQ(read("hide arm/l%2F1").path.second, "l/1");
  EXPECT_TRUE(read("hide layer/safety").path.is_layer);
  EXPECT_EQ(read("hide layer/safety").path.second, "safety");
  // A device called "layer", and a link of it.
  EXPECT_FALSE(read("hide layer").path.is_layer);
  EXPECT_FALSE(read("hide %6Cayer/l1").path.is_layer);
  EXPECT_EQ(read("hide %6Cayer/l1").path.first, "layer");
}

TEST_F(StatementText, Colors) {
  EXPECT_EQ(read("color arm #10Aa30").rgba, 0x10AA30FFU);
  EXPECT_EQ(read("color arm/l1 #10203040").rgba, 0x10203040U);
  EXPECT_TRUE(read("color layer/a default").is_default);
}

TEST_F(StatementText, Drawings) {
  const Statement& line = read("line path:2/3 #ff0000 width=2.5 in arm/tool 0 0 0 1 1 1");
  EXPECT_EQ(line.kind, StatementKind::line);
  EXPECT_EQ(line.name, "path");
  EXPECT_EQ(line.part_index, 2U);
  EXPECT_EQ(line.part_count, 3U);
  EXPECT_EQ(line.size_px, 2.5);
  EXPECT_EQ(line.carrier.second, "tool");
  EXPECT_THAT(line.numbers, ElementsAre(0, 0, 0, 1, 1, 1));
  EXPECT_EQ(read("line a:b #ff0000 0 0 0").name, "a:b");
  EXPECT_EQ(read("points p #ff000080 in a/b size=4 1 2 3").size_px, 4);
  const Statement& label = read(R"(label n in arm/l1 1 2 3 "a \"b\" \\ \n	é")");
  EXPECT_EQ(label.text, "a \"b\" \\ \n\té");
  EXPECT_THAT(label.numbers, ElementsAre(1, 2, 3));
  EXPECT_EQ(read("erase path").name, "path");
  EXPECT_EQ(read("erase *").name, "");
}

TEST_F(StatementText, EventViewAndSeen) {
  EXPECT_EQ(read("event \"\"").text, "");
  EXPECT_EQ(read("event \"picked up\"  ").text, "picked up");
  const Statement& view = read("view top 1 2 3 4 5 6 45");
  EXPECT_THAT(view.numbers, ElementsAre(1, 2, 3, 4, 5, 6, 45, 0, 0, 1));
  EXPECT_FALSE(view.ortho_height_m);
  const Statement& riding = read("view top 1 2 3 4 5 6 45 in arm/l1 ortho 2 up 0 1 0");
  EXPECT_THAT(riding.numbers, ElementsAre(1, 2, 3, 4, 5, 6, 45, 0, 1, 0));
  EXPECT_EQ(riding.ortho_height_m, 2);
  EXPECT_EQ(riding.carrier.first, "arm");
  EXPECT_EQ(read("seen arm 1700000000000000001").seen_ns, 1700000000000000001);
}

TEST_F(StatementText, ASignatureAsTheLastLineIsReserved) {
  EXPECT_EQ(faultsOf("RK1 m - -\nremove a\nsig key QUJD\n\n"), "");
  EXPECT_EQ(faultsOf("RK1 m - -\nsig key QUJD\nremove a"), "2 1 unknown_statement\n");
}

TEST_F(StatementText, AMalformedLineDiscardsThatLineAlone) {
  const std::string text = "RK1 m - -\njoints a 1 x\njoints b 1 2\njoint b q=1 r\nremove c\n";
  EXPECT_EQ(faultsOf(text), "2 12 bad_number\n4 13 bad_name\n");
  PacketTextDecoder decoder;
  const Packet* const packet = decoder.decode(bytesOf(text));
  ASSERT_EQ(packet->statements.size(), 2U);
  EXPECT_EQ(packet->statements[0].name, "b");
  EXPECT_THAT(packet->statements[0].numbers, ElementsAre(1, 2));
  EXPECT_EQ(packet->statements[1].kind, StatementKind::remove);
}

TEST_F(StatementText, EachMalformedLineSaysWhatAndWhere) {
  const struct {
    const char* line;
    const char* fault;
  } kCases[] = {
      {"wave arm", "1 unknown_statement"},
      {"Joints arm 1", "1 unknown_statement"},
      {"joints", "7 missing_field"},
      {"joints arm", "11 missing_field"},
      {"joints arm 1 nan", "14 bad_number"},
      {"joints arm inf", "12 bad_number"},
      {"joints arm -inf", "12 bad_number"},
      {"joints arm 0x10", "12 bad_number"},
      {"joints arm 1,5", "12 bad_number"},
      {"joints arm 1e999", "12 bad_number"},
      {"joints arm 1e", "12 bad_number"},
      {"joints arm .", "12 bad_number"},
      {"joints arm +-1", "12 bad_number"},
      {"joints arm 1d0", "12 bad_number"},
      {"joints ärm 1", "8 bad_name"},
      {"joints arm/l 1", "8 bad_name"},
      {"order arm a b*", "13 bad_name"},
      {"joint arm", "10 missing_field"},
      {"joint arm 1", "11 bad_name"},
      {"joint arm =1", "11 bad_name"},
      {"joint arm a=", "13 bad_number"},
      {"joint arm a=1=2", "13 bad_number"},
      {"pose p 0 0 0 0 0 0", "19 missing_field"},
      {"pose p 0 0 0 0 0 0 0", "14 zero_quaternion"},
      {"pose p 0 0 0 0 0 0 1 in", "24 missing_field"},
      {"pose p 0 0 0 0 0 0 1 in arm", "25 bad_path"},
      {"pose p 0 0 0 0 0 0 1 in arm/", "25 bad_path"},
      {"pose p 0 0 0 0 0 0 1 in a/b c", "29 extra_field"},
      {"pose p 0 0 0 0 0 0 1 2", "22 extra_field"},
      {"add arm", "8 missing_field"},
      {"add arm m kin=12", "11 bad_number"},
      {"add arm m kin=0123456789abcdeg", "11 bad_number"},
      {"add arm m n", "11 extra_field"},
      {"remove", "7 missing_field"},
      {"remove a b", "10 extra_field"},
      {"show", "5 missing_field"},
      {"show a/b/c", "6 bad_path"},
      {"show /b", "6 bad_path"},
      {"show layer/", "6 bad_path"},
      {"hide a default", "8 extra_field"},
      {"color a", "8 missing_field"},
      {"color a red", "9 bad_color"},
      {"color a #12345", "9 bad_color"},
      {"color a #1234567", "9 bad_color"},
      {"color a #12345g", "9 bad_color"},
      {"line a #ffffff", "15 missing_field"},
      {"line a #ffffff 1 2", "19 missing_field"},
      {"line a #ffffff 1 2 3 4", "23 missing_field"},
      {"line a 1 2 3", "8 bad_color"},
      {"line a:0/2 #ffffff 1 2 3", "6 bad_name"},
      {"line a:3/2 #ffffff 1 2 3", "6 bad_name"},
      {"line a/2 #ffffff 1 2 3", "6 bad_name"},
      {"line a:1/4097 #ffffff 1 2 3", "6 too_many"},
      {"line a #ffffff width=0 1 2 3", "22 bad_number"},
      {"line a #ffffff width=1 width=2 1 2 3", "24 bad_number"},
      {"line a #ffffff size=1 1 2 3", "16 bad_number"},
      {"label a 1 2 3", "14 missing_field"},
      {"label a 1 2 3 b", "15 bad_string"},
      {"label a 1 2 3 \"b", "15 bad_string"},
      {"label a 1 2 3 \"b\\\"", "15 bad_string"},
      {"label a 1 2 3 \"b\\t\"", "15 bad_string"},
      {"label a 1 2 3 \"\xFF\"", "15 bad_string"},
      {"label a 1 2 3 \"\x1B[31m\"", "15 bad_string"},
      {"label a 1 2 3 \"b\"c", "15 bad_string"},
      {"label a 1 2 3 \"b\" c", "19 extra_field"},
      {"label a:1/2 1 2 3 \"b\"", "7 bad_name"},
      {"erase", "6 missing_field"},
      {"erase a b", "9 extra_field"},
      {"erase a*", "7 bad_name"},
      {"event", "6 missing_field"},
      {"view v 1 2 3 4 5 6", "19 missing_field"},
      {"view v 1 2 3 4 5 6 0", "20 bad_number"},
      {"view v 1 2 3 4 5 6 180", "20 bad_number"},
      {"view v 1 2 3 1 2 3 45", "20 bad_number"},
      {"view v 1 2 3 4 5 6 45 up 0 0 0", "23 bad_number"},
      {"view v 1 2 3 4 5 6 45 ortho -1", "29 bad_number"},
      {"view v 1 2 3 4 5 6 45 ortho", "28 missing_field"},
      {"view v 1 2 3 4 5 6 45 over", "23 extra_field"},
      {"seen a", "7 missing_field"},
      {"seen a -1", "8 bad_number"},
      {"seen a 9223372036854775808", "8 bad_number"},
      {"seen a 1.5", "8 bad_number"},
  };
  for (const auto& c : kCases) {
    SCOPED_TRACE(c.line);
    EXPECT_EQ(faultsOf("RK1 m - -\n" + std::string(c.line)), "2 " + std::string(c.fault) + "\n");
  }
}

TEST_F(StatementText, ListsAreBounded) {
  const auto repeated = [](std::string text, const char* field, int count) {
    for (int i = 0; i < count; ++i) text += field;
    return text;
  };
  EXPECT_EQ(read(repeated("joints a", " 1", 4096)).numbers.size(), 4096U);
  EXPECT_EQ(faultsOf("RK1 m - -\n" + repeated("joints a", " 1", 4097)), "2 8202 too_many\n");
  EXPECT_EQ(read(repeated("order a", " j", 4096)).names.size(), 4096U);
  EXPECT_EQ(faultsOf("RK1 m - -\n" + repeated("order a", " j", 4097)), "2 8201 too_many\n");
  EXPECT_EQ(faultsOf("RK1 m - -\n" + repeated("joint a", " j=1", 4097)), "2 16393 too_many\n");
  EXPECT_EQ(read("event \"" + std::string(4096, 'x') + "\"").text.size(), 4096U);
  EXPECT_EQ(faultsOf("RK1 m - -\nevent \"" + std::string(4097, 'x') + "\""), "2 7 bad_string\n");
  EXPECT_EQ(read(repeated("points p #ffffff", " 1 2 3", 50000)).numbers.size(), 150000U);
}

TEST_F(StatementText, WhatIsWrittenIsCanonical) {
  const char* const kLines[] = {
      "joints arm 0 -1.5 0.002 1e+300",
      "order arm a b",
      "order arm",
      "joint arm a=1 b=-2.25",
      "pose part 1 2 3 0 0 0.6 0.8 in arm/tool%2F0",
      "add arm puma560 kin=00ff00ff00ff00ff",
      "remove arm",
      "show arm/l1 default",
      "show layer/a",
      "hide layer",
      "hide %6Cayer/l1",
      "color arm #10aa30",
      "color arm #10aa3000",
      "color arm/l1 default",
      "line path:2/3 #ff0000 width=2.5 in arm/tool 0 0 0 1 1 1",
      "points a:b #ff000080 size=4 1 2 3",
      "label n in arm/l1 1 2 3 \"a \\\"b\\\" \\\\ \\n \xC3\xA9\"",
      "erase path",
      "erase *",
      "event \"picked\"",
      "view top 1 2 3 4 5 6 45 up 0 1 0 ortho 2 in arm/l1",
      "seen arm 1700000000000000001",
      // Values that are written in place, and those whose names must be encoded.
      "joint arm a=0 b=-2.2250738585072014e-308 c=1e+22",
      "joint arm a=1 b%20b=2 c=3",
      "signals arm a=true b=false c=-0.1",
      "signals - a=true %C3%BC=false c=0",
  };
  for (const char* const line : kLines) EXPECT_EQ(statementText(read(line)), line);
}

TEST_F(StatementText, TheWriterNeverWritesAStringThatCannotBeRead) {
  Statement statement;
  statement.kind = StatementKind::event;
  statement.text = "a\xFF\x1B\r\t\n\xED\xA0\x80z";
  EXPECT_EQ(read(statementText(statement)).text, "a\uFFFD\uFFFD\uFFFD\t\n\uFFFD\uFFFD\uFFFDz");
}

}  // namespace
}  // namespace rocinante
