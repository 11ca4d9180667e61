// Signals of decoders: numbers, bits, enumerations and texts, of every kind of datagram.

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>

#include "core/foreign/decode/datagram_decoders.h"
#include "core/packet/packet_text.h"

namespace rocinante::decode {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::UnorderedElementsAre;

/// The statements that decoders make of datagrams, without the header.
class DecodedSignals {
 public:
  /// `file`: beside which descriptors lie.
  explicit DecodedSignals(std::string_view text, const std::filesystem::path& file = "test")
      : DecodedSignals(parseDecoders(text, file.string())) {}
  static DecodedSignals ofExample(const std::string& name) {
    return DecodedSignals(readDecoders(std::filesystem::path(ROCINANTE_SOURCE_DIR) /
                                       "examples/decoders" / (name + ".decoders.toml")));
  }

  std::string of(ByteView payload) {
    const DecodedPacket* const packet = decoders_->decode({}, 1'000'000'000, payload);
    if (packet == nullptr) return "";
    PacketTextDecoder reader;
    EXPECT_NE(reader.decode(rocinante::bytesOf(packet->text)), nullptr);
    EXPECT_TRUE(reader.faults().empty()) << packet->text;
    return std::string(packet->text.substr(packet->text.find('\n') + 1));
  }
  std::string of(std::string_view payload) { return of(rocinante::bytesOf(payload)); }

  std::vector<std::string> leftOut() const {
    std::vector<std::string> texts;
    const Account account = decoders_->leftOut();
    for (const LeftOut& one : account.leftOut()) texts.push_back(one.text());
    return texts;
  }

 private:
  explicit DecodedSignals(Result<std::shared_ptr<const DecoderSet>> set) {
    EXPECT_TRUE(set) << set.error().text();
    decoders_.emplace(*set);
  }
  std::optional<DatagramDecoders> decoders_;
};

Bytes telegram(std::uint16_t status, float force) {
  Bytes bytes(16);
  bytes[0] = static_cast<std::byte>(status >> 8U);
  bytes[1] = static_cast<std::byte>(status & 0xFFU);
  bytes[3] = std::byte{150};
  bytes[4] = bytes[5] = std::byte{0xFF};
  bytes[8] = std::byte{65};
  const auto bits = std::bit_cast<std::uint32_t>(force);
  for (unsigned i = 0; i < 4; ++i) bytes[12 + i] = static_cast<std::byte>(bits >> (24 - 8 * i));
  return bytes;
}

TEST(DecodedSignals, OfADrive) {
  DecodedSignals drive = DecodedSignals::ofExample("drive_telegram");
  const std::string numbers =
      "signal arm j1.current 1.5 A\nsignal arm j2.current -0.01 A\nsignal arm j3.current 0 A\n";
  EXPECT_EQ(drive.of(telegram(0x18, 12.5F)),
            "signal arm temperature 25 degC\nsignal arm/tool0 force 12.5 N\nsignal - estop true\n"
            "signal arm mode \"auto\"\n" +
                numbers.substr(0, numbers.size() - 1));
  EXPECT_THAT(drive.leftOut(), IsEmpty());
  // A mode without a name is stated as digits; a force that is none is not, and both are counted.
  EXPECT_EQ(drive.of(telegram(0x50, std::nanf(""))),
            "signal arm temperature 25 degC\nsignal - estop false\nsignal arm mode \"5\"\n" +
                numbers.substr(0, numbers.size() - 1));
  (void)drive.of(telegram(0x50, HUGE_VALF));
  EXPECT_THAT(
      drive.leftOut(),
      UnorderedElementsAre(
          "2 values `force` (not a number, infinite, or not of the declared kind; the first "
          "at drive)",
          "2 values `status` (without a name in `values`, stated as it is; the first at "
          "drive)"));
}

constexpr std::string_view kLines = R"(
[[decoder.signal]]
path = "arm"
name = "load"
field = "load"
scale = 2
offset = 1
unit = "kg"
[[decoder.signal]]
path = "arm/{part}"
name = "{part}.mode"
field = "mode"
values = { "1" = "auto", "M" = "manual" }
[[decoder.signal]]
path = "-"
name = "ready"
field = "ready"
bit = 0
[[decoder.signal]]
path = "-"
name = "program"
field = "part"
text = true
)";

TEST(DecodedSignals, OfJson) {
  DecodedSignals json(R"([[decoder]]
name = "j"
kind = "json"
[[decoder.field]]
name = "load"
at = "/load"
[[decoder.field]]
name = "mode"
at = "/mode"
[[decoder.field]]
name = "ready"
at = "/ready"
[[decoder.field]]
name = "part"
at = "/part"
)" + std::string(kLines));
  EXPECT_EQ(json.of(R"({"load": 1.5, "mode": 1, "ready": true, "part": "hand"})"),
            "signal arm load 4 kg\nsignal arm/hand hand.mode \"auto\"\nsignal - ready true\n"
            "signal - program \"hand\"");
  EXPECT_EQ(json.of(R"({"load": "heavy", "mode": "M", "ready": 0.5, "part": 7})"),
            "signal arm/7 7.mode \"manual\"\nsignal - program \"7\"");
  EXPECT_EQ(json.of(R"({"mode": "X", "part": "a b"})"),
            "signal arm/a%20b a%20b.mode \"X\"\nsignal - program \"a b\"");
  EXPECT_THAT(json.leftOut(),
              UnorderedElementsAre(HasSubstr("1 value `load`"), HasSubstr("1 value `ready`"),
                                   HasSubstr("1 value `mode` (without a name in `values`")));
  // Longer than a signal's text.
  EXPECT_THAT(json.of(R"({"load": 1, "part": ")" + std::string(5000, 'x') + "\"}"),
              Not(HasSubstr("program")));
  EXPECT_THAT(json.leftOut(), Contains(HasSubstr("1 value `part`")));
}

