// Small changes to a valid model, one at a time: the intended rule finds each, and no other does.
#include "core/check/drift/model_drift.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

using ::testing::ElementsAre;
using ::testing::ElementsAreArray;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::string_view kDriftArm = R"(<robot name="arm">
  <material name="red"> <color rgba="1 0 0 1"/> </material>
  <link name="base"> <visual> <geometry> <box size="1 1 1"/> </geometry> <material name="red"/> </visual>
    <collision> <geometry> <sphere radius="1"/> </geometry> </collision> </link>
  <link name="upper"> <visual> <origin xyz="0 0 0.2"/> <geometry> <mesh filename="part.obj" scale="1 1 1"/> </geometry> </visual> </link>
  <link name="hand"/> <link name="left"/> <link name="right"/>
  <joint name="shoulder" type="revolute"> <parent link="base"/> <child link="upper"/>
    <origin xyz="0 0 0.5" rpy="0 0 0"/> <axis xyz="0 0 1"/> <limit lower="-1" upper="1" effort="9" velocity="2"/> </joint>
  <joint name="elbow" type="revolute"> <parent link="upper"/> <child link="hand"/>
    <origin xyz="0 0 0.4" rpy="0 0 0"/> <axis xyz="0 1 0"/> <limit lower="-2" upper="2" effort="9" velocity="2"/> </joint>
  <joint name="finger" type="prismatic"> <parent link="hand"/> <child link="left"/>
    <axis xyz="1 0 0"/> <limit lower="0" upper="0.04" effort="9" velocity="2"/> </joint>
  <joint name="other" type="prismatic"> <parent link="hand"/> <child link="right"/>
    <axis xyz="-1 0 0"/> <limit lower="0" upper="0.04" effort="9" velocity="2"/> <mimic joint="finger" multiplier="1" offset="0"/> </joint>
</robot>
)";

constexpr std::string_view kPartMesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\n";

constexpr std::string_view kTwoDevices = R"(format = 1
[[device]]
name = "arm"
model = "arm.urdf"
pose = { xyz = [1, 0, 0] }
layer = "robots"
[[device]]
name = "spare"
model = "arm.urdf"
optional = true
[[camera]]
name = "front"
eye = [3, 0, 1]
target = [0, 0, 0]
)";

/// Files of a cell, by name.
using Files = std::map<std::string, std::string>;

Files soundFiles() {
  return {{"cell.toml", std::string(kTwoDevices)},
          {"arm.urdf", std::string(kDriftArm)},
          {"part.obj", std::string(kPartMesh)}};
}

/// A cell in its own folder, which lives as long as this object.
struct LoadedCell {
  explicit LoadedCell(const Files& files) {
    for (const auto& [name, text] : files) std::ofstream(folder / name) << text;
    Result<Cell> loaded = loadCell(folder / "cell.toml", {});
    EXPECT_TRUE(loaded.ok());
    if (loaded) cell = std::move(*loaded);
    for (const Finding& fault : cell.faults) ADD_FAILURE() << fault.print();
  }
  const test::TemporaryFolder folder;
  Cell cell;
};

Findings driftBetween(const Files& recorded, const Files& given) {
  const LoadedCell was(recorded), is(given);
  return modelDrift(was.cell, is.cell);
}

struct ModelChange {
  const char* what;
  const char* file;
  std::string from, to;
  std::vector<std::string> rules;
  const char* says;
};

