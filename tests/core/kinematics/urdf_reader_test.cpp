#include "core/kinematics/urdf_reader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/cell/cell.h"
#include "core/kinematics/kinematics.h"
#include "core/math/transform.h"
#include "core/math/trigonometry.h"
#include "tests/core/kinematics/model_test_support.h"
#include "tests/support/write_file.h"

namespace rocinante {
namespace {

using test::ReadUrdf;

TEST(UrdfReader, ReadsLinksJointsAndTheirOrder) {
  const ReadUrdf read(R"(<?xml version="1.0"?>
<robot name="two">
  <link name="b"/> <link name="a"/> <link name="c"/>
  <joint name="second" type="prismatic">
    <parent link="b"/><child link="c"/>
    <origin xyz="1 2 3" rpy="0 0 1.5"/><axis xyz="0 0 -2"/>
    <limit lower="-.5" upper="+1.25e0" effort="10" velocity="2."/>
  </joint>
  <joint name="first" type="continuous">
    <parent link="a"/><child link="b"/>
    <limit effort="3" velocity="4"/>
  </joint>
</robot>)");
  EXPECT_EQ(read.faultText(), "");
  ASSERT_TRUE(read.model);
  const Model& model = *read.model;
  EXPECT_EQ(model.name, "two");
  EXPECT_EQ(model.links[model.root].name, "a");
  ASSERT_EQ(model.joints.size(), 2U);
  EXPECT_EQ(model.movableJoints(), (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(model.update_order, (std::vector<std::size_t>{1, 0}));

  const Joint& second = model.joints[0];
  EXPECT_EQ(second.name, "second");
  EXPECT_EQ(second.type, JointType::prismatic);
  EXPECT_EQ(second.axis, Vec3(0, 0, -1));
  EXPECT_EQ(second.origin.position, Vec3(1, 2, 3));
  EXPECT_EQ(second.origin.orientation, quaternionFromRpy({0, 0, 1.5}));
  ASSERT_TRUE(second.limits);
  EXPECT_EQ(second.limits->lower, -0.5);
  EXPECT_EQ(second.limits->upper, 1.25);
  EXPECT_EQ(second.limits->velocity, 2.0);
  EXPECT_EQ(second.limits->effort, 10.0);

  const Joint& first = model.joints[1];
  EXPECT_EQ(first.axis, Vec3(1, 0, 0)) << "URDF's default";
  ASSERT_TRUE(first.limits);
  EXPECT_EQ(first.limits->upper, std::numeric_limits<double>::infinity());
  EXPECT_EQ(first.limits->velocity, 4.0);
}

TEST(UrdfReader, ReadsEveryShapeOfSeveralVisualsAndCollisions) {
  const ReadUrdf read(R"(<robot name="r"><link name="l">
  <visual name="one"><origin xyz="0 0 1"/><geometry><box size="1 2 3"/></geometry></visual>
  <visual><geometry><cylinder radius="0.5" length="2"/></geometry></visual>
  <visual><geometry><sphere radius="0.5"/></geometry></visual>
  <visual><geometry><capsule radius="0.5" length="1"/></geometry></visual>
  <visual><geometry><box size="1 2 3"/></geometry></visual>
  <collision><geometry><sphere radius="1"/></geometry></collision>
  <collision><geometry><sphere radius="2"/></geometry></collision>
</link></robot>)");
  EXPECT_EQ(read.faultText(), "");
  ASSERT_TRUE(read.model);
  const Link& link = read.model->links[0];
  ASSERT_EQ(link.visuals.size(), 5U);
  EXPECT_EQ(link.collisions.size(), 2U);
  EXPECT_EQ(link.visuals[0].name, "one");
  EXPECT_EQ(link.visuals[0].origin.position, Vec3(0, 0, 1));
  EXPECT_EQ(link.visuals[0].mesh->triangleCount(), 12U);
  EXPECT_EQ(link.visuals[0].mesh, link.visuals[4].mesh) << "equal shapes share one mesh";
  EXPECT_EQ(link.visuals[3].mesh->bounds.max.z, 1.0);
}

TEST(UrdfReader, FindsMaterialsByNameWhereverTheyAreDefined) {
  const ReadUrdf read(R"(<robot name="r">
  <link name="l">
    <visual><geometry><sphere radius="1"/></geometry><material name="late"/></visual>
    <visual><geometry><sphere radius="1"/></geometry>
      <material name="inside"><color rgba="0 1 0 0.5"/></material></visual>
    <visual><geometry><sphere radius="1"/></geometry><material name="inside"/></visual>
    <visual><geometry><sphere radius="1"/></geometry>
      <material name=""><color rgba="0 0 1 1"/></material></visual>
  </link>
  <material name="late"><color rgba="1 0 0 1"/></material>
</robot>)");
  EXPECT_EQ(read.faultText(), "");
  ASSERT_TRUE(read.model);
  const auto& visuals = read.model->links[0].visuals;
  EXPECT_EQ(visuals[0].material->diffuse, glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(visuals[1].material->diffuse, glm::vec4(0, 1, 0, 0.5));
  EXPECT_EQ(visuals[2].material->diffuse, glm::vec4(0, 1, 0, 0.5));
  EXPECT_EQ(visuals[3].material->diffuse, glm::vec4(0, 0, 1, 1));
}

TEST(UrdfReader, MeshesKeepTheirOwnMaterialsAndTheScaleMayMirror) {
  test::TemporaryFolder folder;
  test::writeFile(folder / "own.mtl", "newmtl red\nKd 1 0 0\n");
  test::writeFile(folder / "own.obj",
                  "mtllib own.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n");
  test::writeFile(folder / "plain.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  test::writeFile(folder / "r.urdf", R"(<robot name="r"><link name="l">
    <visual><geometry><mesh filename="own.obj" scale="1 -1 1"/></geometry>
      <material name="blue"><color rgba="0 0 1 1"/></material></visual>
    <visual><geometry><mesh filename="plain.obj"/></geometry><material name="blue"/></visual>
    <visual><geometry><mesh filename="own.obj"/></geometry></visual>
  </link></robot>)");
  const auto cell = loadCell(folder / "r.urdf", {});
  ASSERT_TRUE(cell.ok());
  EXPECT_EQ(test::printed(cell->faults), "");
  const auto& visuals = cell->modelOf(cell->devices[0])->links[0].visuals;
  EXPECT_FALSE(visuals[0].material);
  EXPECT_EQ(visuals[0].scale, Vec3(1, -1, 1));
  EXPECT_EQ(visuals[1].material->diffuse, glm::vec4(0, 0, 1, 1));
  EXPECT_EQ(visuals[0].mesh, visuals[2].mesh) << "a file is read once";
  EXPECT_EQ(cell->files.size(), 4U);
}

TEST(UrdfReader, ShapesOfManySizesAreOneShapeScaled) {
  std::string text = "<robot name='r'><link name='a'>";
  for (int i = 0; i < 1002; ++i) {
    text += "<visual><geometry><sphere radius='" + std::to_string(i + 1) +
            "e-3'/></geometry></visual><collision><geometry><capsule length='1' radius='" +
            std::to_string(i + 1) + "e-3'/></geometry></collision>";
  }
  const test::ReadUrdf read(text + "</link></robot>");
  ASSERT_TRUE(read.model);
  const Link& link = read.model->links[0];
  ASSERT_EQ(link.visuals.size(), 1002U);
  // The first thousand have exact sizes; the others share one mesh.
  EXPECT_EQ(link.visuals[999].scale, Vec3(1, 1, 1));
  EXPECT_NE(link.visuals[998].mesh, link.visuals[999].mesh);
  EXPECT_EQ(link.visuals[1000].mesh, link.visuals[1001].mesh);
  EXPECT_EQ(link.visuals[1001].scale, Vec3(1.002, 1.002, 1.002));
  EXPECT_EQ(link.visuals[1001].mesh->bounds.max.z, 1.0);
  // A capsule cannot be scaled to another.
  EXPECT_EQ(link.collisions[999].mesh->bounds.max.x, 1.0);
  EXPECT_EQ(link.collisions[1000].mesh, nullptr);
  EXPECT_EQ(read.faults.size(), 2U);
  EXPECT_EQ(read.faults[0].text,
            "the capsule is not used: there are more than 1000 of other sizes");
}

TEST(UrdfReader, ReadsMimicsAlongChains) {
  const ReadUrdf read(R"(<robot name="r">
  <link name="a"/><link name="b"/><link name="c"/><link name="d"/>
  <joint name="j3" type="continuous"><parent link="c"/><child link="d"/>
    <mimic joint="j2" multiplier="2" offset="0.5"/></joint>
  <joint name="j1" type="continuous"><parent link="a"/><child link="b"/></joint>
  <joint name="j2" type="prismatic"><parent link="b"/><child link="c"/>
    <limit lower="0" upper="1" effort="1" velocity="1"/><mimic joint="j1" multiplier="-1"/></joint>
</robot>)");
  EXPECT_EQ(read.faultText(), "");
  ASSERT_TRUE(read.model);
  EXPECT_EQ(read.model->positionalCount(), 1U);
  JointVector joints = zeroJoints(*read.model);
  EXPECT_EQ(joints.values, (std::vector<double>{0.5, 0, 0}));
  joints.values[1] = 3.0;
  applyMimics(*read.model, joints);
  EXPECT_EQ(joints.values, (std::vector<double>{-5.5, 3, -3}));
}

}  // namespace
}  // namespace rocinante
