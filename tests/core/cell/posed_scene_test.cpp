#include "core/cell/posed_scene.h"

#include <gtest/gtest.h>

#include "core/cell/bare_cell.h"
#include "core/math/transform.h"
#include "tests/core/cell/cell_fixture.h"

namespace rocinante {
namespace {

using test::stateOf;

class PosedSceneTest : public test::CellFolder {
 protected:
  PosedSceneTest() {
    auto loaded = load(R"(
format = 1
[[device]]
name = "arm"
model = "arm.urdf"
pose = { xyz = [1, 0, 0] }
layer = "robots"
color = "#102030"
[[device]]
name = "tool"
model = "arm.urdf"
on = "arm/tip"
pose = { xyz = [0, 0, 0.5] }
[[device]]
name = "late"
model = "arm.urdf"
optional = true
[[model]]
name = "box"
urdf = "models/arm.urdf"
[[layer]]
name = "robots"
[[camera]]
name = "wrist"
on = "arm/tip"
eye = [1, 0, 0]
target = [0, 0, 0]
[[camera]]
name = "chase"
follow = "tool"
eye = [-1, 0, 1]
target = [0, 0, 0]
[[source]]
name = "planner"
ghost_of = { plan_arm = "arm" }
)");
    EXPECT_TRUE(loaded.ok());
    cell_ = std::move(*loaded);
    EXPECT_EQ(test::printed(cell_.faults), "");
  }

  PosedScene scene(std::string_view lines = {}) {
    state_ = stateOf(lines);
    return poseScene(cell_, state_);
  }
  static Vec3 at(const PosedScene& scene, std::string_view device, std::string_view link = {}) {
    const auto found = scene.find(device, link);
    return found ? positionOf(*found) : Vec3{-999, -999, -999};
  }
  static std::string names(const PosedScene& scene) {
    std::string all;
    for (const PosedDevice& device : scene.devices) all += device.name + " ";
    return all;
  }

