#include "core/foreign/decode/datagram_decoders.h"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <bit>

#include "core/foreign/decode/checksum.h"
#include "core/packet/packet_text.h"

namespace rocinante::decode {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr std::int64_t kTime = 1'700'000'000'250'000'000;
const Route kRoute{19960, "10.0.0.7:4000", "/udp/19960/10.0.0.7"};

DatagramDecoders example(const std::string& name) {
  auto set = readDecoders(std::filesystem::path(ROCINANTE_SOURCE_DIR) / "examples/decoders" /
                          (name + ".decoders.toml"));
  EXPECT_TRUE(set) << set.error().text();
  return DatagramDecoders(*set);
}

DatagramDecoders declared(std::string_view text) {
  auto set = parseDecoders(text, "test");
  EXPECT_TRUE(set) << set.error().text();
  return DatagramDecoders(*set);
}

/// The packet's text, which must be a packet without faults; "" for none.
std::string decodedText(DatagramDecoders& decoders, ByteView payload, const Route& route = kRoute) {
  const DecodedPacket* const packet = decoders.decode(route, kTime, payload);
  if (packet == nullptr) return "";
  PacketTextDecoder reader;
  EXPECT_NE(reader.decode(rocinante::bytesOf(packet->text)), nullptr);
  EXPECT_TRUE(reader.faults().empty()) << packet->text;
  return std::string(packet->text);
}

std::string decodedText(DatagramDecoders& decoders, std::string_view payload) {
  return decodedText(decoders, rocinante::bytesOf(payload));
}

template <class Whole>
void append(Bytes& bytes, Whole whole, bool little_endian = true) {
  for (std::size_t i = 0; i < sizeof whole; ++i) {
    const std::size_t shift = 8 * (little_endian ? i : sizeof whole - 1 - i);
    bytes.push_back(static_cast<std::byte>((whole >> shift) & 0xFFU));
  }
}

constexpr std::string_view kTelegram =
    "<Rob Type=\"KUKA\">\n<RIst X=\"445.0\" Y=\"0.0\" Z=\"790.0\" A=\"90.0\" B=\"0.0\" C=\"0.0\"/>"
    "<RSol X=\"445.0\" Y=\"0.0\" Z=\"790.0\" A=\"180.0\" B=\"0.0\" C=\"180.0\"/>"
    "<AIPos A1=\"0.0\" A2=\"-90.0\" A3=\"90.0\" A4=\"0.0\" A5=\"45.0\" A6=\"180.0\"/>"
    "<Delay D=\"0\"/><IPOC>4208163634</IPOC></Rob>";

TEST(DatagramDecoders, ReadTheTelegramOfAKuka) {
  DatagramDecoders decoders = example("kuka_rsi");
  EXPECT_EQ(decodedText(decoders, kTelegram),
            "RK1 decoded:kuka - 1700000000.25\n"
            "joint kr10 joint_a1=0 joint_a2=-1.5707963267948966 joint_a3=1.5707963267948966 "
            "joint_a4=0 joint_a5=0.7853981633974483 joint_a6=3.141592653589793\n"
            "pose tool 0.445 0 0.79 0 0 0.7071067811865475 0.7071067811865476");
}

TEST(DatagramDecoders, SayAnEventWhenItsFieldChanges) {
  DatagramDecoders decoders = example("kuka_rsi");
  EXPECT_THAT(decodedText(decoders, kTelegram), Not(HasSubstr("event")));
  std::string late(kTelegram);
  late.replace(late.find("D=\"0\""), 5, "D=\"3\"");
  EXPECT_THAT(decodedText(decoders, late), HasSubstr("\nevent \"3 answers came late\""));
  EXPECT_THAT(decodedText(decoders, late), Not(HasSubstr("event")));
  // Another sender has a past of its own.
  const Route other{19960, "10.0.0.8:4000", ""};
  EXPECT_THAT(decodedText(decoders, rocinante::bytesOf(kTelegram), other), Not(HasSubstr("event")));
}

Bytes urPacket(const std::array<double, 6>& q) {
  Bytes packet;
  append(packet, std::uint32_t{1108}, false);
  packet.resize(252);
  for (const double each : q) append(packet, std::bit_cast<std::uint64_t>(each), false);
  packet.resize(1108);
  return packet;
}

TEST(DatagramDecoders, ReadTheRealTimePacketOfAUr) {
  DatagramDecoders decoders = example("ur_realtime");
  EXPECT_EQ(decodedText(decoders, urPacket({0.1, -1.5, 2, -0.5, 1e-3, 0})),
            "RK1 decoded:ur - 1700000000.25\n"
            "joint ur5 shoulder_pan_joint=0.1 shoulder_lift_joint=-1.5 elbow_joint=2 "
            "wrist_1_joint=-0.5 wrist_2_joint=0.001 wrist_3_joint=0");
  EXPECT_EQ(decodedText(decoders, ByteView(urPacket({})).first(1107)), "");
}

TEST(DatagramDecoders, LeaveOutNumbersThatAreNone) {
  DatagramDecoders decoders = example("ur_realtime");
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_THAT(decodedText(decoders, urPacket({std::nan(""), infinite, -infinite, 1, 2, 3})),
              HasSubstr("\njoint ur5 wrist_1_joint=1 wrist_2_joint=2 wrist_3_joint=3"));
  ASSERT_EQ(decoders.notFinite().size(), 3U);
  EXPECT_EQ(decoders.notFinite()[0].source, "decoded:ur");
  EXPECT_EQ(
      decodedText(decoders, urPacket({infinite, infinite, infinite, infinite, infinite, infinite})),
      "");
  EXPECT_EQ(decoders.notFinite().size(), 6U) << "also where no packet comes of it";
  decodedText(decoders, urPacket({}));
  EXPECT_TRUE(decoders.notFinite().empty());
}

/// ATTITUDE of MAVLink 2, as a vehicle's autopilot sends it.
Bytes attitude(float roll, float pitch, float yaw, std::uint8_t extra = 39) {
  Bytes payload;
  append(payload, std::uint32_t{12345});
  for (const float each : {roll, pitch, yaw, 0.0F, 0.0F, 0.0F}) {
    append(payload, std::bit_cast<std::uint32_t>(each));
  }
  while (payload.size() > 1 && payload.back() == std::byte{0}) payload.pop_back();
  Bytes frame;
  for (const unsigned each :
       {0xFDU, static_cast<unsigned>(payload.size()), 0U, 0U, 7U, 1U, 1U, 30U, 0U, 0U}) {
    frame.push_back(static_cast<std::byte>(each));
  }
  frame.insert(frame.end(), payload.begin(), payload.end());
  const Bytes then{static_cast<std::byte>(extra)};
  append(frame, static_cast<std::uint16_t>(
                    checksumOf(ChecksumKind::crc16_mcrf4xx, ByteView(frame).subspan(1), then)));
  return frame;
}

TEST(DatagramDecoders, ReadTheAttitudeOfAMavlinkVehicle) {
  DatagramDecoders decoders = example("mavlink_attitude");
  EXPECT_EQ(decodedText(decoders, attitude(0, 0, 0)),
            "RK1 decoded:mavlink - 1700000000.25\npose vehicle-1 0 0 0 0 0 0 1");
  // A nose down by a quarter turn: positive about y, which points left here.
  EXPECT_THAT(decodedText(decoders, attitude(0, -1.5707963705062866F, 0)),
              StartsWith("RK1 decoded:mavlink - 1700000000.25\npose vehicle-1 0 0 0 0 0.70710679"));
}

TEST(DatagramDecoders, RefuseAWrongChecksumWhereverAByteIsWrong) {
  DatagramDecoders decoders = example("mavlink_attitude");
  const Bytes sound = attitude(0.1F, 0.2F, 0.3F);
  for (std::size_t place = 1; place < sound.size(); ++place) {
    Bytes broken = sound;
    broken[place] ^= std::byte{0x40};
    EXPECT_EQ(decodedText(decoders, broken), "") << place;
  }
  EXPECT_EQ(decodedText(decoders, attitude(0.1F, 0.2F, 0.3F, 40)), "");
  EXPECT_EQ(decoders.counts()[0].refused, sound.size());
  EXPECT_EQ(decoders.counts()[0].last_reason, "its checksum is wrong");
}

TEST(DatagramDecoders, ReadSentencesAndLeaveOutEmptyColumns) {
  DatagramDecoders decoders = example("nmea_arm");
  const auto sentence = [](std::string body) {
    const std::uint32_t sum = checksumOf(ChecksumKind::xor8, rocinante::bytesOf(body), {});
    char digits[3];
    std::snprintf(digits, sizeof digits, "%02X", sum);
    return "$" + body + "*" + digits + "\r\n";
  };
  EXPECT_EQ(decodedText(decoders, sentence("ARM,idle,90,-45,250")),
            "RK1 decoded:sentences - 1700000000.25\njoint arm lift=0.25 "
            "shoulder=1.5707963267948966 elbow=-0.7853981633974483");
  EXPECT_EQ(decodedText(decoders, sentence("ARM,busy,,,500")),
            "RK1 decoded:sentences - 1700000000.25\njoint arm lift=0.5\nevent \"state busy\"");
  EXPECT_EQ(decodedText(decoders, "$ARM,idle,90,-45,250*00"), "");
  EXPECT_EQ(decodedText(decoders, "$ARM,idle,90,-45,250"), "");
}

TEST(DatagramDecoders, ReadJson) {
  DatagramDecoders decoders = example("json_cell");
  EXPECT_EQ(decodedText(decoders,
                        R"({"robot":{"name":"left arm","joints":[0.1,"0.2"]},
                            "pose":{"x":1,"y":-2,"q":[0.5,0.5,0.5,0.5]},"more":[{}]})"),
            "RK1 decoded:cell - 1700000000.25\njoint left%20arm shoulder=0.1 elbow=0.2\n"
            "pose cart 1 -2 0.25 0.5 0.5 0.5 0.5");
  EXPECT_EQ(decodedText(decoders, R"({"robot":{"name":"","joints":[0.1,0.2]}})"), "");
  EXPECT_EQ(decodedText(decoders, R"({"robot":)"), "");
  EXPECT_EQ(decodedText(decoders, std::string(100'000, '[')), "");
  EXPECT_EQ(decodedText(decoders, "{\"robot\":" + std::string(100'000, '[')), "");
}

TEST(DatagramDecoders, FindWhatNoDeclarationPointsTo) {
  DatagramDecoders decoders = example("json_cell");
  const std::string_view text = R"({"robot":{"name":"a","joints":[0.1,0.2,0.3]},"a/b":"c"})";
  const auto found = decoders.undeclared(kRoute, rocinante::bytesOf(text), 10);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].name, "/a~1b");
  EXPECT_EQ(found[0].value, "c");
  EXPECT_EQ(found[1].name, "/robot/joints/2");
  EXPECT_EQ(decoders.undeclared(kRoute, rocinante::bytesOf(text), 1).size(), 1U);
  DatagramDecoders xml = example("kuka_rsi");
  const auto in_xml = xml.undeclared(kRoute, rocinante::bytesOf(kTelegram), 100);
  ASSERT_EQ(in_xml.size(), 8U);
  EXPECT_EQ(in_xml[0].name, "@Type");
  EXPECT_EQ(in_xml[7].name, "IPOC");
}

TEST(DatagramDecoders, ChooseByPortSenderTopicAndLength) {
  DatagramDecoders decoders = declared(R"(
[[decoder]]
name = "a"
kind = "struct"
port = [1, 19960]
from = ["10.0.0.*", "fe80::*"]
topic = "/udp/*"
bytes = [2, 3]
[[decoder.field]]
name = "q"
at = 0
type = "i16"
[[decoder.joint]]
device = "d"
joint = "j"
field = "q"
)");
  const Bytes two{std::byte{0xFE}, std::byte{0xFF}};
  EXPECT_THAT(decodedText(decoders, two), HasSubstr("joint d j=-2"));
  EXPECT_EQ(decodedText(decoders, Bytes(1)), "");
  EXPECT_EQ(decodedText(decoders, Bytes(4)), "");
  EXPECT_EQ(decodedText(decoders, two, {2, "10.0.0.7:4000", "/udp/2/x"}), "");
  EXPECT_EQ(decodedText(decoders, two, {1, "10.0.1.7:4000", "/udp/1/x"}), "");
  EXPECT_EQ(decodedText(decoders, two, {1, "", "/udp/1/x"}), "");
  EXPECT_NE(decodedText(decoders, two, {1, "[fe80::1]:4", "/udp/1/x"}), "");
  EXPECT_EQ(decodedText(decoders, two, {1, "10.0.0.7:4000", "/nats/x"}), "");
}

TEST(DatagramDecoders, ReadBitFieldsOfBothOrders) {
  DatagramDecoders decoders = declared(R"(
[[decoder]]
name = "a"
kind = "struct"
byte_order = "big"
[[decoder.field]]
name = "low"
at = 0
type = "u16"
bits = [0, 4]
[[decoder.field]]
name = "signed"
at = 0
type = "i16"
bits = [4, 12]
[[decoder.field]]
name = "little"
at = 0
type = "u16"
byte_order = "little"
[[decoder.field]]
name = "wide"
at = 2
type = "i24"
[[decoder.joints]]
device = "d"
joints = ["low", "signed", "little", "wide"]
fields = ["low", "signed", "little", "wide"]
)");
  Bytes bytes;
  for (const unsigned each : {0xFFU, 0x5AU, 0xFFU, 0xFFU, 0xFEU}) {
    bytes.push_back(static_cast<std::byte>(each));
  }
  EXPECT_THAT(decodedText(decoders, bytes),
              HasSubstr("joint d low=10 signed=-11 little=23295 wide=-2"));
}

TEST(DatagramDecoders, ADatagramCutAnywhereMakesAPacketOrNone) {
  const Bytes ur = urPacket({1, 2, 3, 4, 5, 6});
  const Bytes mavlink = attitude(1, 2, 3);
  const Bytes drive(16);
  const std::string_view json = R"({"robot":{"name":"l","joints":[0.1,0.2]},"pose":{"x":1}})";
  const std::pair<std::string, ByteView> cases[] = {
      {"ur_realtime", ur},
      {"mavlink_attitude", mavlink},
      {"kuka_rsi", rocinante::bytesOf(kTelegram)},
      {"json_cell", rocinante::bytesOf(json)},
      {"drive_telegram", drive},
  };
  for (const auto& [name, whole] : cases) {
    DatagramDecoders decoders = example(name);
    EXPECT_NE(decodedText(decoders, whole), "") << name;
    for (std::size_t bytes = 0; bytes < whole.size(); ++bytes) {
      // A buffer of its own, so that the sanitizer sees one byte too many.
      const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(bytes));
      EXPECT_EQ(decodedText(decoders, cut), "") << name << " cut at " << bytes;
    }
  }
}

RC_GTEST_PROP(DatagramDecoders, WhatTheyMakeOfAnyTextIsAPacketWithoutFaults,
              (const std::string& name, double number)) {
  DatagramDecoders decoders = declared(R"(
[[decoder]]
name = "a"
kind = "delimited"
separator = "|"
[[decoder.field]]
name = "name"
column = 0
[[decoder.field]]
name = "q"
column = 1
[[decoder.joint]]
device = "d-{name}"
joint = "j"
field = "q"
[[decoder.event]]
text = "{name}"
changes = "name"
)");
  const std::string text = name + "|" + std::to_string(number);
  for (const std::string& each : {std::string("before|1"), text}) {
    const DecodedPacket* const packet = decoders.decode(kRoute, kTime, rocinante::bytesOf(each));
    if (packet == nullptr) continue;
    PacketTextDecoder reader;
    RC_ASSERT(reader.decode(rocinante::bytesOf(packet->text)) != nullptr);
    RC_ASSERT(reader.faults().empty());
  }
}

}  // namespace
}  // namespace rocinante::decode
