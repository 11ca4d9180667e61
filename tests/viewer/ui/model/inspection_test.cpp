#include "viewer/ui/model/inspection.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math/transform.h"
#include "core/math/trigonometry.h"

namespace rocinante {
namespace {

class Inspected : public testing::Test {
 protected:
  Inspected() {
    model_.links.resize(2);
    model_.links[0].name = "base";
    model_.links[1].name = "hand";
    model_.link_by_name = {{"base", 0}, {"hand", 1}};
    add("arm", matrixOf({{1, 0, 0}, quaternionFromRpy({0, 0, kPi / 2})}));
    add("tray", translationMatrix({0, 3, 0}));
  }
  void add(const std::string& name, const Mat4& base) {
    PosedDevice device;
    device.name = name;
    device.model = &model_;
    device.base = base;
    device.link_world = {base, base * translationMatrix({0, 0, 0.5})};
    scene_.device_by_name[name] = scene_.devices.size();
    scene_.devices.push_back(std::move(device));
  }

  Model model_;
  PosedScene scene_;
};

TEST_F(Inspected, APoseIsToldInTheWorldAndInAnyOthersSpace) {
  const auto world = poseIn(scene_, {"arm", "hand"}, {});
  ASSERT_TRUE(world.has_value());
  EXPECT_NEAR(lengthOf(world->position - Vec3(1, 0, 0.5)), 0, 1e-12);
  EXPECT_NEAR(rpyOf(world->orientation).z, kPi / 2, 1e-12);
  // Seen from the arm, which looks along the world's y, the tray is 3 m ahead and 1 m to the left.
  const auto seen = poseIn(scene_, {"tray", ""}, {"arm", "hand"});
  ASSERT_TRUE(seen.has_value());
  EXPECT_NEAR(lengthOf(seen->position - Vec3(3, 1, -0.5)), 0, 1e-12);
  EXPECT_NEAR(rpyOf(seen->orientation).z, -kPi / 2, 1e-12);
  const auto itself = poseIn(scene_, {"arm", "hand"}, {"arm", "hand"});
  ASSERT_TRUE(itself.has_value());
  EXPECT_NEAR(lengthOf(itself->position), 0, 1e-12);
  EXPECT_FALSE(poseIn(scene_, {"leg", ""}, {}).has_value());
  EXPECT_FALSE(poseIn(scene_, {"arm", ""}, {"leg", ""}).has_value());
  EXPECT_FALSE(poseIn(scene_, {"arm", "foot"}, {}).has_value());
}

TEST(RollPitchYaw, AreThoseOfTheQuaternion) {
  for (const double roll : {-3.0, -0.4, 0.0, 1.2, 3.1}) {
    for (const double pitch : {-1.5, -0.3, 0.0, 1.5}) {
      for (const double yaw : {-2.5, 0.0, 0.7, 3.0}) {
        const Vec3 found = rpyOf(quaternionFromRpy({roll, pitch, yaw}));
        EXPECT_NEAR(lengthOf(found - Vec3(roll, pitch, yaw)), 0, 1e-9)
            << roll << " " << pitch << " " << yaw;
      }
    }
  }
}

TEST(RollPitchYaw, AtTheirPoleGiveTheSameTurn) {
  for (const double pitch : {kPi / 2, -kPi / 2}) {
    const Quat turn = quaternionFromRpy({0.3, pitch, 1.1});
    const Quat again = quaternionFromRpy(rpyOf(turn));
    const double same = turn.x * again.x + turn.y * again.y + turn.z * again.z + turn.w * again.w;
    EXPECT_NEAR(std::abs(same), 1, 1e-9);
  }
}

TEST_F(Inspected, ADistanceIsPickedByTwoClicksAndMovesWithWhatWasClicked) {
  DistancePicking picking;
  EXPECT_FALSE(picking.add(scene_, {"arm", "hand"}, {1, 0, 0.5}).has_value());  // not begun
  picking.begin();
  EXPECT_FALSE(picking.add(scene_, {"leg", ""}, {0, 0, 0}).has_value());
  EXPECT_FALSE(picking.first().has_value());
  EXPECT_FALSE(picking.add(scene_, {"arm", "hand"}, {1, 0, 1}).has_value());
  ASSERT_TRUE(picking.first().has_value());
  const auto measure = picking.add(scene_, {"tray", ""}, {1, 3, 1});
  ASSERT_TRUE(measure.has_value());
  EXPECT_FALSE(picking.active());
  EXPECT_EQ(measure->from.path, "arm/hand");
  EXPECT_NEAR(*distanceOf(*measure, scene_), 3, 1e-12);
  // Two metres further.
  scene_.devices[1].base = translationMatrix({0, 5, 0});
  scene_.devices[1].link_world[0] = scene_.devices[1].base;
  EXPECT_NEAR(*distanceOf(*measure, scene_), 5, 1e-12);
  picking.begin();
  EXPECT_FALSE(picking.add(scene_, {"arm", "hand"}, {1, 0, 1}).has_value());
  picking.end();
  EXPECT_FALSE(picking.first().has_value());
}

}  // namespace
}  // namespace rocinante
