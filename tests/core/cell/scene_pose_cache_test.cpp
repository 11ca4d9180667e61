// Posing only moved devices gives the same bits as posing everything.
#include "core/cell/scene_pose_cache.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "core/cell/posed_scene.h"
#include "tests/core/cell/cell_fixture.h"

namespace rocinante {
namespace {

bool sameMatrix(const Mat4& a, const Mat4& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

void expectSame(const PosedScene& a, const PosedScene& b) {
  ASSERT_EQ(a.devices.size(), b.devices.size());
  ASSERT_EQ(a.device_by_name, b.device_by_name);
  for (std::size_t i = 0; i < a.devices.size(); ++i) {
    const PosedDevice& one = a.devices[i];
    const PosedDevice& other = b.devices[i];
    SCOPED_TRACE(one.name);
    EXPECT_EQ(one.name, other.name);
    EXPECT_EQ(one.model, other.model);
    EXPECT_TRUE(sameMatrix(one.base, other.base));
    ASSERT_EQ(one.link_world.size(), other.link_world.size());
    for (std::size_t link = 0; link < one.link_world.size(); ++link) {
      EXPECT_TRUE(sameMatrix(one.link_world[link], other.link_world[link])) << link;
    }
    EXPECT_EQ(one.link_visible, other.link_visible);
    EXPECT_EQ(one.link_color, other.link_color);
    EXPECT_EQ(one.visible, other.visible);
    EXPECT_EQ(one.ghost, other.ghost);
  }
  ASSERT_EQ(a.cameras.size(), b.cameras.size());
  for (std::size_t i = 0; i < a.cameras.size(); ++i) {
    EXPECT_EQ(a.cameras[i].eye, b.cameras[i].eye);
    EXPECT_EQ(a.cameras[i].target, b.cameras[i].target);
  }
}

class ScenePosesTest : public test::CellFolder {
 protected:
  ScenePosesTest() {
    auto loaded = load(R"(
format = 1
[[device]]
name = "arm"
model = "arm.urdf"
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
[[camera]]
name = "wrist"
on = "arm/tip"
eye = [1, 0, 0]
target = [0, 0, 0]
[[source]]
name = "planner"
ghost_of = { plan_arm = "arm" }
)");
    EXPECT_TRUE(loaded.ok());
    cell_ = std::move(*loaded);
  }
  Cell cell_;
};

TEST_F(ScenePosesTest, GivesTheBitsOfPosingEverythingWhateverCameBefore) {
  std::mt19937 random(7);
  const auto pick = [&](std::size_t count) { return random() % count; };
  const auto device = [&] {
    const char* names[] = {"arm", "tool", "late", "plan_arm", "guest"};
    return std::string(names[pick(5)]);
  };
  const auto number = [&] { return std::to_string(0.125 * static_cast<double>(pick(17)) - 1); };
  ScenePoseCache poses(cell_);
  ScenePoseCache chosen_poses(cell_);
  std::string said;
  for (int step = 0; step < 300; ++step) {
    SCOPED_TRACE(step);
    switch (pick(9)) {
      case 0:
        said += "add " + device() + " box\n";
        break;
      case 1:
        said += "remove " + device() + "\n";
        break;
      case 2:
        said += "joint " + device() + " lift=" + number() + "\n";
        break;
      case 3:
        said += "pose " + device() + " " + number() + " 0 0 0 0 0 1\n";
        break;
      case 4:
        said += "pose " + device() + " 1 0 0 0 0 0 1 in " + device() + "/tip\n";
        break;
      case 5:
        said += "hide " + device() + "\n";
        break;
      case 6:
        said += "color " + device() + "/tip #102030\n";
        break;
      case 7:
        said.clear();
        break;  // back to the beginning, as a seek does
      default:
        said += "joints " + device() + " " + number() + "\n";
        break;
    }
    const SessionState state = test::stateOf(said);
    const PosedScene whole = poseScene(cell_, state);
    expectSame(poses.pose(state), whole);
    std::set<std::string, std::less<>> chosen{device()};
    const PosedScene part = chosen_poses.places(state, chosen);
    for (const PosedDevice& posed : whole.devices) {
      EXPECT_EQ(part.findDevice(posed.name) != nullptr, chosen.contains(posed.name)) << posed.name;
    }
    for (const PosedDevice& posed : part.devices) {
      const PosedDevice* const same = whole.findDevice(posed.name);
      ASSERT_NE(same, nullptr);
      EXPECT_TRUE(sameMatrix(posed.base, same->base));
      ASSERT_EQ(posed.link_world.size(), same->link_world.size());
      for (std::size_t link = 0; link < posed.link_world.size(); ++link) {
        EXPECT_TRUE(sameMatrix(posed.link_world[link], same->link_world[link])) << link;
      }
    }
    if (HasFailure()) FAIL() << said;
  }
}

TEST_F(ScenePosesTest, ReckonsOnlyWhatMovedAndWhatThatCarries) {
  ScenePoseCache poses(cell_);
  poses.pose(test::stateOf(""));
  EXPECT_EQ(poses.moved(), 2U);
  poses.pose(test::stateOf("hide arm\n"));
  EXPECT_EQ(poses.moved(), 0U);
  poses.pose(test::stateOf("joints tool 0.5\n"));
  EXPECT_EQ(poses.moved(), 1U);
  poses.pose(test::stateOf("joints tool 0.5\njoints arm 0.5\n"));
  EXPECT_EQ(poses.moved(), 2U) << "the arm carries the tool";
}

}  // namespace
}  // namespace rocinante
