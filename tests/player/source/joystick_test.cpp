#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <string>

#include "player/source/joystick_drive.h"
#include "player/source/joystick_input.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;

constexpr std::uint8_t kButtonEvent = 1;
constexpr std::uint8_t kAxisEvent = 2;

std::string eventBytes(std::uint32_t ms, std::int16_t value, std::uint8_t type,
                       std::uint8_t number) {
  const auto low = static_cast<std::uint16_t>(value);
  const std::array<std::uint32_t, 8> bytes = {
      ms & 255U, ms >> 8U & 255U, ms >> 16U & 255U,
      ms >> 24U, low & 255U,      static_cast<std::uint32_t>(low) >> 8U,
      type,      number};
  std::string text;
  for (const std::uint32_t byte : bytes) text += static_cast<char>(byte);
  return text;
}

JoystickEvent eventOf(std::int16_t value, std::uint8_t type, std::uint8_t number) {
  const std::string bytes = eventBytes(0, value, type, number);
  return JoystickEvent::read(
             std::span<const std::byte, 8>(std::as_bytes(std::span(bytes.data(), 8))))
      .value();
}

JoystickDrive driveOf(const std::vector<std::string>& entries) {
  return JoystickDrive(readJoystickMap(entries).value());
}

double positionOf(const JoystickDrive& drive, Nanoseconds now, std::size_t joint = 0) {
  std::vector<double> positions;
  drive.positionsAt(now, 0, positions);
  return positions.at(joint);
}

TEST(JoystickMap, ReadsWhatThePageShows) {
  const auto map = readJoystickMap({"axis0=arm.shoulder:0.5/s:-1.5..1.5", "axis1=arm.wrist.1:-2/s",
                                    "axis2=grip.width:0..0.08", "button3=event:pick the box"})
                       .value();
  ASSERT_EQ(map.devices.size(), 2U);
  EXPECT_THAT(map.devices[0].joints, ElementsAre("shoulder", "wrist.1"));
  EXPECT_THAT(map.devices[1].joints, ElementsAre("width"));
  ASSERT_EQ(map.bindings.size(), 4U);
  EXPECT_EQ(map.bindings[0].rate, 0.5);
  EXPECT_EQ(map.bindings[0].low, -1.5);
  EXPECT_EQ(map.bindings[2].effect, JoystickBinding::Effect::position);
  EXPECT_EQ(map.bindings[3].text, "pick the box");
}

TEST(JoystickMap, RefusesWhatItCannotRead) {
  for (const char* entry :
       {"", "axis0", "axis=arm.j:1/s", "axis256=arm.j:1/s", "knob0=arm.j:1/s", "axis0=arm:1/s",
        "axis0=.j:1/s", "axis0=arm.:1/s", "axis0=arm.j", "axis0=arm.j:1", "axis0=arm.j:0/s",
        "axis0=arm.j:nan/s", "axis0=arm.j:1..1", "axis0=arm.j:2..1", "axis0=arm.j:1/s:3",
        "axis0=arm.j:0..1:0..1", "axis0=event:go", "button0=event", "button0=event:"}) {
    const auto map = readJoystickMap({entry});
    ASSERT_FALSE(map.ok()) << entry;
    EXPECT_EQ(map.error().where, entry);
  }
  EXPECT_FALSE(readJoystickMap({}).ok());
  EXPECT_FALSE(readJoystickMap({"button0=event:go"}).ok()) << "nothing moves";
  EXPECT_FALSE(readJoystickMap({"axis0=a.b:1/s", "axis0=a.c:1/s"}).ok());
}

TEST(JoystickDrive, TurnsAJointAsLongAsTheStickIsHeld) {
  JoystickDrive drive = driveOf({"axis0=arm.j:0.5/s"});
  EXPECT_FALSE(drive.moves());
  drive.apply(eventOf(32767, kAxisEvent, 0), 1s);
  EXPECT_TRUE(drive.moves());
  EXPECT_DOUBLE_EQ(positionOf(drive, 2s), 0.5);
  drive.apply(eventOf(-32767, kAxisEvent, 0), 3s);
  EXPECT_DOUBLE_EQ(positionOf(drive, 3500ms), 0.75);
  drive.apply(eventOf(0, kAxisEvent, 0), 4s);
  EXPECT_FALSE(drive.moves());
  EXPECT_DOUBLE_EQ(positionOf(drive, 9s), 0.5);
}

TEST(JoystickDrive, StaysWithinBoundsAndComesBackAtOnce) {
  JoystickDrive drive = driveOf({"axis0=arm.j:1/s:0.5..1.5"});
  EXPECT_EQ(positionOf(drive, 0s), 0.5) << "the bound nearest to 0";
  drive.apply(eventOf(32767, kAxisEvent, 0), 0s);
  EXPECT_EQ(positionOf(drive, 60s), 1.5);
  drive.apply(eventOf(-32767, kAxisEvent, 0), 60s);
  EXPECT_DOUBLE_EQ(positionOf(drive, 60s + 250ms), 1.25);
}

