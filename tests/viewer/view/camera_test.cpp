#include "viewer/view/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math/transform.h"
#include "core/math/trigonometry.h"
#include "viewer/view/depth_reach.h"

namespace rocinante {
namespace {

struct Pixel {
  double x, y, depth;
};
Pixel pixelOf(const Camera& camera, const Vec3& world) {
  const Vec4 clip = camera.clipOf(world);
  return {(clip.x / clip.w + 1) / 2 * camera.width(), (1 - clip.y / clip.w) / 2 * camera.height(),
          clip.z / clip.w};
}

TEST(Camera, LooksAtItsTargetWithUpUpAndRightRight) {
  CameraView view;
  view.eye = {0, -10, 0};
  view.target = {0, 0, 0};
  const Camera camera(view, 640, 480, ClipDepth::zero_to_one, 0);
  const Pixel middle = pixelOf(camera, {0, 0, 0});
  EXPECT_NEAR(middle.x, 320, 1e-9);
  EXPECT_NEAR(middle.y, 240, 1e-9);
  EXPECT_LT(pixelOf(camera, {0, 0, 1}).y, 240);  // z is up
  EXPECT_GT(pixelOf(camera, {1, 0, 0}).x, 320);  // looking along y, x is right
}

TEST(Camera, TheVerticalFieldOfViewReachesFromEdgeToEdge) {
  CameraView view;
  view.eye = {0, 0, 0};
  view.target = {1, 0, 0};
  view.fov_deg = 90;
  const Camera camera(view, 800, 400, ClipDepth::zero_to_one, 0);
  EXPECT_NEAR(pixelOf(camera, {5, 0, 5}).y, 0, 1e-9);
  EXPECT_NEAR(pixelOf(camera, {5, 0, -5}).y, 400, 1e-9);
  EXPECT_NEAR(pixelOf(camera, {5, 10, 0}).x, 0, 1e-9);  // y is left
  EXPECT_NEAR(camera.metersPerPixel(5), 10.0 / 400, 1e-12);
}

TEST(Camera, NearerHasGreaterDepthInBothClipSpaces) {
  CameraView view;
  view.eye = {0, 0, 0};
  view.target = {10, 0, 0};
  for (const auto depth : {ClipDepth::zero_to_one, ClipDepth::minus_one_to_one}) {
    for (const bool orthographic : {false, true}) {
      SCOPED_TRACE(orthographic);
      if (orthographic) view.ortho_height_m = 4;
      const Camera camera(view, 64, 64, depth, 128);
      double last = 2;
      for (const double x : {0.02, 0.5, 3.0, 90.0}) {
        const double here = pixelOf(camera, {x, 0, 0}).depth;
        EXPECT_LT(here, last);
        EXPECT_GE(here, depth == ClipDepth::zero_to_one ? 0 : -1);
        last = here;
      }
      view.ortho_height_m.reset();
    }
  }
}

TEST(Camera, ViewsWithoutADirectionStillGiveNumbers) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Vec3 origin(0, 0, 0);
  for (const CameraView& view : {
           CameraView{{1, 2, 3}, {1, 2, 3}, {0, 0, 1}, 45, {}},  // no direction
           CameraView{{0, 0, 5}, origin, {0, 0, 1}, 45, {}},     // along up
           CameraView{{0, 0, 5}, origin, {0, 0, 0}, 45, {}},
           CameraView{{nan, 0, 0}, origin, {0, nan, 1}, nan, {}},
           CameraView{{1, 0, 0}, origin, {0, 0, 1}, 0, {}},
           CameraView{{1, 0, 0}, origin, {0, 0, 1}, 360, {}},
           CameraView{{1, 0, 0}, origin, {0, 0, 1}, 45, nan},
           CameraView{{1, 0, 0}, origin, {0, 0, 1}, 45, -3.0},
       }) {
    const Camera camera(view, 640, 480, ClipDepth::zero_to_one, 10);
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) EXPECT_TRUE(std::isfinite(camera.clipFromRelative()[i][j]));
    }
  }
}

TEST(Camera, HoldsAMicrometreAKilometreFromTheOrigin) {
  CameraView view;
  view.eye = {1000, 1000, 10};
  view.target = {1000.001, 1000, 10};
  const Camera camera(view, 640, 480, ClipDepth::zero_to_one, 0);
  // What GL gets is float; the eye was subtracted before.
  const Mat4 world = translationMatrix({1000.001, 1000.000001, 10});
  const glm::mat4 relative(camera.relative(world));
  EXPECT_NEAR(relative[3][1], 1e-6, 1e-9);
}

TEST(Camera, SeesWhatIsInThePictureAndNotWhatIsBehind) {
  CameraView view;
  view.eye = {0, 0, 0};
  view.target = {1, 0, 0};
  view.fov_deg = 60;
  for (const bool orthographic : {false, true}) {
    if (orthographic) view.ortho_height_m = 2;
    const Camera camera(view, 400, 300, ClipDepth::zero_to_one, 100);
    EXPECT_TRUE(camera.sees({5, 0, 0}, 0.1));
    EXPECT_FALSE(camera.sees({5, 50, 0}, 1));
    EXPECT_FALSE(camera.sees({5, 0, -50}, 1));
    EXPECT_TRUE(camera.sees({5, 50, 0}, 60));
  }
  view.ortho_height_m.reset();
  EXPECT_FALSE(Camera(view, 400, 300, ClipDepth::zero_to_one, 0).sees({-5, 0, 0}, 1));
}

