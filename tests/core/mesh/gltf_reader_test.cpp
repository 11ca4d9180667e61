// glTF: what each core feature becomes, in the models of tests/golden/models/gltf, and that
// whatever is not used is named.

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "core/base/base64.h"
#include "core/mesh/mesh.h"
#include "tests/core/mesh/mesh_test_support.h"

namespace rocinante {
namespace {

using GltfText = nlohmann::json;
using test::expectSound;
using test::ReadMesh;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

GltfText gltfModel(const std::string& name) {
  std::ifstream file(std::string(ROCINANTE_MODELS_DIR) + "/gltf/" + name + ".gltf");
  std::stringstream text;
  text << file.rdbuf();
  GltfText json = GltfText::parse(text.str(), nullptr, false);
  EXPECT_FALSE(json.is_discarded()) << name;
  return json;
}

ReadMesh readGltfText(const GltfText& json) { return test::readMesh(json.dump(), "a.gltf"); }

std::string refusalOf(const GltfText& json) {
  Findings faults;
  const auto mesh = readMeshBytes(bytesOf(json.dump()), "a.gltf", {}, faults);
  return mesh.ok() ? "" : mesh.error().what;
}

/// "field `roughnessFactor`" of each thing left out.
std::vector<std::string> namesLeftOut(const Findings& faults) {
  std::vector<std::string> names;
  for (const Finding& fault : faults) {
    if (!fault.left_out.empty()) names.push_back(fault.left_out);
  }
  return names;
}

TEST(GltfModels, AreReadWithoutAFault) {
  for (const char* name : {"alpha-modes", "wraps", "transforms", "vertex-colours", "quantised",
                           "shared", "skin", "materials"}) {
    SCOPED_TRACE(name);
    const ReadMesh read = readGltfText(gltfModel(name));
    EXPECT_THAT(namesLeftOut(read.faults), IsEmpty());
    EXPECT_THAT(read.faults, IsEmpty());
    expectSound(read.mesh);
  }
}

TEST(GltfModels, AlphaModesComeAsTheyAreWritten) {
  const ReadMesh read = readGltfText(gltfModel("alpha-modes"));
  std::vector<std::string> modes;
  for (const Material& material : read.mesh.materials) {
    modes.push_back(fmt::format("{} {:.1f} {:.1f}", static_cast<int>(material.alpha_mode),
                                material.alpha_cutoff, material.diffuse.a));
  }
  // blend 0, opaque 1, mask 2. An opaque material's opacity is 1 whatever its factor.
  EXPECT_THAT(modes, ElementsAre("1 0.5 1.0", "1 0.5 1.0", "1 0.5 1.0", "2 0.5 1.0", "2 0.5 0.4",
                                 "2 0.2 1.0", "2 0.2 0.4", "0 0.5 1.0", "0 0.5 0.4"));
}

TEST(GltfModels, SamplersWrapAndOnePictureServesAll) {
  const ReadMesh read = readGltfText(gltfModel("wraps"));
  ASSERT_EQ(read.mesh.materials.size(), 4U);
  const auto& m = read.mesh.materials;
  EXPECT_EQ(m[0].wrap_u, TextureWrap::repeat);
  EXPECT_EQ(m[1].wrap_v, TextureWrap::mirrored_repeat);
  EXPECT_EQ(m[2].wrap_u, TextureWrap::clamp_to_edge);
  EXPECT_EQ(m[3].wrap_u, TextureWrap::repeat);
  EXPECT_EQ(m[3].wrap_v, TextureWrap::clamp_to_edge);
  for (const Material& material : m) {
    EXPECT_EQ(material.diffuse_map, "a.gltf#1");
    EXPECT_EQ(material.diffuse_bytes, m[0].diffuse_bytes) << "held once";
  }
}

TEST(GltfModels, TransformsOfTexturesAreThoseOfTheExtension) {
  const GltfText json = gltfModel("transforms");
  const ReadMesh read = readGltfText(json);
  ASSERT_EQ(read.mesh.materials.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const GltfText& given = json["materials"][i]["pbrMetallicRoughness"]["baseColorTexture"]
                                ["extensions"]["KHR_texture_transform"];
    const auto scale = given.value("scale", std::vector<double>{1, 1});
    const auto offset = given.value("offset", std::vector<double>{0, 0});
    const double angle = given.value("rotation", 0.0), s = std::sin(angle), c = std::cos(angle);
    for (const auto& [u, v] : {std::pair(0.0, 0.0), {1.0, 0.0}, {0.3, 0.9}}) {
      // KHR_texture_transform, v down, counter-clockwise as seen on the picture.
      const double x = c * scale[0] * u + s * scale[1] * v + offset[0];
      const double y = -s * scale[0] * u + c * scale[1] * v + offset[1];
      const glm::vec2 ours =
          MapPlacing(read.mesh.materials[i]).of({static_cast<float>(u), static_cast<float>(1 - v)});
      EXPECT_NEAR(ours.x, x, 1e-6) << i;
      EXPECT_NEAR(ours.y, 1 - y, 1e-6) << i;
    }
  }
}

TEST(GltfModels, NumbersOfEveryTypeAreTheSameColoursAndPlaces) {
  const ReadMesh read = readGltfText(gltfModel("vertex-colours"));
  ASSERT_EQ(read.mesh.vertices.size(), 16U);
  for (std::size_t i = 0; i < 16; ++i) {
    EXPECT_EQ(read.mesh.colors[i], read.mesh.colors[i % 4]) << "vertex " << i;
  }
  EXPECT_EQ(read.mesh.colors[0], 0xCA0000FFU);
  EXPECT_EQ(read.mesh.colors[3], 0xFFFFFFFFU);
  EXPECT_EQ(read.mesh.materials.back().diffuse, glm::vec4(1.0F)) << "the default is white";
}

TEST(GltfModels, AQuantisedBlockMeasuresAndIsMappedAsAnyOther) {
  const ReadMesh read = readGltfText(gltfModel("quantised"));
  const Vec3 size = read.mesh.bounds.max - read.mesh.bounds.min;
  EXPECT_NEAR(size.x, 1.0, 1e-6);
  EXPECT_NEAR(size.y, 0.4, 1e-6);  // z of the file
  EXPECT_NEAR(size.z, 0.7, 1e-6);
  for (const Vertex& vertex : read.mesh.vertices) {
    EXPECT_TRUE(vertex.texture.x == 0.0F || vertex.texture.x == 1.0F);
    EXPECT_NEAR(std::abs(vertex.normal.x) + std::abs(vertex.normal.y) + std::abs(vertex.normal.z),
                1, 1e-6);
  }
}

TEST(GltfModels, PartsTakeOnlyTheVerticesThatTheyUse) {
  const ReadMesh read = readGltfText(gltfModel("shared"));
  ASSERT_EQ(read.mesh.parts.size(), 5U);
  std::vector<std::uint32_t> triangles;
  for (const MeshPart& part : read.mesh.parts) triangles.push_back(part.index_count / 3);
  EXPECT_THAT(triangles, ElementsAre(3, 6, 7, 2, 2));
  EXPECT_EQ(read.mesh.vertices.size(), 7U + 8U + 9U + 4U + 6U);
  // Strips and fans face one way; sparse points are lifted towards the viewer, -y of ours.
  double lifted = 0;
  for (std::size_t i = 0; i < read.mesh.indices.size(); i += 3) {
    const Vec3 a(read.mesh.vertices[read.mesh.indices[i]].position);
    const Vec3 b(read.mesh.vertices[read.mesh.indices[i + 1]].position);
    const Vec3 c(read.mesh.vertices[read.mesh.indices[i + 2]].position);
    EXPECT_LT(crossOf(b - a, c - a).y, 0) << "triangle " << i / 3;
    lifted = std::min(lifted, a.y);
  }
  EXPECT_NEAR(lifted, -0.5, 1e-6);
}

TEST(GltfModels, ThreeHundredPartsOfOneAccessorHoldNineHundredVertices) {
  constexpr std::size_t kPoints = 100'000, kParts = 300;
  std::vector<float> points;
  for (std::size_t i = 0; i < kPoints; ++i) {
    points.insert(points.end(), {static_cast<float>(i % 317), static_cast<float>(i / 317), 0.0F});
  }
  std::vector<std::uint32_t> corners;
  GltfText json = gltfModel("materials");
  for (const char* key : {"materials", "textures", "images"}) json.erase(key);
  json["scenes"] = {{{"nodes", {0}}}};
  json["nodes"] = {{{"mesh", 0}}};
  json["bufferViews"] = {{{"buffer", 0}, {"byteLength", kPoints * 12}},
                         {{"buffer", 1}, {"byteLength", kParts * 12}}};
  json["accessors"] = {
      {{"bufferView", 0}, {"componentType", 5126}, {"count", kPoints}, {"type", "VEC3"}}};
  json["meshes"] = {{{"primitives", GltfText::array()}}};
  for (std::size_t i = 0; i < kParts; ++i) {
    const auto at = static_cast<std::uint32_t>(i * 318);
    corners.insert(corners.end(), {at, at + 1, at + 317});
    json["accessors"].push_back({{"bufferView", 1},
                                 {"byteOffset", i * 12},
                                 {"componentType", 5125},
                                 {"count", 3},
                                 {"type", "SCALAR"}});
    json["meshes"][0]["primitives"].push_back(
        {{"attributes", {{"POSITION", 0}}}, {"indices", i + 1}});
  }
  const auto uriOf = [](const auto& numbers) {
    return "data:application/octet-stream;base64," + base64Of(std::as_bytes(std::span(numbers)));
  };
  json["buffers"] = {{{"byteLength", kPoints * 12}, {"uri", uriOf(points)}},
                     {{"byteLength", kParts * 12}, {"uri", uriOf(corners)}}};
  const ReadMesh read = readGltfText(json);
  EXPECT_EQ(read.mesh.triangleCount(), kParts);
  EXPECT_EQ(read.mesh.vertices.size(), kParts * 3);
  EXPECT_LT(read.mesh.vertices.capacity() * sizeof(Vertex), 100'000U);
}

TEST(GltfModels, MirroredAndInstancedShapesKeepTheirOutside) {
  const ReadMesh read = readGltfText(gltfModel("nodes"));
  EXPECT_THAT(namesLeftOut(read.faults), ElementsAre("node `elsewhere`", "scene `other`"));
  std::vector<std::string> groups;
  for (const MeshPart& part : read.mesh.parts) {
    groups.push_back(part.group);
    double volume = 0;
    for (std::uint32_t i = 0; i < part.index_count; i += 3) {
      const auto at = [&](std::uint32_t corner) {
        return Vec3(read.mesh.vertices[read.mesh.indices[part.first_index + i + corner]].position);
      };
      volume += dotOf(at(0), crossOf(at(1), at(2)));
    }
    EXPECT_GT(volume, 0) << part.group;
  }
  EXPECT_THAT(groups,
              ElementsAre("plain", "turned", "by matrix", "instances", "instances", "instances"));
}

TEST(GltfModels, ASkinIsDrawnAtRestWhereItsJointsAre) {
  const ReadMesh read = readGltfText(gltfModel("skin"));
  EXPECT_NEAR(read.mesh.bounds.min.z, 0, 1e-6) << "of the joints; the mesh's own node is far away";
  // The upper metre leans to the left by 60 degrees: (-sin 60, cos 60), and 0.2 m to each side.
  EXPECT_NEAR(read.mesh.bounds.min.x, -std::sin(M_PI / 3) - 0.2 * std::cos(M_PI / 3), 1e-5);
  EXPECT_NEAR(read.mesh.bounds.max.z, 1.5 + 0.2 * std::sin(M_PI / 3), 1e-5);
}

TEST(GltfAccount, WhatIsNotUsedIsNamedOnceWithItsCount) {
  GltfText json = gltfModel("materials");
  json["animations"] = {{{"name", "wave"}}, {{"name", "walk"}}};
  json["cameras"] = {{{"type", "perspective"}}};
  json["extensionsUsed"] = {"KHR_lights_punctual", "KHR_materials_unlit"};
  json["extensions"]["KHR_lights_punctual"]["lights"] = GltfText::array();
  for (auto& material : json["materials"]) {
    material["normalTexture"]["index"] = 0;
    material["pbrMetallicRoughness"]["roughnessFactor"] = 0.5;
  }
  json["materials"][0]["extensions"]["KHR_materials_unlit"] = GltfText::object();
  json["meshes"][0]["primitives"][0]["targets"] = GltfText::array();
  json["meshes"][1]["primitives"][0]["mode"] = 1;
  json["samplers"] = {{{"magFilter", 9728}}};
  const ReadMesh read = readGltfText(json);
  EXPECT_THAT(
      namesLeftOut(read.faults),
      testing::UnorderedElementsAre("animation", "camera", "extension `KHR_lights_punctual`",
                                    "extension `KHR_materials_unlit`", "field `normalTexture`",
                                    "field `roughnessFactor`", "field `targets`",
                                    "primitive `lines`", "field `magFilter`"));
  for (const Finding& fault : read.faults) {
    EXPECT_EQ(fault.rule, "model.left-out");
    if (fault.left_out == "animation") {
      EXPECT_EQ(fault.count, 2U);
      EXPECT_EQ(fault.text, "animations[0]: animations are not played");
    }
    if (fault.left_out == "field `normalTexture`") {
      EXPECT_EQ(fault.count, 3U);
    }
  }
}

TEST(GltfAccount, RotationsOffUnitLengthAreNamed) {
  GltfText json = gltfModel("materials");
  GltfText& node = json["nodes"][0];
  node.erase("matrix");
  const auto said = [&](std::vector<double> turn) {
    node["rotation"] = std::move(turn);
    std::string text;
    for (const Finding& fault : readGltfText(json).faults) text += fault.print() + "\n";
    return text;
  };
  EXPECT_THAT(said({0, 0, 0, 1.0009}), testing::Not(testing::HasSubstr("`rotation`")));
  EXPECT_THAT(said({5, 6, 7, 8}),
              testing::HasSubstr("length `rotation` is left out: nodes[0]: it is off 1 by more "
                                 "than 0.001, and the quaternion is normalised"));
  EXPECT_THAT(said({0, 0, 0, 0}),
              testing::HasSubstr("length `rotation` is left out: nodes[0]: it is 0, which is no "
                                 "rotation"));
}

/// What came of a file: its picture's content and what was said.
std::string signatureOf(const GltfText& json) {
  Findings faults;
  const auto mesh = readMeshBytes(bytesOf(json.dump()), "a.gltf", {}, faults);
  if (!mesh.ok()) return "refused: " + mesh.error().what;
  std::string text;
  for (const Finding& fault : faults) text += fault.print() + "\n";
  const auto add = [&](const auto& values) {
    text.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0]));
  };
  add(mesh->vertices);
  add(mesh->indices);
  add(mesh->colors);
  for (const MeshPart& part : mesh->parts) {
    text += fmt::format("{} {} {}\n", part.group, part.material, part.index_count);
  }
  for (const Material& m : mesh->materials) {
    text += fmt::format("{} {} {} {} {} {} {} {} {}\n", m.name, m.diffuse.r, m.diffuse.g,
                        m.diffuse.b, m.diffuse.a, m.emission.g, m.diffuse_map.string(),
                        m.missing_map, m.alpha_cutoff);
    text += fmt::format("{} {} {} {} {} {} {}\n", m.map_scale.x, m.map_scale.y, m.map_offset.x,
                        m.map_rotation, static_cast<int>(m.wrap_u), static_cast<int>(m.wrap_v),
                        static_cast<int>(m.alpha_mode));
    if (m.diffuse_bytes) text += textOf(*m.diffuse_bytes);
  }
  return text;
}

