#include "core/cell/cell.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "core/kinematics/kinematics.h"
#include "core/math/transform.h"
#include "core/math/trigonometry.h"
#include "tests/core/cell/cell_fixture.h"

namespace rocinante {
namespace {

class CellTest : public test::CellFolder {};

TEST_F(CellTest, EveryExampleOfTheDocumentLoadsWithoutAFault) {
  std::ifstream file(std::filesystem::path(ROCINANTE_SOURCE_DIR) / "docs/cell-format.md");
  std::stringstream text;
  text << file.rdbuf();
  const std::string page = text.str();
  int examples = 0;
  const std::string fence = "```toml\n";
  for (std::size_t at = page.find(fence); at != std::string::npos; at = page.find(fence, at)) {
    at += fence.size();
    const std::string example = page.substr(at, page.find("```", at) - at);
    SCOPED_TRACE(example);
    const auto cell = load(example);
    ASSERT_TRUE(cell.ok()) << cell.error().text();
    EXPECT_EQ(test::printed(cell->faults), "");
    for (const CellDevice& device : cell->devices) EXPECT_NE(cell->modelOf(device), nullptr);
    ++examples;
  }
  EXPECT_GE(examples, 3);
}

TEST_F(CellTest, ReadsDevicesWithTheirPosesColoursAndLayers) {
  const auto cell = load(R"(
format = 1
[[device]]
name = "a"
model = "arm.urdf"
pose = { xyz = [1, 2.5, 3], rpy_deg = [0, 0, 90] }
layer = "robots"
color = "#ff800040"
[[device]]
name = "b"
model = "arm.urdf"
optional = true
pose = { quaternion = [0, 0, 2, 0] }
)");
  ASSERT_TRUE(cell.ok());
  EXPECT_EQ(test::printed(cell->faults), "");
  ASSERT_EQ(cell->devices.size(), 2U);
  EXPECT_EQ(cell->devices[0].pose.position, Vec3(1, 2.5, 3));
  EXPECT_EQ(cell->devices[0].pose.orientation, quaternionFromRpy({0, 0, kPi / 2}));
  EXPECT_EQ(cell->devices[0].layer, "robots");
  EXPECT_EQ(cell->devices[0].color, glm::vec4(1, 128 / 255.0F, 0, 64 / 255.0F));
  EXPECT_TRUE(cell->devices[1].optional);
  EXPECT_EQ(cell->devices[1].pose.orientation, Quat(0, 0, 0, 1));
  EXPECT_EQ(cell->modelOf(cell->devices[0]), cell->modelOf(cell->devices[1])) << "read once";
  EXPECT_EQ(cell->findDevice("b"), &cell->devices[1]);
  EXPECT_EQ(cell->findDevice("c"), nullptr);
  EXPECT_EQ(cell->files.size(), 2U);
}

TEST_F(CellTest, ModelsAreKnownByWrittenNameFileNameAndStem) {
  test::writeFile(folder_ / "other/arm.urdf", "<robot name='x'><link name='only'/></robot>");
  const auto cell = load(R"(
format = 1
[[model]]
name = "box"
urdf = "other/arm.urdf"
[[device]]
name = "a"
model = "models/arm.urdf"
)");
  ASSERT_TRUE(cell.ok());
  std::vector<std::string> names;
  for (const auto& [name, model] : cell->models) names.push_back(name);
  EXPECT_EQ(names, (std::vector<std::string>{"arm", "arm.urdf", "box", "models/arm.urdf"}));

  const auto two = load(
      "format = 1\n[[device]]\nname = 'a'\nmodel = 'models/arm.urdf'\n"
      "[[device]]\nname = 'b'\nmodel = 'other/arm.urdf'\n");
  ASSERT_TRUE(two.ok());
  names.clear();
  for (const auto& [name, model] : two->models) names.push_back(name);
  EXPECT_EQ(names, (std::vector<std::string>{"models/arm.urdf", "other/arm.urdf"}))
      << "short names that would mean two models mean neither";
}

TEST_F(CellTest, ABareModelIsACellOfOneDevice) {
  const auto urdf = loadCell(folder_ / "arm.urdf", {});
  ASSERT_TRUE(urdf.ok());
  ASSERT_EQ(urdf->devices.size(), 1U);
  EXPECT_EQ(urdf->devices[0].name, "arm");
  EXPECT_TRUE(urdf->models.contains("arm"));
  EXPECT_TRUE(urdf->models.contains("arm.urdf"));

  const auto obj = loadCell(folder_ / "gantry.obj", {});
  ASSERT_TRUE(obj.ok());
  EXPECT_EQ(obj->devices[0].name, "gantry");
  EXPECT_EQ(obj->modelOf(obj->devices[0])->links[0].visuals[0].mesh->triangleCount(), 5U);
  ASSERT_EQ(obj->faults.size(), 1U);
  EXPECT_EQ(obj->faults[0].severity, Severity::note);
}

TEST_F(CellTest, WithoutGeometryNoMeshIsOpenedAndTheKinematicsAreTheSame) {
  const std::string_view text = R"(
format = 1
[[device]]
name = "g"
model = "g"
[[model]]
name = "g"
obj = "gantry.obj"
unit = "m"
up = "z"
[[model.link]]
name = "bridge"
parent = "base"
groups = ["bridge*"]
joint = { name = "x", type = "prismatic", axis = [1, 0, 0], limits = [0, 6] }
)";
  const auto with = load(text);
  CellOptions options;
  options.geometry = false;
  const auto without = loadCell(folder_ / "test.cell.toml", options);
  ASSERT_TRUE(with.ok() && without.ok());
  EXPECT_EQ(kinematicsHash(*with->models.at("g")), kinematicsHash(*without->models.at("g")));
  EXPECT_EQ(with->files.size(), 2U);
  EXPECT_EQ(without->files.size(), 1U);
}

TEST_F(CellTest, InlineKinematicsShareTheGroupsOfOneFile) {
  const auto cell = load(R"(
format = 1
[[device]]
name = "g"
model = "g"
[[model]]
name = "g"
obj = "gantry.obj"
unit = "m"
up = "z"
[[model.link]]
name = "bridge"
parent = "base"
groups = ["bridge_*"]
joint = { name = "x", type = "prismatic", axis = [2, 0, 0], origin = [0, 0, 2], limits = [0, 6], velocity = 1 }
[[model.link]]
name = "hand"
parent = "bridge"
groups = ["h?nd"]
joint = { name = "turn", type = "revolute", axis = [0, 0, 1], limits_deg = [-90, 90], origin = { xyz = [1, 0, 0], rpy_deg = [180, 0, 0] } }
)");
  ASSERT_TRUE(cell.ok());
  EXPECT_EQ(test::printed(cell->faults), "");
  const Model& model = *cell->models.at("g");
  ASSERT_EQ(model.links.size(), 3U);
  EXPECT_EQ(model.links[model.root].name, "base");
  ASSERT_EQ(model.links[0].visuals.size(), 1U);
  EXPECT_EQ(model.links[0].visuals[0].mesh_parts, (std::vector<std::size_t>{0, 3}))
      << "the root takes what no other link takes";
  EXPECT_EQ(model.links[1].visuals[0].mesh_parts, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(model.links[2].visuals[0].mesh_parts, (std::vector<std::size_t>{4}));
  EXPECT_EQ(model.joints[0].axis, Vec3(1, 0, 0));
  EXPECT_EQ(model.joints[0].limits->velocity, 1.0);
  EXPECT_NEAR(model.joints[1].limits->upper, kPi / 2, 1e-15);

  // At zero every vertex of the "world" file must be where the file has it.
  const std::vector<Mat4> poses = linkPoses(model, zeroJoints(model));
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const Mat4 placed = poses[i] * matrixOf(model.links[i].visuals[0].origin);
    const Vec3 point = transformPoint(placed, {0.3, 0.4, 2});
    EXPECT_NEAR(point.x, 0.3, 1e-15);
    EXPECT_NEAR(point.y, 0.4, 1e-15);
    EXPECT_NEAR(point.z, 2.0, 1e-15);
  }
}

TEST_F(CellTest, UnitAndUpAxisAreAppliedToTheGeometry) {
  const auto cell = load(R"(
format = 1
[[model]]
name = "tank"
obj = "tank.obj"
unit = "mm"
up = "y"
geometry = "link"
)");
  ASSERT_TRUE(cell.ok());
  EXPECT_EQ(test::printed(cell->faults), "");
  const Bounds& bounds = cell->models.at("tank")->links[0].visuals[0].mesh->bounds;
  EXPECT_EQ(bounds.max.x, 1.0);
  EXPECT_EQ(bounds.max.z, 1.0);
  EXPECT_EQ(bounds.max.y, 0.0);
}

TEST_F(CellTest, WhatIsNoCellIsRefused) {
  EXPECT_EQ(faultsOf("format = 2\n"),
            "REFUSED: the cell has format 2; this program reads format 1 (test.cell.toml)");
  EXPECT_EQ(faultsOf("[case]\nname = 'x'\n"),
            "REFUSED: this is not a cell: it has neither `format` nor a [[device]] "
            "(test.cell.toml)");
  const std::string broken = faultsOf("format = 1\n[[device]\n");
  EXPECT_TRUE(broken.starts_with("REFUSED: ")) << broken;
  EXPECT_NE(broken.find("(test.cell.toml:2:"), std::string::npos) << broken;
  const std::string key = faultsOf("format = 1\n[= [1]\n");
  EXPECT_NE(key.find("(test.cell.toml:2:2)"), std::string::npos) << key;
  EXPECT_EQ(faultsOf("format = 1\n\xC3\xA9t\xC3\xA9 = 1\n"),
            "REFUSED: letters beyond ASCII must be in quotes (test.cell.toml:2:1)");
  EXPECT_EQ(faultsOf("format = 1\nx-a = ['\xC3\xA9', \xC3\xA9]\n"),
            "REFUSED: letters beyond ASCII must be in quotes (test.cell.toml:2:13)");
  for (const char* const word : {"2v\"\xCF\x99", "26....\"\xCF\x99", "2[\"\xCF\x99"}) {
    const std::string quoted = faultsOf(std::string("format = 1\nname = ") + word + "\n");
    EXPECT_NE(quoted.find("(test.cell.toml:2:"), std::string::npos) << quoted;
  }
  EXPECT_TRUE(faultsOf("format = 1\nx-a = '\xFF'\n").starts_with("REFUSED: "));
  EXPECT_EQ(loadCell(folder_ / "none.cell.toml", {}).error().kind, ErrorKind::not_found);
  EXPECT_EQ(loadCell("/dev/zero", {}).error().kind, ErrorKind::bad_argument);
  EXPECT_EQ(loadCell(folder_.path(), {}).error().kind, ErrorKind::bad_argument);
  test::writeFile(folder_ / "a.urdf.xacro", "<robot/>");
  EXPECT_EQ(loadCell(folder_ / "a.urdf.xacro", {}).error().what,
            "a xacro template is not read; expand it first: xacro model.xacro > model.urdf");
  test::writeFile(folder_ / "bad.urdf", "<robot name='r'>\n  <xacro:a/></robot>");
  EXPECT_EQ(loadCell(folder_ / "bad.urdf", {}).error().where,
            (folder_ / "bad.urdf").string() + ":2:3");
  CellOptions nowhere;
  nowhere.search = {folder_ / "none"};
  EXPECT_EQ(loadCell(folder_ / "arm.urdf", nowhere).error().kind, ErrorKind::not_found);
}

TEST_F(CellTest, NestingHasABound) {
  const auto cell = load("format = 1\nx-deep = " + std::string(100000, '['));
  ASSERT_FALSE(cell.ok());
  EXPECT_EQ(cell.error().kind, ErrorKind::damaged);
  test::writeFile(folder_ / "large.cell.toml", std::string(5 << 20, '\n'));
  EXPECT_EQ(loadCell(folder_ / "large.cell.toml", {}).error().what,
            "the file is larger than 4 MiB");
}

}  // namespace
}  // namespace rocinante
