#include <gmock/gmock.h>

#include <bit>
#include <cstdio>
#include <fstream>
#include <limits>

#include "core/foreign/decode/datagram_decoders.h"
#include "core/foreign/decode/dis_field.h"
#include "core/foreign/decode/geo_frame.h"
#include "core/packet/packet_text.h"
#include "tests/support/shared_data.h"

namespace rocinante::decode {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr std::int64_t kDisTime = 1'700'000'000'000'000'000;

template <class Number>
void putBig(Bytes& bytes, Number number) {
  for (std::size_t i = sizeof number; i-- > 0;) {
    bytes.push_back(static_cast<std::byte>((number >> (8 * i)) & 0xFFU));
  }
}
void putBig(Bytes& bytes, float number) { putBig(bytes, std::bit_cast<std::uint32_t>(number)); }
void putBig(Bytes& bytes, double number) { putBig(bytes, std::bit_cast<std::uint64_t>(number)); }

struct Parameter {
  std::uint8_t designator;
  std::uint32_t type;
  float value;
};

struct Entity {
  Vec3 location{6'378'137, 0, 0};
  float psi = 0, theta = 0, phi = 0;
  std::string marking = "M1";
  std::vector<Parameter> parameters;
};

/// An Entity State PDU, written out field by field.
Bytes entityState(const Entity& entity) {
  Bytes pdu;
  for (const unsigned each : {7U, 1U, 1U, 1U}) {  // version, exercise, Entity State, its family
    putBig(pdu, static_cast<std::uint8_t>(each));
  }
  putBig(pdu, std::uint32_t{0});  // timestamp
  putBig(pdu, static_cast<std::uint16_t>(144 + 16 * entity.parameters.size()));
  putBig(pdu, std::uint16_t{0});                // status, padding
  for (const unsigned each : {42U, 4U, 26U}) {  // site, application, entity
    putBig(pdu, static_cast<std::uint16_t>(each));
  }
  putBig(pdu, std::uint8_t{2});  // force
  putBig(pdu, static_cast<std::uint8_t>(entity.parameters.size()));
  for (const unsigned each : {1U, 2U}) putBig(pdu, static_cast<std::uint8_t>(each));
  putBig(pdu, std::uint16_t{225});  // country
  for (const unsigned each : {3U, 4U, 5U, 6U}) putBig(pdu, static_cast<std::uint8_t>(each));
  putBig(pdu, std::uint64_t{0});                                   // alternative type
  for (const float each : {1.5F, -2.5F, 3.5F}) putBig(pdu, each);  // velocity
  for (const double each : {entity.location.x, entity.location.y, entity.location.z}) {
    putBig(pdu, each);
  }
  for (const float each : {entity.psi, entity.theta, entity.phi}) putBig(pdu, each);
  putBig(pdu, std::uint32_t{0x00200000});  // appearance
  pdu.resize(128);                         // dead reckoning
  putBig(pdu, std::uint8_t{1});            // ASCII
  for (std::size_t i = 0; i < 11; ++i) {
    pdu.push_back(static_cast<std::byte>(i < entity.marking.size() ? entity.marking[i] : 0));
  }
  putBig(pdu, std::uint32_t{0});  // capabilities
  for (const Parameter& each : entity.parameters) {
    putBig(pdu, each.designator);
    putBig(pdu, std::uint8_t{0});   // change
    putBig(pdu, std::uint16_t{0});  // attached to
    putBig(pdu, each.type);
    putBig(pdu, each.value);
    putBig(pdu, std::uint32_t{0});  // padding
  }
  return pdu;
}

/// A decoder of these fields, as joints of device "d" where they are numbers.
DatagramDecoders decoderOf(const std::vector<std::string>& fields, const std::string& more = "") {
  std::string text = "[[decoder]]\nname = \"dis\"\nkind = \"dis\"\n" + more + "\n";
  std::string names;
  for (const std::string& field : fields) {
    text += "[[decoder.field]]\nname = \"" + field + "\"\nat = \"" + field + "\"\n";
    names += (names.empty() ? "\"" : ", \"") + field + "\"";
  }
  text +=
      "[[decoder.joints]]\ndevice = \"d\"\njoints = [" + names + "]\nfields = [" + names + "]\n";
  auto set = parseDecoders(text, "test");
  EXPECT_TRUE(set) << set.error().text();
  return DatagramDecoders(*set);
}

std::string disText(DatagramDecoders& decoders, ByteView pdu) {
  const DecodedPacket* const packet =
      decoders.decode(Route{3000, "10.0.0.1:3000", ""}, kDisTime, pdu);
  if (packet == nullptr) return "";
  PacketTextDecoder reader;
  EXPECT_NE(reader.decode(rocinante::bytesOf(packet->text)), nullptr);
  EXPECT_TRUE(reader.faults().empty()) << packet->text;
  return std::string(packet->text.substr(packet->text.find('\n') + 1));
}

TEST(DisReader, ReadsTheFieldsOfAnEntityState) {
  DatagramDecoders decoders = decoderOf(
      {"version",     "exercise",   "site",       "application",     "entity",
       "force",       "kind",       "domain",     "country",         "category",
       "subcategory", "specific",   "extra",      "appearance",      "velocity.x",
       "velocity.y",  "velocity.z", "location.x", "orientation.psi", "primary-turret-1.azimuth"});
  Entity entity;
  entity.psi = 0.5F;
  entity.parameters = {{1, 4107, 9}, {0, 4429, 0.25F}, {0, 4107, -0.75F}};
  EXPECT_EQ(disText(decoders, entityState(entity)),
            "joint d version=7 exercise=1 site=42 application=4 entity=26 force=2 kind=1 domain=2 "
            "country=225 category=3 subcategory=4 specific=5 extra=6 appearance=2097152 "
            "velocity.x=1.5 velocity.y=-2.5 velocity.z=3.5 location.x=6378137 orientation.psi=0.5 "
            "primary-turret-1.azimuth=-0.75");
}

TEST(DisReader, NamesArticulationsAndFindsThoseThatNobodyDeclared) {
  DatagramDecoders decoders = decoderOf({"primary-turret-1.azimuth", "1024.5"});
  Entity entity;
  entity.parameters = {{0, 4107, 1}, {0, 4429, 2}, {0, 1029, 3}, {1, 4431, 4}, {0, 7009, 5}};
  EXPECT_EQ(disText(decoders, entityState(entity)), "joint d primary-turret-1.azimuth=1 1024.5=3");
  const auto found = decoders.undeclared(Route{}, entityState(entity), 10);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].name, "primary-gun-1.elevation");
  EXPECT_EQ(found[0].value, "2");
  EXPECT_EQ(found[1].name, "secondary-radar-2.position");
  for (const char* const name : {"primary-turret-10.rotation-rate", "secondary-gun-3.elevation",
                                 "1024.position", "4096.17"}) {
    const auto field = disFieldNamed(name);
    ASSERT_TRUE(field) << name;
    const auto again = disFieldNamed(articulationName(field->parameter_type));
    ASSERT_TRUE(again) << name;
    EXPECT_EQ(again->parameter_type, field->parameter_type) << name;
  }
  for (const char* const name : {"primary-turret-0.azimuth", "primary-turret-11.azimuth", "4097.1",
                                 "primary-turret-1.32", "turret", "location", "", ".", "4096."}) {
    EXPECT_FALSE(disFieldNamed(name)) << name;
  }
}

