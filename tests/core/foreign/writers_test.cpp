#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "core/foreign/foxglove/foxglove_format.h"
#include "core/foreign/pcap/pcap_file.h"
#include "core/foreign/proto/proto_schema.h"
#include "core/foreign/proto/proto_writer.h"
#include "core/foreign/ros_out/cdr_writer.h"
#include "core/foreign/ros_out/ros2_format.h"
#include "core/foreign/session/session_format.h"

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
