#include "viewer/model/convert.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "core/kinematics/kinematics.h"
#include "core/mesh/mesh.h"
#include "tests/core/cell/cell_fixture.h"
#include "tests/support/shared_data.h"
#include "viewer/model/model_info.h"
#include "viewer/model/pose_request.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

std::string contentOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

std::uint64_t trianglesOf(const Cell& cell) { return modelInfo(cell, "")->triangles; }

void expectNear(const Bounds& a, const Bounds& b, double most) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(a.min[i], b.min[i], most);
    EXPECT_NEAR(a.max[i], b.max[i], most);
  }
}

class ConvertTest : public test::CellFolder {
 protected:
  ConvertTest() { fs::create_directory(out_ = folder_ / "out"); }

  Result<ConvertReport> convert(const Cell& cell, const std::string& name, PoseRequest pose = {}) {
    return convertModel(cell, {out_ / name, false, std::move(pose)});
  }
  // The values of every joint, different and within no limits.
  static PoseRequest someValues(const Model& model) {
    PoseRequest request;
    request.joints.emplace();
    for (std::size_t i = 0; i < model.positionalCount(); ++i) {
      request.joints->push_back(0.37 * static_cast<double>(i + 1) - 0.9);
    }
    return request;
  }
  // Same kinematics to the bit, same triangles, same size to the rounding of a float.
  void expectSameAsCell(const fs::path& file) {
    SCOPED_TRACE(file);
    const auto before = loadCell(file, {});
    ASSERT_TRUE(before.ok());
    const std::string name = file.stem().string() + ".cell.toml";
    const auto written = convert(*before, name);
    ASSERT_TRUE(written.ok()) << written.error().text();
    const auto after = loadCell(out_ / name, {});
    ASSERT_TRUE(after.ok()) << after.error().text();
    EXPECT_EQ(test::printed(after->faults), "");
    const Model& old_model = *before->modelOf(before->devices[0]);
    const Model& new_model = *after->modelOf(after->devices[0]);
    EXPECT_EQ(kinematicsHash(old_model), kinematicsHash(new_model));
    EXPECT_EQ(trianglesOf(*before), trianglesOf(*after));
    EXPECT_EQ(trianglesOf(*before), written->triangles);
    expectNear(modelInfo(*before, "")->bounds, modelInfo(*after, "")->bounds, 1e-6);
    const auto old_links = forwardKinematics(*before, someValues(old_model));
    const auto new_links = forwardKinematics(*after, someValues(new_model));
    ASSERT_TRUE(old_links.ok() && new_links.ok());
    ASSERT_EQ(old_links->size(), new_links->size());
    for (const LinkPose& old_link : *old_links) {
      for (const LinkPose& new_link : *new_links) {
        if (new_link.link != old_link.link) continue;
        EXPECT_EQ(new_link.pose, old_link.pose);
      }
    }
  }

  fs::path out_;
};

// Every kind of joint, a mirrored mesh, two visuals a link, names that need quoting.
constexpr std::string_view kRobot = R"(<robot name="odd/robot">
<material name="red"><color rgba="1 0.2 0.3 0.5"/></material>
<link name="base"><visual><geometry><box size="1 2 3"/></geometry><material name="red"/></visual>
  <visual><origin xyz="0.1 0.2 0.3" rpy="0.4 0.5 0.6"/><geometry>
    <mesh filename="tank.obj" scale="-0.001 0.002 0.003"/></geometry></visual></link>
<link name='a "quoted" * name'><visual><geometry><sphere radius="0.2"/></geometry></visual></link>
<link name="b"/>
<link name="c"><visual><geometry><cylinder radius="0.1" length="1"/></geometry></visual></link>
<link name="d"><visual><geometry><box size="0.1 0.1 0.1"/></geometry></visual></link>
<link name="a__quoted____name"><visual><geometry><box size="0.1 0.1 0.2"/></geometry></visual></link>
<joint name="spin" type="continuous"><origin xyz="0.1 0 1" rpy="1 2 3"/><parent link="base"/>
  <child link='a "quoted" * name'/><axis xyz="1 2 3"/><limit effort="3" velocity="4"/></joint>
