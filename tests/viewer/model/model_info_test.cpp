#include "viewer/model/model_info.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/core/cell/cell_fixture.h"
#include "tests/support/shared_data.h"

namespace rocinante {
namespace {

using Json = nlohmann::json;

class ModelInfoTest : public test::CellFolder {
 protected:
  Json jsonOf(const Cell& cell, const std::string& device = {}) {
    const auto info = modelInfo(cell, device);
    EXPECT_TRUE(info.ok()) << info.error().text();
    return info.ok() ? Json::parse(modelInfoJson(*info)) : Json();
  }
};

constexpr std::string_view kGantry = R"(
format = 1
[[device]]
name = "g"
model = "gantry"
[[device]]
name = "late"
model = "gantry"
optional = true
pose = { xyz = [10, 0, 0] }
[[model]]
name = "gantry"
obj = "gantry.obj"
unit = "m"
up = "z"
[[model.link]]
name = "bridge"
parent = "base"
groups = ["bridge*"]
joint = { name = "x", type = "prismatic", axis = [1, 0, 0], limits = [0, 6], velocity = 2 }
[[model.link]]
name = "wheel"
parent = "bridge"
joint = { name = "spin", type = "continuous", axis = [0, 1, 0], mimic = { joint = "x", multiplier = 3 } }
[[model.link]]
name = "car"
parent = "base"
joint = { name = "drive", type = "planar" }
)";

TEST_F(ModelInfoTest, TellsTreeJointsAndGeometryOfOneDevice) {
  const auto cell = load(kGantry);
  ASSERT_TRUE(cell.ok());
  const Json info = jsonOf(*cell, "g");
  EXPECT_EQ(info["format"], 1);
  EXPECT_EQ(info["name"], "gantry");
  EXPECT_EQ(info["links"], Json({"base", "bridge", "wheel", "car"}));
  ASSERT_EQ(info["joints"].size(), 3U);
  EXPECT_EQ(info["joints"][0]["name"], "x");
  EXPECT_EQ(info["joints"][0]["type"], "prismatic");
  EXPECT_EQ(info["joints"][0]["parent"], "base");
  EXPECT_EQ(info["joints"][0]["child"], "bridge");
  EXPECT_EQ(info["joints"][0]["upper"], 6.0);
  EXPECT_EQ(info["joints"][0]["velocity"], 2.0);
  EXPECT_TRUE(info["joints"][0]["mimic"].is_null());
  EXPECT_EQ(info["joints"][1]["mimic"]["joint"], "x");
  EXPECT_TRUE(info["joints"][1]["lower"].is_null()) << "a continuous joint has no bounds";
  EXPECT_TRUE(info["joints"][1]["position"].is_null()) << "a mimic joint takes no value";
  EXPECT_EQ(info["joints"][2]["position"], 1);
  EXPECT_EQ(info["movable"], 2);
  EXPECT_EQ(info["values"], 4);
  EXPECT_EQ(info["triangles"], 5);
  EXPECT_EQ(info["meshes_missing"], 0);
  EXPECT_EQ(info["bounds_m"]["min"], Json({0.0, 0.0, 2.0}));
  EXPECT_EQ(info["bounds_m"]["max"], Json({1.0, 1.0, 2.0}));
}

TEST_F(ModelInfoTest, NamesOfSeveralDevicesHaveTheirDeviceBeforeThem) {
  const auto cell = load(kGantry);
  ASSERT_TRUE(cell.ok());
  const Json info = jsonOf(*cell);
  EXPECT_EQ(info["name"], "test");
  EXPECT_EQ(info["links"][0], "g/base");
  EXPECT_EQ(info["joints"][4]["mimic"]["joint"], "late/x");
  EXPECT_EQ(info["triangles"], 5) << "what waits for `add` is not drawn";
  EXPECT_EQ(info["devices"].size(), 2U);
  EXPECT_EQ(jsonOf(*cell, "late")["bounds_m"]["min"], Json({10.0, 0.0, 2.0}))
      << "one that is asked for is there";
}

TEST_F(ModelInfoTest, CountsMeshesThatAreMissingAndTellsOfThem) {
  test::writeFile(folder_ / "broken.urdf", R"(<robot name="b"><link name="a"><visual><geometry>
<mesh filename="none.stl"/></geometry></visual></link></robot>)");
  const auto urdf = loadCell(folder_ / "broken.urdf", {});
  ASSERT_TRUE(urdf.ok());
  const Json info = jsonOf(*urdf);
  EXPECT_EQ(info["meshes_missing"], 1);
  EXPECT_TRUE(info["bounds_m"].is_null());
  ASSERT_EQ(info["faults"].size(), 1U);
  EXPECT_EQ(info["faults"][0]["rule"], "model.missing-file");
  EXPECT_EQ(info["faults"][0]["severity"], "error");
  EXPECT_EQ(info["faults"][0]["line"], 2);

  const auto cell = load(
      "format=1\n[[device]]\nname='d'\nmodel='m'\n[[model]]\nname='m'\nobj='none.obj'\nunit='m'\n"
      "up='z'\n");
  ASSERT_TRUE(cell.ok());
  EXPECT_EQ(jsonOf(*cell)["meshes_missing"], 1);
  CellOptions strict;
  strict.strict = true;
  EXPECT_FALSE(loadCell(folder_ / "broken.urdf", strict).ok());
}

TEST_F(ModelInfoTest, BoundsAreThoseOfTheTurnedDeviceNotOfItsTurnedBox) {
  const auto cell = load(
      "format=1\n[[device]]\nname='t'\nmodel='t'\npose={rpy_deg=[0,0,45]}\n[[model]]\nname='t'\n"
      "obj='tank.obj'\nunit='mm'\nup='z'\n");
  ASSERT_TRUE(cell.ok());
  const Json bounds = jsonOf(*cell)["bounds_m"];
  EXPECT_NEAR(bounds["max"][1].get<double>(), std::sqrt(0.5), 1e-12) << "not the square root of 2";
}

TEST_F(ModelInfoTest, SaysTheSameEveryTime) {
  const auto first = load(kGantry), second = load(kGantry);
  ASSERT_TRUE(first.ok() && second.ok());
  EXPECT_EQ(modelInfoJson(*modelInfo(*first, "")), modelInfoJson(*modelInfo(*second, "")));
  EXPECT_EQ(modelInfoText(*modelInfo(*first, "")), modelInfoText(*modelInfo(*second, "")));
}

TEST_F(ModelInfoTest, TheRealRobotsAreAsTheirMakersSay) {
  ROCINANTE_NEEDS_SHARED_DATA("robots");
  struct Robot {
    const char* file;
    std::size_t links, movable, triangles, textures;
  };
  for (const Robot& robot :
       {Robot{"robots/puma560_description/urdf/puma560_robot.urdf", 7, 6, 8116, 0},
        Robot{"robots/kuka_iiwa/model.urdf", 8, 7, 14758, 0},
        Robot{"robots/franka_panda/panda.urdf", 13, 8, 102759, 1}}) {
    const auto path = test::sharedData() / robot.file;
    SCOPED_TRACE(robot.file);
    const auto cell = loadCell(path, {});
    ASSERT_TRUE(cell.ok());
    const Json info = jsonOf(*cell);
    EXPECT_EQ(info["links"].size(), robot.links);
    EXPECT_EQ(info["movable"], robot.movable);
    EXPECT_EQ(info["triangles"], robot.triangles);
    EXPECT_EQ(info["textures"], robot.textures);
    EXPECT_EQ(info["meshes_missing"], 0);
  }
}

TEST(ModelTree, AVeryDeepTreeStaysNarrow) {
  Model model;
  for (std::size_t i = 0; i < 20000; ++i) {
    Link link;
    link.name = "l" + std::to_string(i);
    if (i > 0) {
      link.parent_joint = i - 1;
      Joint joint;
      joint.name = "j";
      joint.parent = i - 1;
      joint.child = i;
      model.joints.push_back(joint);
    }
    model.links.push_back(std::move(link));
  }
  const std::string tree = treeText(model, true);
  EXPECT_LT(tree.size(), 20000U * 300U);
  EXPECT_NE(tree.find("(19999 deep) l19999"), std::string::npos);
}

TEST(ModelTree, NamesCannotMoveTheCursor) {
  Model model;
  model.links.emplace_back().name = "a\x1b[2Jb";
  EXPECT_EQ(treeText(model, false), "  a\\x1b[2Jb\n");
}

}  // namespace
}  // namespace rocinante