/// Calls each(object) for every object of the document.
template <class Each>
void eachObject(GltfText& json, const Each& each) {
  if (json.is_object()) each(json);
  if (!json.is_structured()) return;
  for (auto& value : json) eachObject(value, each);
}

// DESIGN, section 3: insert something unknown or remove something used, and the output changes, or
// the account does.
TEST(GltfAccount, EveryMutationChangesTheMeshOrTheAccount) {
  // What is as good as not written: defaults, redundancies, and what glTF defines as ignorable.
  const std::set<std::string> harmless = {"min", "max", "extensionsUsed", "extensionsRequired",
                                          "byteOffset" /* the same numbers lie there */};
  std::size_t mutations = 0;
  for (const char* name : {"alpha-modes", "wraps", "transforms", "vertex-colours", "quantised",
                           "shared", "nodes", "skin", "materials"}) {
    GltfText json = gltfModel(name);
    const std::string before = signatureOf(json);
    eachObject(json, [&](GltfText& object) {
      object["unheard-of"] = 5;
      EXPECT_TRUE(signatureOf(json) != before) << name << ": in " << object.dump().substr(0, 200);
      object.erase("unheard-of");
      ++mutations;
      const GltfText whole = object;
      for (const auto& [key, value] : whole.items()) {
        const bool is_default = value == 0 || (key == "mode" && value == 4) ||
                                value == GltfText({1, 1, 1, 1}) ||
                                (key == "wrapS" && value == 10497);
        // A normal's length does not count.
        if (key == "normalized" && whole["componentType"] == 5120) continue;
        // Nothing is named by it, or moved: it has no mesh, is not drawn, or is bound to joints.
        const bool is_idle =
            (key == "name" && !whole.contains("mesh") && !whole.contains("nodes")) ||
            (key == "translation" &&
             (whole.contains("skin") || whole.value("name", "") == "elsewhere"));
        if (is_default || is_idle || harmless.contains(key)) continue;
        object.erase(key);
        EXPECT_TRUE(signatureOf(json) != before)
            << name << ": without " << key << " of " << whole.dump().substr(0, 200);
        object = whole;
        ++mutations;
      }
    });
  }
  EXPECT_GT(mutations, 1000U);
}

