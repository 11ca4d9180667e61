// What is drawn as one has the bits of what is drawn one by one.
#include "viewer/passes/item_batch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/math/transform.h"
#include "core/mesh/mesh_builder.h"
#include "tests/viewer/support/test_scene.h"
#include "viewer/gl/frame_buffer.h"
#include "viewer/gl/inputs_hash.h"
#include "viewer/gl/offscreen_context.h"
#include "viewer/gl/render_context.h"
#include "viewer/overlay/text_atlas.h"
#include "viewer/passes/draw_passes.h"

namespace rocinante {
namespace {

using test::colored;
using test::squareMesh;

/// A closed body of five sides, so that some of its triangles are culled.
Mesh pyramidMesh(float half) {
  Mesh mesh;
  const glm::vec3 tip(0, 0, half * 2);
  const glm::vec3 corners[] = {
      {-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}};
  const auto triangle = [&](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::vec3 normal = glm::normalize(glm::cross(b - a, c - a));
    for (const glm::vec3& at : {a, b, c}) {
      mesh.indices.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
      mesh.vertices.push_back({at, normal, {0, 0}});
      mesh.bounds.add(Vec3(at));
    }
  };
  for (int i = 0; i < 4; ++i) triangle(corners[i], corners[(i + 1) % 4], tip);
  triangle(corners[0], corners[2], corners[1]);
  triangle(corners[0], corners[3], corners[2]);
  mesh.parts = {{"pyramid", 0, 0, static_cast<std::uint32_t>(mesh.indices.size())}};
  mesh.materials = {Material{}};
  return mesh;
}

/// Three hundred links of pyramids and squares in three looks, turned, stretched and mirrored,
/// around a place a kilometre from the origin.
std::shared_ptr<const Model> crowd(std::mt19937& random) {
  std::uniform_real_distribution<double> far(-3, 3);
  const std::shared_ptr<const Mesh> meshes[] = {std::make_shared<const Mesh>(pyramidMesh(0.3F)),
                                                std::make_shared<const Mesh>(pyramidMesh(0.5F)),
                                                std::make_shared<const Mesh>(squareMesh(0.7))};
  Material shiny = colored(0.7F, 0.2F, 0.1F);
  shiny.specular = {0.5F, 0.5F, 0.5F};
  shiny.shininess = 40;
  auto model = std::make_shared<Model>();
  for (int i = 0; i < 300; ++i) {
    Link link;
    link.name = "link" + std::to_string(i);
    Visual visual;
    visual.mesh = meshes[random() % 3];
    if (i % 3 > 0) visual.material = i % 3 == 1 ? shiny : colored(0.1F, 0.4F, 0.6F);
    visual.origin.position = {1000 + far(random), far(random), far(random)};
    visual.origin.orientation = quaternionFromRpy({far(random), far(random), far(random)});
    visual.scale = {far(random), far(random), far(random)};
    link.visuals.push_back(visual);
    model->links.push_back(link);
  }
  return model;
}

TEST(ItemBatch, HasTheBitsOfItemsDrawnOneByOne) {
  const auto context = makeOffscreenContext(Profile::reproducible);
  ASSERT_TRUE(context.has_value());
  const auto gl = fillGlTable([&](const char* name) { return (*context)->procAddress(name); });
  ASSERT_TRUE(gl.has_value());
  std::mt19937 random(7);
  Cell cell;
  cell.models["crowd"] = crowd(random);
  CellDevice& device = cell.devices.emplace_back();
  device.name = device.model = "crowd";
  DrawPasses passes(*gl);
  InputsHash inputs;
  const SceneCatalog catalog(cell);
  const MeshBuffers meshes(*gl, catalog, inputs);
  const TextureStore textures(*gl, catalog.textures(), Profile::reproducible, inputs);
  const auto target = FrameBuffer::create(*gl, 160, 120, 4);
  ASSERT_TRUE(target.has_value());
  const auto choice = ViewChoice::make({}, {});
  PosedScene scene = poseScene(cell, SessionState{});
  // One is nowhere: it must spoil no other.
  scene.devices[0].link_world[5][3][0] = std::numeric_limits<double>::infinity();

  for (const bool orthographic : {false, true}) {
    CameraView view;
    view.eye = {1000, -8, 2};
    view.target = {1000, 0, 0};
    if (orthographic) view.ortho_height_m = 6;
    const Camera camera(view, 160, 120, passes.clipDepth(), 50);
    DrawList list = makeDrawList(scene, catalog, *choice, camera, {});
    ASSERT_GT(ItemBatch::reach(list.opaque, catalog), ItemBatch::kLeastItems);
    for (const Shading shading : {Shading::standard, Shading::plain}) {
      SurfaceLook surfaces;
      surfaces.shading = shading;
      const auto drawn = [&] {
        EXPECT_TRUE(passes.prepare(surfaces, cell.scene).has_value());
        target->bind();
        passes.begin(cell.scene, {0, 0, 160, 120}, 120);
        passes.scene.drawOpaque(list, catalog, meshes, textures, camera, cell.scene, surfaces);
        passes.end();
        target->resolve();
        return target->read();
      };
      for (DrawItem& item : list.opaque) item.batched = true;
      const Picture as_one = drawn();
      for (DrawItem& item : list.opaque) item.batched = false;
      EXPECT_EQ(ItemBatch::reach(list.opaque, catalog), 0U);
      EXPECT_EQ(as_one.rgba, drawn().rgba) << orthographic;
      EXPECT_EQ((*gl).GetError(), static_cast<GLenum>(GL_NO_ERROR));
    }
  }
}

TEST(ItemBatch, EndsWhereLooksSidesOrLiftsChange) {
  std::mt19937 random(1);
  Cell cell;
  cell.models["crowd"] = crowd(random);
  const SceneCatalog catalog(cell);
  const Material material = colored(1, 0, 0);
  DrawItem item;
  item.batched = true;
  item.material = &material;
  std::vector<DrawItem> items(6, item);
  EXPECT_EQ(ItemBatch::reach(items, catalog), 6U);
  const auto reachWith = [&](const auto& change) {
    std::vector<DrawItem> changed = items;
    change(changed[4]);
    return ItemBatch::reach(changed, catalog);
  };
  const Material equal = material;
  EXPECT_EQ(reachWith([&](DrawItem& one) { one.material = &equal; }), 6U);
  Material emits = material;
  emits.emission = {1, 0, 0};
  EXPECT_EQ(reachWith([&](DrawItem& one) { one.material = &emits; }), 4U);
  EXPECT_EQ(reachWith([](DrawItem& one) { one.diffuse.g = 1; }), 4U);
  EXPECT_EQ(reachWith([](DrawItem& one) { one.coplanar_rank = 1; }), 4U);
  EXPECT_EQ(reachWith([](DrawItem& one) { one.lift_units = 1; }), 4U);
  EXPECT_EQ(reachWith([](DrawItem& one) { one.batched = false; }), 4U);
  const auto one_sided = [&](const DrawItem& one) {
    return catalog.meshes()[one.mesh].parts[0].one_sided_count > 0;
  };
  for (std::uint32_t mesh = 0; mesh < catalog.meshes().size(); ++mesh) {
    DrawItem other = item;
    other.mesh = mesh;
    const std::size_t expected = one_sided(other) == one_sided(item) ? 6 : 4;
    EXPECT_EQ(reachWith([&](DrawItem& one) { one.mesh = mesh; }), expected) << mesh;
  }
  EXPECT_EQ(reachWith([](DrawItem& one) { one.mirrored = true; }), one_sided(item) ? 4U : 6U);
  EXPECT_EQ(ItemBatch::reach({}, catalog), 0U);
}

}  // namespace
}  // namespace rocinante
