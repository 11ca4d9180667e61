#include <gmock/gmock.h>

#include <bit>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include "core/foreign/decode/carried_decoders.h"
#include "core/foreign/decode/datagram_decoders.h"
#include "core/foreign/protobuf/protobuf_schema.h"
#include "core/packet/packet_text.h"
#include "tests/support/temporary_folder.h"

namespace rocinante::decode {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr std::int64_t kEgmTime = 1'700'000'000'250'000'000;
const Route kEgmRoute{6510, "10.0.0.7:4000", "/udp/6510/10.0.0.7"};
const std::filesystem::path kExamples =
    std::filesystem::path(ROCINANTE_SOURCE_DIR) / "examples/decoders";

/// A message by hand, from protobuf's encoding.
class Wire {
 public:
  Wire& whole(unsigned field, std::uint64_t value) {
    varint(field << 3U);
    varint(value);
    return *this;
  }
  Wire& real(unsigned field, double value) {
    varint((field << 3U) | 1U);
    const auto bits = std::bit_cast<std::uint64_t>(value);
    for (unsigned i = 0; i < 8; ++i) text_ += static_cast<char>((bits >> (8 * i)) & 0xFFU);
    return *this;
  }
  Wire& message(unsigned field, const Wire& inner) { return bytes(field, inner.text_); }
  Wire& bytes(unsigned field, std::string_view inner) {
    varint((field << 3U) | 2U);
    varint(inner.size());
    text_ += inner;
    return *this;
  }
  const std::string& text() const { return text_; }

 private:
  void varint(std::uint64_t value) {
    for (; value >= 0x80; value >>= 7U) text_ += static_cast<char>((value & 0x7FU) | 0x80U);
    text_ += static_cast<char>(value);
  }
  std::string text_;
};

Wire joints(const std::vector<double>& degrees) {
  Wire wire;
  for (const double each : degrees) wire.real(1, each);
  return wire;
}

Wire egmPose() {
  return Wire()
      .message(1, Wire().real(1, 364.5).real(2, -20).real(3, 594))
      .message(2, Wire().real(1, 0.5).real(2, -0.5).real(3, 0.5).real(4, 0.5));
}

/// As a controller sends it, with fields that the example does not know.
Wire egm(const std::vector<double>& degrees, unsigned motors = 1) {
  return Wire()
      .message(1, Wire().whole(1, 4711).whole(2, 98'765).whole(3, 2))
      .message(2, Wire()
                      .message(1, joints(degrees))
                      .message(2, egmPose())
                      .message(3, joints({}))
                      .message(4, Wire().whole(1, 1'700'000'000).whole(2, 250'000)))
      .message(4, Wire().whole(1, motors))
      .message(5, Wire().whole(1, 3))
      .whole(6, 1)
      .message(8, Wire().whole(1, 2));
}

class ProtobufDecoder : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!ROCINANTE_TEST_HAS_PROTOBUF) GTEST_SKIP() << "built without the protobuf part";
  }

  static DatagramDecoders egmDecoders() {
    auto set = readDecoders(kExamples / "abb_egm.decoders.toml");
    EXPECT_TRUE(set) << set.error().text();
    return DatagramDecoders(*set);
  }
};

/// The packet's text, which must be one without faults; "" for none.
std::string egmText(DatagramDecoders& decoders, std::string_view payload) {
  const DecodedPacket* const packet =
      decoders.decode(kEgmRoute, kEgmTime, rocinante::bytesOf(payload));
  if (packet == nullptr) return "";
  PacketTextDecoder reader;
  EXPECT_NE(reader.decode(rocinante::bytesOf(packet->text)), nullptr);
  EXPECT_TRUE(reader.faults().empty()) << packet->text;
  return std::string(packet->text);
}

TEST_F(ProtobufDecoder, ReadsTheFeedbackOfAnAbbController) {
  DatagramDecoders decoders = egmDecoders();
  EXPECT_EQ(egmText(decoders, egm({0, -90, 90, 0, 45, 180}).text()),
            "RK1 decoded:egm - 1700000000.25\n"
            "joint irb120 joint_1=0 joint_2=-1.5707963267948966 joint_3=1.5707963267948966 "
            "joint_4=0 joint_5=0.7853981633974483 joint_6=3.141592653589793\n"
            "pose tool 0.3645 -0.02 0.594 -0.5 0.5 0.5 0.5");
  EXPECT_THAT(egmText(decoders, egm({0, 0, 0, 0, 0, 0}, 2).text()),
              HasSubstr("\nevent \"motors in state 2\""));
}

TEST_F(ProtobufDecoder, LeavesOutWhatIsNotThere) {
  DatagramDecoders decoders = egmDecoders();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(egmText(decoders, Wire()
                                  .message(1, Wire().whole(3, 2))
                                  .message(2, Wire().message(1, joints({90, nan, 180})))
                                  .text()),
            "RK1 decoded:egm - 1700000000.25\n"
            "joint irb120 joint_1=1.5707963267948966 joint_3=3.141592653589793");
  // Another type of message is left to other decoders.
  EXPECT_EQ(egmText(decoders, Wire().message(1, Wire().whole(3, 1)).text()), "");
  EXPECT_EQ(decoders.counts()[0].refused, 0U);
}