TEST(DisReader, RefusesWhatIsNoWholeEntityState) {
  Entity entity;
  entity.parameters = {{0, 4107, 1}, {0, 4429, 2}};
  const Bytes whole = entityState(entity);
  DatagramDecoders decoders = decoderOf({"site"});
  for (std::size_t bytes = 0; bytes < whole.size(); ++bytes) {
    const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(bytes));
    EXPECT_EQ(disText(decoders, cut), "") << bytes;
  }
  EXPECT_EQ(decoders.counts()[0].last_reason, "its length is not the one that it states");
  const auto refusal = [&](std::size_t at, unsigned value) {
    Bytes wrong = whole;
    wrong[at] = static_cast<std::byte>(value);
    EXPECT_EQ(disText(decoders, wrong), "");
    return decoders.counts()[0].last_reason;
  };
  EXPECT_EQ(refusal(2, 2), "it is not an Entity State PDU");
  EXPECT_EQ(refusal(19, 3), "it ends before its articulation parameters");
  EXPECT_EQ(refusal(9, 143), "its length is not the one that it states");
  // Other PDUs may follow in the datagram.
  Bytes bundled = whole;
  bundled.resize(whole.size() + 100);
  EXPECT_EQ(disText(decoders, bundled), "joint d site=42");
}