TEST(ModelDrift, FindsEachSmallChangeAndNothingElse) {
  const std::string elbow_end = "effort=\"9\" velocity=\"2\"/> </joint>\n  <joint name=\"finger\"";
  const std::vector<ModelChange> mutations = {
      {"a joint renamed",
       "arm.urdf",
       "\"elbow\"",
       "\"bend\"",
       {"drift.joint-renamed"},
       "was renamed to bend"},
      {"a joint reversed",
       "arm.urdf",
       "axis xyz=\"0 1 0\"",
       "axis xyz=\"0 -1 0\"",
       {"drift.joint-axis"},
       "reversed"},
      {"an axis turned",
       "arm.urdf",
       "axis xyz=\"0 1 0\"",
       "axis xyz=\"0 1 1\"",
       {"drift.joint-axis"},
       "turned by 45°"},
      {"a joint moved",
       "arm.urdf",
       "xyz=\"0 0 0.4\"",
       "xyz=\"0 0 0.412\"",
       {"drift.joint-origin"},
       "moved by 12 mm"},
      {"a joint turned",
       "arm.urdf",
       "xyz=\"0 0 0.4\" rpy=\"0 0 0\"",
       "xyz=\"0 0 0.4\" rpy=\"0 0 1.5707963267948966\"",
       {"drift.joint-origin"},
       "turned by 90°"},
      {"a joint in degrees",
       "arm.urdf",
       "rpy=\"0 0 0\"/> <axis xyz=\"0 1 0\"",
       "rpy=\"0 0 3\"/> <axis xyz=\"0 1 0\"",
       {"drift.joint-origin"},
       "turned by 171.9°"},
      {"a joint of another type",
       "arm.urdf",
       "\"finger\" type=\"prismatic\"",
       "\"finger\" type=\"revolute\"",
       {"drift.joint-type"},
       "metres would be taken for radians"},
      {"a joint fixed",
       "arm.urdf",
       "\"elbow\" type=\"revolute\"",
       "\"elbow\" type=\"fixed\"",
       {"drift.joint-type"},
       "its value would move nothing"},
      {"a joint on another link",
       "arm.urdf",
       "<parent link=\"upper\"/> <child link=\"hand\"/>",
       "<parent link=\"base\"/> <child link=\"hand\"/>",
       {"drift.joint-parent"},
       "had parent link upper and has base"},
      {"a limit wider",
       "arm.urdf",
       "lower=\"-2\"",
       "lower=\"-2.5\"",
       {"drift.joint-limits"},
       "[-114.592°, 114.592°] at 114.592°/s to [-143.239°, 114.592°]"},
      {"a slower joint",
       "arm.urdf",
       "upper=\"1\" effort=\"9\" velocity=\"2\"",
       "upper=\"1\" effort=\"9\" velocity=\"1\"",
       {"drift.joint-limits"},
       "at 57.2958°/s"},
      {"another effort",
       "arm.urdf",
       "upper=\"1\" effort=\"9\"",
       "upper=\"1\" effort=\"8\"",
       {"drift.joint-limits"},
       "effort"},
      {"a mimic reversed",
       "arm.urdf",
       "multiplier=\"1\"",
       "multiplier=\"-1\"",
       {"drift.joint-mimic"},
       "is -1 times finger"},
      {"a mimic with an offset",
       "arm.urdf",
       "offset=\"0\"",
       "offset=\"0.01\"",
       {"drift.joint-mimic"},
       "plus 0.01"},
      {"a mimic of another",
       "arm.urdf",
       "mimic joint=\"finger\"",
       "mimic joint=\"elbow\"",
       {"drift.joint-mimic"},
       "times elbow"},
      {"a mimic gone",
       "arm.urdf",
       " <mimic joint=\"finger\" multiplier=\"1\" offset=\"0\"/>",
       "",
       {"drift.joint-mimic"},
       "no longer mimics"},
      {"a leaf link renamed",
       "arm.urdf",
       "\"left\"",
       "\"thumb\"",
       {"drift.link-renamed"},
       "was renamed to thumb"},
      {"the root renamed",
       "arm.urdf",
       "\"base\"",
       "\"foot\"",
       {"drift.link-renamed"},
       "was renamed to foot"},
      {"a link added",
       "arm.urdf",
       "</robot>",
       "<link name=\"x\"/> <joint name=\"j\" type=\"fixed\"> <parent link=\"hand\"/> <child "
       "link=\"x\"/> </joint> </robot>",
       {"drift.joint-added", "drift.link-added"},
       "joint j of arm is new"},
      {"a driven link added",
       "arm.urdf",
       "</robot>",
       "<link name=\"x\"/> <joint name=\"j\" type=\"continuous\"> <parent link=\"hand\"/> <child "
       "link=\"x\"/> </joint> </robot>",
       {"drift.joint-added", "drift.link-added"},
       "the log never drives it"},
      {"a box larger",
       "arm.urdf",
       "box size=\"1 1 1\"",
       "box size=\"1 1 1.5\"",
       {"drift.geometry"},
       "was 1000 x 1000 x 1000 mm, now 1000 x 1000 x 1500 mm"},
      {"a box larger all round",
       "arm.urdf",
       "box size=\"1 1 1\"",
       "box size=\"2 2 2\"",
       {"drift.geometry"},
       "different shape: 2 times as large"},
      {"a mesh in inches",
       "arm.urdf",
       "scale=\"1 1 1\"",
       "scale=\"0.0254 0.0254 0.0254\"",
       {"drift.geometry"},
       "to 0.0254"},
      {"a mesh mirrored",
       "arm.urdf",
       "scale=\"1 1 1\"",
       "scale=\"1 -1 1\"",
       {"drift.geometry"},
       "to 1 -1 1"},
      {"a shape moved",
       "arm.urdf",
       "<origin xyz=\"0 0 0.2\"/>",
       "<origin xyz=\"0 0 0.3\"/>",
       {"drift.geometry"},
       "moved by 100 mm"},
      {"a shape gone",
       "arm.urdf",
       " <visual> <origin xyz=\"0 0 0.2\"/> <geometry> <mesh filename=\"part.obj\" scale=\"1 1 "
       "1\"/> </geometry> </visual>",
       "",
       {"drift.geometry"},
       "had 1 shapes, now has 0"},
      {"a vertex moved",
       "part.obj",
       "v 0 1 0",
       "v 0 1.001 0",
       {"drift.geometry"},
       "was 1000 x 1000 x 1000 mm, now 1000 x 1001 x 1000 mm"},
      {"a vertex moved inside",
       "part.obj",
       "v 0 1 0",
       "v 0.5 1 0",
       {"drift.geometry"},
       "points have moved within the same size"},
      {"a face gone", "part.obj", "f 1 2 4\n", "", {"drift.geometry"}, "had 2 triangles, now 1"},
      {"a mesh in millimetres",
       "part.obj",
       "v 1 0 0\nv 0 1 0\nv 0 0 1",
       "v 1000 0 0\nv 0 1000 0\nv 0 0 1000",
       {"drift.geometry"},
       "1000 times as large"},
      {"a collision grown",
       "arm.urdf",
       "radius=\"1\"",
       "radius=\"2\"",
       {"drift.collision"},
       "collision shape"},
      {"a colour changed",
       "arm.urdf",
       "rgba=\"1 0 0 1\"",
       "rgba=\"0 0 1 1\"",
       {"drift.material"},
       "#ff0000ff to #0000ffff"},
      {"a device moved",
       "cell.toml",
       "xyz = [1, 0, 0]",
       "xyz = [1, 2, 0]",
       {"drift.device-moved"},
       "moved by 2 m"},
      {"a device renamed",
       "cell.toml",
       "name = \"spare\"",
       "name = \"reserve\"",
       {"drift.device-removed", "drift.device-added"},
       "device spare is gone"},
      {"a device on another layer",
       "cell.toml",
       "\"robots\"",
       "\"arms\"",
       {"drift.layer"},
       "instead of `robots`"},
      {"a device coloured",
       "cell.toml",
       "layer = \"robots\"",
       "layer = \"robots\"\ncolor = \"#00ff00\"",
       {"drift.material"},
       "colours device arm"},
      {"a device that no longer waits",
       "cell.toml",
       "optional = true",
       "optional = false",
       {"drift.device-optional"},
       "no longer waits"},
      {"a device carried",
       "cell.toml",
       "optional = true",
       "optional = true\non = \"arm/hand\"",
       {"drift.device-moved"},
       "is mounted on arm/hand instead of the ground"},
      {"a camera moved",
       "cell.toml",
       "eye = [3, 0, 1]",
       "eye = [4, 0, 1]",
       {"drift.camera"},
       "camera front"},
      {"a camera renamed",
       "cell.toml",
       "name = \"front\"",
       "name = \"back\"",
       {"drift.camera", "drift.camera"},
       "is gone"},
      {"a point coloured",
       "part.obj",
       "v 0 0 0\n",
       "v 0 0 0 1 0 0\n",
       {"drift.material"},
       "the colours at the points of link"},
      // Changes without effect.
      {"a comment", "arm.urdf", "</robot>", "<!-- checked --> </robot>", {}, ""},
      {"a number written otherwise", "arm.urdf", "xyz=\"0 0 0.4\"", "xyz=\"0 -0 4.0e-1\"", {}, ""},
      {"an axis of another length", "arm.urdf", "axis xyz=\"0 1 0\"", "axis xyz=\"0 2 0\"", {}, ""},
      {"rounding", "arm.urdf", "xyz=\"0 0 0.4\"", "xyz=\"0 0 0.40000000001\"", {}, ""},
      {"a mesh saved anew", "part.obj", "v 0 0 0\n", "# exported\nv 0.000 0.000 0.000\n", {}, ""},
      {"a mesh numbered anew",
       "part.obj",
       "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\n",
       "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 2 3 4\nf 2 3 5\n",
       {},
       ""},
  };
  for (const ModelChange& mutation : mutations) {
    SCOPED_TRACE(mutation.what);
    Files changed = soundFiles();
    std::string& text = changed.at(mutation.file);
    std::size_t times = 0;
    for (std::size_t at = 0; (at = text.find(mutation.from, at)) != text.npos; ++times) {
      text.replace(at, mutation.from.size(), mutation.to);
      at += mutation.to.size();
    }
    ASSERT_GT(times, 0U) << "the mutation changes nothing";
    const Findings found = driftBetween(soundFiles(), changed);
    std::vector<std::string> rules;
    std::string said;
    for (const Finding& finding : found) {
      rules.push_back(finding.rule);
      said += finding.text + "\n";
    }
    EXPECT_THAT(rules, ElementsAreArray(mutation.rules)) << said;
    EXPECT_THAT(said, HasSubstr(mutation.says));
  }
}