TEST_F(ProtobufDecoder, ReadsRepeatedNumbersPackedTooAndTheLastOfTwo) {
  DatagramDecoders decoders = egmDecoders();
  std::string packed(16, '\0');
  packed.replace(8, 8, joints({90}).text().substr(1));
  EXPECT_THAT(egmText(decoders, Wire()
                                    .message(1, Wire().whole(3, 1).whole(3, 2))
                                    .message(2, Wire().message(1, Wire().bytes(1, packed)))
                                    .text()),
              HasSubstr("joint irb120 joint_1=0 joint_2=1.5707963267948966"));
}

TEST_F(ProtobufDecoder, RefusesOtherBytesWithAReason) {
  DatagramDecoders decoders = egmDecoders();
  const auto reason = [&](std::string_view payload) {
    const std::uint64_t before = decoders.counts()[0].refused;
    EXPECT_EQ(egmText(decoders, payload), "");
    EXPECT_EQ(decoders.counts()[0].refused, before + 1);
    return std::string(decoders.counts()[0].last_reason);
  };
  EXPECT_EQ(reason("RAW text"), "it is not a protobuf message");
  EXPECT_EQ(reason(Wire().whole(200, 3).text()), "it has no field of the message");
  const Wire no_z =
      Wire().message(2, Wire().message(2, Wire().message(1, Wire().real(1, 1).real(2, 2))));
  EXPECT_EQ(reason(no_z.text()), "a field that the message requires is missing");
  EXPECT_EQ(reason(std::string((1U << 20U) + 1, '\0')), "it has more than 1 MiB");
  std::string groups;
  for (int i = 0; i < 100; ++i) groups += '\x7B';
  EXPECT_EQ(reason(groups), "its messages are nested deeper than 64");
}

TEST_F(ProtobufDecoder, MakesAPacketOrARefusalOfEveryBeginning) {
  DatagramDecoders decoders = egmDecoders();
  const std::string whole = egm({1, 2, 3, 4, 5, 6}).text();
  for (std::size_t bytes = 0; bytes < whole.size(); ++bytes) {
    (void)egmText(decoders, whole.substr(0, bytes));
    std::string flipped = whole;
    flipped[bytes] = static_cast<char>(flipped[bytes] ^ 0x55);
    (void)egmText(decoders, flipped);
  }
  EXPECT_EQ(egmText(decoders, whole), egmText(decoders, whole));
}

TEST_F(ProtobufDecoder, NamesWhatNoDeclarationPointsTo) {
  DatagramDecoders decoders = egmDecoders();
  const std::string message = egm({1, 2, 3, 4, 5, 6, 7}).text();
  std::vector<std::string> found;
  for (const FoundField& each : decoders.undeclared(kEgmRoute, rocinante::bytesOf(message), 100)) {
    found.push_back(each.name + "=" + each.value);
  }
  EXPECT_THAT(found,
              ElementsAre("header.seqno=4711", "header.tm=98765", "feedBack.joints.joints[6]=7",
                          "feedBack.#4=10 bytes", "#5=2 bytes", "#6=1", "#8=2 bytes"));
  EXPECT_EQ(decoders.undeclared(kEgmRoute, rocinante::bytesOf(message), 2).size(), 2U);
}

/// The example with another line in place of one of it.
std::string egmFault(const std::string& from, const std::string& to) {
  std::ifstream file(kExamples / "abb_egm.decoders.toml");
  std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::size_t at = text.find(from);
  EXPECT_NE(at, text.npos);
  text.replace(at, from.size(), to);
  const auto set = parseDecoders(text, (kExamples / "a.toml").string());
  return set ? "" : set.error().text();
}

TEST_F(ProtobufDecoder, SaysWhichNameOfADeclarationIsWrong) {
  EXPECT_THAT(egmFault("abb.egm.EgmRobot", "EgmRobot"),
              HasSubstr("it has no message `EgmRobot`; its messages: abb.egm.EgmHeader"));
  EXPECT_THAT(egmFault("header.mtype", "header.type"),
              HasSubstr("abb.egm.EgmHeader has no field `type`; its fields: seqno, tm, mtype"));
  EXPECT_THAT(egmFault("cartesian.pos.x", "cartesian.pos"),
              HasSubstr("`pos` is a message: go on to one of its fields: x, y, z"));
  EXPECT_THAT(egmFault("cartesian.pos.x", "cartesian.pos.x.a"),
              HasSubstr("`x` is a value, which has no fields"));
  EXPECT_THAT(egmFault("count = 6", ""), HasSubstr("`joints` is repeated: give the index, as in"));
  EXPECT_THAT(egmFault("cartesian.pos.x", "cartesian.pos.x[0]"),
              HasSubstr("`x` has one value, without an index"));
  EXPECT_THAT(egmFault("abb_egm.binpb", "abb_egm.proto"), HasSubstr("not a FileDescriptorSet"));
  EXPECT_THAT(egmFault("abb_egm.binpb", "none.binpb"), HasSubstr("none.binpb"));
  EXPECT_THAT(egmFault("abb_egm.binpb", "../a.binpb"), HasSubstr("lies in the folder"));
  EXPECT_THAT(egmFault("descriptor = \"abb_egm.binpb\"", ""), HasSubstr("`descriptor`"));
}

