#include "viewer/cull/draw_list.h"

#include <gtest/gtest.h>

#include "tests/viewer/support/test_scene.h"

namespace rocinante {
namespace {

using test::colored;
using test::squareMesh;
using test::TestCell;

Camera wideCamera() {
  CameraView view;
  view.eye = {0, -10, 0};
  view.target = {0, 0, 0};
  return Camera(view, 640, 480, ClipDepth::zero_to_one, 0);
}

std::vector<std::string> namesOf(const std::vector<DrawItem>& items, const PosedScene& scene) {
  std::vector<std::string> names;
  for (const DrawItem& item : items) names.push_back(scene.devices[item.device].name);
  return names;
}

struct Listed {
  std::vector<std::string> opaque, translucent;
};

Listed listOf(TestCell& cell, const std::vector<std::string>& hide = {},
              const std::vector<std::string>& show = {}) {
  const SceneCatalog catalog(cell.cell());
  const PosedScene scene = cell.scene();
  const DrawList list =
      makeDrawList(scene, catalog, *ViewChoice::make(hide, show), wideCamera(), {});
  return {namesOf(list.opaque, scene), namesOf(list.translucent, scene)};
}

using Names = std::vector<std::string>;

TEST(DrawList, TranslucentThingsComeFromBackToFront) {
  TestCell cell;
  cell.add("near", squareMesh(1), {0, -2, 0}, colored(1, 0, 0, 0.5F))
      .add("far", squareMesh(1), {0, 5, 0}, colored(0, 1, 0, 0.5F))
      .add("middle", squareMesh(1), {0, 0, 0}, colored(0, 0, 1, 0.5F))
      .add("solid", squareMesh(1), {0, 0, 1}, colored(0, 0, 1));
  const Listed list = listOf(cell);
  EXPECT_EQ(list.translucent, (Names{"far", "middle", "near"}));
  EXPECT_EQ(list.opaque, (Names{"solid"}));
}

TEST(DrawList, ATranslucentBoxComesAfterWhatItHoldsUnlessTheEyeIsInside) {
  const auto glass = colored(0.5F, 0.7F, 1, 0.3F);
  TestCell cell;
  cell.add("hall", boxMesh({6, 6, 6}), {0, 0, 0}, glass)
      .add("cabin", boxMesh({4, 4, 4}), {0, 0, 0}, glass)
      .add("far", boxMesh({1, 1, 1}), {0, 1, 0}, glass)
      .add("near", boxMesh({1, 1, 1}), {0, -1.4, 0}, glass)
      .add("beside", boxMesh({1, 1, 1}), {3.5, -1, 0}, glass);
  EXPECT_EQ(listOf(cell).translucent, (Names{"far", "beside", "near", "cabin", "hall"}));
  TestCell around;
  around.add("hall", boxMesh({30, 30, 30}), {0, 1, 0}, glass)
      .add("near", boxMesh({1, 1, 1}), {0, 0, 0}, glass);
  EXPECT_EQ(listOf(around).translucent, (Names{"hall", "near"}));
}

TEST(DrawList, EquallyFarTranslucentThingsKeepTheOrderOfTheCell) {
  TestCell cell;
  cell.add("b", squareMesh(1), {1, 0, 0}, colored(1, 0, 0, 0.5F))
      .add("a", squareMesh(1), {-1, 0, 0}, colored(0, 1, 0, 0.5F));
  EXPECT_EQ(listOf(cell).translucent, (Names{"b", "a"}));
}

TEST(DrawList, LeavesOutWhatIsBesideBehindOrInvisible) {
  TestCell cell;
  cell.add("seen", squareMesh(1), {0, 0, 0})
      .add("beside", squareMesh(1), {100, 0, 0})
      .add("behind", squareMesh(1), {0, -30, 0})
      .add("glass of nothing", squareMesh(1), {0, 0, 0}, colored(1, 1, 1, 0));
  const Listed list = listOf(cell);
  EXPECT_EQ(list.opaque, (Names{"seen"}));
  EXPECT_TRUE(list.translucent.empty());
}

TEST(DrawList, TheNearestChoiceOfTheViewerDecides) {
  TestCell cell;
  cell.cell().layers = {{"tanks", true}, {"walls", false}};
  cell.add("t1", squareMesh(1), {0, 0, 0}, {}, "tanks")
      .add("t2", squareMesh(1), {0, 0, 1}, {}, "tanks")
      .add("w", squareMesh(1), {0, 0, -1}, {}, "walls");
  EXPECT_EQ(listOf(cell).opaque, (Names{"t1", "t2"}));
  EXPECT_EQ(listOf(cell, {"layer/tanks"}).opaque, Names{});
  EXPECT_EQ(listOf(cell, {"layer/tanks"}, {"t2"}).opaque, (Names{"t2"}));
  EXPECT_EQ(listOf(cell, {"t2"}, {"t2/body"}).opaque, (Names{"t1", "t2"}));
  EXPECT_EQ(listOf(cell, {"t1/body"}, {"t1"}).opaque, (Names{"t2"}));
  EXPECT_EQ(listOf(cell, {}, {"layer/walls"}).opaque, (Names{"t1", "t2", "w"}));
  EXPECT_EQ(listOf(cell, {"t1"}, {"t1"}).opaque, (Names{"t2"}));
}

TEST(ViewChoice, RefusesWhatIsNoPath) {
  for (const char* path : {"", "/", "arm/", "/link", "layer", "layer/", "a%2", "a%zz"}) {
    SCOPED_TRACE(path);
    EXPECT_FALSE(ViewChoice::make({path}, {}).has_value());
  }
  EXPECT_TRUE(ViewChoice::make({"arm%20one/link%2F6"}, {"layer/x"}).has_value());
}

TEST(ViewChoice, BuiltInLayersShowUnlessHidden) {
  const auto choice = ViewChoice::make({"layer/labels"}, {});
  EXPECT_FALSE(choice->layerVisible("labels"));
  EXPECT_TRUE(choice->layerVisible("lines"));
}

TEST(DrawList, AColorThatWasSetReplacesMaterialAndTexture) {
  TestCell cell;
  Material material = colored(1, 0, 0);
  material.diffuse_map = "picture.png";
  cell.add("a", squareMesh(1), {0, 0, 0}, material);
  const SceneCatalog catalog(cell.cell());
  ASSERT_EQ(catalog.textures().size(), 1U);
  PosedScene scene = cell.scene();
  const auto listNow = [&] {
    return makeDrawList(scene, catalog, *ViewChoice::make({}, {}), wideCamera(), {});
  };
  EXPECT_EQ(listNow().opaque.at(0).texture, 0);
  scene.devices[0].link_color[0] = 0x0000FF80;
  const DrawList list = listNow();
  ASSERT_EQ(list.translucent.size(), 1U);
  EXPECT_EQ(list.translucent[0].texture, -1);
  EXPECT_FLOAT_EQ(list.translucent[0].diffuse.b, 1);
  EXPECT_FLOAT_EQ(list.translucent[0].diffuse.a, 128.0F / 255);
}

TEST(DrawList, APictureWithHolesMakesItsSurfaceTranslucent) {
  TestCell cell;
  Material material = colored(1, 1, 1);
  material.diffuse_map = "fence.png";
  cell.add("fence", squareMesh(1), {0, 0, 0}, material);
  const SceneCatalog catalog(cell.cell());
  const PosedScene scene = cell.scene();
  const auto choice = ViewChoice::make({}, {});
  EXPECT_EQ(makeDrawList(scene, catalog, *choice, wideCamera(), {0}).opaque.size(), 1U);
  EXPECT_EQ(makeDrawList(scene, catalog, *choice, wideCamera(), {1}).translucent.size(), 1U);
}

TEST(SceneCatalog, PutsOneSidedTrianglesLastInTheirPart) {
  Mesh mesh = squareMesh(2);
  // A back for the first triangle only: the same corners, the other way round.
  mesh.indices.insert(mesh.indices.end(), {0, 2, 1});
  mesh.parts.push_back({"back", 0, 6, 3});
  TestCell cell;
  cell.add("wall", mesh, {0, 0, 0});
  const SceneCatalog catalog(cell.cell());
  const CatalogMesh& known = catalog.meshes().at(0);
  EXPECT_EQ(known.indices(), (std::vector<std::uint32_t>{0, 2, 3, 0, 1, 2, 0, 2, 1}));
  EXPECT_EQ(known.parts[0].one_sided_count, 3U);
  EXPECT_EQ(known.parts[1].one_sided_count, 3U);
}

}  // namespace
}  // namespace rocinante
