// ../shared/field, the glTF cases: what a file in the shape of a public bug report must come out
// as, by its README. Pictures of the same cases: tests/viewer/render/alpha_modes_test.cpp.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>

#include "core/base/base64.h"
#include "core/mesh/mesh.h"
#include "tests/core/mesh/mesh_test_support.h"
#include "tests/support/shared_data.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

struct GltfFieldCase {
  const char* file;
  std::function<void(const test::ReadMesh& read)> judge;
};
void PrintTo(const GltfFieldCase& one, std::ostream* out) { *out << one.file; }

class GltfField : public testing::TestWithParam<GltfFieldCase> {};

TEST_P(GltfField, ComesOutAsItsReadmeSays) {
  const fs::path file = test::sharedData("../field") / GetParam().file;
  if (!fs::exists(file)) GTEST_SKIP() << "no field cases here: " << file;
  test::ReadMesh read;
  Result<Mesh> mesh = readMeshFile(file, {}, read.faults);
  ASSERT_TRUE(mesh.ok()) << mesh.error().text();
  read.mesh = std::move(*mesh);
  test::expectSound(read.mesh);
  GetParam().judge(read);
}

constexpr float kTexturedCorners[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};

Vec3 sizeOfField(const test::ReadMesh& read) { return read.mesh.bounds.max - read.mesh.bounds.min; }

/// The L of 1 x 0.9 x 0.3 m of these cases.
void isTheBracket(const test::ReadMesh& read) {
  EXPECT_EQ(read.mesh.triangleCount(), 24U);
  EXPECT_NEAR(sizeOfField(read).x, 1.0, 1e-6);
  EXPECT_NEAR(sizeOfField(read).y, 0.9, 1e-6);
  EXPECT_NEAR(sizeOfField(read).z, 0.3, 1e-6);
}

void isGreen(const test::ReadMesh& read) {
  isTheBracket(read);
  const Material& material = read.mesh.materials.at(read.mesh.parts.at(0).material);
  glm::vec4 color = material.diffuse;
  for (const std::uint32_t tint : read.mesh.colors) {
    EXPECT_EQ(tint, read.mesh.colors[0]);
    color = {static_cast<float>(tint >> 24U) / 255.0F,
             static_cast<float>(tint >> 16U & 255U) / 255.0F,
             static_cast<float>(tint >> 8U & 255U) / 255.0F, 1};
  }
  EXPECT_EQ(color, glm::vec4(0, 1, 0, 1));
}

void leavesOut(const test::ReadMesh& read, const std::string& what) {
  const bool is_named = std::ranges::any_of(
      read.faults, [&](const Finding& fault) { return fault.left_out == what; });
  EXPECT_TRUE(is_named) << what;
}

const Material& onlyMaterial(const test::ReadMesh& read) {
  return read.mesh.materials.at(read.mesh.parts.at(0).material);
}

/// The four corners' places in the picture, v down as glTF has it: top left, top right, bottom
/// left.
void isMapped(const test::ReadMesh& read, const glm::vec2& top_left, const glm::vec2& top_right,
              const glm::vec2& bottom_left) {
  const MapPlacing placing(onlyMaterial(read));
  for (const Vertex& vertex : read.mesh.vertices) {
    const bool left = vertex.position.x<0.5F, top = vertex.position.z> 0.5F;
    if (!left && !top) continue;
    const glm::vec2 wanted = left && top ? top_left : top ? top_right : bottom_left;
    const glm::vec2 at = placing.of(vertex.texture);
    EXPECT_NEAR(at.x, wanted.x, 1e-4);
    EXPECT_NEAR(1 - at.y, wanted.y, 1e-4);
  }
}