TEST(GltfGuard, RefusesWhatLeadsNowhere) {
  struct Change {
    const char* model;
    const char* pointer;
    GltfText value;
    const char* sentence;
  };
  for (const Change& change : {
           Change{"skin", "/nodes/0/skin", 4, "nodes[0]: `skin` is not an index into the 1 skins"},
           {"skin",
            "/skins/0/joints",
            {9},
            "skins[0]: holds something that is not an index into "
            "the 4 nodes"},
           {"skin", "/skins/0/inverseBindMatrices", 0,
            "skins[0]: `inverseBindMatrices` has the wrong type, or fewer than its joints"},
           {"nodes", "/nodes/4/extensions/EXT_mesh_gpu_instancing/attributes/SCALE", 0,
            "nodes[4]: the attributes of the instances differ in count"},
           {"shared", "/accessors/1/sparse/count", 99999999,
            "accessors[1]: `sparse` has no valid count or type"},
           {"transforms",
            "/materials/0/pbrMetallicRoughness/baseColorTexture/extensions/KHR_texture_transform/"
            "offset",
            {1},
            "materials[0]: a texture transform is not 2 numbers"},
           {"alpha-modes",
            "/materials/0/pbrMetallicRoughness/baseColorFactor",
            {1, 1, 1},
            "materials[0]: `baseColorFactor` is not 4 numbers"},
           {"materials", "/buffers/0/uri", "data:;base64,AAAA", "bytes, and has 3"},
           {"materials", "/buffers/0/uri", "data:text/plain,AAAA",
            "buffers[0]: its data URI is not base64"},
           {"materials",
            "/extensionsRequired",
            {"KHR_draco_mesh_compression"},
            "requires KHR_draco_mesh_compression, which is not read"},
       }) {
    SCOPED_TRACE(change.pointer);
    GltfText json = gltfModel(change.model);
    json[GltfText::json_pointer(change.pointer)] = change.value;
    EXPECT_THAT(refusalOf(json), HasSubstr(change.sentence));
  }
}

