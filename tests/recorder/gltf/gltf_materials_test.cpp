#include "recorder/gltf/gltf_materials.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/math/srgb.h"
#include "core/report/json_text.h"

namespace rocinante {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Json materialsOf(const GltfMaterials& materials) {
  Json document;
  materials.describe(document);
  return document;
}

std::shared_ptr<const Bytes> bytesPtr(std::string_view text) {
  const ByteView bytes = bytesOf(text);
  return std::make_shared<const Bytes>(bytes.begin(), bytes.end());
}

TEST(LinearOfSrgb, IsTurnedBack) {
  for (int level = 0; level < 256; ++level) {
    const double shown = level / 255.0;
    EXPECT_NEAR(srgbOfLinear(linearOfSrgb(shown)), shown, 1e-12);
  }
  EXPECT_NEAR(linearOfSrgb(0.5), 0.21404114, 1e-7);
}

TEST(GltfMaterials, EqualOnesAreShared) {
  GltfBinary binary;
  GltfMaterials materials(binary);
  Material red;
  red.diffuse = {1, 0, 0, 0.5F};
  EXPECT_EQ(materials.add(Material{}), 0U);
  EXPECT_EQ(materials.add(red), 1U);
  EXPECT_EQ(materials.add(Material{}), 0U);
  const Json document = materialsOf(materials);
  ASSERT_EQ(document["materials"].size(), 2U);
  EXPECT_EQ(document["materials"][1]["alphaMode"], "BLEND");
  EXPECT_EQ(document["materials"][1]["pbrMetallicRoughness"]["baseColorFactor"],
            Json::array({1.0, 0.0, 0.0, 0.5}));
  EXPECT_FALSE(document["materials"][0].contains("alphaMode"));
  EXPECT_EQ(document["materials"][0]["pbrMetallicRoughness"]["roughnessFactor"], 1.0);
  EXPECT_FALSE(document.contains("images"));
}

TEST(GltfMaterials, ImagesAreTakenAsTheyAre) {
  GltfBinary binary;
  GltfMaterials materials(binary);
  Material painted;
  painted.diffuse_map = "arm.glb#1";
  // IHDR of colour type 6: RGB and alpha.
  painted.diffuse_bytes =
      bytesPtr(std::string_view("\x89PNG\r\n\x1A\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\x08\x06\0\0\0", 29));
  Material same = painted;
  same.name = "other";
  EXPECT_TRUE(materials.hasImage(materials.add(painted)));
  EXPECT_TRUE(materials.hasImage(materials.add(same)));
  const Json document = materialsOf(materials);
  ASSERT_EQ(document["images"].size(), 1U);
  EXPECT_EQ(document["images"][0]["mimeType"], "image/png");
  EXPECT_EQ(document["materials"][1]["alphaMode"], "BLEND");
  EXPECT_EQ(binary.bytes(), 32U);
  EXPECT_THAT(materials.gaps(), IsEmpty());
}

TEST(GltfMaterials, AlphaModesAndWrapsAreWritten) {
  GltfBinary binary;
  GltfMaterials materials(binary);
  Material opaque;
  opaque.diffuse = {1, 1, 1, 0.25F};
  opaque.diffuse_map = "arm.glb#1";
  opaque.diffuse_bytes =
      bytesPtr(std::string_view("\x89PNG\r\n\x1A\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\x08\x06\0\0\0", 29));
  opaque.alpha_mode = AlphaMode::opaque;
  Material mask = opaque;
  mask.alpha_mode = AlphaMode::mask;
  mask.alpha_cutoff = 0.25F;
  mask.wrap_u = TextureWrap::clamp_to_edge;
  mask.wrap_v = TextureWrap::mirrored_repeat;
  materials.add(opaque);
  materials.add(mask);
  const Json document = materialsOf(materials);
  EXPECT_FALSE(document["materials"][0].contains("alphaMode"));
  EXPECT_EQ(document["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"][3], 1.0);
  EXPECT_EQ(document["materials"][1]["alphaMode"], "MASK");
  EXPECT_EQ(document["materials"][1]["alphaCutoff"], 0.25);
  EXPECT_EQ(document["images"].size(), 1U);
  ASSERT_EQ(document["textures"].size(), 2U);
  const Json& sampler = document["samplers"][document["textures"][1]["sampler"].get<std::size_t>()];
  EXPECT_EQ(sampler["wrapS"], 33071);
  EXPECT_EQ(sampler["wrapT"], 33648);
}

TEST(GltfMaterials, OtherImagesAreNamedOnce) {
  GltfBinary binary;
  GltfMaterials materials(binary);
  Material bitmap, again, missing;
  bitmap.diffuse_map = again.diffuse_map = "a.bmp";
  bitmap.diffuse_bytes = again.diffuse_bytes = bytesPtr("BM....");
  again.name = "again";
  missing.diffuse_map = "/nowhere/b.png";
  EXPECT_FALSE(materials.hasImage(materials.add(bitmap)));
  EXPECT_FALSE(materials.hasImage(materials.add(again)));
  EXPECT_FALSE(materials.hasImage(materials.add(missing)));
  EXPECT_THAT(materials.gaps(), ElementsAre("the image a.bmp is left out: glTF has PNG and JPEG",
                                            HasSubstr("the image /nowhere/b.png is left out: ")));
}

}  // namespace
}  // namespace rocinante