void hasAlpha(const test::ReadMesh& read, AlphaMode mode, float opacity) {
  EXPECT_EQ(onlyMaterial(read).alpha_mode, mode);
  EXPECT_NEAR(onlyMaterial(read).diffuse.a, opacity, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(
    Cases, GltfField,
    testing::Values(
        GltfFieldCase{"08-gltf-mirror-colours/c3b.glb", isGreen},
        GltfFieldCase{"08-gltf-mirror-colours/c4b.glb", isGreen},
        GltfFieldCase{"08-gltf-mirror-colours/c4h.glb", isGreen},
        GltfFieldCase{"08-gltf-mirror-colours/unlit.glb",
                      [](const auto& read) {
                        isGreen(read);
                        leavesOut(read, "extension `KHR_materials_unlit`");
                      }},
        GltfFieldCase{"08-gltf-mirror-colours/sg.glb",
                      [](const auto& read) {
                        isTheBracket(read);
                        EXPECT_EQ(onlyMaterial(read).diffuse, glm::vec4(1.0F));
                        leavesOut(read, "extension `KHR_materials_pbrSpecularGlossiness`");
                      }},
        GltfFieldCase{
            "08-gltf-mirror-colours/mirror.glb",
            [](const auto& read) {
              ASSERT_EQ(read.mesh.parts.size(), 3U);
              for (const MeshPart& part : read.mesh.parts) {
                double volume = 0;
                for (std::uint32_t i = 0; i < part.index_count; i += 3) {
                  const auto at = [&](std::uint32_t c) {
                    return Vec3(
                        read.mesh.vertices[read.mesh.indices[part.first_index + i + c]].position);
                  };
                  volume += dotOf(at(0), crossOf(at(1), at(2)));
                }
                EXPECT_GT(volume, 0) << part.group << " is turned inside out";
              }
            }},
        GltfFieldCase{"09-gltf-quantized/q.glb", isTheBracket},
        GltfFieldCase{"47-gltf-uris/bom.gltf", isTheBracket},
        GltfFieldCase{"47-gltf-uris/data.gltf", isTheBracket},
        GltfFieldCase{"47-gltf-uris/data2.gltf", isTheBracket},
        GltfFieldCase{"47-gltf-uris/noscene.glb", isTheBracket},
        GltfFieldCase{"47-gltf-uris/pct.gltf", isTheBracket},
        GltfFieldCase{"47-gltf-uris/strip.glb",
                      [](const auto& read) { EXPECT_EQ(read.mesh.triangleCount(), 2U); }},
        GltfFieldCase{"58-gltf-shared-accessor/shared.glb",
                      [](const auto& read) {
                        EXPECT_EQ(read.mesh.triangleCount(), 300U);
                        EXPECT_LE(read.mesh.vertices.size(), 900U);
                      }},
        GltfFieldCase{"59-gltf-texcoords/float.glb",
                      [](const auto& read) {
                        isMapped(read, {0, 0}, {1, 0}, {0, 1});
                      }},
        GltfFieldCase{"59-gltf-texcoords/ushort.glb",
                      [](const auto& read) {
                        isMapped(read, {0, 0}, {1, 0}, {0, 1});
                      }},
        GltfFieldCase{"59-gltf-texcoords/offset.glb",
                      [](const auto& read) {
                        isMapped(read, {.5, 0}, {1.5, 0}, {.5, 1});
                      }},
        GltfFieldCase{"59-gltf-texcoords/scale2.glb",
                      [](const auto& read) {
                        isMapped(read, {0, 0}, {2, 0}, {0, 2});
                      }},
        // Counter-clockwise on the picture: right becomes up.
        GltfFieldCase{"59-gltf-texcoords/rot90.glb",
                      [](const auto& read) {
                        isMapped(read, {0, 0}, {0, -1}, {1, 0});
                      }},
        GltfFieldCase{"59-gltf-texcoords/clamp.glb",
                      [](const auto& read) {
                        EXPECT_EQ(onlyMaterial(read).wrap_u, TextureWrap::clamp_to_edge);
                        EXPECT_EQ(onlyMaterial(read).wrap_v, TextureWrap::clamp_to_edge);
                      }},
        GltfFieldCase{
            "59-gltf-texcoords/repeat.glb",
            [](const auto& read) { EXPECT_EQ(onlyMaterial(read).wrap_u, TextureWrap::repeat); }},
        GltfFieldCase{"63-gltf-alpha-modes/default.glb",
                      [](const auto& read) { hasAlpha(read, AlphaMode::opaque, 1); }},
        GltfFieldCase{"63-gltf-alpha-modes/opaque.glb",
                      [](const auto& read) { hasAlpha(read, AlphaMode::opaque, 1); }},
        GltfFieldCase{"63-gltf-alpha-modes/mask.glb",
                      [](const auto& read) {
                        hasAlpha(read, AlphaMode::mask, 1);
                        EXPECT_EQ(onlyMaterial(read).alpha_cutoff, 0.5F);
                      }},
        GltfFieldCase{"63-gltf-alpha-modes/maskfactor0.glb",
                      [](const auto& read) { hasAlpha(read, AlphaMode::mask, 0); }},
        GltfFieldCase{"63-gltf-alpha-modes/maskfactor1.glb",
                      [](const auto& read) { hasAlpha(read, AlphaMode::mask, 0.7F); }},
        GltfFieldCase{"63-gltf-alpha-modes/blend.glb",
                      [](const auto& read) { hasAlpha(read, AlphaMode::blend, 1); }},
        GltfFieldCase{"63-gltf-alpha-modes/blendfactor.glb",
                      [](const auto& read) { hasAlpha(read, AlphaMode::blend, 0.3F); }},
        GltfFieldCase{"70-gltf-instancing-skin/plain.glb",
                      [](const auto& read) { EXPECT_EQ(read.mesh.parts.size(), 1U); }},
        GltfFieldCase{"70-gltf-instancing-skin/instanced.glb",
                      [](const auto& read) { EXPECT_EQ(read.mesh.parts.size(), 5U); }},
        GltfFieldCase{"70-gltf-instancing-skin/instanced-required.glb",
                      [](const auto& read) { EXPECT_EQ(read.mesh.parts.size(), 5U); }}),
    [](const auto& each) {
      std::string name = each.param.file;
      std::ranges::replace_if(
          name, [](char c) { return !(c >= '0' && c <= '9') && !(c >= 'a' && c <= 'z'); }, '_');
      return name;
    });

/// Case 42 has no glTF file: its PNG and JPEG pictures, named by one and inside one.
TEST(GltfFieldTextures, EveryPngAndJpegIsUsedByNameAndInsideTheFile) {
  const fs::path folder = test::sharedData("../field") / "42-textures";
  if (!fs::exists(folder)) GTEST_SKIP() << "no field cases here: " << folder;
  std::size_t pictures = 0;
  for (const auto& entry : fs::directory_iterator(folder / "tex")) {
    const std::string name = entry.path().filename().string();
    const bool is_png = name.ends_with(".png");
    if (!is_png && !name.ends_with(".jpg")) continue;
    ++pictures;
    const Result<Bytes> bytes = readWholeFile(entry.path(), std::uint64_t{1} << 20U);
    ASSERT_TRUE(bytes.ok());
    const std::string points = base64Of(std::as_bytes(std::span(kTexturedCorners)));
    const std::string inside =
        std::string("data:image/") + (is_png ? "png" : "jpeg") + ";base64," + base64Of(*bytes);
    for (const std::string& uri : {"tex/" + name, inside}) {
      SCOPED_TRACE(uri.substr(0, 20) + " " + name);
      const std::string text = fmt::format(
          R"({{"asset":{{"version":"2.0"}},"nodes":[{{"mesh":0}}],"scenes":[{{"nodes":[0]}}],
"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"material":0}}]}}],
"materials":[{{"pbrMetallicRoughness":{{"baseColorTexture":{{"index":0}},"metallicFactor":0}}}}],
"textures":[{{"source":0}}],"images":[{{"uri":"{}"}}],
"accessors":[{{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}}],
"bufferViews":[{{"buffer":0,"byteLength":36}}],
"buffers":[{{"byteLength":36,"uri":"data:application/octet-stream;base64,{}"}}]}})",
          uri, points);
      const test::ReadMesh read = test::readMesh(text, (folder / "all.gltf").string());
      EXPECT_THAT(read.faults, testing::IsEmpty());
      if (uri == inside) {
        ASSERT_NE(onlyMaterial(read).diffuse_bytes, nullptr);
        EXPECT_TRUE(*onlyMaterial(read).diffuse_bytes == *bytes);
      } else {
        EXPECT_TRUE(fs::equivalent(onlyMaterial(read).diffuse_map, entry.path()));
      }
    }
  }
  EXPECT_GE(pictures, 6U);
}

}  // namespace
}  // namespace rocinante
