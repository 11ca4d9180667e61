#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/kinematics/urdf_reader.h"
#include "tests/core/kinematics/model_test_support.h"

namespace rocinante {
namespace {

using test::ReadUrdf;

TEST(UrdfFaults, AllFaultsOfAFileAreListedWithTheirPlacesAndTheRestIsLoaded) {
  const ReadUrdf read(R"(<robot name="r">
  <link name="base"/>
  <link name="arm">
    <visual>
      <geometry><box size="1 2"/></geometry>
    </visual>
    <visaul/>
    <visual><geometry><sphere radius="1"/></geometry><material name="bleu"/></visual>
  </link>
  <link/>
  <joint name="j1" type="revolut">
    <parent link="base"/>
    <child link="arm"/>
    <axis xyz="0 0 0"/>
    <limit lower="1" upper="-1" effort="1" velocity="1"/>
  </joint>
  <joint name="j2" type="revolute">
    <parent link="base"/>
    <child link="amr"/>
  </joint>
  <material name="blue"><color rgba="0 0 2 1"/></material>
</robot>)");
  EXPECT_EQ(
      read.faultText(),
      "robot.urdf:21:32: warning: a colour of material `blue` is outside 0 to 1 (it is "
      "clamped) [urdf.color-range]\n"
      "robot.urdf:5:22: error: `size` of <box> is `1 2`, where 3 numbers are expected "
      "[urdf.bad-number]\n"
      "robot.urdf:10:3: error: <link> lacks its attribute `name` [urdf.missing-attribute]\n"
      "robot.urdf:11:20: error: joint `j1` has the unknown type `revolut`; it is taken as "
      "fixed (did you mean `revolute`?) [urdf.unknown-joint-type]\n"
      "robot.urdf:17:3: warning: revolute joint `j2` has no <limit>; it is taken as "
      "unlimited (URDF requires one; other readers refuse the file) [urdf.missing-limit]\n"
      "robot.urdf:8:54: error: no material is named `bleu` (did you mean `blue`?) "
      "[urdf.unknown-material]\n"
      "robot.urdf:19:12: error: the child of joint `j2` is `amr`, which is not a link (did "
      "you mean `arm`?) [urdf.unknown-link]\n"
      "robot.urdf:7:5: warning: element `visaul` is left out: <link> has no such element (did "
      "you mean `visual`?) [urdf.unknown-element]\n");
  ASSERT_TRUE(read.model);
  EXPECT_EQ(read.model->links.size(), 2U);
  ASSERT_EQ(read.model->joints.size(), 1U);
  EXPECT_EQ(read.model->joints[0].type, JointType::fixed);
  EXPECT_EQ(read.model->links[1].visuals.size(), 1U);
}

struct FaultCase {
  const char* text;
  const char* fault;
};

TEST(UrdfFaults, AMeshWithoutAFileIsMissingAsOneWhoseFileIs) {
  for (const char* mesh : {"<mesh/>", "<mesh filename=''/>", "<mesh filename='none.stl'/>"}) {
    SCOPED_TRACE(mesh);
    const ReadUrdf read(fmt::format(
        "<robot name='r'><link name='l'><visual name='v'><origin xyz='1 0 0'/><geometry>{0}"
        "</geometry></visual><collision><geometry>{0}</geometry></collision></link></robot>",
        mesh));
    ASSERT_TRUE(read.model);
    const Link& link = read.model->links.at(0);
    ASSERT_EQ(link.visuals.size(), 1U);
    EXPECT_EQ(link.visuals[0].mesh, nullptr);
    EXPECT_EQ(link.visuals[0].origin.position, Vec3(1, 0, 0));
    EXPECT_EQ(link.collisions.size(), 1U);
    EXPECT_EQ(countOf(read.faults, Severity::error), 2U) << read.faultText();
  }
}

TEST(UrdfFaults, EachKindOfFaultSaysWhereAndWhat) {
  const FaultCase cases[] = {
      {"<robot><link name='a'/></robot>",
       "robot.urdf:1:1: warning: <robot> has no name (URDF requires one; other readers refuse the "
       "file) [urdf.no-name]\n"},
      {"<robot name='r'><link name='a'/><link name='a'/></robot>",
       "robot.urdf:1:33: error: a second link is named `a` (the first one is used) "
       "[urdf.duplicate-link]\n"},
      {"<robot name='r'><link name='a'/><link name='b'/></robot>",
       "robot.urdf:1:33: error: link `b` has no parent joint, and neither has `a` (connect it "
       "with a joint; it is drawn at the model's origin) [urdf.two-roots]\n"},
      {"<robot name='r'><link name='a'/><link name='b'/>\n"
       "<joint name='x' type='fixed'><parent link='a'/><child link='b'/></joint>\n"
       "<joint name='y' type='fixed'><parent link='b'/><child link='a'/></joint></robot>",
       "robot.urdf:3:1: error: joint `y` closes a loop (links must form a tree) "
       "[urdf.joint-loop]\n"},
      {"<robot name='r'><link name='a'/><link name='b'/><link name='c'/>\n"
       "<joint name='x' type='fixed'><parent link='a'/><child link='b'/></joint>\n"
       "<joint name='z' type='fixed'><parent link='a'/><child link='c'/></joint>\n"
       "<joint name='y' type='fixed'><parent link='c'/><child link='b'/></joint></robot>",
       "robot.urdf:4:1: error: joint `y` gives link `b` a second parent; joint `x` is its first "
       "(a link has one parent joint) [urdf.two-parents]\n"},
      {"<robot name='r'><link name='a'/>\n"
       "<joint name='x' type='fixed'><parent link='a'/><child link='a'/></joint></robot>",
       "robot.urdf:2:1: error: joint `x` closes a loop (links must form a tree) "
       "[urdf.joint-loop]\n"},
      {"<robot name='r'><link name='a'/>\n"
       "<joint name='x'><parent link='a'/></joint></robot>",
       "robot.urdf:2:1: error: <joint> lacks its attribute `type` [urdf.missing-attribute]\n"
       "robot.urdf:2:1: error: joint `x` has no <child> [urdf.missing-element]\n"},
      {"<robot name='r'><link name='a'/><link name='b'/>\n"
       "<joint name='x' type='continuous'><parent link='a'/><child link='b'/>"
       "<mimic joint='x'/></joint></robot>",
       "robot.urdf:2:77: error: joint `x` mimics itself, directly or through others (it is taken "
       "as driven) [urdf.mimic-loop]\n"},
      {"<robot name='r'><link name='a'/><link name='b'/>\n"
       "<joint name='x' type='planar'><parent link='a'/><child link='b'/>"
       "<mimic joint='y'/></joint></robot>",
       "robot.urdf:2:73: error: joint `x` mimics `y`, which is not a joint [urdf.unknown-mimic]\n"},
      {"<robot name='r'><link name='a'/><link name='b'/>\n"
       "<joint name='x' type='prismatic'><parent link='a'/><child link='b'/>"
       "<limit/><limit/></joint></robot>",
       "robot.urdf:2:77: error: <joint> has a second <limit> (the first one is used) "
       "[urdf.repeated-element]\n"
       "robot.urdf:2:69: warning: the limit of joint `x` lacks `effort` (URDF requires it; other "
       "readers refuse the file) [urdf.missing-limit-attribute]\n"
       "robot.urdf:2:69: warning: the limit of joint `x` lacks `velocity` (URDF requires it; other "
       "readers refuse the file) [urdf.missing-limit-attribute]\n"
       "robot.urdf:2:69: warning: the limit of joint `x` has neither `lower` nor `upper`: it "
       "cannot move (both default to 0) [urdf.no-motion]\n"},
      {"<robot name='r'><link name='a'><visual/></link></robot>",
       "robot.urdf:1:32: error: <visual> has no <geometry> [urdf.missing-element]\n"},
      {"<robot name='r'><link "
       "name='a'><visual><geometry><cone/></geometry></visual></link></robot>",
       "robot.urdf:1:40: error: <geometry> has no known shape (shapes are box, cylinder, "
       "sphere, capsule, mesh) [urdf.no-shape]\n"
       "robot.urdf:1:50: note: element `cone` is left out: an extension that is not read "
       "[model.left-out]\n"},
      {"<robot name='r'><link name='a'><visual><geometry><sphere radius='-1'/></geometry></visual>"
       "</link></robot>",
       "robot.urdf:1:58: error: `radius` of <sphere> must be above 0 and below 1e9 "
       "[urdf.bad-size]\n"},
      {"<robot name='r'><link name='a'><visual><geometry><mesh filename='a.stl' scale='1 1 1e308'/>"
       "</geometry></visual></link></robot>",
       "robot.urdf:1:73: error: `scale` of <mesh> must be between -1e9 and 1e9 "
       "[urdf.bad-size]\n"},
      {"<robot name='r'><link name='a'><visual><geometry><sphere radius='nan'/></geometry></visual>"
       "</link></robot>",
       "robot.urdf:1:58: error: `radius` of <sphere> is `nan`, where a number is expected "
       "[urdf.bad-number]\n"},
      {"<robot name='r'><link name='a'><visual><geometry><sphere "
       "radius='${r}'/></geometry></visual>"
       "</link></robot>",
       "robot.urdf:1:58: error: `radius` of <sphere> is `${r}`, where a number is expected (expand "
       "the template first: xacro model.xacro > model.urdf) [urdf.bad-number]\n"},
      {"<robot name='r'><link name='a'><visual><geometry><mesh filename='no.stl'/></geometry>"
       "</visual></link></robot>",
       "robot.urdf:1:56: error: the mesh `no.stl` is not used: there is no such file within the "
       "search roots (add its folder to `search` in the cell, or use --search) "
       "[model.missing-file]\n"},
      {"<robot name='r'><link name='a'><visual><geometry><mesh filename='$(find p)/a.stl'/>"
       "</geometry></visual></link></robot>",
       "robot.urdf:1:56: error: the mesh `$(find p)/a.stl` is not used: its name is a template "
       "expression (expand the template first: xacro model.xacro > model.urdf) "
       "[model.missing-file]\n"},
      {"<robot name='r'><link name='a'><visual><geometry><mesh filename='/dev/zero'/>"
       "</geometry></visual></link></robot>",
       "robot.urdf:1:56: error: the mesh `/dev/zero` is not used: it is outside the search roots "
       "(add its folder to `search` in the cell, or use --search) [model.missing-file]\n"},
  };
  for (const FaultCase& each : cases) {
    SCOPED_TRACE(each.text);
    const ReadUrdf read(each.text);
    EXPECT_EQ(read.faultText(), each.fault);
    EXPECT_TRUE(read.model);
  }
}

TEST(UrdfFaults, WhatIsNoUrdfAtAllIsRefusedWithItsReason) {
  const FaultCase cases[] = {
      {"", "robot.urdf: error: the file holds no XML [urdf.xml]\n"},
      {"<robot name='r'><link name='a'></robot>",
       "robot.urdf:1: error: the XML breaks off here: an end tag does not match its start tag "
       "[urdf.xml]\n"},
      {"<sdf version='1.6'/>",
       "robot.urdf:1:1: error: the outermost element is <sdf>, where URDF has <robot> (this is "
       "SDF: name the file .sdf) [urdf.no-robot]\n"},
      {"<robot name='r'/>", "robot.urdf:1:1: error: the model has no link [urdf.no-link]\n"},
      {"<robot name='r' xmlns:xacro='x'>\n  <!-- <xacro:not this='1'/> -->\n"
       "  <xacro:include filename='a'/><link name='a'/></robot>",
       "robot.urdf:3:3: error: <xacro:include> makes this a xacro template, not URDF (expand the "
       "template first: xacro model.xacro > model.urdf) [urdf.xacro]\n"},
  };
  for (const FaultCase& each : cases) {
    SCOPED_TRACE(each.text);
    const ReadUrdf read(each.text);
    EXPECT_EQ(read.faultText(), each.fault);
    EXPECT_FALSE(read.model);
  }
}

TEST(UrdfFaults, PlacesStandAlsoBesideCommentsAndQuotedBrackets) {
  const ReadUrdf read(
      "<?xml version='1.0'?>\n<!-- <link/> --><robot name='a>b'><![CDATA[<link/>]]>\n"
      "\t<link name='a'><visual><geometry>\n    <sphere\n  radius='one'/></geometry></visual>"
      "</link></robot>");
  EXPECT_EQ(read.faultText(),
            "robot.urdf:5:3: error: `radius` of <sphere> is `one`, where a number is expected "
            "[urdf.bad-number]\n");
}

TEST(UrdfFaults, ManyFaultsOfOneKindAreCountedNotListed) {
  std::string text = "<robot name='r'><link name='a'/>";
  for (int i = 0; i < 1000; ++i) text += "<link name='a'/>";
  const ReadUrdf read(text + "</robot>");
  ASSERT_EQ(read.faults.size(), 101U);
  EXPECT_EQ(read.faults.back().text, "900 more of these");
}

TEST(UrdfFaults, DeepAndEndlessFilesAreRefusedByTheirLimits) {
  std::string deep = "<robot name='r'>";
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  const ReadUrdf deep_read(deep);
  EXPECT_FALSE(deep_read.model);
  EXPECT_EQ(deep_read.faultText(),
            "robot.urdf:1: error: the XML is nested deeper than 100 elements [urdf.xml]\n");

  std::string many = "<robot name='r'><link name='a'/>";
  for (std::size_t i = 0; i <= 1000000; ++i) many += "<joint/>";
  many += "</robot>";
  const ReadUrdf joints_read(many);
  EXPECT_FALSE(joints_read.model);
  EXPECT_EQ(joints_read.faultText(),
            "robot.urdf:1:1: error: the robot has more than 65536 links or joints "
            "[urdf.too-many]\n");

  for (std::size_t i = 0; i < 100000; ++i) many += "<joint/>";
  const ReadUrdf many_read(many);
  EXPECT_FALSE(many_read.model);
  EXPECT_EQ(many_read.faultText(),
            "robot.urdf: error: the file has more than 1048576 elements [urdf.too-many]\n");
}

TEST(UrdfFaults, ATextCutAnywhereIsReadOrRefusedButNeverCrashes) {
  const std::string text = R"(<?xml version="1.0"?><!-- c --><robot name="r"><link name="a"><visual>
<origin xyz="0 0 1" rpy="0 0 0"/><geometry><box size="1 1 1"/></geometry><material name="m">
<color rgba="1 0 0 1"/></material></visual></link><link name="b"/><joint name="j" type="revolute">
<parent link="a"/><child link="b"/><limit lower="0" upper="1" effort="1" velocity="1"/></joint>
</robot>)";
  for (std::size_t length = 0; length < text.size(); ++length) {
    const std::string cut(text.data(), length);
    const ReadUrdf read(cut);
    EXPECT_FALSE(read.model) << length;
    EXPECT_FALSE(read.faults.empty()) << length;
  }
  EXPECT_EQ(ReadUrdf(text).faultText(), "");
}

}  // namespace
}  // namespace rocinante