TEST(DecodedSignals, OfDelimitedTextAndXml) {
  std::string columns = "[[decoder]]\nname = \"d\"\nkind = \"delimited\"\n";
  std::string elements = "[[decoder]]\nname = \"x\"\nkind = \"xml\"\n";
  int column = 0;
  for (const char* const field : {"load", "mode", "ready", "part"}) {
    columns += "[[decoder.field]]\nname = \"" + std::string(field) +
               "\"\ncolumn = " + std::to_string(column++) + "\n";
    elements +=
        "[[decoder.field]]\nname = \"" + std::string(field) + "\"\nat = \"@" + field + "\"\n";
  }
  DecodedSignals line(columns + std::string(kLines)), xml(elements + std::string(kLines));
  const std::string expected =
      "signal arm load 0 kg\nsignal arm/p p.mode \"auto\"\nsignal - ready true\n"
      "signal - program \"p\"";
  EXPECT_EQ(line.of("-0.5,01,3,p"), expected);
  EXPECT_EQ(xml.of("<R load=\"-0.5\" mode=\"1.0\" ready=\"1\" part=\"p\"/>"), expected);
  EXPECT_EQ(line.of("nan,,inf,p"), "signal - program \"p\"");
  EXPECT_THAT(line.leftOut(), UnorderedElementsAre(HasSubstr("`load`"), HasSubstr("`ready`")));
}

TEST(DecodedSignals, OfDis) {
  DecodedSignals dis(R"([[decoder]]
name = "ship"
kind = "dis"
[[decoder.field]]
name = "speed"
at = "velocity.x"
[[decoder.field]]
name = "appearance"
at = "appearance"
[[decoder.field]]
name = "entity"
at = "entity"
[[decoder.signal]]
path = "ship-{entity}"
name = "speed"
field = "speed"
unit = "m/s"
[[decoder.signal]]
path = "ship-{entity}"
name = "burning"
field = "appearance"
bit = 16
)");
  Bytes pdu(144);
  pdu[2] = std::byte{1};
  pdu[9] = std::byte{144};
  pdu[17] = std::byte{5};
  const auto speed = std::bit_cast<std::uint32_t>(2.5F);
  for (unsigned i = 0; i < 4; ++i) pdu[36 + i] = static_cast<std::byte>(speed >> (24 - 8 * i));
  EXPECT_EQ(dis.of(pdu), "signal ship-5 speed 2.5 m/s\nsignal ship-5 burning false");
}