  Cell cell_;
  SessionState state_;
};

TEST_F(PosedSceneTest, TheCellStandsAsWrittenWhenNothingWasSaid) {
  const PosedScene posed = scene();
  EXPECT_EQ(names(posed), "arm tool ");
  EXPECT_EQ(at(posed, "arm"), Vec3(1, 0, 0));
  EXPECT_EQ(at(posed, "tool", "tip"), Vec3(1, 0, 0.5)) << "carried by arm/tip";
  EXPECT_EQ(posed.findDevice("arm")->link_color[1], 0x102030FFU);
  EXPECT_FALSE(posed.findDevice("tool")->link_color[0]);
  EXPECT_EQ(posed.find("arm", "nothing"), std::nullopt);
  EXPECT_EQ(posed.find("nothing", ""), std::nullopt);
}

TEST_F(PosedSceneTest, JointsMoveLinksAndAllThatTheyCarry) {
  EXPECT_EQ(at(scene("joints arm 0.25\n"), "tool", "tip"), Vec3(1, 0, 0.75));
  EXPECT_EQ(at(scene("joints arm 7\n"), "arm", "tip"), Vec3(1, 0, 7)) << "limits do not clamp";
  EXPECT_EQ(at(scene("joint arm lift=0.5\n"), "arm", "tip"), Vec3(1, 0, 0.5));
  EXPECT_EQ(at(scene("joints arm 0.25\njoint arm lift=0.5\n"), "arm", "tip"), Vec3(1, 0, 0.5));
}

TEST_F(PosedSceneTest, AWrongNumberOfValuesAndUnknownNamesMoveNothing) {
  EXPECT_EQ(at(scene("joints arm 0.25 0.25\n"), "arm", "tip"), Vec3(1, 0, 0));
  EXPECT_EQ(at(scene("joint arm nod=0.5\n"), "arm", "tip"), Vec3(1, 0, 0));
  EXPECT_EQ(names(scene("joints other 1\npose other 1 2 3 0 0 0 1\n")), "arm tool ");
}

TEST_F(PosedSceneTest, PosesOutrankTheCellAndMayBeCarried) {
  EXPECT_EQ(at(scene("pose arm 5 6 7 0 0 0 1\n"), "tool"), Vec3(5, 6, 7.5));
  EXPECT_EQ(at(scene("pose tool 5 6 7 0 0 0 1\n"), "tool"), Vec3(5, 6, 7))
      << "a pose without a carrier is in the world";
  EXPECT_EQ(at(scene("pose arm 0 0 1 0 0 1 0\npose tool 1 0 0 0 0 0 1 in arm/tip\n"), "tool"),
            Vec3(-1, 0, 1));
}

TEST_F(PosedSceneTest, MissingCarriersAndLoopsStandInTheWorld) {
  EXPECT_EQ(at(scene("pose tool 1 2 3 0 0 0 1 in nobody/tip\n"), "tool"), Vec3(1, 2, 3));
  EXPECT_EQ(at(scene("pose tool 1 2 3 0 0 0 1 in arm/nothing\n"), "tool"), Vec3(1, 2, 3));
  EXPECT_EQ(at(scene("remove arm\n"), "tool"), Vec3(0, 0, 0.5));
  const PosedScene loop =
      scene("pose arm 1 0 0 0 0 0 1 in tool/tip\npose tool 2 0 0 0 0 0 1 in arm/tip\n");
  EXPECT_EQ(at(loop, "arm"), Vec3(1, 0, 0));
  EXPECT_EQ(at(loop, "tool"), Vec3(2, 0, 0));
  EXPECT_EQ(at(scene("pose arm 1 0 0 0 0 0 1 in arm/tip\n"), "arm"), Vec3(1, 0, 0));
  const PosedScene beside = scene(
      "add late box\npose late 0 1 0 0 0 0 1 in tool/tip\n"
      "pose arm 1 0 0 0 0 0 1 in tool/tip\npose tool 2 0 0 0 0 0 1 in arm/tip\n");
  EXPECT_EQ(at(beside, "late"), Vec3(2, 1, 0)) << "not of the loop, but carried by one of it";
}

TEST_F(PosedSceneTest, AddBringsAndRemoveTakesAway) {
  EXPECT_EQ(names(scene("add late arm.urdf\n")), "arm tool late ");
  EXPECT_EQ(names(scene("remove arm\n")), "tool ");
  EXPECT_EQ(names(scene("add zebra box\nadd ape arm\n")), "arm tool ape zebra ");
  EXPECT_EQ(names(scene("add zebra unknown\n")), "arm tool ");
  EXPECT_EQ(names(scene("add late unknown\n")), "arm tool late ") << "with the cell's own model";
  EXPECT_EQ(scene("add arm box\n").findDevice("arm")->model, cell_.models.at("box").get());
  const PosedScene kept = scene("joints part 0.5\npose part 0 0 1 0 0 0 1\nadd part box\n");
  EXPECT_EQ(at(kept, "part", "tip"), Vec3(0, 0, 1.5)) << "what was said before it was added";
}

TEST_F(PosedSceneTest, ThingsAreSeenWhenLayerDeviceAndLinkAreShown) {
  const auto seen = [&](std::string_view lines) {
    const PosedScene posed = scene(lines);
    const PosedDevice& arm = *posed.findDevice("arm");
    return std::string(arm.visible ? "V" : "v") + (arm.link_visible[0] ? "F" : "f") +
           (arm.link_visible[1] ? "T" : "t");
  };
  EXPECT_EQ(seen(""), "VFT");
  EXPECT_EQ(seen("hide arm/tip\n"), "VFt");
  EXPECT_EQ(seen("hide arm\n"), "vft");
  EXPECT_EQ(seen("hide arm\nshow arm/tip\n"), "vft");
  EXPECT_EQ(seen("hide layer/robots\n"), "vft");
  EXPECT_EQ(seen("hide layer/robots\nshow arm\n"), "vft");
  EXPECT_EQ(seen("hide arm\nshow arm default\n"), "VFT");
  EXPECT_EQ(seen("hide layer/other\n"), "VFT");
  cell_.layers[0].visible = false;
  EXPECT_EQ(seen(""), "vft");
  EXPECT_EQ(seen("show layer/robots\n"), "VFT") << "packets outrank the cell";
}

TEST_F(PosedSceneTest, ColoursOfLinksOutrankDevicesLayersAndTheCell) {
  const auto colors = [&](std::string_view lines) {
    const PosedScene posed = scene(lines);
    const PosedDevice& arm = *posed.findDevice("arm");
    return std::pair(arm.link_color[0].value_or(0), arm.link_color[1].value_or(0));
  };
  using Pair = std::pair<std::uint32_t, std::uint32_t>;
  EXPECT_EQ(colors("color arm #ff0000\n"), Pair(0xFF0000FF, 0xFF0000FF));
  EXPECT_EQ(colors("color arm #ff0000\ncolor arm/tip #00ff0080\n"), Pair(0xFF0000FF, 0x00FF0080));
  EXPECT_EQ(colors("color arm #ff0000\ncolor arm/tip default\n"), Pair(0xFF0000FF, 0x102030FF));
  EXPECT_EQ(colors("color layer/robots #0000ff\n"), Pair(0x0000FFFF, 0x0000FFFF));
  EXPECT_EQ(colors("color layer/robots #0000ff\ncolor arm default\n"),
            Pair(0x102030FF, 0x102030FF));
  EXPECT_EQ(colors("color arm/none #0000ff\n"), Pair(0x102030FF, 0x102030FF));
}

TEST_F(PosedSceneTest, DrawingsAndViewsRideOnTheirCarriers) {
  const PosedScene posed = scene(
      "joints arm 2\n"
      "line path #ff0000 in arm/tip 0 0 0 1 0 0\nlabel here 0 0 0 \"x\"\n"
      "label lost in none/tip 0 0 0 \"x\"\n"
      "view look 3 0 0 0 0 0 40 in arm/tip\nview wrist 1 2 3 0 0 0 50\n");
  ASSERT_EQ(posed.drawings.size(), 3U);
  EXPECT_EQ(posed.drawings[2].id, "path");
  EXPECT_EQ(positionOf(posed.drawings[2].to_world), Vec3(1, 0, 2));
  EXPECT_EQ(positionOf(posed.drawings[0].to_world), Vec3(0, 0, 0));
  EXPECT_EQ(posed.drawings[1].to_world, Mat4{1.0});
  EXPECT_EQ(posed.findCamera("look")->eye, Vec3(4, 0, 2));
  EXPECT_EQ(posed.findCamera("look")->fov_deg, 40);
  EXPECT_EQ(posed.findCamera("wrist")->eye, Vec3(1, 2, 3)) << "the session's outranks the cell's";
  EXPECT_EQ(posed.findCamera("chase")->eye, Vec3(0, 0, 3.5));
  EXPECT_EQ(posed.findCamera("none"), nullptr);
}

TEST_F(PosedSceneTest, CamerasRideWithTurningAndFollowWithout) {
  const PosedScene posed = scene("pose arm 0 0 0 0 0 1 0\npose tool 0 0 1 0 0 1 0\n");
  EXPECT_EQ(posed.findCamera("wrist")->eye, Vec3(-1, 0, 0));
  EXPECT_EQ(posed.findCamera("chase")->eye, Vec3(-1, 0, 2));
}

TEST_F(PosedSceneTest, AGhostStandsWithItsOriginalUntilItIsToldOtherwise) {
  const PosedScene posed = scene("joints plan_arm 0.5\n");
  ASSERT_EQ(names(posed), "arm tool plan_arm ");
  const PosedDevice& ghost = *posed.findDevice("plan_arm");
  EXPECT_TRUE(ghost.ghost);
  EXPECT_LT(*ghost.link_color[0] & 0xFF, 0xFFU) << "translucent";
  EXPECT_EQ(at(posed, "plan_arm", "tip"), Vec3(1, 0, 0.5));
  EXPECT_EQ(at(scene("pose arm 4 0 0 0 0 0 1\njoints plan_arm 0\n"), "plan_arm"), Vec3(4, 0, 0));
  EXPECT_EQ(at(scene("pose plan_arm 9 0 0 0 0 0 1\n"), "plan_arm"), Vec3(9, 0, 0));
}

TEST(BareCell, StandsWhereItsPosesAreAndListsTheRest) {
  const Cell cell = bareCell();
  const SessionState state = stateOf(
      "pose base 1 0 0 0 0 0 1\npose tool 1 0 1 0 0 0 1\n"
      "pose part 0 0 1 0 0 0 1 in base/flange\njoints arm 1 2\nsignal plc load 5\nadd new m\n"
      "remove gone\nhide shy\npose shy 0 0 0 0 0 0 1\nsignal - estop true\n");
  const PosedScene scene = poseScene(cell, state);
  const auto placeOf = [&](std::string_view name) -> std::optional<Vec3> {
    const PosedDevice* const device = scene.findDevice(name);
    if (device == nullptr || !device->placed) return std::nullopt;
    EXPECT_TRUE(device->bare);
    return positionOf(device->base);
  };
  EXPECT_EQ(placeOf("tool"), Vec3(1, 0, 1));
  for (const char* name : {"part", "arm", "plc", "new"}) {
    ASSERT_NE(scene.findDevice(name), nullptr) << name;
    EXPECT_FALSE(placeOf(name)) << name;
    EXPECT_FALSE(scene.findDevice(name)->link_visible[0]) << name;
  }
  EXPECT_EQ(scene.findDevice("gone"), nullptr);
  EXPECT_FALSE(scene.findDevice("shy")->visible);
  EXPECT_TRUE(poseScene(Cell(), state).devices.empty());
}

TEST_F(PosedSceneTest, ALongChainOfCarriersIsWalkedWithoutRecursion) {
  std::string lines;
  const int count = 3000;
  for (int i = 0; i < count; ++i) {
    std::string name("d");
    name += std::to_string(i);
    lines += "add " + name + " box\npose " + name + " 0 0 1 0 0 0 1";
    if (i + 1 < count) lines += " in d" + std::to_string(i + 1) + "/foot";
    lines += "\n";
  }
  EXPECT_EQ(at(scene(lines), "d0"), Vec3(0, 0, count));
}

}  // namespace
}  // namespace rocinante