TEST(ModelDrift, SeesWhatOpacityMeansAndHowATextureLies) {
  Files painted = soundFiles();
  const std::string plain =
      "[[material]]\ndevice = \"arm\"\nlink = \"base\"\ntexture = \"a.png\"\n";
  painted.at("cell.toml") += plain;
  painted["a.png"] = "no picture, but a file";
  for (const auto& [more, rule, says] :
       {std::tuple{"alpha = \"opaque\"\n", "drift.material", "was blended, and is opaque"},
        {"alpha = \"mask\"\nalpha_cutoff = 0.25\n", "drift.material", "is cut out below 0.25"},
        {"texture_wrap = \"clamp\"\n", "drift.texture", "is mapped differently"},
        {"texture_rotation_deg = 90\n", "drift.texture", "is mapped differently"}}) {
    Files changed = painted;
    changed.at("cell.toml") += more;
    const Findings found = driftBetween(painted, changed);
    ASSERT_EQ(found.size(), 1U) << more;
    EXPECT_EQ(found[0].rule, rule);
    EXPECT_THAT(found[0].text, HasSubstr(says));
  }
}

TEST(ModelDrift, SeesColoursAtPointsThatHaveChangedOrGone) {
  const auto colored = [](const std::string& with) {
    Files files = soundFiles();
    std::string& text = files.at("part.obj");
    text.replace(text.find("v 1 0 0\n"), 8, "v 1 0 0" + with + "\n");
    return files;
  };
  const auto said = [](const Files& was, const Files& is) {
    std::string all;
    for (const Finding& finding : driftBetween(was, is)) {
      EXPECT_EQ(finding.rule, "drift.material");
      all += finding.text + "\n";
    }
    return all;
  };
  EXPECT_EQ(said(colored(" 1 0 0"), colored(" 1.000 0 0")), "");
  EXPECT_THAT(said(colored(" 1 0 0"), colored(" 0 1 0")), HasSubstr("have changed"));
  EXPECT_THAT(said(colored(" 1 0 0"), colored("")), HasSubstr("are gone"));
}