TEST_F(ProtobufDecoder, CarriesItsDescriptorAndHashesItToo) {
  auto set = readDecoders(kExamples / "abb_egm.decoders.toml");
  ASSERT_TRUE(set) << set.error().text();
  const auto carried = carriedFiles(**set, LogTime{});
  ASSERT_EQ(carried.size(), 2U);
  EXPECT_EQ(carried[0].attachment.name, "decoders/" + (*set)->hash + ".toml");
  EXPECT_EQ(carried[1].attachment.name, "decoders/" + (*set)->hash + "/abb_egm.binpb");

  // As `log extract --all` lays them out, they are the same decoders.
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / (*set)->hash);
  for (const CarriedFile& each : carried) {
    std::ofstream(folder.path() /
                  std::filesystem::path(each.attachment.name).lexically_relative("decoders"))
        << textOf(each.bytes);
  }
  auto again = readDecoders(folder.path() / ((*set)->hash + ".toml"));
  ASSERT_TRUE(again) << again.error().text();
  EXPECT_EQ((*again)->hash, (*set)->hash);
  // Another descriptor makes other packets, and has another hash.
  std::ofstream(folder.path() / (*set)->hash / "abb_egm.binpb", std::ios::app) << "\x50\x01";
  auto changed = readDecoders(folder.path() / ((*set)->hash + ".toml"));
  EXPECT_TRUE(!changed || (*changed)->hash != (*set)->hash);
}

TEST_F(ProtobufDecoder, RefusesADescriptorAtEveryLengthButItsOwn) {
  std::ifstream file(kExamples / "abb_egm.binpb", std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(file), {}};
  for (std::size_t bytes = 0; bytes <= whole.size(); ++bytes) {
    const auto schema =
        protobuf::Schema::open(std::string_view(whole).substr(0, bytes), "abb.egm.EgmRobot");
    EXPECT_EQ(schema.has_value(), bytes == whole.size()) << bytes;
  }
}

/// A descriptor set of one file, whose types T0, T1, ... are given.
std::string setOf(const std::vector<Wire>& types) {
  Wire file = Wire().bytes(1, "a.proto");
  for (const Wire& type : types) file.message(4, type);
  return Wire().message(1, file).text();
}

Wire fieldOf(unsigned number, unsigned label, unsigned type, const std::string& type_name = "") {
  Wire field = Wire().bytes(1, "f" + std::to_string(number)).whole(3, number).whole(4, label);
  field.whole(5, type);
  return type_name.empty() ? field : field.bytes(6, type_name);
}

TEST_F(ProtobufDecoder, BoundsWhatADescriptorDeclares) {
  constexpr unsigned kOptional = 1, kMessage = 11;
  std::vector<Wire> chain;
  for (unsigned i = 0; i < 4000; ++i) {
    Wire type = Wire().bytes(1, "T" + std::to_string(i));
    const std::string next = ".T" + std::to_string((i + 1) % 4000);
    chain.push_back(type.message(2, fieldOf(1, kOptional, kMessage, next)));
  }
  EXPECT_TRUE(protobuf::Schema::open(setOf(chain), "T0"));
  for (unsigned i = 0; i < 100; ++i) chain.push_back(Wire().bytes(1, "U" + std::to_string(i)));
  const auto too_many = protobuf::Schema::open(setOf(chain), "T0");
  ASSERT_FALSE(too_many);
  EXPECT_EQ(too_many.error().what, "it declares more than 4,096 types or 65,536 fields");
}

TEST_F(ProtobufDecoder, BoundsTheMemoryOfAMessage) {
  constexpr unsigned kOptional = 1, kRepeated = 3, kDouble = 1, kMessage = 11;
  Wire large = Wire().bytes(1, "Large");
  for (unsigned i = 1; i <= 1000; ++i) large.message(2, fieldOf(i, kOptional, kDouble));
  const Wire top = Wire().bytes(1, "Top").message(2, fieldOf(1, kRepeated, kMessage, ".Large"));
  auto schema = protobuf::Schema::open(setOf({large, top}), "Top");
  ASSERT_TRUE(schema) << schema.error().text();
  protobuf::Reader reader(*schema, {"f1[3].f7"});
  std::string message;
  for (int i = 0; i < 1000; ++i) message += std::string("\x0A\x00", 2);
  EXPECT_EQ(reader.read(rocinante::bytesOf(message)), "");
  EXPECT_EQ(reader.values()[0].kind, 0);
  for (int i = 0; i < 30'000; ++i) message += std::string("\x0A\x00", 2);
  EXPECT_EQ(reader.read(rocinante::bytesOf(message)), "it would need more than 64 MiB of memory");
}

}  // namespace
}  // namespace rocinante::decode
