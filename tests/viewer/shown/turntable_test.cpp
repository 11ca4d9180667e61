#include "viewer/shown/turntable.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rocinante {
namespace {

double lengthOf(const Vec3& v) { return std::sqrt(glm::dot(v, v)); }

void expectNear(const Vec3& a, const Vec3& b, double tolerance = 1e-9) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

CameraView viewFrom(const Vec3& eye, const Vec3& target) {
  CameraView view;
  view.eye = eye;
  view.target = target;
  return view;
}

TEST(Turntable, TakesOverWhereTheCameraStands) {
  const CameraView before = viewFrom({4, -3, 2.5}, {0.5, 0.25, 1});
  const CameraView after = Turntable(before).view();
  expectNear(after.eye, before.eye);
  expectNear(after.target, before.target);
  EXPECT_DOUBLE_EQ(after.fov_deg, before.fov_deg);
}

TEST(Turntable, FromStraightAboveKeepsWhatIsUpInThePicture) {
  CameraView above = viewFrom({0, 0, 10}, {0, 0, 0});
  above.up = {0, 1, 0};
  const CameraView after = Turntable(above).view();
  // Nearly straight above still, and the eye leans away from what is up.
  EXPECT_GT(after.eye.z, 9.99);
  EXPECT_LT(after.eye.y, 0);
}

TEST(Turntable, ADragAcrossTheHeightTurnsByHalfATurn) {
  Turntable camera(viewFrom({5, 0, 0}, {0, 0, 0}));
  camera.orbit(-720, 0, 720);
  expectNear(camera.view().eye, {-5, 0, 0}, 1e-9);
}

TEST(Turntable, NeverTipsOverThePole) {
  Turntable camera(viewFrom({5, 0, 0}, {0, 0, 0}));
  for (int i = 0; i < 10; ++i) camera.orbit(0, 500, 720);
  const CameraView view = camera.view();
  EXPECT_GT(view.eye.x, 0);
  EXPECT_GT(view.eye.z, 4.99);
}

TEST(Turntable, PanningMovesEyeAndTargetTogether) {
  Turntable camera(viewFrom({0, -5, 0}, {0, 0, 0}));
  camera.pan(100, 0, 720);
  const CameraView view = camera.view();
  // Looking along y, a drag to the right moves the scene right: the eye goes left.
  EXPECT_LT(view.eye.x, 0);
  EXPECT_NEAR(view.eye.x, view.target.x, 1e-12);
  // 100 of 720 pixels of a height of 2 * 5 * tan(22.5 deg).
  EXPECT_NEAR(-view.eye.x, 100.0 / 720 * 10 * std::tan(22.5 * 3.14159265358979 / 180), 1e-9);
}

TEST(Turntable, ZoomingInAndOutComesBack) {
  Turntable camera(viewFrom({5, 0, 0}, {0, 0, 0}));
  camera.zoom(3);
  EXPECT_NEAR(lengthOf(camera.view().eye), 5 * 0.9 * 0.9 * 0.9, 1e-12);
  camera.zoom(-3);
  EXPECT_NEAR(lengthOf(camera.view().eye), 5, 1e-12);
  camera.zoom(1e9);
  EXPECT_GT(lengthOf(camera.view().eye), 0);
}

/// Where a point of the target's plane is seen, from the picture's middle, in pixels.
std::pair<double, double> seenAt(const CameraView& view, const Vec3& point, int height_px) {
  const Vec3 forward = glm::normalize(view.target - view.eye);
  const Vec3 right = glm::normalize(glm::cross(forward, Vec3(0, 0, 1)));
  const Vec3 up = glm::cross(right, forward);
  const Vec3 offset = point - view.eye;
  const double half_m = view.ortho_height_m ? *view.ortho_height_m / 2
                                            : glm::dot(offset, forward) *
                                                  std::tan(view.fov_deg * 3.14159265358979 / 360);
  const double px_per_m = height_px / 2.0 / half_m;
  return {glm::dot(offset, right) * px_per_m, -glm::dot(offset, up) * px_per_m};
}

TEST(Turntable, ZoomingKeepsWhatIsUnderTheMouse) {
  for (const bool ortho : {false, true}) {
    CameraView start = viewFrom({5, -4, 3}, {0.5, 0.25, 1});
    if (ortho) start.ortho_height_m = 4;
    for (const double steps : {1.0, 7.5, -3.0}) {
      Turntable camera(start);
      // The point under (200, -120): pan it to the middle, and take the target.
      Turntable there(start);
      there.pan(-200, 120, 720);
      const Vec3 point = there.view().target;
      camera.zoomAt(steps, 200, -120, 720);
      const auto [right, down] = seenAt(camera.view(), point, 720);
      EXPECT_NEAR(right, 200, 1e-6);
      EXPECT_NEAR(down, -120, 1e-6);
      expectNear(glm::normalize(camera.view().eye - camera.view().target),
                 glm::normalize(start.eye - start.target), 1e-9);
    }
  }
}

TEST(Turntable, FittingShowsThePointsAndKeepsTheDirection) {
  Turntable camera(viewFrom({5, 0, 0}, {0, 0, 0}));
  camera.fit({{-1, -1, -1}, {3, 1, 1}}, 1280, 720);
  const CameraView view = camera.view();
  expectNear(view.target, {1, 0, 0});
  EXPECT_GT(view.eye.x, 4);
  EXPECT_NEAR(view.eye.z, 0, 1e-12);
  camera.fit({}, 1280, 720);
  expectNear(camera.view().eye, view.eye);
}

TEST(Turntable, ANarrowWindowStandsFartherOff) {
  Turntable wide(viewFrom({5, 0, 0}, {0, 0, 0}));
  Turntable narrow = wide;
  wide.fit({{-1, -1, -1}, {1, 1, 1}}, 1280, 720);
  narrow.fit({{-1, -1, -1}, {1, 1, 1}}, 400, 720);
  EXPECT_GT(lengthOf(narrow.view().eye), lengthOf(wide.view().eye));
}

TEST(Turntable, FliesWhereItLooks) {
  Turntable camera(viewFrom({0, -5, 1}, {0, 0, 1}));
  camera.fly(1, 2, 3);
  expectNear(camera.view().eye, {1, -3, 4});
  expectNear(camera.view().target, {1, 2, 4});
}

TEST(Turntable, WithoutPerspectiveItFliesInThePicture) {
  CameraView above = viewFrom({0, -0.01, 10}, {0, 0, 0});
  above.ortho_height_m = 4;
  Turntable camera(above);
  camera.fly(1, 2, 3);
  expectNear(camera.view().target, {1, 2, 0}, 0.01);
  EXPECT_DOUBLE_EQ(*camera.view().ortho_height_m, 7);
  camera.fly(0, 0, -100);
  EXPECT_GT(*camera.view().ortho_height_m, 0);
}

TEST(Turntable, LookingAroundKeepsTheEye) {
  Turntable camera(viewFrom({0, -5, 1}, {0, 0, 1}));
  // To the right by a quarter turn, half the way of an orbit.
  camera.lookAround(720, 0, 720);
  expectNear(camera.view().eye, {0, -5, 1});
  expectNear(camera.view().target, {5, -5, 1});
  camera.lookAround(0, 100, 720);
  expectNear(camera.view().eye, {0, -5, 1});
  EXPECT_LT(camera.view().target.z, 1);
}

}  // namespace
}  // namespace rocinante