TEST(GltfGuard, NumbersOfStrangersEndInASentence) {
  // Indices beyond the accessor, bad values, a scene that names a node again and again.
  GltfText json = gltfModel("materials");
  json["scenes"][0]["nodes"] = GltfText::array();
  for (int i = 0; i < 1000; ++i) json["scenes"][0]["nodes"].push_back(0);
  EXPECT_EQ(readGltfText(json).mesh.parts.size(), 1U) << "a node is drawn once";
  json = gltfModel("materials");
  json["materials"][0]["alphaMode"] = "GLASS";
  json["materials"][1]["alphaMode"] = 5;
  json["samplers"] = {{{"wrapS", 1}}};
  json["textures"][0]["sampler"] = 0;
  EXPECT_THAT(namesLeftOut(readGltfText(json).faults),
              testing::IsSupersetOf({"value `GLASS`", "value `?`", "value `1`"}));
  json = gltfModel("shared");
  json["accessors"][0]["count"] = 20;  // of 35: what lies beyond is not there
  json["accessors"][1]["count"] = 35;
  const ReadMesh cut = readGltfText(json);
  EXPECT_THAT(cut.rules(), Contains("mesh.bad-triangle"));
  expectSound(cut.mesh);
}

}  // namespace
}  // namespace rocinante