TEST(DecodedSignals, OfProtobuf) {
  if (!ROCINANTE_TEST_HAS_PROTOBUF) GTEST_SKIP() << "built without protobuf";
  DecodedSignals egm(R"([[decoder]]
name = "egm"
kind = "protobuf"
descriptor = "abb_egm.binpb"
message = "abb.egm.EgmRobot"
[[decoder.field]]
name = "motors"
at = "motorState.state"
[[decoder.signal]]
path = "irb120"
name = "motors"
field = "motors"
values = { "1" = "on", "2" = "off" }
)",
                     std::filesystem::path(ROCINANTE_SOURCE_DIR) / "examples/decoders/test.toml");
  // EgmMotorState is field 4, its state field 1.
  EXPECT_EQ(egm.of(std::string_view("\x22\x02\x08\x02", 4)), "signal irb120 motors \"off\"");
}

TEST(DecodedSignals, BitsAreThoseOfExactWholeNumbers) {
  DecodedSignals json(R"([[decoder]]
name = "j"
kind = "json"
[[decoder.field]]
name = "n"
at = "/n"
[[decoder.signal]]
path = "-"
name = "top"
field = "n"
bit = 52
[[decoder.signal]]
path = "-"
name = "low"
field = "n"
bits = [1, 2]
scale = 10
)");
  EXPECT_EQ(json.of(R"({"n": 6})"), "signal - top false\nsignal - low 30");
  EXPECT_EQ(json.of(R"({"n": -1})"), "signal - top true\nsignal - low 30");
  EXPECT_EQ(json.of(R"({"n": 4503599627370496})"), "signal - top true\nsignal - low 0");
  EXPECT_EQ(json.of(R"({"n": 1e300})"), "");
  EXPECT_EQ(json.of(R"({"n": 0.5})"), "");
  EXPECT_THAT(json.leftOut(), UnorderedElementsAre(HasSubstr("2 values `n`")));
}

TEST(DecodedSignals, NaNsOfJointsAndPosesAreCountedOnceADatagram) {
  DecodedSignals line(R"([[decoder]]
name = "d"
kind = "struct"
[[decoder.field]]
name = "q"
at = 0
type = "f32"
[[decoder.joint]]
device = "arm"
joint = "a"
field = "q"
[[decoder.pose]]
device = "arm"
position = ["q", "q", 0]
)");
  Bytes bytes(4);
  EXPECT_EQ(line.of(bytes), "joint arm a=0\npose arm 0 0 0 0 0 0 1");
  bytes[2] = std::byte{0xC0};
  bytes[3] = std::byte{0x7F};
  EXPECT_EQ(line.of(bytes), "");
  EXPECT_THAT(line.leftOut(), UnorderedElementsAre(HasSubstr("1 value `q`")));
}

TEST(DecodedSignals, QuaternionsOffUnitLengthAreNamedWithTheFirst) {
  DecodedSignals json(R"([[decoder]]
name = "j"
kind = "json"
[[decoder.field]]
name = "who"
at = "/who"
[[decoder.field]]
name = "qw"
at = "/qw"
[[decoder.pose]]
device = "arm-{who}"
position = [0, 0, 0]
quaternion = [0, 0, 0, "qw"]
)");
  EXPECT_EQ(json.of(R"({"who":1,"qw":1.0009})"), "pose arm-1 0 0 0 0 0 0 1");
  EXPECT_THAT(json.leftOut(), IsEmpty());
  EXPECT_EQ(json.of(R"({"who":1,"qw":0.5})"), "pose arm-1 0 0 0 0 0 0 1");
  EXPECT_EQ(json.of(R"({"who":2,"qw":7})"), "pose arm-2 0 0 0 0 0 0 1");
  EXPECT_EQ(json.of(R"({"who":2,"qw":0})"), "");
  EXPECT_THAT(json.leftOut(),
              UnorderedElementsAre(
                  "2 lengths `arm-{who}` (of quaternions off unit length by more than 0.001, "
                  "normalised; the first has length 0.5; the first at j)",
                  "1 pose `arm-{who}` (a quaternion that is zero is no rotation; at j)"));
}

