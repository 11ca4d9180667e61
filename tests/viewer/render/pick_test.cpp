// What a click on a frame means: what the frame shows there.
#include <gtest/gtest.h>

#include "tests/viewer/render/looks_studio.h"
#include "viewer/picture/picture.h"

namespace rocinante {
namespace {

using test::colored;
using test::frontView;
using test::squareMesh;
using test::Studio;
using test::TestCell;

/// Looks along y from 5 m, 45 degrees high.
CameraView alongY() {
  CameraView view;
  view.eye = {0, -5, 0};
  view.target = {0, 0, 0};
  return view;
}

std::string deviceOf(const std::optional<PickedLink>& met) {
  return met ? met->name.device : std::string();
}

TEST(Pick, TheNearestSurfaceIsMetToThePixel) {
  TestCell cell;
  cell.add("near", squareMesh(1), {0, 0, 0}).add("far", squareMesh(4), {0, 3, 0});
  Studio studio(cell);
  const auto at = [&](double x, double y) { return deviceOf(studio.picked(x, y, {}, alongY())); };
  // Half a metre at 5 m: 0.5 / (5 tan(22.5 deg)) of 80 pixels, 19.3.
  EXPECT_EQ(at(80, 80), "near");
  EXPECT_EQ(at(80 + 18, 80), "near");
  EXPECT_EQ(at(80 + 20, 80), "far");
  EXPECT_EQ(at(80, 80 - 19), "near");
  EXPECT_EQ(at(80, 80 - 21), "far");
  EXPECT_EQ(at(159, 80), "");
}

TEST(Pick, ThePointLiesOnTheSurface) {
  TestCell cell;
  cell.add("near", squareMesh(1), {0, 0, 0}).add("far", squareMesh(4), {0, 3, 0});
  Studio studio(cell);
  const auto near = studio.picked(79.5, 79.5, {}, alongY());
  ASSERT_TRUE(near.has_value());
  EXPECT_NEAR(near->point.y, 0, 1e-4);
  EXPECT_NEAR(near->point.x, 0, 0.02);
  const auto far = studio.picked(50, 70, {}, alongY());
  ASSERT_TRUE(far.has_value());
  EXPECT_NEAR(far->point.y, 3, 1e-4);
  // 29.5 of 80 pixels to the left at 8 m, 9.5 up.
  EXPECT_NEAR(far->point.x, -29.5 / 80 * 8 * 0.41421356, 1e-3);
  EXPECT_NEAR(far->point.z, 9.5 / 80 * 8 * 0.41421356, 1e-3);
  const auto flat = studio.picked(80 + 16, 80, {}, frontView());
  ASSERT_TRUE(flat.has_value());
  EXPECT_NEAR(flat->point.x, 16.5 / 16, 1e-6);
  EXPECT_NEAR(flat->point.y, 3, 1e-3);
}

TEST(Pick, WhatIsHiddenIsNotInTheWay) {
  TestCell cell;
  cell.add("near", squareMesh(1), {0, 0, 0})
      .add("far", squareMesh(4), {0, 3, 0}, colored(1, 0, 0), "lamps");
  Studio studio(cell);
  EXPECT_EQ(deviceOf(studio.picked(80, 80, {}, alongY(), {"near"})), "far");
  EXPECT_EQ(deviceOf(studio.picked(80, 80, {}, alongY(), {"near", "layer/lamps"})), "");
  CameraView behind = alongY();
  behind.eye = {0, 1, 0};
  behind.target = {0, 2, 0};
  EXPECT_EQ(deviceOf(studio.picked(80, 80, {}, behind)), "far") << "behind the eye is nothing";
}

TEST(Pick, LooksAndCollisionGeometryAreMetAsTheyAreDrawn) {
  TestCell cell;
  cell.add("box", boxMesh({2, 2, 2}), {0, 0, 0}).add("wall", squareMesh(8), {0, 3, 0});
  auto model = std::make_shared<Model>(*cell.cell().models.at("box"));
  Visual hull;
  hull.mesh = std::make_shared<const Mesh>(boxMesh({4, 4, 1}));
  model->links[0].collisions.push_back(hull);
  cell.cell().models["box"] = model;
  Studio studio(cell);
  const auto at = [&](const char* look, double x, double y) {
    return deviceOf(studio.picked(
        x, y, look == nullptr ? std::vector<std::string>{} : std::vector<std::string>{look}));
  };
  // The box covers pixels 64 to 96 each way, its hull 48 to 112 across and 72 to 88 down.
  EXPECT_EQ(at(nullptr, 80, 66), "box");
  EXPECT_EQ(at(nullptr, 52, 80), "wall");
  EXPECT_EQ(at("collision=box", 80, 66), "wall");
  EXPECT_EQ(at("collision=box", 52, 80), "box");
  EXPECT_EQ(at("collision-over=box", 80, 66), "box");
  EXPECT_EQ(at("collision-over=box", 52, 80), "box");
  EXPECT_EQ(at("wireframe=box", 72, 78), "wall");
  EXPECT_EQ(at("wireframe=box", 64, 76), "box");
  EXPECT_EQ(at("transparent=box@0.1", 80, 66), "box");
}

TEST(Pick, ThroughAHoleOfAPictureItMeetsWhatIsBehind) {
  TestCell cell;
  // A lattice whose upper half is cut out.
  Picture lattice{4, 4, {}};
  for (int i = 0; i < 16; ++i) {
    const std::uint8_t alpha = i < 8 ? 0 : 255;
    for (const int value : {200, 200, 200, static_cast<int>(alpha)}) {
      lattice.rgba.push_back(static_cast<std::uint8_t>(value));
    }
  }
  Material cut;
  cut.diffuse_map = "lattice.png";
  cut.diffuse_bytes = std::make_shared<const Bytes>(encodePng(lattice));
  cell.add("fence", squareMesh(4), {0, 0, 0}, cut).add("wall", squareMesh(8), {0, 3, 0});
  Studio studio(cell);
  // The fence covers pixels 48 to 112 each way.
  EXPECT_EQ(deviceOf(studio.picked(80, 60)), "wall");
  EXPECT_EQ(deviceOf(studio.picked(80, 100)), "fence");
}

TEST(Pick, ALineIsMetFromTwoPixelsBeside) {
  TestCell cell;
  cell.add("pole", boxMesh({0.05, 0.05, 4}), {0.5 / 16, 0, 0});
  Studio studio(cell);
  EXPECT_EQ(deviceOf(studio.picked(80, 80)), "pole");
  EXPECT_EQ(deviceOf(studio.picked(81, 81)), "pole");
  EXPECT_EQ(deviceOf(studio.picked(85, 80)), "");
  EXPECT_EQ(deviceOf(studio.picked(0, 0)), "") << "at the picture's corner";
}

TEST(Pick, TheInsetOnTopHasTheClick) {
  TestCell cell;
  cell.add("near", squareMesh(1), {0, 0, 0}).add("high", squareMesh(1), {0, 0, 30});
  Studio studio(cell);
  FrameInset inset;
  inset.part = {100, 10, 50, 40};
  inset.camera = frontView();
  inset.camera.eye.z = inset.camera.target.z = 30;
  const auto at = [&](double x, double y) {
    return deviceOf(studio.picked(x, y, {}, frontView(), {}, {inset}));
  };
  EXPECT_EQ(at(80, 80), "near");
  EXPECT_EQ(at(125, 30), "high");
  EXPECT_EQ(at(102, 12), "");
  FrameInset over = inset;
  over.camera = frontView();
  EXPECT_EQ(deviceOf(studio.picked(125, 30, {}, frontView(), {}, {inset, over})), "near");
}

TEST(Pick, ItAgreesWithTheIdentityOfEveryPixel) {
  TestCell cell;
  cell.add("box", boxMesh({2, 2, 2}), {0, 0, 0})
      .add("glass", boxMesh({1, 1, 1}), {2, 0, 1}, colored(0, 0, 1, 0.5F))
      .add("wall", squareMesh(6), {0, 3, 0});
  Studio studio(cell);
  for (const char* look : {"edges", "wireframe=box"}) {
    const std::vector<std::string> owners = studio.owners({look});
    for (int y = 0; y < 160; y += 9) {
      for (int x = 0; x < 160; x += 7) {
        const std::string& shown = owners[static_cast<std::size_t>(y * 160 + x)];
        if (shown.empty()) continue;
        EXPECT_EQ(deviceOf(studio.picked(x, y, {look})), shown) << look << " " << x << " " << y;
      }
    }
  }
}

}  // namespace
}  // namespace rocinante
