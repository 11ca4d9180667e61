// ../shared/field: files in the shape of public bug reports, with what is right in their READMEs.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/core/mesh/mesh_test_support.h"
#include "tests/support/shared_data.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;
using test::expectSound;
using test::ReadMesh;
using ::testing::IsEmpty;

fs::path fieldFile(const fs::path& below) { return test::sharedData("../field") / below; }

ReadMesh readField(const fs::path& below) {
  ReadMesh read;
  MeshReadOptions options;
  // As a cell does: also from the folder above the mesh's.
  options.resolve = [](const std::string& name, const fs::path& beside) {
    FoundFile found;
    std::error_code ignored;
    const fs::path file = (beside / name).lexically_normal();
    if (name.empty() || !fs::is_regular_file(file, ignored)) return found;
    found.why = FoundFile::Why::found;
    found.path = file;
    return found;
  };
  Result<Mesh> mesh = readMeshFile(fieldFile(below), options, read.faults);
  EXPECT_TRUE(mesh.ok()) << mesh.error().text();
  if (mesh) read.mesh = std::move(*mesh);
  expectSound(read.mesh);
  return read;
}

double areaOf(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Vec3 a(mesh.vertices[mesh.indices[i]].position);
    sum += lengthOf(crossOf(Vec3(mesh.vertices[mesh.indices[i + 1]].position) - a,
                            Vec3(mesh.vertices[mesh.indices[i + 2]].position) - a)) /
           2;
  }
  return sum;
}

Vec3 sizeOf(const Mesh& mesh) { return mesh.bounds.max - mesh.bounds.min; }

/// Faults that blame the file: not its account, and not what is good to know.
std::vector<std::string> blameOf(const ReadMesh& read) {
  std::vector<std::string> blame;
  for (const Finding& fault : read.faults) {
    if (fault.severity == Severity::note) continue;
    blame.push_back(fault.rule + ": " + fault.text);
  }
  return blame;
}

const Material& materialOf(const ReadMesh& read, std::size_t part = 0) {
  return read.mesh.materials.at(read.mesh.parts.at(part).material);
}

/// A file whose mesh has this many triangles and this size.
struct SoundCase {
  const char* file;
  std::size_t triangles;
  Vec3 size;
};

class FieldMesh : public ::testing::TestWithParam<SoundCase> {};

TEST_P(FieldMesh, IsReadWholeAndBlamedForNothing) {
  if (!fs::exists(fieldFile(""))) GTEST_SKIP() << "no field cases here: " << fieldFile("");
  const ReadMesh read = readField(GetParam().file);
  EXPECT_EQ(read.mesh.triangleCount(), GetParam().triangles);
  EXPECT_LT(lengthOf(sizeOf(read.mesh) - GetParam().size), 1e-5)
      << sizeOf(read.mesh).x << " " << sizeOf(read.mesh).y << " " << sizeOf(read.mesh).z;
  EXPECT_THAT(blameOf(read), IsEmpty());
}

