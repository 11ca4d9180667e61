// PendingCommand devices and links first leaves out what asking every part leaves out, and nothing
// else.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <tuple>

#include "core/math/transform.h"
#include "tests/viewer/support/test_scene.h"
#include "viewer/cull/draw_list.h"

namespace rocinante {
namespace {

using test::colored;
using test::squareMesh;
using test::TestCell;

void expectSameItems(const std::vector<DrawItem>& a, const std::vector<DrawItem>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(std::tie(a[i].device, a[i].link, a[i].mesh, a[i].part),
              std::tie(b[i].device, b[i].link, b[i].mesh, b[i].part));
  }
}

/// A device of several links with several visuals each, none of them where its link is.
std::shared_ptr<const Model> scatteredModel(std::mt19937& random,
                                            const std::shared_ptr<const Mesh>& mesh) {
  std::uniform_real_distribution<double> far(-3, 3);
  auto model = std::make_shared<Model>();
  for (int l = 0; l < 4; ++l) {
    Link link;
    link.name = "link" + std::to_string(l);
    for (int v = 0; v < 3; ++v) {
      Visual visual;
      visual.mesh = mesh;
      visual.origin.position = {far(random), far(random), far(random)};
      visual.origin.orientation = quaternionFromRpy({far(random), far(random), far(random)});
      visual.scale = {far(random), far(random), far(random)};
      link.visuals.push_back(visual);
    }
    model->links.push_back(link);
  }
  return model;
}

TEST(Culling, ByDeviceGivesTheListOfByPart) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-12, 12);
  std::uniform_real_distribution<double> turn(-3, 3);
  Mesh mesh = squareMesh(1);
  mesh.parts = {{"a", 0, 0, 3}, {"b", 0, 3, 3}};
  const auto shared = std::make_shared<const Mesh>(std::move(mesh));
  Cell cell;
  for (int d = 0; d < 40; ++d) {
    CellDevice device;
    device.name = device.model = "d" + std::to_string(d);
    cell.models[device.name] = scatteredModel(random, shared);
    cell.devices.push_back(device);
  }
  const SceneCatalog catalog(cell);
  const auto choice = ViewChoice::make({}, {});
  const double bad[] = {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, -HUGE_VAL, 1e300,
                        1e-300};
  std::size_t seen = 0, left_out = 0;
  for (int round = 0; round < 400; ++round) {
    SCOPED_TRACE(round);
    PosedScene scene = poseScene(cell, SessionState{});
    for (PosedDevice& device : scene.devices) {
      for (Mat4& world : device.link_world) {
        world = matrixOf({{place(random), place(random), place(random)},
                          quaternionFromRpy({turn(random), turn(random), turn(random)})});
        if (round % 4 == 3 && random() % 8 == 0) {
          world[static_cast<int>(random() % 4)][static_cast<int>(random() % 3)] =
              bad[random() % std::size(bad)];
        }
      }
    }
    CameraView view;
    view.eye = {place(random), place(random), place(random)};
    view.target = {place(random), place(random), place(random)};
    view.fov_deg = 5 + 20 * std::abs(turn(random));
    if (round % 3 == 0) view.ortho_height_m = 1 + std::abs(place(random));
    const Camera camera(view, 640, 480, ClipDepth::zero_to_one, 100);
    const auto listOf = [&](Culling culling) {
      return makeDrawList(scene, catalog, *choice, camera, {}, {}, DrawnGeometry::visuals, {},
                          culling);
    };
    const DrawList fast = listOf(Culling::by_device);
    const DrawList slow = listOf(Culling::by_part);
    expectSameItems(fast.opaque, slow.opaque);
    EXPECT_EQ(fast.triangles, slow.triangles);
    if (HasFailure()) return;
    seen += slow.opaque.size();
    left_out += std::size_t{40} * 4 * 3 * 2 - slow.opaque.size();
  }
  EXPECT_GT(seen, 1000U);
  EXPECT_GT(left_out, 1000U);
}

TEST(Culling, TenThousandDevicesAreSortedByStateInTheOrderOfTheScene) {
  // Two that are small and look alike, one that is small and looks otherwise, and two that are not
  // small.
  Mesh large = squareMesh(0.1);
  large.vertices.resize(100, large.vertices.front());
  TestCell cell;
  const Material red = colored(1, 0, 0);
  cell.add("a", squareMesh(0.1), {0, 0, 0}, red).add("b", squareMesh(0.1), {0, 0, 0}, red);
  cell.add("c", squareMesh(0.1), {0, 0, 0}, colored(0, 0, 1));
  cell.add("d", large, {0, 0, 0}).add("e", large, {0, 0, 0});
  constexpr std::size_t kGroups[] = {2, 2, 3, 0, 1};  // in which they are drawn
  const std::vector<CellDevice> samples = cell.cell().devices;
  cell.cell().devices.clear();
  for (int i = 0; i < 10'000; ++i) {
    CellDevice device = samples[static_cast<std::size_t>(i) % samples.size()];
    device.name = "d" + std::to_string(i);
    device.pose.position = {i % 100 - 50.0, i / 100 * 1.0, 0};
    cell.cell().devices.push_back(device);
  }
  const PosedScene scene = cell.scene();
  const SceneCatalog catalog(cell.cell());
  CameraView view;
  view.eye = {0, -200, 0};
  view.target = {0, 0, 0};
  const Camera camera(view, 640, 480, ClipDepth::zero_to_one, 0);
  const DrawList list = makeDrawList(scene, catalog, *ViewChoice::make({}, {}), camera, {});
  ASSERT_EQ(list.opaque.size(), 10'000U);
  const auto place = [&](const DrawItem& item) {
    return std::pair(kGroups[item.device % samples.size()], item.device);
  };
  for (std::size_t i = 0; i + 1 < list.opaque.size(); ++i) {
    EXPECT_LT(place(list.opaque[i]), place(list.opaque[i + 1]));
  }
}

}  // namespace
}  // namespace rocinante
