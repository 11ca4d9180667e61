#include "viewer/ui/pick.h"

#include <gtest/gtest.h>

#include "tests/viewer/render/test_scene.h"

namespace rocinante {
namespace {

using test::colored;
using test::squareMesh;
using test::TestCell;

/// Looks along y at squares a metre wide; 200 pixels a side.
CameraView along(double ortho_height_m = 0) {
  CameraView view;
  view.eye = {0, -5, 0};
  view.target = {0, 0, 0};
  if (ortho_height_m > 0) view.ortho_height_m = ortho_height_m;
  return view;
}

class Picking : public testing::Test {
 protected:
  Picking() {
    cell_.add("near", squareMesh(1), {0, 0, 0})
        .add("far", squareMesh(4), {0, 3, 0})
        .add("aside", squareMesh(1), {3, 0, 0}, colored(1, 0, 0), "lamps");
  }
  /// The device at a pixel; empty for nothing.
  std::string at(double x, double y, const ViewChoice& choice = {},
                 const CameraView& view = along()) const {
    const PosedScene scene = cell_.scene();
    const Camera camera(view, 200, 200, ClipDepth::zero_to_one, 100);
    const auto met = pick(scene, choice, sightLine(camera, x, y));
    return met ? scene.devices[met->device].name : std::string();
  }
  TestCell cell_;
};

TEST_F(Picking, TheNearestSurfaceIsMet) {
  EXPECT_EQ(at(100, 100), "near");
  EXPECT_EQ(at(60, 100), "far");
  EXPECT_EQ(at(199, 100), "");
}

TEST_F(Picking, PixelsAndSurfacesMeetAtTheEdge) {
  // Half a metre at 5 m: 0.5 / (5 tan(22.5 deg)) of 100 pixels, 24.1.
  EXPECT_EQ(at(100 + 23, 100), "near");
  EXPECT_EQ(at(100 + 25, 100), "far");
  EXPECT_EQ(at(100, 100 - 24), "near");
  EXPECT_EQ(at(100, 100 - 25), "far");
}

TEST_F(Picking, WhatIsHiddenIsNotInTheWay) {
  const auto choice = ViewChoice::make({"near"}, {});
  ASSERT_TRUE(choice.ok());
  EXPECT_EQ(at(100, 100, *choice), "far");
  const auto layer = ViewChoice::make({"layer/lamps", "far", "near"}, {});
  EXPECT_EQ(at(100, 100, *layer), "");
}

TEST_F(Picking, AnOrthographicLineRunsBesideTheView) {
  EXPECT_EQ(at(100, 100, {}, along(10)), "near");
  EXPECT_EQ(at(160, 100, {}, along(10)), "aside");
  EXPECT_EQ(at(130, 100, {}, along(10)), "far");
}

TEST_F(Picking, NothingIsMetBehindTheEye) {
  CameraView view = along();
  view.eye = {0, 1, 0};
  view.target = {0, 2, 0};
  EXPECT_EQ(at(100, 100, {}, view), "far");
  view.eye = {0, 5, 0};
  view.target = {0, 9, 0};
  EXPECT_EQ(at(100, 100, {}, view), "");
}

TEST_F(Picking, TheDistanceIsTheSurfaces) {
  const Camera camera(along(), 200, 200, ClipDepth::zero_to_one, 100);
  const auto met = pick(cell_.scene(), {}, sightLine(camera, 99.5, 99.5));
  ASSERT_TRUE(met.has_value());
  EXPECT_NEAR(met->distance_m, 5, 1e-9);
  EXPECT_NEAR(met->point.y, 0, 1e-9);
}

}  // namespace
}  // namespace rocinante