constexpr Vec3 kCuboid{1, 2, 3};
constexpr Vec3 kCube{1, 1, 1};
INSTANTIATE_TEST_SUITE_P(
    Files, FieldMesh,
    ::testing::Values(SoundCase{"01-stl-uppercase/caps.stl", 12, kCuboid},
                      SoundCase{"02-stl-binary-solid/color.stl", 12, kCuboid},
                      SoundCase{"02-stl-binary-solid/end.stl", 12, kCuboid},
                      SoundCase{"02-stl-binary-solid/sw.stl", 12, kCuboid},
                      SoundCase{"03-obj-usemtl-before-mtllib/early.obj", 12, kCuboid},
                      SoundCase{"03-obj-usemtl-before-mtllib/late.obj", 12, kCuboid},
                      SoundCase{"04-obj-continuations-negative-names/rhino.obj", 12, kCuboid},
                      SoundCase{"04-obj-continuations-negative-names/tex.obj", 12, kCuboid},
                      SoundCase{"07-dae-primitives/oct.dae", 6, {2, 2, 0}},
                      SoundCase{"07-dae-primitives/polygons.dae", 12, {1, 1, 1}},
                      SoundCase{"07-dae-primitives/strip.dae", 3, {1, 2, 0}},
                      SoundCase{"07-dae-primitives/fan.dae", 2, {1, 1, 0}},
                      SoundCase{"07-dae-primitives/hole.dae", 8, {3, 3, 0}},
                      SoundCase{"07-dae-primitives/nomaterial.dae", 12, {1, 1, 1}},
                      SoundCase{"51-dae-whitespace/base.dae", 12, kCube},
                      SoundCase{"51-dae-whitespace/color-space.dae", 12, kCube},
                      SoundCase{"51-dae-whitespace/float-newline.dae", 12, kCube},
                      SoundCase{"51-dae-whitespace/float-space.dae", 12, kCube},
                      SoundCase{"51-dae-whitespace/float_array-newline.dae", 12, kCube},
                      SoundCase{"51-dae-whitespace/float_array-space.dae", 12, kCube},
                      SoundCase{"51-dae-whitespace/matrix-newline.dae", 12, kCube},
                      SoundCase{"51-dae-whitespace/matrix-space.dae", 12, kCube},
                      SoundCase{"51-dae-whitespace/p-newline.dae", 12, kCube},
                      SoundCase{"51-dae-whitespace/p-space.dae", 12, kCube},
                      SoundCase{"51-dae-whitespace/rotate-newline.dae", 12, kCube},
                      SoundCase{"51-dae-whitespace/rotate-space.dae", 12, kCube},
                      SoundCase{"51-dae-whitespace/scale-newline.dae", 12, kCube},
                      SoundCase{"51-dae-whitespace/scale-space.dae", 12, kCube},
                      SoundCase{"51-dae-whitespace/translate-newline.dae", 12, kCube},
                      SoundCase{"51-dae-whitespace/translate-space.dae", 12, kCube},
                      SoundCase{"51-dae-whitespace/up_axis.dae", 12, kCube},
                      SoundCase{"51-dae-whitespace/vcount-newline.dae", 12, kCube},
                      SoundCase{"51-dae-whitespace/vcount-space.dae", 12, kCube},
                      SoundCase{"52-dae-skin-whitespace/skin8-plain.dae", 6, {0.07, 1, 1}},
                      SoundCase{"52-dae-skin-whitespace/skin8-space.dae", 6, {0.07, 1, 1}},
                      SoundCase{"52-dae-skin-whitespace/skin8-newline.dae", 6, {0.07, 1, 1}}));

TEST(FieldCollada, TheDrawnFilesOfOneModelAreThatModel) {
  if (!fs::exists(fieldFile(""))) GTEST_SKIP() << "no field cases here";
  const ReadMesh base = readField("51-dae-whitespace/base.dae");
  for (const auto& entry : fs::directory_iterator(fieldFile("51-dae-whitespace"))) {
    const std::string name = entry.path().filename().string();
    if (!name.ends_with(".dae") || name.starts_with("clips")) continue;
    SCOPED_TRACE(name);
    const ReadMesh read = readField("51-dae-whitespace/" + name);
    ASSERT_EQ(read.mesh.vertices.size(), base.mesh.vertices.size());
    EXPECT_EQ(read.mesh.bounds.min, base.mesh.bounds.min);
    EXPECT_EQ(materialOf(read), materialOf(base));
    EXPECT_EQ(materialOf(read).diffuse, glm::vec4(1, 0, 0, 1));
  }
  EXPECT_NEAR((base.mesh.bounds.min.x + base.mesh.bounds.max.x) / 2, 5, 1e-6);
  EXPECT_NEAR((base.mesh.bounds.min.y + base.mesh.bounds.max.y) / 2, 1, 1e-6);
  for (const char* clips : {"clips.dae", "clips_nov.dae"}) {
    const ReadMesh read = readField(fs::path("51-dae-whitespace") / clips);
    EXPECT_THAT(blameOf(read), IsEmpty()) << clips;
  }
}

TEST(FieldCollada, ASkinIsNeverReadSoItCanDoNoHarm) {
  if (!fs::exists(fieldFile(""))) GTEST_SKIP() << "no field cases here";
  for (const auto& entry : fs::directory_iterator(fieldFile("52-dae-skin-whitespace"))) {
    const std::string name = entry.path().filename().string();
    if (!name.ends_with(".dae")) continue;
    SCOPED_TRACE(name);
    const ReadMesh read = readField("52-dae-skin-whitespace/" + name);
    EXPECT_GT(read.mesh.triangleCount(), 0U);
    EXPECT_TRUE(std::ranges::any_of(
        read.faults, [](const Finding& fault) { return fault.left_out == "element `skin`"; }));
  }
}

