// Surfaces of several devices in one plane: the same one shows whatever trembles.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/math/transform.h"
#include "tests/viewer/support/test_scene.h"
#include "viewer/cull/coplanar_surfaces.h"
#include "viewer/gl/offscreen_context.h"
#include "viewer/render/renderer.h"

namespace rocinante {
namespace {

using test::colored;
using test::squareMesh;
using test::TestCell;

/// A square of n by n cells: corners that no other square has.
Mesh tiledSquare(double size, int n) {
  Mesh mesh = squareMesh(size);
  const Vertex corner = mesh.vertices[0];
  mesh.vertices.clear();
  mesh.indices.clear();
  for (int i = 0; i < (n + 1) * (n + 1); ++i) {
    Vertex vertex = corner;
    vertex.position.x = static_cast<float>(size * (i % (n + 1)) / n - size / 2);
    vertex.position.z = static_cast<float>(size * (i / (n + 1)) / n - size / 2);
    mesh.vertices.push_back(vertex);
  }
  for (int i = 0; i < n * n; ++i) {
    const auto a = static_cast<std::uint32_t>(i / n * (n + 1) + i % n);
    const auto up = a + static_cast<std::uint32_t>(n) + 1;
    for (const std::uint32_t index : {a, a + 1, up + 1, a, up + 1, up}) {
      mesh.indices.push_back(index);
    }
  }
  mesh.parts[0].index_count = static_cast<std::uint32_t>(mesh.indices.size());
  return mesh;
}

class Views {
 public:
  explicit Views(const Cell& cell) {
    auto context = makeOffscreenContext(Profile::reproducible);
    EXPECT_TRUE(context.has_value());
    context_ = std::move(*context);
    auto renderer = Renderer::create(*context_, cell, Profile::reproducible);
    EXPECT_TRUE(renderer.has_value());
    renderer_.emplace(std::move(*renderer));
    auto target = FrameBuffer::create(renderer_->gl(), 120, 80, 1);
    EXPECT_TRUE(target.has_value());
    target_.emplace(std::move(*target));
  }

  /// Pixels that are rather green than red.
  std::vector<bool> green(const PosedScene& scene, const CameraView& view,
                          const std::vector<std::string>& hide = {}) {
    std::vector<std::string> hidden = hide;
    hidden.push_back("layer/gnomon");
    const auto choice = ViewChoice::make(hidden, {});
    const SceneFrame frame{&scene, view, &*choice};
    EXPECT_TRUE(renderer_->draw(frame, *target_).has_value());
    target_->resolve();
    const Picture picture = target_->read();
    std::vector<bool> pixels;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
      pixels.push_back(picture.rgba[i + 1] > picture.rgba[i]);
    }
    return pixels;
  }