<joint name="follow" type="revolute"><parent link='a "quoted" * name'/><child link="b"/>
  <axis xyz="0 0.3 0.1"/><limit lower="-1" upper="0.1" effort="1" velocity="2"/>
  <mimic joint="spin" multiplier="-0.3" offset="0.2"/></joint>
<joint name="fly" type="floating"><origin xyz="0 0 0.3"/><parent link="b"/><child link="c"/></joint>
<joint name="floor" type="planar"><parent link="base"/><child link="d"/><axis xyz="1 1 0"/></joint>
<joint name="held" type="fixed"><origin rpy="0 0 1.5707963"/><parent link="d"/>
  <child link="a__quoted____name"/></joint>
</robot>)";

TEST_F(ConvertTest, AUrdfAsACellHasTheSameKinematicsToTheBit) {
  test::writeFile(folder_ / "odd.urdf", kRobot);
  expectSameAsCell(folder_ / "odd.urdf");
}

TEST_F(ConvertTest, TheRealRobotsAsCellsAreTheSameMachines) {
  ROCINANTE_NEEDS_SHARED_DATA("robots");
  for (const char* file : {"robots/puma560_description/urdf/puma560_robot.urdf",
                           "robots/kuka_iiwa/model.urdf", "robots/r2d2/r2d2.urdf"}) {
    expectSameAsCell(test::sharedData() / file);
  }
}

TEST_F(ConvertTest, APosedModelStandsInTheObjAsItWouldBeDrawn) {
  test::writeFile(folder_ / "odd.urdf", kRobot);
  const auto cell = loadCell(folder_ / "odd.urdf", {});
  ASSERT_TRUE(cell.ok());
  PoseRequest pose = someValues(*cell->modelOf(cell->devices[0]));
  pose.base = Pose{{5, 0, 0}, {1, 0, 0, 0}};
  ASSERT_TRUE(convert(*cell, "posed.obj", pose).ok());
  ASSERT_TRUE(convert(*cell, "posed.stl", pose).ok());
  const auto obj = loadCell(out_ / "posed.obj", {}), stl = loadCell(out_ / "posed.stl", {});
  ASSERT_TRUE(obj.ok() && stl.ok());
  EXPECT_EQ(trianglesOf(*obj), trianglesOf(*cell));
  EXPECT_EQ(trianglesOf(*stl), trianglesOf(*cell));
  expectNear(modelInfo(*obj, "")->bounds, modelInfo(*stl, "")->bounds, 1e-9);
  EXPECT_GT(modelInfo(*obj, "")->bounds.min.x, 2.0);
  const Mesh& mesh = *obj->modelOf(obj->devices[0])->links[0].visuals[0].mesh;
  std::set<std::string> groups;
  for (const MeshPart& part : mesh.parts) groups.insert(part.group);
  EXPECT_EQ(groups.size(), 5U) << "one for each link with geometry, however they are named";
  EXPECT_EQ(mesh.materials[mesh.parts[0].material].diffuse, glm::vec4(1.0F, 0.2F, 0.3F, 0.5F));
}

TEST_F(ConvertTest, AMirroredMeshStaysOutsideOut) {
  test::writeFile(folder_ / "mirror.urdf", R"(<robot name="m"><link name="l"><visual><geometry>
<mesh filename="tank.obj" scale="-0.001 0.001 0.001"/></geometry></visual></link></robot>)");
  const auto cell = loadCell(folder_ / "mirror.urdf", {});
  ASSERT_TRUE(cell.ok());
  ASSERT_TRUE(convert(*cell, "mirror.obj").ok());
  const auto again = loadCell(out_ / "mirror.obj", {});
  ASSERT_TRUE(again.ok());
  const Mesh& mesh = *again->modelOf(again->devices[0])->links[0].visuals[0].mesh;
  const auto at = [&](int i) { return mesh.vertices[mesh.indices[static_cast<std::size_t>(i)]]; };
  const glm::vec3 across =
      glm::cross(at(1).position - at(0).position, at(2).position - at(0).position);
  EXPECT_GT(glm::dot(across, at(0).normal), 0.0F);
  EXPECT_EQ(at(0).normal, glm::vec3(0, 0, 1));
}