TEST(FieldCollada, ASceneWithoutAMeshDrawsNothing) {
  if (!fs::exists(fieldFile(""))) GTEST_SKIP() << "no field cases here";
  Findings faults;
  const auto mesh = readMeshFile(fieldFile("53-dae-no-mesh/empties.dae"), {}, faults);
  ASSERT_FALSE(mesh.ok());
  EXPECT_EQ(mesh.error().what, "holds no triangle that can be drawn");
}

TEST(FieldCollada, OpacityIsAsTheStandardDeterminesIt) {
  if (!fs::exists(fieldFile(""))) GTEST_SKIP() << "no field cases here";
  const ReadMesh read = readField("05-dae-transparency/seven.dae");
  ASSERT_EQ(read.mesh.parts.size(), 7U);
  std::vector<float> opacities;
  for (std::size_t i = 0; i < 7; ++i) opacities.push_back(materialOf(read, i).diffuse.a);
  EXPECT_THAT(opacities, ::testing::Pointwise(::testing::FloatNear(1e-5F),
                                              {1.0F, 1.0F, 0.5F, 1.0F, 0.5F, 0.5F, 1.0F}));
  ASSERT_EQ(blameOf(read).size(), 1U);
  EXPECT_THAT(blameOf(read)[0], ::testing::HasSubstr("invisible"));
}