 private:
  std::unique_ptr<RenderContext> context_;
  std::optional<Renderer> renderer_;
  std::optional<FrameBuffer> target_;
};

CameraView viewFrom(const Vec3& eye, std::optional<double> ortho = {}) {
  CameraView view;
  view.eye = eye;
  view.target = {0, 0, 0};
  view.fov_deg = 600 / lengthOf(eye);
  view.ortho_height_m = ortho;
  return view;
}

std::vector<CameraView> manyViews() {
  return {viewFrom({2, -12, 3}),          viewFrom({2.01, -12, 3}),   viewFrom({30, -3, 8}),
          viewFrom({-300, -90, 40}),      viewFrom({900, -600, 100}), viewFrom({3, -12, 2}, 10.0),
          viewFrom({40, -4.001, 6}, 10.0)};
}

/// A wall and a smaller sign on it, its corners elsewhere; devices in either order.
TestCell wallAndSign(bool sign_first, const Vec3& at) {
  TestCell cell;
  for (const bool sign : {sign_first, !sign_first}) {
    cell.add(sign ? "sign" : "wall", sign ? tiledSquare(4, 5) : squareMesh(9), at,
             sign ? colored(0, 1, 0) : colored(1, 0, 0));
  }
  return cell;
}

TEST(CoplanarItems, ASignShowsOnItsWallWhateverTremblesAndInWhicheverOrder) {
  for (const bool sign_first : {false, true}) {
    TestCell cell = wallAndSign(sign_first, {0, 0, 0});
    PosedScene scene = cell.scene();
    Views views(cell.cell());
    for (const double off : {0.0, 4e-5, -4e-5}) {
      Mat4& world = scene.devices[sign_first ? 0 : 1].link_world[0];
      world = translationMatrix({0.3, off, -0.2}) * matrixOf({{}, quaternionFromRpy({0, 0.6, 0})});
      for (const CameraView& view : manyViews()) {
        const auto alone = views.green(scene, view, {"wall"});
        EXPECT_GT(std::count(alone.begin(), alone.end(), true), 20);
        EXPECT_TRUE(views.green(scene, view) == alone)
            << view.eye.x << " " << off << " " << sign_first;
      }
    }
    // Where it stands clearly behind, it is hidden.
    scene.devices[sign_first ? 0 : 1].link_world[0] = translationMatrix({0.3, 0.05, -0.2});
    const auto hidden = views.green(scene, manyViews()[0]);
    EXPECT_EQ(std::count(hidden.begin(), hidden.end(), true), 0);
  }
}

TEST(CoplanarItems, AHundredKilometresFromTheOriginToo) {
  const Vec3 at(1e5, -7e4, 1e3);
  TestCell cell = wallAndSign(true, at);
  const PosedScene scene = cell.scene();
  Views views(cell.cell());
  for (CameraView view : manyViews()) {
    view.eye += at;
    view.target += at;
    EXPECT_TRUE(views.green(scene, view) == views.green(scene, view, {"wall"}));
  }
}

TEST(CoplanarItems, OfTwoThatAreEqualTheLaterNameShows) {
  for (const bool green_first : {false, true}) {
    TestCell cell;
    for (const bool green : {green_first, !green_first}) {
      cell.add(green ? "b" : "a", squareMesh(4), {0, 0, 0},
               green ? colored(0, 1, 0) : colored(1, 0, 0));
    }
    const PosedScene scene = cell.scene();
    Views views(cell.cell());
    for (const CameraView& view : manyViews()) {
      EXPECT_TRUE(views.green(scene, view) == views.green(scene, view, {"a"}));
    }
  }
}

DrawList listOf(const PosedScene& scene, const SceneCatalog& catalog, const Camera& camera) {
  DrawList list = makeDrawList(scene, catalog, ViewChoice(), camera, {});
  liftCoplanarItems(std::vector{LiftedList{&list, &catalog}}, scene, camera);
  return list;
}

std::uint32_t mostRank(TestCell& cell) {
  const SceneCatalog catalog(cell.cell());
  const Camera camera(viewFrom({2, -12, 3}), 120, 80, ClipDepth::zero_to_one, 0);
  std::uint32_t most = 0;
  for (const DrawItem& item : listOf(cell.scene(), catalog, camera).opaque) {
    most = std::max(most, item.coplanar_rank);
  }
  return most;
}

TEST(CoplanarItems, NothingIsLiftedThatLiesOnNothing) {
  TestCell apart, touching, beside, alike, stacked;
  const auto red = colored(1, 0, 0);
  apart.add("a", squareMesh(4), {0, 0, 0}, red).add("b", squareMesh(2), {0, 0.01, 0});
  EXPECT_EQ(mostRank(apart), 0U);
  // Solids that stand on one another, and tiles side by side.
  touching.add("a", boxMesh({2, 2, 2}), {0, 0, 0}, red).add("b", boxMesh({1, 1, 1}), {0, 0, 1.5});
  EXPECT_EQ(mostRank(touching), 0U);
  beside.add("a", squareMesh(4), {0, 0, 0}, red).add("b", squareMesh(4), {4, 0, 0});
  EXPECT_EQ(mostRank(beside), 0U);
  alike.add("a", squareMesh(4), {0, 0, 0}, red).add("b", squareMesh(2), {0, 0, 0}, red);
  EXPECT_EQ(mostRank(alike), 0U);
  for (int i = 0; i < 20; ++i) {
    const auto shade = static_cast<float>(i) / 20;
    stacked.add("s" + std::to_string(i), squareMesh(9 - i * 0.2), {0, 0, 0}, colored(shade, 0, 1));
  }
  EXPECT_EQ(mostRank(stacked), 15U) << "ranks are bounded";
}

}  // namespace
}  // namespace rocinante