TEST_F(ConvertTest, TexturesComeAlongAndSoDoesHowTheyLie) {
  test::writeFile(folder_ / "painted.obj",
                  "mtllib painted.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.25 0.5\nvt 1 0\nvt 0 1\n"
                  "g painted thing\nusemtl paint\nf 1/1 2/2 3/3\n");
  test::writeFile(folder_ / "painted.mtl",
                  "newmtl paint\nKd 0.1 0.2 0.3\nKs 0.5 0.5 0.5\nNs 20\n"
                  "map_Kd -s 2 3 1 -o 0.5 0 0 a picture.png\n");
  test::writeFile(folder_ / "a picture.png", "no picture, but a file");
  const auto cell = loadCell(folder_ / "painted.obj", {});
  ASSERT_TRUE(cell.ok());
  const auto written = convert(*cell, "again.obj");
  ASSERT_TRUE(written.ok()) << written.error().text();
  EXPECT_EQ(written->files.back(), out_ / "again.obj");
  EXPECT_EQ(contentOf(out_ / "again.textures/a_picture.png"), "no picture, but a file");
  const auto again = loadCell(out_ / "again.obj", {});
  ASSERT_TRUE(again.ok());
  const Mesh& old_mesh = *cell->modelOf(cell->devices[0])->links[0].visuals[0].mesh;
  const Mesh& mesh = *again->modelOf(again->devices[0])->links[0].visuals[0].mesh;
  Material expected = old_mesh.materials[old_mesh.parts[0].material];
  expected.diffuse_map = mesh.materials[mesh.parts[0].material].diffuse_map;
  EXPECT_EQ(mesh.materials[mesh.parts[0].material], expected);
  EXPECT_EQ(expected.diffuse_map.filename(), "a_picture.png");
  EXPECT_EQ(mesh.vertices[mesh.indices[0]].texture, glm::vec2(0.25F, 0.5F));
}

TEST_F(ConvertTest, ColoursByVertexComeAlong) {
  test::writeFile(folder_ / "scan.obj",
                  "v 0 0 0 1 0 0\nv 1 0 0 0 0.2 0.4\nv 0 0 1 0 0 1\nf 1 2 3\n");
  const auto cell = loadCell(folder_ / "scan.obj", {});
  ASSERT_TRUE(cell.ok());
  const auto written = convert(*cell, "again.obj");
  ASSERT_TRUE(written.ok()) << written.error().text();
  EXPECT_TRUE(written->left_out.empty());
  const auto again = loadCell(out_ / "again.obj", {});
  ASSERT_TRUE(again.ok());
  const auto colorsOf = [](const Cell& of) {
    return of.modelOf(of.devices[0])->links[0].visuals[0].mesh->colors;
  };
  EXPECT_EQ(colorsOf(*again), colorsOf(*cell));
  EXPECT_EQ(colorsOf(*again).at(1), 0x003366FFU);

  const auto as_stl = convert(*cell, "again.stl");
  ASSERT_TRUE(as_stl.ok());
  EXPECT_EQ(accountSentence(as_stl->left_out),
            "left out: 1 vertex colour (STL has only triangles)");
}