TEST(ModelDrift, SaysWhichValuesWouldDriveEachOthersJoint) {
  Files swapped = soundFiles();
  std::string& text = swapped.at("arm.urdf");
  const std::size_t shoulder = text.find("  <joint name=\"shoulder\"");
  const std::size_t elbow = text.find("  <joint name=\"elbow\""),
                    finger = text.find("  <joint name=\"finger\"");
  text = text.substr(0, shoulder) + text.substr(elbow, finger - elbow) +
         text.substr(shoulder, elbow - shoulder) + text.substr(finger);
  const Findings found = driftBetween(soundFiles(), swapped);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].rule, "drift.joint-order");
  EXPECT_THAT(found[0].text,
              HasSubstr("values 1 and 2 of `joints` would drive each other's joint"));
}

TEST(ModelDrift, HintsAtTheCountThatMakesADeviceStandStill) {
  Files longer = soundFiles();
  std::string& text = longer.at("arm.urdf");
  text.insert(text.find("</robot>"),
              "<link name=\"x\"/> <joint name=\"j\" type=\"continuous\"> <parent link=\"hand\"/> "
              "<child link=\"x\"/> </joint>");
  EXPECT_THAT(driftBetween(soundFiles(), longer)[0].hint,
              HasSubstr("have 3 values and the model takes 4: arm would not move"));
  const Findings back = driftBetween(longer, soundFiles());
  ASSERT_EQ(back.size(), 2U);
  EXPECT_EQ(back[0].rule, "drift.joint-removed");
  EXPECT_THAT(back[0].hint, HasSubstr("have 4 values and the model takes 3"));
  EXPECT_EQ(back[1].rule, "drift.link-removed");
}