TEST(DecodedSignals, TextsThatMakeNoNameAreCountedOnceADatagram) {
  DecodedSignals json(R"([[decoder]]
name = "j"
kind = "json"
[[decoder.field]]
name = "load"
at = "/load"
[[decoder.field]]
name = "who"
at = "/who"
[[decoder.field]]
name = "what"
at = "/what"
[[decoder.joint]]
device = "{who}"
joint = "a"
field = "load"
[[decoder.pose]]
device = "{who}"
position = ["load", 0, 0]
[[decoder.signal]]
path = "{who}/tip"
name = "load"
field = "load"
[[decoder.signal]]
path = "-"
name = "{what}"
field = "load"
)");
  EXPECT_EQ(json.of(R"({"load": 1, "who": "arm", "what": "x"})"),
            "joint arm a=1\npose arm 1 0 0 0 0 0 1\nsignal arm/tip load 1\nsignal - x 1");
  EXPECT_EQ(json.of(R"({"load": 1, "who": "", "what": "x"})"), "signal - x 1");
  EXPECT_EQ(json.of(R"({"load": 1, "who": "a\u0001", "what": "x"})"), "signal - x 1");
  EXPECT_EQ(json.of(R"({"load": 1, "who": "arm", "what": ")" + std::string(256, 'x') + "\"}"),
            "joint arm a=1\npose arm 1 0 0 0 0 0 1\nsignal arm/tip load 1");
  // What is missing is not counted.
  EXPECT_EQ(json.of(R"({"load": 1, "what": "x"})"), "signal - x 1");
  EXPECT_THAT(json.leftOut(), UnorderedElementsAre(HasSubstr("2 values `who` (empty, over 255"),
                                                   HasSubstr("1 value `what` (empty, over 255")));
}

TEST(DecodedSignals, DeclarationsAreRefusedWithTheirPlace) {
  const auto faultOf = [](const std::string& line) {
    const auto set = parseDecoders(
        "[[decoder]]\nname = \"a\"\nkind = \"json\"\n[[decoder.field]]\nname = \"n\"\nat = "
        "\"/n\"\n" +
            line,
        "a.toml");
    return set ? std::string() : set.error().text();
  };
  const std::string whole = "[[decoder.signal]]\npath = \"arm\"\nname = \"s\"\nfield = \"n\"\n";
  EXPECT_EQ(faultOf(whole), "");
  const std::pair<std::string, const char*> cases[] = {
      {whole + "unit = \"a b\"", "is not 1 to 32 printable ASCII"},
      {whole + "bit = 53", "`bit` must be a whole number from 0 to 52"},
      {whole + "bit = 1\nbits = [0, 1]", "give `bit` or `bits`, not both"},
      {whole + "bits = [50, 4]", "must be a whole number from 1 to 3"},
      {whole + "bits = 4", "`bits` is [first, how many]"},
      {whole + "bit = 1\nunit = \"A\"", "`unit` is of a number"},
      {whole + "text = true\nscale = 2", "`scale` is of a number"},
      {whole + "text = true\nbit = 2", "without `bit`, `bits`, `values`"},
      {whole + "bit = 1\nvalues = { \"0\" = \"x\" }", "a `bit` is true or false"},
      {whole + "values = { \"0\" = 1 }", "is a text of at most 4096 bytes"},
      {whole + "values = { }", "`values` is a table"},
      {whole + "valus = { }", "valus"},
      {"[[decoder.signal]]\npath = \"arm/\"\nname = \"s\"\nfield = \"n\"", "is not DEVICE"},
      {"[[decoder.signal]]\npath = \"arm\"\nname = \"" + std::string(300, 'x') +
           "\"\nfield = \"n\"",
       "is not a valid name"},
      {"[[decoder.signal]]\npath = \"arm\"\nname = \"s\"\nfield = \"m\"", "has no field"},
      {"[[decoder.signals]]\npath = \"arm\"\nnames = [\"s\"]\nfields = []", "1 signals have 0"},
  };
  for (const auto& [text, fault] : cases) {
    EXPECT_THAT(faultOf(text), HasSubstr(fault)) << text;
    EXPECT_THAT(faultOf(text), HasSubstr("a.toml:")) << text;
  }
}

RC_GTEST_PROP(DecodedSignals, AnyTextIsAPacketWithoutFaults,
              (const std::string& part, const std::string& mode, double load)) {
  std::string columns = "[[decoder]]\nname = \"d\"\nkind = \"delimited\"\nseparator = \"|\"\n";
  int column = 0;
  for (const char* const field : {"load", "mode", "ready", "part"}) {
    columns += "[[decoder.field]]\nname = \"" + std::string(field) +
               "\"\ncolumn = " + std::to_string(column++) + "\n";
  }
  DecodedSignals line(columns + std::string(kLines));
  (void)line.of(std::to_string(load) + "|" + mode + "|" + mode + "|" + part);
}

}  // namespace
}  // namespace rocinante::decode
