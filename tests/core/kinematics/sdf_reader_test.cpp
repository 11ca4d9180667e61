#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/cell/cell.h"
#include "core/kinematics/kinematics.h"
#include "core/math/transform.h"
#include "tests/core/kinematics/model_text.h"
#include "tests/core/kinematics/sdf_test_support.h"
#include "tests/core/kinematics/xml_mutations.h"
#include "tests/support/shared_data.h"

namespace rocinante {
namespace {

using test::kTwoParts;
using test::ReadSdf;
using ::testing::HasSubstr;

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
  EXPECT_EQ(
      read.faultText(),
      "arm.sdf:2: warning: element `include` is left out: a model in another file is not read "
      "(name the included model in a cell of its own) [sdf.passed-over]\n"
      "arm.sdf:5:1: warning: model `other` is left out: of several models in a file the first "
      "is read [sdf.passed-over]\n"
      "arm.sdf: error: joint `b` is of type ball, which is not read; it is taken as fixed "
      "(types are fixed, revolute, continuous, prismatic) [sdf.unknown-joint-type]\n");
}

TEST(SdfReader, ALinkThatDoesNotExistIsNamed) {
  ROCINANTE_NEEDS_SDF;
  const ReadSdf read(R"(<sdf version='1.7'><model name='a'><link name='base'/><link name='hand'/>
<joint name='turn' type='fixed'><parent>bsae</parent><child>hand</child></joint></model></sdf>)");
  EXPECT_THAT(read.faultText(),
              HasSubstr("the parent of joint `turn` is `bsae`, which is not a link"));
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

TEST(SdfReader, ReadsAUrdfInAnSdfAsUrdf) {
  testing::internal::CaptureStderr();
  const ReadSdf read("<robot name='r'><link name='a'/></robot>");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_TRUE(read.model);
  EXPECT_EQ(read.faultText(),
            "arm.sdf:1:1: warning: this is URDF, and is read as that (name the file .urdf) "
            "[sdf.invalid]\n");
}

TEST(SdfReader, NamesTheValueAndItsPlaceAndNothingOfUrdf) {
  ROCINANTE_NEEDS_SDF;
  const struct {
    const char *text, *fault;
  } cases[] = {
      {"<sdf version='1.7'><model name='m'>\n<link name='l'><pose>0 0 O.5 0 0 0</pose></link>"
       "</model></sdf>",
       "arm.sdf:2:16: error: <pose> is `0 0 O.5 0 0 0`, where 6 numbers are expected "
       "[sdf.invalid]\n"},
      {"<sdf version='1.7'><model name='m'><link name='l'><visual name='v'><geometry><sphere>"
       "<radius>1</radius></sphere></geometry><material><diffuse>red</diffuse></material></visual>"
       "</link></model></sdf>",
       "arm.sdf:1:134: error: <diffuse> is `red`, where 3 or 4 numbers from 0 to 1 are expected "
       "[sdf.invalid]\n"},
      {"<sdf version='1.7'><model name='m'><link name='l'>\n<pose>0 0 0\n</link></model></sdf>",
       "arm.sdf:2: error: the XML breaks off here: an end tag does not match its start tag "
       "[sdf.invalid]\n"},
      {"<sdf><model name='m'><link name='l'/></model></sdf>",
       "arm.sdf:1:1: error: <sdf> lacks its attribute `version` (write the version of the format, "
       "such as version=\"1.7\") [sdf.invalid]\n"},
      {"<fds version='1.7'/>",
       "arm.sdf:1:1: error: the outermost element is <fds>, where SDF has <sdf> "
       "[sdf.invalid]\n"},
  };
  for (const auto& each : cases) {
    SCOPED_TRACE(each.text);
    const ReadSdf read(each.text);
    EXPECT_FALSE(read.model);
    EXPECT_EQ(read.faultText(), each.fault);
  }
  const ReadSdf future("<sdf version='1.99'><model name='m'><link name='l'/></model></sdf>");
  EXPECT_TRUE(future.model);
  EXPECT_THAT(future.faultText(),
              HasSubstr("the file is in version `1.99` of SDF, newer than 1.9"));
}

// Every element and attribute that the reader uses, none with its default.
constexpr const char* kWholeSdf = R"(<sdf version="1.9"><model name="m">
  <frame name="f" attached_to="base"><pose>0 0 1 0 0 0</pose></frame>
  <link name="base"><pose degrees="true">1 2 3 0 0 90</pose><inertial><mass>2</mass></inertial>
    <visual name="v"><pose>0 0 0.5 0 0 0</pose><transparency>0.5</transparency>
      <geometry><box><size>1 2 3</size></box></geometry>
      <material><diffuse>1 0.5 0 1</diffuse><ambient>1 0 0 1</ambient><emissive>0 0 1 1</emissive>
        <specular>1 1 1 1</specular></material></visual>
    <visual name="red"><geometry><cylinder><radius>0.6</radius><length>2</length></cylinder>
      </geometry><material><script><uri>x</uri><name>Gazebo/Red</name></script></material></visual>
    <visual name="blue"><geometry><capsule><radius>0.7</radius><length>2</length></capsule>
      </geometry><material><ambient>0 0 1 1</ambient></material></visual>
    <collision name="c"><pose>0 0 1 0 0 0</pose>
      <geometry><sphere><radius>3</radius></sphere></geometry></collision></link>
  <link name="arm"><pose relative_to="f">0 0 1 0 0 0</pose>
    <visual name="mesh"><geometry><mesh><uri>two.obj</uri><scale>2 2 2</scale>
      <submesh><name>right</name><center>true</center></submesh></mesh></geometry></visual></link>
  <model name="hand"><pose>0 0 4 0 0 0</pose><link name="palm"><visual name="v">
    <geometry><box><size>1 1 2</size></box></geometry></visual></link></model>
  <joint name="j" type="revolute"><pose>0.1 0 0 0 0 0</pose><parent>base</parent><child>arm</child>
    <axis><xyz expressed_in="__model__">1 0 0</xyz><limit><lower>-1</lower><upper>2</upper>
      <effort>3</effort><velocity>4</velocity></limit><dynamics><damping>1</damping></dynamics></axis>
  </joint>
  <joint name="k" type="prismatic"><parent>arm</parent><child>hand::palm</child>
    <axis><xyz>0 1 0</xyz></axis></joint>
  <plugin name="p" filename="p.so"/>
</model></sdf>)";

TEST(SdfReader, DrawsColoursScriptsTransparencyAndSubmeshes) {
  ROCINANTE_NEEDS_SDF;
  const ReadSdf read(kWholeSdf, kTwoParts);
  ASSERT_TRUE(read.model);
  const auto& base = read.model->links.at(0).visuals;
  ASSERT_EQ(base.size(), 3U);
  EXPECT_EQ(base[0].material->diffuse, glm::vec4(1, 0.5, 0, 0.5));
  EXPECT_EQ(base[0].material->emission, glm::vec3(0, 0, 1));
  EXPECT_EQ(base[1].material->diffuse, glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(base[2].material->diffuse, glm::vec4(0, 0, 1, 1)) << "its ambient, not black";
  const Visual& mesh = read.model->links.at(1).visuals.at(0);
  EXPECT_EQ(mesh.mesh_parts, (std::vector<std::size_t>{1}));
  // The middle of the right part, (11, 2, 0), twice as large, lies at the visual's place.
  const JointVector joints = zeroJoints(*read.model);
  const Vec3 middle = transformPoint(linkPoses(*read.model, joints)[1] * matrixOf(mesh.origin),
                                     Vec3(11, 2, 0) * mesh.scale);
  EXPECT_NEAR(glm::distance(middle, Vec3(1, 2, 5)), 0, 1e-12);
}

TEST(SdfReader, ItsAccountChangesOrTheModelDoesWhateverIsTakenOutOrPutIn) {
  ROCINANTE_NEEDS_SDF;
  const ReadSdf read(kWholeSdf, kTwoParts);
  ASSERT_TRUE(read.model);
  EXPECT_EQ(countOf(read.faults, Severity::error), 0U) << read.faultText();
  const std::string whole = test::outcomeText(read.model, read.faults);
  // Scripts: the name of one stands for it. libsdformat takes 50 ms for each, so not all.
  int number = 0;
  for (const test::XmlMutation& mutation :
       test::mutationsOf(kWholeSdf, {"inertial", "dynamics", "plugin", "specular", "script"})) {
    if (++number % 4 != 0) continue;
    const ReadSdf changed(mutation.text, kTwoParts);
    EXPECT_NE(test::outcomeText(changed.model, changed.faults), whole) << mutation.what;
  }
}

TEST(SdfReader, LinksThatNothingJoinsLieWhereTheFileHasThem) {
  ROCINANTE_NEEDS_SDF;
  const ReadSdf read(R"(<sdf version="1.7"><model name="m"><link name="a"/>
<link name="b"><pose>0 0 2 0 0 0</pose><visual name="v"><geometry><box><size>1 1 1</size></box>
</geometry></visual></link></model></sdf>)");
  EXPECT_EQ(read.faultText(), "");
  ASSERT_TRUE(read.model);
  EXPECT_EQ(read.model->links.at(1).visuals.at(0).origin.position, Vec3(0, 0, 2));
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
  EXPECT_EQ(accountSentence(accountOf(cell->faults)).substr(0, 27), "left out: 1 element `static");
  EXPECT_EQ(countOf(cell->faults, Severity::note), cell->faults.size())
      << test::printed(cell->faults);
  const Model& model = *cell->modelOf(cell->devices.at(0));
  ASSERT_EQ(model.links.at(0).visuals.size(), 1U);
  EXPECT_NEAR(model.links[0].visuals[0].mesh->bounds.max.z, 25.9, 0.01);
}

}  // namespace
}  // namespace rocinante
