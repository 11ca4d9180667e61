#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/base/number_list.h"
#include "core/math/trigonometry.h"
#include "tests/core/cell/cell_fixture.h"
#include "viewer/model/pose_request.h"

namespace rocinante {
namespace {

class ForwardKinematicsTest : public test::CellFolder {
 protected:
  ForwardKinematicsTest() {
    test::writeFile(folder_ / "two.urdf", R"(<robot name="two">
<link name="base"/><link name="arm"/><link name="hand"/><link name="copy"/><link name="car"/>
<joint name="turn" type="revolute"><parent link="base"/><child link="arm"/><axis xyz="0 0 1"/>
  <limit lower="-9" upper="9" effort="1" velocity="1"/></joint>
<joint name="slide" type="prismatic"><parent link="arm"/><child link="hand"/><axis xyz="1 0 0"/>
  <limit lower="0" upper="1" effort="1" velocity="1"/></joint>
<joint name="copied" type="prismatic"><parent link="arm"/><child link="copy"/><axis xyz="0 1 0"/>
  <limit lower="0" upper="1" effort="1" velocity="1"/><mimic joint="slide" multiplier="2"/></joint>
<joint name="drive" type="planar"><parent link="base"/><child link="car"/><axis xyz="0 0 1"/></joint>
</robot>)");
  }

  std::string answer(const std::string& file, const PoseRequest& request) {
    const auto cell = loadCell(folder_ / file, {});
    if (!cell.ok()) return cell.error().text();
    const auto links = forwardKinematics(*cell, request);
    return links.ok() ? forwardKinematicsText(*links) : links.error().text();
  }
};

TEST_F(ForwardKinematicsTest, TurnsSlidesAndMimics) {
  PoseRequest request;
  request.degrees = true;
  request.joints = {90, 0.5, 3, 4, 180};
  request.base = Pose{{10, 0, 0}, {1, 0, 0, 0}};
  const auto cell = loadCell(folder_ / "two.urdf", {});
  ASSERT_TRUE(cell.ok());
  const auto links = forwardKinematics(*cell, request);
  ASSERT_TRUE(links.ok()) << links.error().text();
  const auto json = nlohmann::json::parse(forwardKinematicsJson(*links));
  EXPECT_EQ(json["format"], 1);
  EXPECT_EQ(json.size(), 6U);
  EXPECT_NEAR(json["hand"]["xyz"][0].get<double>(), 10.0, 1e-15);
  EXPECT_NEAR(json["hand"]["xyz"][1].get<double>(), 0.5, 1e-15) << "degrees do not slide";
  EXPECT_NEAR(json["copy"]["xyz"][0].get<double>(), 9.0, 1e-15);
  EXPECT_NEAR(json["hand"]["quaternion"][2].get<double>(), std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(json["hand"]["quaternion"][3].get<double>(), std::sqrt(0.5), 1e-15) << "x y z w";
  EXPECT_EQ(json["car"]["xyz"], nlohmann::json({13.0, 4.0, 0.0}));
}

TEST_F(ForwardKinematicsTest, SingleJointsStandOverPositionalOnes) {
  PoseRequest request;
  request.joints = {0.0, 0.25, 0, 0, 0};
  request.named = {{"slide", 1.0}, {"drive.x", 7.0}};
  const std::string text = answer("two.urdf", request);
  EXPECT_NE(text.find("hand  1.000000"), std::string::npos) << text;
  EXPECT_NE(text.find("car   7.000000"), std::string::npos) << text;
}

TEST_F(ForwardKinematicsTest, WrongValuesAreRefusedWithWhatIsRight) {
  PoseRequest request;
  request.joints = {1.0};
  EXPECT_EQ(answer("two.urdf", request),
            "1 joint value, but the model takes 5: turn slide drive.x drive.y drive.yaw");
  request.joints.reset();
  request.named = {{"slied", 1.0}};
  EXPECT_EQ(answer("two.urdf", request), "the model has no joint `slied`; did you mean `slide`?");
  request.named = {{"copied", 1.0}};
  EXPECT_EQ(answer("two.urdf", request),
            "joint `copied` mimics `slide` and cannot have its own value");
  request.named = {{"drive", 1.0}};
  EXPECT_EQ(answer("two.urdf", request),
            "joint `drive` is planar: its values are `drive.x` and so on");
  EXPECT_EQ(parseNumbers("1 2x 3").error().what, "`2x` is not a number");
  EXPECT_EQ(parseNumbers("nan").error().what, "`nan` is not a number");
  EXPECT_EQ(*parseNumbers(" -1,+2e3\t.5 "), (std::vector<double>{-1, 2000, 0.5}));
}

TEST_F(ForwardKinematicsTest, OfACellEveryDeviceStandsWhereItIsCarried) {
  test::writeFile(folder_ / "cell.toml", R"(format = 1
[[device]]
name = "a"
model = "two.urdf"
pose = { xyz = [1, 0, 0] }
[[device]]
name = "b"
model = "arm.urdf"
on = "a/hand"
[[device]]
name = "waits"
model = "arm.urdf"
optional = true
)");
  PoseRequest request;
  request.named = {{"turn", 0.0}};
  EXPECT_EQ(answer("cell.toml", request), "the cell has 3 devices: choose one with --device");
  request.device = "a";
  request.named = {{"slide", 0.5}};
  const auto cell = loadCell(folder_ / "cell.toml", {});
  ASSERT_TRUE(cell.ok());
  EXPECT_EQ(forwardKinematics(*cell, request)->at(2).link, "hand");
  EXPECT_EQ(forwardKinematics(*cell, request)->at(2).pose.position, Vec3(1.5, 0, 0));
  const auto all = forwardKinematics(*cell, {});
  ASSERT_TRUE(all.ok());
  EXPECT_EQ(all->size(), 7U) << "what waits for `add` is not there";
  EXPECT_EQ(all->at(6).link, "b/tip");
  EXPECT_EQ(all->at(6).pose.position, Vec3(1, 0, 0));
}

}  // namespace
}  // namespace rocinante
