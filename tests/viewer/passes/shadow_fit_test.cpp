#include "viewer/passes/shadow_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math/transform.h"

namespace rocinante {
namespace {

std::vector<Vec3> box(const Vec3& center, double half) {
  std::vector<Vec3> corners;
  for (const double x : {-half, half}) {
    for (const double y : {-half, half}) {
      for (const double z : {-half, half}) corners.push_back(center + Vec3(x, y, z));
    }
  }
  return corners;
}

constexpr Vec3 kLight{0.4, -0.5, 0.8};

TEST(ShadowFit, HoldsEveryCornerWithRoomForTheFilter) {
  for (const double half : {0.001, 0.4, 1.0, 37.0, 4000.0}) {
    for (const Vec3& light : {kLight, Vec3(0, 0, 1), Vec3(0, 0, -2), Vec3(1, 0, 0)}) {
      const auto corners = box({half * 3, -half, half / 2}, half);
      const ShadowFit fit = shadowFit(corners, light, 2048);
      const Camera camera(fit.view, 2048, 2048, ClipDepth::zero_to_one, fit.reach_m);
      for (const Vec3& corner : corners) {
        const Vec4 clip = camera.clipOf(corner);
        EXPECT_LT(std::abs(clip.x), 1 - 4.0 / 2048);
        EXPECT_LT(std::abs(clip.y), 1 - 4.0 / 2048);
        EXPECT_TRUE(clip.z > 0 && clip.z < 1) << clip.z;
      }
      EXPECT_LT(fit.view.ortho_height_m.value(), half * 5.5) << "not much larger than need be";
    }
  }
}

// What swims is a texel's edge that passes over a surface: it never does, because a map moves by
// whole texels and its texels change size only when the scene grows by a quarter.
TEST(ShadowFit, MovesByWholeTexels) {
  const ShadowFit before = shadowFit(box({0, 0, 0}, 1.4), kLight, 2048);
  int same_size = 0;
  for (int i = 1; i <= 50; ++i) {
    const double moved = i * 0.0137;
    const ShadowFit fit = shadowFit(box({moved, moved / 3, 0}, 1.4 + moved / 1000), kLight, 2048);
    if (fit.texel_m != before.texel_m) continue;
    ++same_size;
    const Camera camera(before.view, 2048, 2048, ClipDepth::zero_to_one, before.reach_m);
    const Vec3 step = fit.view.eye - before.view.eye;
    for (const Vec3& axis : {camera.right(), camera.up()}) {
      const double texels = dotOf(step, axis) / fit.texel_m;
      EXPECT_NEAR(texels, std::round(texels), 1e-6);
    }
    EXPECT_EQ(fit.reach_m, before.reach_m);
  }
  EXPECT_EQ(same_size, 50);
}

TEST(ShadowFit, BearsWithEverything) {
  const double nan = std::nan("");
  for (const auto& corners : {std::vector<Vec3>{}, box({0, 0, 0}, 0), box({1e300, 0, 0}, 1),
                              box({nan, nan, nan}, 1), box({1e6, 1e6, 1e6}, 5e6)}) {
    for (const Vec3& light : {kLight, Vec3(0, 0, 0), Vec3(nan, 0, 0), Vec3(1e300, 0, 0)}) {
      const ShadowFit fit = shadowFit(corners, light, 2048);
      EXPECT_TRUE(std::isfinite(fit.view.eye.x + fit.view.eye.y + fit.view.eye.z));
      EXPECT_TRUE(fit.texel_m > 0 && std::isfinite(fit.texel_m));
      EXPECT_TRUE(fit.reach_m > 0 && std::isfinite(fit.reach_m));
    }
  }
}

}  // namespace
}  // namespace rocinante
