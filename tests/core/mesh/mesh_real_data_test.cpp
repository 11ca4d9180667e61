#include <fmt/format.h>

#include <map>
#include <numeric>
#include <set>

#include "tests/core/mesh/mesh_test_support.h"
#include "tests/support/shared_data.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;
using test::expectSound;
using test::ReadMesh;
using test::sharedData;
using ::testing::IsEmpty;

ReadMesh readShared(const fs::path& below, const MeshReadOptions& options = {}) {
  ReadMesh read;
  Result<Mesh> mesh = readMeshFile(sharedData(below), options, read.faults);
  EXPECT_TRUE(mesh.ok()) << mesh.error().text();
  if (mesh) read.mesh = std::move(*mesh);
  return read;
}

std::size_t trianglesOf(const fs::path& folder, const std::vector<std::string>& names,
                        std::string_view ending) {
  std::size_t triangles = 0;
  for (const std::string& name : names) {
    SCOPED_TRACE(name);
    const ReadMesh read = readShared(folder / (name + std::string(ending)));
    EXPECT_THAT(read.blame(), IsEmpty());
    expectSound(read.mesh);
    triangles += read.mesh.triangleCount();
  }
  return triangles;
}

TEST(RealMeshes, TheWasteYardLoadsWithItsMaterialsAndTextures) {
  ROCINANTE_NEEDS_SHARED_DATA("env/waste_yard");
  const ReadMesh read = readShared("env/waste_yard/waste_yard.obj");
  // Correct: a program cut its power plant and left slivers.
  EXPECT_THAT(read.rules(), testing::ElementsAre("model.left-out", "mesh.degenerate-triangles"));
  EXPECT_THAT(read.leftOut(), testing::ElementsAre("statement `illum`"));
  EXPECT_EQ(read.faults.back().text, "408 of the 29960 triangles have no area");
  expectSound(read.mesh);
  EXPECT_EQ(read.mesh.triangleCount(), 29960U);
  EXPECT_EQ(read.mesh.materials.size(), 44U);
  std::set<fs::path> textures;
  for (const Material& material : read.mesh.materials) {
    if (!material.diffuse_map.empty()) textures.insert(material.diffuse_map);
  }
  EXPECT_EQ(textures.size(), 32U);
  std::set<std::string> groups;
  for (const MeshPart& part : read.mesh.parts) groups.insert(part.group);
  EXPECT_EQ(groups.size(), 18U);
  for (const char* name : {"reactor_1", "crane_1", "barrel_10", "dumpster_5", "powerplant_1"}) {
    EXPECT_TRUE(groups.contains(name)) << name;
  }
}

TEST(RealMeshes, ThePumaLoadsFromItsStlFilesInInches) {
  ROCINANTE_NEEDS_SHARED_DATA("robots/puma560_description");
  EXPECT_EQ(trianglesOf("robots/puma560_description/meshes",
                        {"puma_link1", "puma_link2", "puma_link3", "puma_link4", "puma_link5",
                         "puma_link6", "puma_link7"},
                        ".stl"),
            8116U);
  MeshReadOptions inches;
  inches.unit_m = 0.0254;
  const ReadMesh base = readShared("robots/puma560_description/meshes/puma_link1.stl", inches);
  EXPECT_NEAR(base.mesh.bounds.max.z, 23.45 * 0.0254, 1e-7);
}

TEST(RealMeshes, TheKukaLoadsFromObjAndStlAlike) {
  ROCINANTE_NEEDS_SHARED_DATA("robots/kuka_iiwa");
  const std::vector<std::string> links = {"link_0", "link_1", "link_2", "link_3",
                                          "link_4", "link_5", "link_6", "link_7"};
  EXPECT_EQ(trianglesOf("robots/kuka_iiwa/meshes", links, ".obj"), 14758U);
  EXPECT_EQ(trianglesOf("robots/kuka_iiwa/meshes", links, ".stl"), 14758U);
}

