#include "viewer/overlay/overlay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rocinante {
namespace {

Camera frontCamera(bool orthographic = false) {
  CameraView view;
  view.eye = {0, -10, 0};
  view.target = {0, 0, 0};
  if (orthographic) view.ortho_height_m = 10;
  return Camera(view, 400, 300, ClipDepth::zero_to_one, 64);
}

/// Height in pixels of all vertices together.
double heightOf(const Overlay& overlay) {
  double low = 1e300;
  double high = -1e300;
  for (const OverlayVertex& vertex : overlay.vertices()) {
    const double y = (1 - vertex.clip.y / vertex.clip.w) / 2 * 300;
    low = std::min(low, y);
    high = std::max(high, y);
  }
  return high - low;
}

TEST(Overlay, ALineHasItsWidthInPixelsAtAnyDistance) {
  for (const double y : {-5.0, 0.0, 50.0}) {
    const Camera camera = frontCamera();
    Overlay overlay(camera);
    overlay.addLine({{-1, y, 0}, {1, y, 0}}, 0xFF0000FF, 2);
    ASSERT_EQ(overlay.vertices().size(), 6U);
    EXPECT_NEAR(heightOf(overlay), 2, 1e-3);
  }
}

TEST(Overlay, ALineIsNearerThanItsSurfaceInBothProjections) {
  for (const bool orthographic : {false, true}) {
    const Camera camera = frontCamera(orthographic);
    Overlay overlay(camera);
    overlay.addLine({{-1, 0, 0}, {1, 0, 0}}, 0xFF0000FF, 1);
    const Vec4 surface = camera.clipOf({-1, 0, 0});
    const glm::vec4 line = overlay.vertices().at(0).clip;
    EXPECT_GT(line.z / line.w, surface.z / surface.w);
  }
}

TEST(Overlay, NothingBehindTheEyeAndNothingThatIsNoNumberIsDrawn) {
  const Camera camera = frontCamera();
  const TextAtlas atlas(16);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Overlay overlay(camera);
  overlay.addLine({{0, -20, 0}, {1, -30, 0}}, 0xFF0000FF, 1);
  overlay.addLine({{0, 0, 0}, {0, 0, 0}}, 0xFF0000FF, 1);
  overlay.addLine({{nan, 0, 0}, {0, 0, 0}}, 0xFF0000FF, 1);
  overlay.addLine({}, 0xFF0000FF, 1);
  overlay.addPoint({0, -20, 0}, 0xFF0000FF, 5);
  overlay.addPoint({nan, 0, 0}, 0xFF0000FF, 5);
  overlay.addLabel(atlas, {0, -20, 0}, 0xFFFFFFFF, "behind");
  overlay.addLabel(atlas, {500, 0, 0}, 0xFFFFFFFF, "beside");
  overlay.addLabel(atlas, {nan, 0, 0}, 0xFFFFFFFF, "nowhere");
  EXPECT_TRUE(overlay.vertices().empty());
}

TEST(Overlay, SizesAreBounded) {
  const Camera camera = frontCamera();
  Overlay overlay(camera);
  overlay.addPoint({0, 0, 0}, 0xFF0000FF, 1e9);
  EXPECT_LE(heightOf(overlay), 258);
}

TEST(Overlay, AtScaleTwoAPictureOfTwiceThePixelsIsLaidOutAlike) {
  const auto verticesAt = [](int scale) {
    CameraView view;
    view.eye = {3, -10, 4};
    const Camera camera(view, 400 * scale, 300 * scale, ClipDepth::zero_to_one, 64);
    Overlay overlay(camera, scale);
    overlay.addLine({{-1, 0, 0}, {1, 2, 0}, {1, 2, 3}}, 0xFF0000FF, 4);
    overlay.addPoint({0, 1, 1}, 0xFF0000FF, 5);
    overlay.addRibbon({{{0, 0, 0}, 0xFF, 3}, {{1, 0, 0}, 0xFF, 3}, {{1, 1, 0}, 0xFF, 3}});
    overlay.addGnomon(TextAtlas(16 * scale));
    overlay.addScaleBar(TextAtlas(16 * scale), {1, 150, "1 m"});
    std::vector<glm::vec4> corners;
    for (const OverlayVertex& vertex : overlay.vertices()) {
      // Glyphs stand on whole pixels.
      if (vertex.kind != OverlayKind::text) corners.push_back(vertex.clip / vertex.clip.w);
    }
    return corners;
  };
  const auto once = verticesAt(1);
  const auto twice = verticesAt(2);
  ASSERT_EQ(once.size(), twice.size());
  for (std::size_t i = 0; i < once.size(); ++i) {
    // A text's width is rounded up to whole pixels: one of them.
    EXPECT_NEAR(once[i].x, twice[i].x, 2.0 / 400) << i;
    EXPECT_NEAR(once[i].y, twice[i].y, 2.0 / 300) << i;
  }
}

TEST(Overlay, ALabelStaysInsideThePictureWhereItFits) {
  const Camera camera = frontCamera(true);
  const TextAtlas atlas(16);
  for (const Vec3& at : {Vec3(6.5, 0, 4.9), Vec3(-6.5, 0, -4.9), Vec3(0, 0, 4.99)}) {
    Overlay overlay(camera);
    overlay.addLabel(atlas, at, 0xFFFFFFFF, "tank 12");
    ASSERT_FALSE(overlay.vertices().empty());
    for (const OverlayVertex& vertex : overlay.vertices()) {
      if (vertex.kind != OverlayKind::text) continue;
      EXPECT_LE(std::abs(vertex.clip.x), 1);
      EXPECT_LE(std::abs(vertex.clip.y), 1);
    }
  }
}

}  // namespace
}  // namespace rocinante