/// Points of the lens's own space (x right, y down, z along the view), by OpenCV's formula.
TEST(Camera, OfACalibratedLensProjectsAsOpenCvDoes) {
  CameraView view;
  view.eye = {1, 2, 3};
  view.target = {1, 6, 3};  // z along y, x along x, y downwards
  view.intrinsics = CameraIntrinsics{820.5, 795.25, 301.75, 261.5, 640, 480};
  const CameraIntrinsics& lens = *view.intrinsics;
  struct Size {
    int width, height;
    double left, top, scale;
  };
  // As large, twice as large, with room at the sides, with room above and below.
  for (const Size& size : {Size{640, 480, 0, 0, 1}, Size{1280, 960, 0, 0, 2},
                           Size{1000, 480, 180, 0, 1}, Size{320, 300, 0, 30, 0.5}}) {
    const Camera camera(view, size.width, size.height, ClipDepth::zero_to_one, 0);
    for (const Vec3& p : {Vec3(0, 0, 4), Vec3(1, 0.5, 3), Vec3(-0.7, 0.9, 2.5), Vec3(3, -2, 9)}) {
      const Pixel seen = pixelOf(camera, {1 + p.x, 2 + p.z, 3 - p.y});
      EXPECT_NEAR(seen.x, size.left + size.scale * (lens.fx * p.x / p.z + lens.cx + 0.5), 1e-9);
      EXPECT_NEAR(seen.y, size.top + size.scale * (lens.fy * p.y / p.z + lens.cy + 0.5), 1e-9);
      EXPECT_NEAR(camera.depthAt(seen.depth), p.z, 1e-9);
    }
    // What lies at the picture's edge is seen, what lies beyond is not.
    const double right_x = (size.width - size.left - size.scale * (lens.cx + 0.5)) / size.scale;
    const double edge = 4 * right_x / lens.fx;
    EXPECT_TRUE(camera.sees({1 + edge - 0.02, 6, 3}, 0.01));
    EXPECT_FALSE(camera.sees({1 + edge + 0.02, 6, 3}, 0.01));
  }
}

TEST(DepthReach, IsOfWhatThePictureShowsAndNotOfTheSiteAround) {
  // A site of two kilometres, flat, and a part of a centimetre on it.
  std::vector<Vec3> corners;
  for (const Vec3& half : {Vec3(1000, 1000, 0), Vec3(0.005, 0.005, 0.005)}) {
    for (unsigned k = 0; k < 8; ++k) {
      corners.emplace_back((k & 1U) != 0 ? half.x : -half.x, (k & 2U) != 0 ? half.y : -half.y,
                           (k & 4U) != 0 ? half.z : -half.z);
    }
  }
  CameraView view;
  view.target = {0, 0, 0};
  view.ortho_height_m = 0.05;
  const auto reach = [&](const Vec3& eye) {
    view.eye = eye;
    return depthReach(Camera(view, 400, 300, ClipDepth::zero_to_one, 1), corners, 10);
  };
  EXPECT_EQ(reach({0, 0, 0.3}), 1) << "from above";
  EXPECT_EQ(reach({1, 1, 1}), 2) << "aslant";
  EXPECT_EQ(reach({0, -1, 0}), 1024) << "along the ground, of which all is in the picture";
  EXPECT_EQ(reach({0, 0, -5000}), 8192);
  corners.erase(corners.begin(), corners.begin() + 8);
  EXPECT_EQ(reach({0, 0, 0.3}), 16) << "to the grid";
}

TEST(FittedView, ShowsEveryPointWithAMarginAndFillsThePicture) {
  const std::vector<Vec3> points{{0, 0, 0}, {3, 1, 0.2}, {-1, 2, 5}, {0.5, -4, 1}};
  for (const auto& [width, height] : {std::pair(640, 480), std::pair(200, 900)}) {
    const Camera camera(fittedView(points, width, height), width, height, ClipDepth::zero_to_one,
                        0);
    double widest = 0;
    for (const Vec3& point : points) {
      const Vec4 clip = camera.clipOf(point);
      ASSERT_GT(clip.w, 0);
      widest = std::max({widest, std::abs(clip.x / clip.w), std::abs(clip.y / clip.w)});
    }
    EXPECT_LE(widest, 0.95);
    EXPECT_GE(widest, 0.80);
  }
}

TEST(FittedView, StandsOffFromASinglePointAndAnEmptyScene) {
  const CameraView one = fittedView({{7, 8, 9}}, 640, 480);
  EXPECT_NEAR(glm::length(one.eye - Vec3(7, 8, 9)), 1, 1e-6);
  EXPECT_NE(fittedView({}, 640, 480).eye, Vec3(0, 0, 0));
}

TEST(CarriedView, RidesOnItsCarrier) {
  CameraView view;
  view.eye = {1, 0, 0};
  view.target = {2, 0, 0};
  const Mat4 carrier =
      translationMatrix({10, 0, 0}) * rotationMatrix(quaternionAbout({0, 0, 1}, kPi / 2));
  const CameraView carried = carriedView(view, carrier);
  EXPECT_NEAR(carried.eye.x, 10, 1e-12);
  EXPECT_NEAR(carried.eye.y, 1, 1e-12);
  EXPECT_NEAR(carried.target.y, 2, 1e-12);
  EXPECT_EQ(carried.up, Vec3(0, 0, 1));
}

}  // namespace
}  // namespace rocinante