TEST(DisReader, GivesPosesAtAPlaceOfTheEarth) {
  // At longitude 0 on the equator: east is the Earth's y, north its z, up its x.
  const std::string origin = "origin = { latitude = 0, longitude = 0, height = 0 }";
  const std::vector<std::string> local{"local.x",  "local.y",  "local.z", "local.qx",
                                       "local.qy", "local.qz", "local.qw"};
  DatagramDecoders decoders = decoderOf(local, origin);
  Entity entity;
  entity.location = {6'378'137 + 30.0, 10, 20};
  // The body's x to the north: psi 0, theta a quarter turn up from the Earth's x to its z; down is
  // then where the Earth's -x is.
  entity.theta = -1.57079632679F;
  entity.phi = 0;
  const std::string north = disText(decoders, entityState(entity));
  EXPECT_THAT(north, StartsWith("joint d local.x=10 local.y=20 local.z=30"));
  const GeoFrame frame({0, 0, 0});
  const double quarter = 1.5707963267948966;
  const auto forwardOf = [](const Quat& turn) { return turn * Vec3(1, 0, 0); };
  const auto upOf = [](const Quat& turn) { return turn * Vec3(0, 0, 1); };
  const Quat up_x = frame.orientationOf(0, 0, 0);
  EXPECT_NEAR(forwardOf(up_x).z, 1, 1e-12);  // along the Earth's x
  EXPECT_NEAR(upOf(up_x).y, -1, 1e-12);      // the body's z, down, along the Earth's z: north
  const Quat to_north = frame.orientationOf(0, -quarter, 0);
  EXPECT_NEAR(forwardOf(to_north).y, 1, 1e-12);
  EXPECT_NEAR(upOf(to_north).z, 1, 1e-12);
  const Quat to_east = frame.orientationOf(quarter, 0, 0);
  EXPECT_NEAR(forwardOf(to_east).x, 1, 1e-12);
}

TEST(DisReader, LeavesOutAPoseWhoseAnglesAreNoNumbers) {
  DatagramDecoders decoders = decoderOf({"site", "local.x", "local.qw"},
                                        "origin = { latitude = 0, longitude = 0, height = 0 }");
  Entity entity;
  entity.psi = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(disText(decoders, entityState(entity)), "joint d site=42 local.x=0");
  entity.psi = 0;
  entity.location.x = std::numeric_limits<double>::infinity();
  EXPECT_THAT(disText(decoders, entityState(entity)), StartsWith("joint d site=42 local.qw="));
}

TEST(DisReader, WantsAnOriginForLocalFieldsAndNamesThatItKnows) {
  const auto fault = [](const std::string& at, const std::string& more) {
    const auto set = parseDecoders("[[decoder]]\nname = \"d\"\nkind = \"dis\"\n" + more +
                                       "[[decoder.field]]\nname = \"f\"\nat = \"" + at +
                                       "\"\n[[decoder.joint]]\ndevice = \"d\"\njoint = \"j\"\n"
                                       "field = \"f\"\n",
                                   "test");
    return set ? "" : set.error().text();
  };
  EXPECT_EQ(fault("location.x", ""), "");
  EXPECT_THAT(fault("local.x", ""), HasSubstr("needs `origin`"));
  EXPECT_THAT(fault("location", ""), HasSubstr("is not a field of an Entity State PDU"));
  EXPECT_THAT(fault("site", "origin = { latitude = 91, longitude = 0, height = 0 }\n"),
              HasSubstr("`latitude` is -90 to 90"));
  EXPECT_THAT(fault("site", "origin = { latitude = 1, longitude = 0 }\n"),
              HasSubstr("`origin` needs `height`"));
}

