#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/cell/cell.h"
#include "core/kinematics/urdf_reader.h"
#include "core/report/account.h"
#include "tests/core/kinematics/model_test_support.h"
#include "tests/core/kinematics/model_text.h"
#include "tests/core/kinematics/xml_mutations.h"
#include "tests/support/write_file.h"

namespace rocinante {
namespace {

using test::ReadUrdf;
using testing::HasSubstr;

// Every element and attribute that the reader uses, none with its default.
constexpr const char* kWholeUrdf = R"(<robot name="r">
  <material name="late"><color rgba="1 0 0 0.5"/></material>
  <material name="pictured"><color rgba="1 1 0 1"/><texture filename="none.png"/></material>
  <link name="base">
    <visual name="foot"><origin xyz="1 2 3" rpy="0.1 0.2 0.3"/><geometry><box size="1 2 3"/></geometry>
      <material name="late"/></visual>
    <visual><geometry><cylinder radius="0.5" length="2"/></geometry>
      <material name="own"><color rgba="0 1 0 1"/></material></visual>
    <collision name="hull"><origin xyz="0 0 1"/><geometry><sphere radius="3"/></geometry></collision>
    <inertial><mass value="1"/></inertial>
  </link>
  <link name="arm">
    <visual><geometry><capsule radius="0.5" length="1"/></geometry><material name="pictured"/></visual>
    <visual><geometry><mesh filename="none.stl" scale="2 2 2"/></geometry></visual>
  </link>
  <link name="hand"/>
  <joint name="j" type="revolute"><origin xyz="0 0 1" quat_xyzw="0 0 1 0"/><parent link="base"/>
    <child link="arm"/><axis xyz="0 1 0"/>
    <limit lower="-1" upper="2" effort="3" velocity="4"/><dynamics damping="1"/></joint>
  <joint name="k" type="prismatic"><origin rpy="0 0 1"/><parent link="arm"/><child link="hand"/>
    <limit lower="-1" upper="2" effort="3" velocity="4"/>
    <mimic joint="j" multiplier="2" offset="0.5"/></joint>
  <transmission name="t"/>
  <gazebo reference="base"><material>Gazebo/Red</material></gazebo>
</robot>)";

TEST(UrdfAccount, ChangesOrTheModelDoesWhateverIsTakenOutOrPutIn) {
  const ReadUrdf read(kWholeUrdf);
  ASSERT_TRUE(read.model);
  const std::string whole = test::outcomeText(read.model, read.faults);
  const auto mutations =
      test::mutationsOf(kWholeUrdf, {"inertial", "dynamics", "transmission", "gazebo"});
  EXPECT_GT(mutations.size(), 150U);
  for (const test::XmlMutation& mutation : mutations) {
    const ReadUrdf changed(mutation.text);
    EXPECT_NE(test::outcomeText(changed.model, changed.faults), whole) << mutation.what;
  }
}

TEST(UrdfAccount, NamesWhatIsKnownAndNotUsed) {
  const ReadUrdf read(kWholeUrdf);
  EXPECT_THAT(accountSentence(accountOf(read.faults), 10),
              testing::AllOf(HasSubstr("1 element `inertial` (masses are not used; at "),
                             HasSubstr("1 element `transmission` (actuators are not modelled"),
                             HasSubstr("1 element `gazebo` (what is for a simulator is not read"),
                             HasSubstr("1 element `dynamics` (motion is shown, not simulated")));
}

TEST(UrdfAccount, NamesAQuaternionThatIsNormalised) {
  const auto faultsOf = [](const std::string& turn) {
    return ReadUrdf(
               "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/>\n"
               "<joint name=\"j\" type=\"fixed\"><origin quat_xyzw=\"" +
               turn + "\"/><parent link=\"a\"/><child link=\"b\"/></joint></robot>")
        .faultText();
  };
  EXPECT_EQ(faultsOf("0 0 0 1.0009"), "");
  EXPECT_THAT(faultsOf("5 6 7 8"),
              HasSubstr("length `origin/@quat_xyzw` is left out: it is off 1 by more than 0.001, "
                        "and the quaternion is normalised"));
}

TEST(UrdfAccount, CountsExtensionsAndWarnsOfTypos) {
  const ReadUrdf read(R"(<robot name="r" xmlns:drake="http://drake.mit.edu">
<link name="a" drake:ignore="1"><drake:stiff/><drake:stiff/></link><link name="b"/>
<joint name="j" type="revolute"><parent link="a"/><child link="b"/>
<limit lowr="-1" upper="1" effort="1" velocity="1"/></joint></robot>)");
  EXPECT_EQ(
      read.faultText(),
      "robot.urdf:2:16: note: attribute `link/@drake:ignore` is left out: an attribute that "
      "is not read [model.left-out]\n"
      "robot.urdf:2:33: note: element `drake:stiff` is left out 2 times: an extension that is "
      "not read [model.left-out]\n"
      "robot.urdf:4:8: warning: attribute `limit/@lowr` is left out: <limit> has no such "
      "attribute (did you mean `lower`?) [urdf.unknown-element]\n");
}

TEST(UrdfAccount, NamesBoundsOfAJointThatHasNone) {
  const ReadUrdf read(R"(<robot name="r"><link name="a"/><link name="b"/>
<joint name="j" type="continuous"><parent link="a"/><child link="b"/>
<limit lower="-3" upper="0" velocity="1"/></joint></robot>)");
  EXPECT_EQ(read.faultText(),
            "robot.urdf:3:8: note: attribute `limit/@lower` is left out: a continuous joint has no "
            "bounds [model.left-out]\n");
}

TEST(UrdfAccount, OfAHostileFileIsBounded) {
  std::string text = "<robot name='r'><link name='a'/>";
  for (int i = 0; i < 20000; ++i) text += "<e" + std::to_string(i) + " a='1'/>";
  const ReadUrdf read(text + "</robot>");
  ASSERT_TRUE(read.model);
  ASSERT_EQ(read.faults.size(), 101U);
  EXPECT_EQ(read.faults.back().text, "19900 more of these");
}

TEST(UrdfReader, WarnsOfAModelOfWhichNothingIsDrawn) {
  const ReadUrdf read(R"(<robot name="r"><link name="a"><collision><geometry><box size="1 1 1"/>
</geometry></collision></link></robot>)");
  EXPECT_THAT(read.faultText(),
              HasSubstr("robot.urdf:1:1: warning: nothing of the model is drawn: 1 link has "
                        "collision geometry, and none has a <visual> (to see it: render "
                        "--collision '*'"));
  const ReadUrdf seen(R"(<robot name="r"><link name="a"><visual><geometry><box size="1 1 1"/>
</geometry></visual></link></robot>)");
  EXPECT_EQ(seen.faultText(), "");
  EXPECT_EQ(ReadUrdf("<robot name='r'><link name='a'/></robot>").faultText(), "");
}

TEST(UrdfReader, ReadsTheEncodingsThatEditorsWrite) {
  const std::string latin =
      "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?><robot name=\"r\"><link name=\"Tr\xE4ger\"/>"
      "</robot>";
  ASSERT_TRUE(ReadUrdf(latin).model);
  EXPECT_EQ(ReadUrdf(latin).model->links[0].name, "Tr\xC3\xA4ger");
  EXPECT_EQ(ReadUrdf("\xEF\xBB\xBF<robot name='r'><link name='a'/></robot>").faultText(), "");
  EXPECT_EQ(ReadUrdf("<!-- by a tool --><?xml version='1.0'?>\n<robot name='r'><link/></robot>")
                .faultText(),
            "robot.urdf:2:17: error: <link> lacks its attribute `name` [urdf.missing-attribute]\n"
            "robot.urdf:2:1: error: the model has no link [urdf.no-link]\n");
  // A character beyond 16 bits, and a half of one.
  const std::u16string wide = u"<robot name='r'><link name='\U0001F916\xD83E'/></robot>";
  for (const bool big : {false, true}) {
    for (const bool marked : {false, true}) {
      std::string bytes = !marked ? "" : big ? "\xFE\xFF" : "\xFF\xFE";
      for (const char16_t unit : wide) {
        const char high = static_cast<char>(unit >> 8), low = static_cast<char>(unit & 0xFF);
        bytes += big ? std::string{high, low} : std::string{low, high};
      }
      const ReadUrdf read(bytes);
      ASSERT_TRUE(read.model) << big << marked << read.faultText();
      EXPECT_EQ(read.model->links[0].name, "\xF0\x9F\xA4\x96\xEF\xBF\xBD");
    }
  }
  EXPECT_EQ(
      ReadUrdf("<?xml version='1.0' encoding='Shift_JIS'?><robot name='\x83\x8D'/>").faultText(),
      "robot.urdf: error: the file is in the encoding `shift_jis`, which is not read: save it "
      "as UTF-8 [urdf.xml]\n");
  EXPECT_THAT(ReadUrdf("<!DOCTYPE robot [<!ENTITY w '1'>]><robot name='r'><link name='a'><visual>"
                       "<geometry><sphere radius='&w;'/></geometry></visual></link></robot>")
                  .faultText(),
              HasSubstr("an entity of the file's own DOCTYPE is not expanded"));
}

TEST(UrdfReader, GivesItsMaterialToThePartsOfAMeshThatHaveNone) {
  test::TemporaryFolder folder;
  test::writeFile(folder / "two.mtl", "newmtl red\nKd 1 0 0\n");
  test::writeFile(folder / "two.obj",
                  "mtllib two.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nusemtl red\nf 1 2 3\n"
                  "usemtl none\nf 2 4 3\n");
  test::writeFile(folder / "r.urdf", R"(<robot name="r"><link name="l">
    <visual name="v"><geometry><mesh filename="two.obj"/></geometry><material name="blue"/></visual>
    <visual><geometry><sphere radius="1"/></geometry>
      <material name="blue"><color rgba="0 0 1 1"/></material></visual>
  </link></robot>)");
  const auto cell = loadCell(folder / "r.urdf", {});
  ASSERT_TRUE(cell.ok());
  const auto& visuals = cell->modelOf(cell->devices[0])->links[0].visuals;
  ASSERT_EQ(visuals.size(), 3U);
  EXPECT_FALSE(visuals[0].material);
  EXPECT_EQ(visuals[0].mesh_parts, (std::vector<std::size_t>{0}));
  EXPECT_EQ(visuals[1].name, "v");
  EXPECT_EQ(visuals[1].mesh_parts, (std::vector<std::size_t>{1}));
  EXPECT_EQ(visuals[1].material->diffuse, glm::vec4(0, 0, 1, 1));
  EXPECT_EQ(visuals[2].material->diffuse, glm::vec4(0, 0, 1, 1));
}

}  // namespace
}  // namespace rocinante