TEST(FieldCollada, InstancesStandWhereTheirNodesPutThem) {
  if (!fs::exists(fieldFile(""))) GTEST_SKIP() << "no field cases here";
  const ReadMesh read = readField("06-dae-unit-up-instances/cm.dae");
  ASSERT_EQ(read.mesh.parts.size(), 3U);
  EXPECT_EQ(materialOf(read, 0).diffuse, glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(materialOf(read, 1).diffuse, glm::vec4(0, 1, 0, 1));
  EXPECT_EQ(materialOf(read, 2).diffuse, glm::vec4(0, 0, 1, 1));
  EXPECT_LT(lengthOf(read.mesh.bounds.min - Vec3(-0.5, -0.5, -0.5)), 1e-6);
  EXPECT_LT(lengthOf(read.mesh.bounds.max - Vec3(2.5, 0.5, 3.5)), 1e-6);
}

TEST(FieldCollada, APolygonWithAHoleKeepsIt) {
  if (!fs::exists(fieldFile(""))) GTEST_SKIP() << "no field cases here";
  EXPECT_NEAR(areaOf(readField("07-dae-primitives/hole.dae").mesh), 8, 1e-5);
}

TEST(FieldCollada, EveryWayToNameAPictureFindsIt) {
  if (!fs::exists(fieldFile(""))) GTEST_SKIP() << "no field cases here";
  for (const auto& entry : fs::directory_iterator(fieldFile("43-dae-texture-paths"))) {
    const std::string name = entry.path().filename().string();
    if (!name.ends_with(".dae") || name == "mt.dae") continue;  // whose picture is not there
    SCOPED_TRACE(name);
    const ReadMesh read = readField("43-dae-texture-paths/" + name);
    EXPECT_THAT(blameOf(read), IsEmpty());
    EXPECT_FALSE(materialOf(read).diffuse_map.empty());
  }
}

TEST(FieldCollada, AnImageLiesOnTheCoordinatesBoundToIt) {
  if (!fs::exists(fieldFile(""))) GTEST_SKIP() << "no field cases here";
  for (const auto& [name, largest] : {std::pair{"60-dae-two-uv-sets/bound0.dae", 0.2F},
                                      {"60-dae-two-uv-sets/bound1.dae", 1.0F}}) {
    const ReadMesh read = readField(name);
    float seen = 0;
    for (const Vertex& vertex : read.mesh.vertices) seen = std::max(seen, vertex.texture.x);
    EXPECT_FLOAT_EQ(seen, largest) << name;
  }
}

TEST(FieldStl, ACountThatIsWrongIsToldAndTheTrianglesAreRead) {
  if (!fs::exists(fieldFile(""))) GTEST_SKIP() << "no field cases here";
  for (const char* name : {"count0.stl", "countmax.stl", "tail.stl"}) {
    SCOPED_TRACE(name);
    const ReadMesh read = readField(fs::path("02-stl-binary-solid") / name);
    EXPECT_EQ(read.mesh.triangleCount(), 12U);
    EXPECT_EQ(blameOf(read).size(), 1U);
  }
}

TEST(FieldObj, AMaterialDefinedAfterItsUseIsDrawn) {
  if (!fs::exists(fieldFile(""))) GTEST_SKIP() << "no field cases here";
  for (const char* name : {"early.obj", "late.obj"}) {
    const ReadMesh read = readField(fs::path("03-obj-usemtl-before-mtllib") / name);
    EXPECT_EQ(materialOf(read).diffuse, glm::vec4(1, 0, 0, 1)) << name;
  }
}

TEST(FieldObj, TheImageOfEachQuadIsFound) {
  if (!fs::exists(fieldFile(""))) GTEST_SKIP() << "no field cases here";
  const ReadMesh read = readField("42-textures/all.obj");
  EXPECT_THAT(blameOf(read), IsEmpty());
  EXPECT_GT(read.mesh.parts.size(), 8U);
  for (std::size_t i = 0; i < read.mesh.parts.size(); ++i) {
    EXPECT_FALSE(materialOf(read, i).diffuse_map.empty()) << materialOf(read, i).name;
  }
}

TEST(FieldObj, ATinyPartAndAHugeOneKeepTheirSizes) {
  if (!fs::exists(fieldFile(""))) GTEST_SKIP() << "no field cases here";
  EXPECT_NEAR(sizeOf(readField("57-tiny-huge/tiny.obj").mesh).x, 1e-4, 1e-9);
  EXPECT_NEAR(sizeOf(readField("57-tiny-huge/huge.obj").mesh).x, 2e4, 1e-2);
}

TEST(FieldObj, ConcavePolygonsKeepTheirArea) {
  if (!fs::exists(fieldFile(""))) GTEST_SKIP() << "no field cases here";
  const std::map<std::string, double> areas = {
      {"C", 7}, {"L", 5}, {"dart", 0.5}, {"star", 0.6667}, {"tilted.obj", 8.103086}};
  for (const auto& entry : fs::directory_iterator(fieldFile("62-obj-concave"))) {
    const std::string name = entry.path().filename().string();
    const auto area = areas.find(name.substr(0, name.find('-')));
    if (area == areas.end()) continue;
    const ReadMesh read = readField("62-obj-concave/" + name);
    EXPECT_NEAR(areaOf(read.mesh), area->second, 1e-4) << name;
    EXPECT_THAT(blameOf(read), IsEmpty()) << name;
  }
}

TEST(FieldMeshes, ACornerThatIsNowhereTakesOnlyItsTrianglesAlong) {
  if (!fs::exists(fieldFile(""))) GTEST_SKIP() << "no field cases here";
  for (const auto& entry : fs::directory_iterator(fieldFile("64-nan-vertices"))) {
    const std::string name = entry.path().filename().string();
    if (name == "README") continue;
    SCOPED_TRACE(name);
    const ReadMesh read = readField("64-nan-vertices/" + name);
    EXPECT_THAT(blameOf(read), ::testing::Not(IsEmpty()));
    EXPECT_GE(read.mesh.triangleCount(), 6U);
    EXPECT_LT(read.mesh.triangleCount(), 12U);
    EXPECT_LE(lengthOf(sizeOf(read.mesh)), lengthOf(Vec3(1, 2, 3)) + 1e-5);
  }
}

TEST(FieldMtl, OptionsOfImagesAreReadOrNamed) {
  if (!fs::exists(fieldFile(""))) GTEST_SKIP() << "no field cases here";
  const ReadMesh read = readField("68-mtl-options/q.obj");
  EXPECT_THAT(blameOf(read), IsEmpty());
  ASSERT_EQ(read.mesh.materials.size(), 6U);
  for (const Material& material : read.mesh.materials) {
    EXPECT_FALSE(material.diffuse_map.empty()) << material.name;
  }
  EXPECT_EQ(read.mesh.materials[0].map_offset, glm::vec2(0, 0.5F));
  EXPECT_EQ(read.mesh.materials[0].wrap_u, TextureWrap::clamp_to_edge);
  EXPECT_EQ(read.mesh.materials[4].map_scale, glm::vec2(2, 1));
  EXPECT_EQ(read.mesh.materials[4].diffuse_map.filename(), "sp ace.png");
  std::set<std::string> left_out;
  for (const Finding& fault : read.faults) left_out.insert(fault.left_out);
  EXPECT_THAT(left_out, ::testing::IsSupersetOf({"option `-bm`", "option `-mm`", "option `-texres`",
                                                 "statement `Map_Ks`"}));
}

}  // namespace
}  // namespace rocinante
