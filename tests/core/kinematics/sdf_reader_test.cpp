#include "core/kinematics/sdf_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/loaded_module.h"
#include "core/cell/cell.h"
#include "core/kinematics/kinematics.h"
#include "core/math/transform.h"
#include "tests/core/kinematics/model_test_support.h"
#include "tests/support/shared_data.h"
#include "tests/support/write_file.h"

namespace rocinante {
namespace {

using ::testing::HasSubstr;

#define ROCINANTE_NEEDS_SDF                         \
  if (!loadModule("librocinante_sdformat.so").ok()) \
  GTEST_SKIP() << "built without ROCINANTE_SDF (libsdformat)"

struct ReadSdf {
  explicit ReadSdf(std::string_view text) {
    static_cast<void>(search.addRoot(folder.path()).ok());
    MeshStore meshes(search, true);
    model = readSdf(bytesOf(text), folder / "arm.sdf", meshes, faults);
  }
  std::string faultText() const { return test::printed(faults, folder.path()); }

  test::TemporaryFolder folder;
  FileSearch search;
  Findings faults;
  std::optional<Model> model;
};

// Links have poses in the model, and joints poses in their child, unlike in URDF.
constexpr const char* kArm = R"(<sdf version='1.7'>
<model name='arm'>
  <link name='base'><pose>1 0 0 0 0 0</pose>
    <visual name='foot'><pose>0 0 0.5 0 0 0</pose><geometry><box><size>1 2 3</size></box></geometry>
      <material><diffuse>1 0.5 0 1</diffuse></material></visual></link>
  <link name='upper'><pose>1 0 2 0 0 1.5707963267948966</pose>
    <collision name='c'><geometry><sphere><radius>0.1</radius></sphere></geometry></collision></link>
  <link name='hand'><pose>1 1 2 0 0 0</pose></link>
  <joint name='turn' type='revolute'><parent>base</parent><child>upper</child>
    <pose>0.5 0 0 0 0 0</pose>
    <axis><xyz>0 0 1</xyz><limit><lower>-1</lower><upper>2</upper><velocity>3</velocity><effort>4</effort></limit></axis></joint>
  <joint name='slide' type='prismatic'><parent>upper</parent><child>hand</child>
    <axis><xyz>1 0 0</xyz><limit><lower>0</lower><upper>1</upper></limit></axis></joint>
</model></sdf>)";

TEST(SdfReader, LinksStandWhereTheFileHasThemAndJointsTurnThemAboutTheirOwnPlace) {
  ROCINANTE_NEEDS_SDF;
  const ReadSdf read(kArm);
  EXPECT_EQ(read.faultText(), "");
  ASSERT_TRUE(read.model);
  const Model& model = *read.model;
  EXPECT_EQ(model.name, "arm");
  ASSERT_EQ(model.links.size(), 3U);
  ASSERT_EQ(model.joints.size(), 2U);
  EXPECT_EQ(model.joints[0].type, JointType::revolute);
  EXPECT_EQ(model.joints[0].limits->lower, -1);
  EXPECT_EQ(model.joints[0].limits->velocity, 3);
  EXPECT_EQ(model.joints[0].limits->effort, 4);

  const Link& base = model.links[0];
  ASSERT_EQ(base.visuals.size(), 1U);
  EXPECT_EQ(base.visuals[0].origin.position, (Vec3{1, 0, 0.5}));
  EXPECT_EQ(base.visuals[0].material->diffuse, glm::vec4(1, 0.5, 0, 1));
  ASSERT_EQ(model.links[1].collisions.size(), 1U);

  // At zero the sphere is at upper's place; a quarter turn moves it around the joint, which is half
  // a metre along upper's x, the model's y: at (1, 0.5, 2).
  JointVector joints = zeroJoints(model);
  const auto sphereAt = [&] {
    return transformPoint(
        linkPoses(model, joints)[1] * matrixOf(model.links[1].collisions[0].origin), {0, 0, 0});
  };
  EXPECT_NEAR(glm::distance(sphereAt(), Vec3(1, 0, 2)), 0, 1e-12);
  joints.values[joints.first_value[0]] = std::acos(0.0);
  EXPECT_NEAR(glm::distance(sphereAt(), Vec3(1.5, 0.5, 2)), 0, 1e-12);
}

TEST(SdfReader, WhatItCannotReadIsToldAndTheRestIsLoaded) {
  ROCINANTE_NEEDS_SDF;
  const ReadSdf read(R"(<sdf version='1.7'>
<world name='w'><include><uri>/etc/passwd</uri></include>
<model name='a'><link name='l'/><link name='m'/>
<joint name='b' type='ball'><parent>l</parent><child>m</child></joint></model>
<model name='other'><link name='x'/></model></world></sdf>)");
  ASSERT_TRUE(read.model);
  EXPECT_EQ(read.faultText(),
            "arm.sdf:2: warning: <include> is passed over (name the included model in a cell of "
            "its own) [sdf.passed-over]\n"
            "arm.sdf: error: joint `b` is of type ball, which is not read; it is taken as fixed "
            "(types are fixed, revolute, continuous, prismatic) [sdf.unknown-joint-type]\n"
            "arm.sdf: warning: model `other` is passed over; the first one is read "
            "[sdf.passed-over]\n");
}

TEST(SdfReader, WhatIsNoSdfIsRefusedWithItsReason) {
  ROCINANTE_NEEDS_SDF;
  for (const char* text : {"", "no XML", "<sdf version='1.7'/>", "<robot name='r'/>",
                           "<sdf version='1.7'><model name='a'></sdf>"}) {
    SCOPED_TRACE(text);
    const ReadSdf read(text);
    EXPECT_FALSE(read.model);
    EXPECT_THAT(read.faultText(), HasSubstr("arm.sdf"));
  }
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  EXPECT_EQ(ReadSdf(deep).faultText(),
            "arm.sdf: error: the XML is nested deeper than 100 elements [sdf.invalid]\n");
  // libsdformat makes about a hundred of these per second.
  std::string many = "<sdf version='1.7'>";
  for (int i = 0; i < 10000; ++i) many += "<model name='m'><link name='l'/></model>";
  EXPECT_EQ(ReadSdf(many + "</sdf>").faultText(),
            "arm.sdf: error: the file is too large: libsdformat would take more than half a minute "
            "for its elements (one file per model reads much faster) [sdf.invalid]\n");
}

TEST(SdfReader, WhatUrdfdomSaysOfAUrdfIsAFaultAndNotALineOnStandardError) {
  ROCINANTE_NEEDS_SDF;
  testing::internal::CaptureStderr();
  const test::TemporaryFolder folder;
  test::writeFile(folder / "r.sdf", "<robot name='r'/>");
  const Result<Cell> cell = loadCell(folder / "r.sdf", {});
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  ASSERT_FALSE(cell.ok());
  EXPECT_NE(cell.error().what.find("No link elements found in urdf file"), std::string::npos)
      << cell.error().what;
}

TEST(SdfReader, TheKukaWithItsGripperIsTheArmOfItsUrdf) {
  ROCINANTE_NEEDS_SDF;
  ROCINANTE_NEEDS_SHARED_DATA("robots/kuka_iiwa/kuka_with_gripper.sdf");
  const auto cell = loadCell(test::sharedData("robots/kuka_iiwa/kuka_with_gripper.sdf"), {});
  ASSERT_TRUE(cell.ok()) << cell.error().text();
  for (const Finding& fault : cell->faults) {
    EXPECT_NE(fault.severity, Severity::error) << fault.print();
  }
  const Model& model = *cell->modelOf(cell->devices.at(0));
  EXPECT_EQ(model.links.size(), 15U);
  EXPECT_EQ(model.joints.size(), 14U);

  CellOptions options;
  options.geometry = false;
  const auto other = loadCell(test::sharedData("robots/kuka_iiwa/model.urdf"), options);
  ASSERT_TRUE(other.ok());
  const Model& arm = *other->modelOf(other->devices.at(0));
  // The flange is where the URDF has it, in every posture. The SDF names its joints J0 to J6.
  std::mt19937_64 random(14);
  std::uniform_real_distribution<double> values(-2, 2);
  for (int turn = 0; turn < 20; ++turn) {
    JointVector ours = zeroJoints(model), theirs = zeroJoints(arm);
    for (int i = 0; i < 7; ++i) {
      const double value = values(random);
      const auto joint = model.findJoint("J" + std::to_string(i));
      ASSERT_TRUE(joint);
      ours.values[ours.first_value[*joint]] = value;
      theirs.values[static_cast<std::size_t>(i)] = value;
    }
    const auto of_sdf = model.findLink("lbr_iiwa_link_7"),
               of_urdf = arm.findLink("lbr_iiwa_link_7");
    ASSERT_TRUE(of_sdf && of_urdf);
    const Vec3 a = transformPoint(linkPoses(model, ours)[*of_sdf], {0, 0, 0});
    const Vec3 b = transformPoint(linkPoses(arm, theirs)[*of_urdf], {0, 0, 0});
    // The SDF has rounded its poses to 1e-4.
    EXPECT_NEAR(glm::distance(a, b), 0, 1e-3);
  }
}

TEST(SdfReader, TheReactorIsFoundByItsModelUri) {
  ROCINANTE_NEEDS_SDF;
  ROCINANTE_NEEDS_SHARED_DATA("env/gazebo_originals/reactor");
  CellOptions options;
  options.search = {test::sharedData("env/gazebo_originals")};
  const auto cell = loadCell(test::sharedData("env/gazebo_originals/reactor/model.sdf"), options);
  ASSERT_TRUE(cell.ok()) << cell.error().text();
  EXPECT_EQ(test::printed(cell->faults), "");
  const Model& model = *cell->modelOf(cell->devices.at(0));
  ASSERT_EQ(model.links.at(0).visuals.size(), 1U);
  EXPECT_NEAR(model.links[0].visuals[0].mesh->bounds.max.z, 25.9, 0.01);
}

}  // namespace
}  // namespace rocinante