TEST(ModelDrift, ARealRobotHasNotDriftedFromItself) {
  ROCINANTE_NEEDS_SHARED_DATA("robots/franka_panda/panda.urdf");
  CellOptions options;
  options.search = {test::sharedData("robots")};
  const Result<Cell> a = loadCell(test::sharedData("robots/franka_panda/panda.urdf"), options);
  const Result<Cell> b = loadCell(test::sharedData("robots/franka_panda/panda.urdf"), options);
  ASSERT_TRUE(a.ok() && b.ok());
  EXPECT_THAT(modelDrift(*a, *b), IsEmpty());
  const Result<Cell> kuka = loadCell(test::sharedData("robots/kuka_iiwa/model.urdf"), options);
  ASSERT_TRUE(kuka.ok());
  EXPECT_GT(modelDrift(*a, *kuka).size(), 1U);
}

TEST(ModelDrift, NamesTheGroupsOfAMeshThatChanged) {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  const std::string screw1 = "g screw1\nf 1 2 3\n", screw2 = "g screw2\nf 1 2 4\n";
  Files was = soundFiles(), is = soundFiles();
  was["part.obj"] = points + screw1 + screw2;
  is["part.obj"] = points + screw1;
  const auto only = [&] {
    const Findings found = driftBetween(was, is);
    return found.size() == 1 ? found[0].text : std::to_string(found.size()) + " findings";
  };
  EXPECT_THAT(only(), HasSubstr("link upper of arm has a different shape: group screw2 is gone, "
                                "had 2 triangles, now 1"));
  is["part.obj"] = points + screw1 + "g screw2\nf 1 3 4\n";
  EXPECT_THAT(only(), HasSubstr("shape: group screw2 has a different shape"));
  is["part.obj"] = points + screw1 + screw2 + "g nut\nf 2 3 4\n";
  EXPECT_THAT(only(), HasSubstr("shape: group nut is new"));
}

}  // namespace
}  // namespace rocinante