TEST(JoystickDrive, AStickNearItsMiddleRests) {
  JoystickDrive drive = driveOf({"axis0=arm.j:1/s"});
  drive.apply(eventOf(1600, kAxisEvent, 0), 0s);
  EXPECT_FALSE(drive.moves());
  drive.apply(eventOf(1700, kAxisEvent, 0), 0s);
  EXPECT_TRUE(drive.moves());
  EXPECT_LT(positionOf(drive, 1s), 0.01) << "no step at the zone's edge";
}

TEST(JoystickDrive, APositionFollowsTheStick) {
  JoystickDrive drive = driveOf({"axis2=grip.width:0..0.08"});
  EXPECT_DOUBLE_EQ(positionOf(drive, 0s), 0.04);
  drive.apply(eventOf(-32768, kAxisEvent, 2), 0s);
  EXPECT_EQ(positionOf(drive, 0s), 0);
  drive.apply(eventOf(32767, kAxisEvent, 2), 0s);
  EXPECT_DOUBLE_EQ(positionOf(drive, 0s), 0.08);
}

TEST(JoystickDrive, TwoButtonsTurnOneJointBothWays) {
  JoystickDrive drive = driveOf({"button0=arm.j:1/s", "button1=arm.j:-1/s"});
  drive.apply(eventOf(1, kButtonEvent, 0), 0s);
  drive.apply(eventOf(1, kButtonEvent, 1), 1s);
  EXPECT_FALSE(drive.moves()) << "both are pressed";
  drive.apply(eventOf(0, kButtonEvent, 0), 2s);
  EXPECT_DOUBLE_EQ(positionOf(drive, 4s), -1);
}

TEST(JoystickDrive, AnEventIsSaidOncePerPress) {
  JoystickDrive drive = driveOf({"axis0=arm.j:1/s", "button0=event:pick"});
  drive.apply(eventOf(1, kButtonEvent | 0x80, 0), 0s);  // held when it was opened
  EXPECT_TRUE(drive.takePressed().empty());
  drive.apply(eventOf(0, kButtonEvent, 0), 0s);
  drive.apply(eventOf(1, kButtonEvent, 0), 0s);
  EXPECT_THAT(drive.takePressed(), ElementsAre("pick"));
  EXPECT_TRUE(drive.takePressed().empty());
}

TEST(JoystickInput, AFilesEventsComeAtTheirOwnMoments) {
  const test::TemporaryFolder folder;
  const auto path = folder / "events";
  // The driver's clock wraps between them.
  test::writeFile(
      path, eventBytes(0xFFFFFFF0U, 5, kAxisEvent, 0) + eventBytes(0x00000054U, 6, kAxisEvent, 0));
  JoystickInput input = JoystickInput::open(path).value();
  EXPECT_EQ(input.next(0s).value()->value, 5);
  EXPECT_FALSE(input.next(99ms).value());
  EXPECT_EQ(input.nextMoment(), Nanoseconds(100ms));
  EXPECT_FALSE(input.ended());
  EXPECT_EQ(input.next(150ms).value()->value, 6);
  EXPECT_EQ(input.moment(), Nanoseconds(100ms));
  EXPECT_FALSE(input.next(1h).value());
  EXPECT_TRUE(input.ended());
}

TEST(JoystickInput, SaysWhereAFileBreaksOff) {
  const test::TemporaryFolder folder;
  const auto path = folder / "events";
  const std::string whole = eventBytes(0, 5, kAxisEvent, 0) + eventBytes(1, 1, kButtonEvent, 7);
  for (std::size_t length = 0; length <= whole.size(); ++length) {
    test::writeFile(path, whole.substr(0, length));
    JoystickInput input = JoystickInput::open(path).value();
    std::size_t events = 0;
    Result<std::optional<JoystickEvent>> event = input.next(1s);
    for (; event && *event; event = input.next(1s)) ++events;
    EXPECT_EQ(events, length / 8);
    EXPECT_EQ(event.ok(), length % 8 == 0) << length;
    if (!event) {
      EXPECT_EQ(event.error().text(), "ends within an event, " + std::to_string(length % 8) +
                                          " of 8 bytes (" + path.string() + ", byte " +
                                          std::to_string(length / 8 * 8) + ")");
    }
  }
}

TEST(JoystickInput, RefusesWhatIsNoJoystick) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(JoystickInput::open(folder.path()).error().kind, ErrorKind::bad_argument);
  EXPECT_EQ(JoystickInput::open(folder / "none").error().kind, ErrorKind::not_found);
  const auto path = folder / "events";
  test::writeFile(path, "t,shoulder,elbow\n0,1,2\n");
  JoystickInput input = JoystickInput::open(path).value();
  EXPECT_EQ(
      input.next(0s).error().text(),
      "holds no joystick event; a joystick is /dev/input/jsN (" + path.string() + ", byte 0)");
}

}  // namespace
}  // namespace rocinante