Bytes fileBytes(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const ByteView bytes = rocinante::bytesOf(text);
  return {bytes.begin(), bytes.end()};
}

TEST(DisReader, ReadsWhatOtherSimulatorsSend) {
  ROCINANTE_NEEDS_SHARED_DATA("captures/dis_pdus");
  const std::filesystem::path folder = test::sharedData("captures/dis_pdus");
  auto set = readDecoders(std::filesystem::path(ROCINANTE_SOURCE_DIR) /
                          "examples/decoders/dis_entity.decoders.toml");
  ASSERT_TRUE(set) << set.error().text();
  DatagramDecoders example(*set);
  // A tank at 42.882481 N, 20.870044 E, 499.38 m, level and heading east.
  const std::string tank = disText(example, fileBytes(folder / "dis_EntityStatePdu-26.raw"));
  double x = 0, y = 0, z = 0, qx = 0, qy = 0, qz = 0, qw = 0;
  ASSERT_EQ(std::sscanf(tank.c_str(), "pose entity-42.4.26 %lf %lf %lf %lf %lf %lf %lf", &x, &y, &z,
                        &qx, &qy, &qz, &qw),
            7)
      << tank;
  EXPECT_NEAR(x, 3.604, 0.01);
  EXPECT_NEAR(y, -2.11, 0.01);
  EXPECT_NEAR(z, -0.616, 0.01);
  EXPECT_NEAR(qx, 0, 1e-5);
  EXPECT_NEAR(qy, 0, 1e-5);
  EXPECT_NEAR(qz, 0, 1e-5);
  EXPECT_NEAR(qw * qw, 1, 1e-9);
  EXPECT_THAT(disText(example, fileBytes(folder / "dis7_EntityStatePdu-articulated_parts.raw")),
              HasSubstr("joint entity-1.200.1 turret=1.7826199531555176 gun=1.2814699411392212\n"));
  // Sixteen articulations, two of which the example uses.
  const Bytes vbs = fileBytes(folder / "dis_EntityStatePdu-vbs-articulated-parameters.raw");
  EXPECT_THAT(disText(example, vbs),
              HasSubstr("turret=1.5411100387573242 gun=0.07811719179153442\n"));
  EXPECT_EQ(example.undeclared(Route{}, vbs, 100).size(), 14U);
  EXPECT_EQ(example.counts()[0].refused, 0U);
  for (std::size_t bytes = 0; bytes < vbs.size(); ++bytes) {
    const Bytes cut(vbs.begin(), vbs.begin() + static_cast<std::ptrdiff_t>(bytes));
    EXPECT_EQ(disText(example, cut), "");
  }
}

TEST(GeoFrame, KnowsPlacesOfTheEarth) {
  // WGS 84: the pole is 6,356,752.3142 m from the centre.
  const GeoFrame pole({90, 0, 0});
  EXPECT_NEAR(pole.origin().z, 6'356'752.3142, 1e-4);
  EXPECT_NEAR(pole.origin().x, 0, 1e-8);
  const GeoFrame east({0, 90, 1000});
  EXPECT_NEAR(east.origin().y, 6'379'137, 1e-8);
  const GeoFrame somewhere({42.882481000630925, 20.870044142553493, 499.3841030858457});
  EXPECT_NEAR(somewhere.origin().x, 4'374'082.804855892, 1e-6);
  EXPECT_NEAR(somewhere.origin().y, 1'667'679.9573010718, 1e-6);
  EXPECT_NEAR(somewhere.origin().z, 4'318'284.368902691, 1e-6);
  const Vec3 here = somewhere.positionOf(somewhere.origin());
  EXPECT_EQ(here.x, 0);
  EXPECT_EQ(here.y, 0);
  EXPECT_EQ(here.z, 0);
}

}  // namespace
}  // namespace rocinante::decode