TEST_F(ConvertTest, WhatAnObjCannotSayIsNamed) {
  const fs::path models = fs::path(ROCINANTE_MODELS_DIR) / "gltf";
  const auto masked = loadCell(models / "alpha-modes.gltf", {});
  ASSERT_TRUE(masked.ok());
  const auto written = convert(*masked, "masked.obj");
  ASSERT_TRUE(written.ok()) << written.error().text();
  EXPECT_EQ(accountSentence(written->left_out),
            "left out: 1 alpha mode `opaque` (MTL has only opacity: the alpha of a texture is "
            "blended), 8 texture wraps `clamp` (textures of MTL repeat), 4 alpha modes `mask` (MTL "
            "has only opacity: holes are blended)");
  // The picture inside the file becomes one beside it.
  EXPECT_TRUE(contentOf(out_ / "masked.textures/alpha-modes.gltf_1.png").starts_with("\x89PNG"));

  const auto turned = loadCell(models / "transforms.gltf", {});
  ASSERT_TRUE(turned.ok() && convert(*turned, "turned.obj").ok());
  const auto again = loadCell(out_ / "turned.obj", {});
  ASSERT_TRUE(again.ok());
  const auto placesOf = [](const Cell& of) {
    const Mesh& mesh = *of.modelOf(of.devices[0])->links[0].visuals[0].mesh;
    std::vector<glm::vec2> places;
    for (const MeshPart& part : mesh.parts) {
      for (std::uint32_t i = 0; i < part.index_count; ++i) {
        places.push_back(MapPlacing(mesh.materials[part.material])
                             .of(mesh.vertices[mesh.indices[part.first_index + i]].texture));
      }
    }
    return places;
  };
  const auto before = placesOf(*turned), after = placesOf(*again);
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_NEAR(before[i].x, after[i].x, 1e-6);
    EXPECT_NEAR(before[i].y, after[i].y, 1e-6);
  }
}

TEST_F(ConvertTest, TheSameInputGivesTheSameBytes) {
  test::writeFile(folder_ / "odd.urdf", kRobot);
  fs::create_directory(folder_ / "again");
  for (const char* name : {"odd.obj", "odd.stl", "odd.cell.toml"}) {
    const auto first = loadCell(folder_ / "odd.urdf", {}),
               second = loadCell(folder_ / "odd.urdf", {});
    ASSERT_TRUE(convertModel(*first, {out_ / name, true, {}}).ok());
    ASSERT_TRUE(convertModel(*second, {folder_ / "again" / name, true, {}}).ok());
    EXPECT_EQ(contentOf(out_ / name), contentOf(folder_ / "again" / name)) << name;
  }
}

TEST_F(ConvertTest, NothingIsOverwrittenAndNothingIsLeftHalfDone) {
  const auto cell = loadCell(folder_ / "gantry.obj", {});
  ASSERT_TRUE(cell.ok());
  test::writeFile(out_ / "g.mtl", "mine");
  const auto refused = convert(*cell, "g.cell.toml");
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().where, (out_ / "g.mtl").string());
  EXPECT_EQ(contentOf(out_ / "g.mtl"), "mine");
  EXPECT_FALSE(fs::exists(out_ / "g.obj"));
  EXPECT_TRUE(convertModel(*cell, {out_ / "g.cell.toml", true, {}}).ok());

  fs::create_directory(out_ / "h.cell.toml");  // can not be written over, and comes last
  EXPECT_FALSE(convertModel(*cell, {out_ / "h.cell.toml", true, {}}).ok());
  EXPECT_FALSE(fs::exists(out_ / "h.obj"));
  EXPECT_FALSE(fs::exists(out_ / "h.mtl"));
}

TEST_F(ConvertTest, WhatCannotBeWrittenIsRefused) {
  const auto cell = loadCell(folder_ / "gantry.obj", {});
  const auto bare = loadCell(folder_ / "arm.urdf", {});
  ASSERT_TRUE(cell.ok() && bare.ok());
  EXPECT_EQ(convert(*cell, "g.fbx").error().what,
            "the output must end in .obj, .stl or .cell.toml");
  EXPECT_EQ(convert(*bare, "g.obj").error().what, "no geometry to write");
  PoseRequest pose;
  pose.named = {{"lift", 1.0}};
  EXPECT_EQ(convert(*bare, "g.cell.toml", pose).error().what,
            "a cell keeps its joints, so joint values have no effect here");
}

}  // namespace
}  // namespace rocinante
