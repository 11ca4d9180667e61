// Forward kinematics in pictures: each link of each real robot, drawn alone, covers the pixels that
// projecting its own vertices predicts, in every pose.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/math/transform.h"
#include "tests/viewer/proof/real_machines.h"
#include "viewer/view/camera_choice.h"

namespace rocinante {
namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 240;

struct PixelRange {
  double left = 1e9, top = 1e9, right = -1e9, bottom = -1e9;
  bool empty() const { return left > right; }
};

/// Where the vertices of a link's visuals lie in the picture, clipped to it.
PixelRange predicted(const PosedDevice& device, std::size_t link, const Camera& camera) {
  PixelRange range;
  for (const Visual& visual : device.model->links[link].visuals) {
    if (!visual.mesh) continue;
    const Mat4 world =
        device.link_world[link] * matrixOf(visual.origin) * scaleMatrix(visual.scale);
    for (const std::uint32_t index : visual.mesh->indices) {
      const Vec3 vertex(visual.mesh->vertices[index].position);
      const Vec4 clip = camera.clipOf(transformPoint(world, vertex));
      const double x = (clip.x / clip.w + 1) / 2 * kWidth;
      const double y = (1 - clip.y / clip.w) / 2 * kHeight;
      range.left = std::min(range.left, x);
      range.right = std::max(range.right, x);
      range.top = std::min(range.top, y);
      range.bottom = std::max(range.bottom, y);
    }
  }
  range.left = std::max(range.left, 0.0);
  range.top = std::max(range.top, 0.0);
  range.right = std::min(range.right, static_cast<double>(kWidth));
  range.bottom = std::min(range.bottom, static_cast<double>(kHeight));
  return range;
}

/// All that is drawn but one link.
std::vector<std::string> allLinksBut(const PosedDevice& device, std::size_t link) {
  std::vector<std::string> paths;
  for (std::size_t other = 0; other < device.model->links.size(); ++other) {
    if (other != link) paths.push_back(device.name + "/" + device.model->links[other].name);
  }
  return paths;
}

class PicturedLinks : public testing::TestWithParam<std::string> {};

TEST_P(PicturedLinks, CoverThePixelsThatTheirVerticesPredict) {
  const auto& machines = test::realMachines();
  const auto machine = std::find_if(machines.begin(), machines.end(),
                                    [](const auto& each) { return each.name == GetParam(); });
  ROCINANTE_NEEDS_SHARED_DATA(machine->folder);
  const test::TemporaryFolder folder;
  auto maker = test::makerOf(*machine, folder);
  ASSERT_TRUE(maker.has_value()) << maker.error().text();
  std::size_t judged = 0;
  for (std::size_t pose = 0; pose < machine->poses.size(); ++pose) {
    FrameRequest request;
    request.time = test::sessionTime(static_cast<std::int64_t>(pose) * 1000);
    request.width = kWidth;
    request.height = kHeight;
    request.samples = 1;
    request.camera = "near";
    const auto state = maker->session()->stateAt(request.time);
    ASSERT_TRUE(state.has_value()) << state.error().text();
    const PosedScene scene = poseScene(maker->cell(), **state);
    const PosedDevice& device = scene.devices.front();
    const Camera camera(viewOf(*scene.findCamera("near")), kWidth, kHeight, ClipDepth::zero_to_one,
                        100);
    for (std::size_t link = 0; link < device.model->links.size(); ++link) {
      const PixelRange wanted = predicted(device, link, camera);
      if (wanted.empty()) continue;
      SCOPED_TRACE(fmt::format("{} at pose {}", device.model->links[link].name, pose));
      request.hide = allLinksBut(device, link);
      const auto drawn = maker->identity(request);
      ASSERT_TRUE(drawn.has_value()) << drawn.error().text();
      ASSERT_EQ(drawn->names.size(), 1U);
      EXPECT_EQ(drawn->names[0], (IdentityName{device.name, device.model->links[link].name}));
      const IdentityExtent found = extentsOf(*drawn)[0];
      // A pixel counts when its centre does, so that a thin tip may fall between centres.
      EXPECT_NEAR(found.left, wanted.left, 1.6);
      EXPECT_NEAR(found.right, wanted.right, 1.6);
      EXPECT_NEAR(found.top, wanted.top, 1.6);
      EXPECT_NEAR(found.bottom, wanted.bottom, 1.6);
      EXPECT_GT(found.pixels, 3U);
      ++judged;
    }
  }
  EXPECT_GE(judged, machine->poses.size() * 6);
}

INSTANTIATE_TEST_SUITE_P(Robots, PicturedLinks, testing::Values("puma", "kuka", "panda", "r2d2"),
                         [](const auto& robot) { return robot.param; });

}  // namespace
}  // namespace rocinante
