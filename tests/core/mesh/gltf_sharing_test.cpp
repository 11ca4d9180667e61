// glTF: bytes that are changed by a sparse accessor, or shared by many users, are read within their
// bounds and once.

#include <array>
#include <cstring>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/base/base64.h"
#include "core/mesh/gltf_document.h"
#include "tests/core/mesh/mesh_test_support.h"

namespace rocinante {
namespace {

using nlohmann::json;
using test::ReadMesh;
using ::testing::ElementsAre;

/// tests/golden/models/gltf/shared.gltf, whose accessor 1 changes four elements of accessor 0.
json sharedModel() {
  std::ifstream file(std::string(ROCINANTE_MODELS_DIR) + "/gltf/shared.gltf");
  std::stringstream text;
  text << file.rdbuf();
  return json::parse(text.str(), nullptr, false);
}

ReadMesh readJson(const json& model) { return test::readMesh(model.dump(), "a.gltf"); }

std::string toldOfJson(const json& model) {
  Findings faults;
  const auto mesh = readMeshBytes(bytesOf(model.dump()), "a.gltf", {}, faults);
  return test::told(mesh, faults);
}

const ResolveFile kNoFiles = [](const std::string&, const std::filesystem::path&) {
  return FoundFile{};
};

template <class Numbers>
std::string uriOf(const Numbers& numbers) {
  return "data:application/octet-stream;base64," + base64Of(std::as_bytes(std::span(numbers)));
}

/// Adds a buffer with these bytes, and returns the number of the view of it.
template <class Numbers>
std::size_t addView(json& model, const Numbers& numbers) {
  const std::size_t bytes = std::as_bytes(std::span(numbers)).size();
  model["buffers"].push_back({{"byteLength", bytes}, {"uri", uriOf(numbers)}});
  model["bufferViews"].push_back({{"buffer", model["buffers"].size() - 1}, {"byteLength", bytes}});
  return model["bufferViews"].size() - 1;
}

TEST(GltfSparse, IndicesOfEveryTypeChangeTheSameElements) {
  const json model = sharedModel();
  const std::string whole = toldOfJson(model);
  const std::string text = model.dump();
  const auto document = openGltf(bytesOf(text), "a.gltf", kNoFiles);
  ASSERT_TRUE(document.ok());
  // The four changed elements, from the file's own list of shorts.
  std::array<std::uint8_t, 4> bytes{};
  std::array<std::uint32_t, 4> words{};
  const ByteView shorts = document->buffers[0].subspan(420, 8);
  for (std::size_t i = 0; i < 4; ++i) {
    bytes[i] = static_cast<std::uint8_t>(shorts[2 * i]);
    words[i] = bytes[i];
  }
  // 5120, a signed byte, is not allowed here, but has one byte and no more: the last bytes of their
  // buffer, beyond which nothing is read.
  for (const auto& [type, view_of] :
       {std::pair<int, int>{5120, 0}, {5121, 0}, {5125, 1}, {5126, 1}}) {
    SCOPED_TRACE(type);
    json changed = model;
    const std::size_t view = view_of == 0 ? addView(changed, bytes) : addView(changed, words);
    changed["accessors"][1]["sparse"]["indices"] = {{"bufferView", view}, {"componentType", type}};
    EXPECT_EQ(toldOfJson(changed), whole);
  }
}

TEST(GltfSparse, ChangesAreFoundOnceForAllWhoUseThem) {
  const std::string text = sharedModel().dump();
  const auto document = openGltf(bytesOf(text), "a.gltf", kNoFiles);
  ASSERT_TRUE(document.ok());
  const GltfAccessor first(*document, 1), second(*document, 1), base(*document, 0);
  ASSERT_EQ(document->changes.size(), 1U);
  ASSERT_NE(document->changes.at(1), nullptr);
  EXPECT_EQ(document->changes.at(1)->size(), 4U);
  EXPECT_EQ(document->changes.at(1).use_count(), 3) << "the document's and two accessors'";
  std::vector<std::size_t> changed;
  for (std::size_t i = 0; i < base.count(); ++i) {
    EXPECT_EQ(first.number(i, 2), second.number(i, 2));
    if (first.number(i, 2) != base.number(i, 2)) changed.push_back(i);
  }
  EXPECT_THAT(changed, ElementsAre(26, 27, 33, 34));
}

TEST(GltfSparse, WithoutABufferViewTheRestIsZero) {
  json model = sharedModel();
  model["accessors"][1].erase("bufferView");
  const std::string text = model.dump();
  const auto document = openGltf(bytesOf(text), "a.gltf", kNoFiles);
  ASSERT_TRUE(document.ok());
  const GltfAccessor zeros(*document, 1);
  EXPECT_TRUE(zeros.hasBytes());
  EXPECT_EQ(zeros.number(0, 0), 0);
  EXPECT_EQ(zeros.number(1, 0), 0);
  EXPECT_NE(zeros.number(26, 2), 0);
  // Elements that no byte of the file stands for.
  model["accessors"][1]["count"] = (1U << 20) + 1;
  Findings faults;
  const auto refused = readMeshBytes(bytesOf(model.dump()), "a.gltf", {}, faults);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().what,
            "accessors[1]: has 1048577 elements without bytes, and 1048576 are read");
}

TEST(GltfPictures, ThoseThatOverlapTakeNoMoreThanTheirBuffer) {
  json model = sharedModel();
  const std::vector<char> picture(3000, 'x');
  const std::size_t view = addView(model, picture);
  constexpr std::size_t kPictures = 400;
  for (std::size_t i = 0; i < kPictures; ++i) {
    if (i > 0) model["bufferViews"].push_back(model["bufferViews"][view]);
    model["images"].push_back({{"bufferView", view + i}, {"mimeType", "image/png"}});
    model["textures"].push_back({{"source", i}});
    model["materials"].push_back(
        {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", i}}}}}});
  }
  const ReadMesh read = readJson(model);
  std::size_t held = 0;
  for (const Material& material : read.mesh.materials) {
    if (material.diffuse_bytes != nullptr) held += material.diffuse_bytes->size();
  }
  EXPECT_GE(held, picture.size()) << "the first one is read";
  EXPECT_LE(held, picture.size() + 1000U) << "not more than all buffers together";
  EXPECT_THAT(read.rules(), ::testing::Contains("mesh.missing-texture"));
}

TEST(GltfReader, ACornerBeyondThePlanetsCostsItsTriangle) {
  for (const float far : {2e13F, -3e38F, std::numeric_limits<float>::infinity()}) {
    json model = sharedModel();
    const std::array<float, 9> points{0, 0, 0, 1, 0, 0, 0, far, 0};
    const std::size_t view = addView(model, points);
    model["accessors"].push_back(
        {{"bufferView", view}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}});
    model["meshes"][0]["primitives"].push_back(
        {{"attributes", {{"POSITION", model["accessors"].size() - 1}}}});
    const ReadMesh read = readJson(model);
    EXPECT_THAT(read.rules(), ElementsAre("mesh.bad-triangle"));
    EXPECT_EQ(read.mesh.parts.size(), 5U);
    EXPECT_LT(read.mesh.bounds.max.z, 10) << "the picture's scale is that of the rest";
  }
}

}  // namespace
}  // namespace rocinante