TEST(RealMeshes, ThePandaLoadsWithATextureNamedOnAnotherMachine) {
  ROCINANTE_NEEDS_SHARED_DATA("robots/franka_panda");
  // All that panda.urdf draws: link0 and link7 show their collision meshes, the finger twice.
  std::size_t triangles = trianglesOf(
      "robots/franka_panda/meshes/visual",
      {"link1", "link2", "link3", "link4", "link5", "link6", "hand", "finger", "finger"}, ".obj");
  for (const char* name : {"link0.obj", "link7.obj"}) {
    triangles +=
        readShared(fs::path("robots/franka_panda/meshes/collision") / name).mesh.triangleCount();
  }
  EXPECT_EQ(triangles, 102759U);
  const ReadMesh link1 = readShared("robots/franka_panda/meshes/visual/link1.obj");
  EXPECT_EQ(link1.mesh.materials[0].diffuse_map,
            sharedData("robots/franka_panda/meshes/visual/colors.png").lexically_normal());
}

TEST(RealMeshes, TheFingersOfR2D2Load) {
  ROCINANTE_NEEDS_SHARED_DATA("robots/r2d2");
  EXPECT_EQ(trianglesOf("robots/r2d2", {"l_finger", "l_finger_tip"}, ".stl"), 253U + 151U);
}

/// The bounds of one group's triangles, from the corners that they use.
Vec3 sizeOfGroup(const Mesh& mesh, const std::string& group) {
  Bounds bounds;
  for (const MeshPart& part : mesh.parts) {
    if (part.group != group) continue;
    for (std::uint32_t i = 0; i < part.index_count; ++i) {
      bounds.add(Vec3(mesh.vertices[mesh.indices[part.first_index + i]].position));
    }
  }
  return bounds.max - bounds.min;
}

TEST(RealSizes, AnInchColladaMeasuresAsItsMetreTwinInObj) {
  ROCINANTE_NEEDS_SHARED_DATA("env/gazebo_originals/reactor/meshes/reactor.dae");
  ROCINANTE_NEEDS_SHARED_DATA("env/waste_yard/waste_yard.obj");
  // Someone else modelled the same reactor in this scene, at a different place.
  const Bounds inches = readShared("env/gazebo_originals/reactor/meshes/reactor.dae").mesh.bounds;
  const Vec3 metres = sizeOfGroup(readShared("env/waste_yard/waste_yard.obj").mesh, "reactor_1");
  EXPECT_LT(glm::length(inches.max - inches.min - metres), 1e-4);
  EXPECT_NEAR(metres.z, 25.90462, 1e-4) << "85 feet high";
}

TEST(RealSizes, ThePumaOfInchesIsAsLargeAsThePumaOfMetres) {
  ROCINANTE_NEEDS_SHARED_DATA("robots/puma560_description");
  // Two sets of meshes of one arm, by different authors: STL in inches, COLLADA in metres.
  MeshReadOptions inches;
  inches.unit_m = 0.0254;
  const auto stl = [&](int link) {
    return readShared(fmt::format("robots/puma560_description/meshes/puma_link{}.stl", link),
                      inches)
        .mesh.bounds;
  };
  const auto collada = [&](int link) {
    return readShared(fmt::format("robots/puma560_description/meshes/puma560_link{}.dae", link))
        .mesh.bounds;
  };
  // The flange is the same in both, two inches across.
  EXPECT_LT(glm::length(stl(7).max - collada(7).max), 1e-6);
  EXPECT_LT(glm::length(stl(7).min - collada(7).min), 1e-6);
  EXPECT_NEAR(stl(7).max.x - stl(7).min.x, 2 * 0.0254, 1e-6);
  // The others were modelled again: a wrong unit would make them 39 times as large.
  for (int link = 1; link <= 7; ++link) {
    const Vec3 a = stl(link).max - stl(link).min, b = collada(link).max - collada(link).min;
    EXPECT_NEAR(glm::length(a) / glm::length(b), 1, 0.13) << "link " << link;
  }
}

}  // namespace
}  // namespace rocinante
