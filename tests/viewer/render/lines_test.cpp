// What edges, outlines, trails and the scale bar do to the pixels of a frame.
#include <gtest/gtest.h>

#include "tests/viewer/render/looks_studio.h"
#include "viewer/gl/offscreen_context.h"
#include "viewer/overlay/scale_bar.h"
#include "viewer/passes/outline_pass.h"

namespace rocinante {
namespace {

using test::at;
using test::colored;
using test::differingPixels;
using test::frontView;
using test::Rgb;
using test::squareMesh;
using test::Studio;
using test::TestCell;

TEST(Lines, EdgesAreDrawnAlongABoxAndHiddenOnesAreNot) {
  TestCell cell;
  cell.add("box", boxMesh({4, 4, 4}), {0, 0, 0}, colored(0.9F, 0.9F, 0.9F));
  Studio studio(cell);
  CameraView corner;
  corner.eye = {10, -10, 8};
  corner.target = {0, 0, 0};
  corner.ortho_height_m = 10;
  const Picture plain = studio.drawn({}, corner);
  const Picture edges = studio.drawn({"edges"}, corner);
  // The nearest upright edge runs down from the middle of the picture.
  int dark = 0;
  for (int x = 78; x <= 81; ++x) dark += at(edges, x, 95).sum() < 300 ? 1 : 0;
  EXPECT_GE(dark, 1);
  // Between the edges surfaces are what they were; the hidden corner lies behind the middle.
  EXPECT_EQ(at(edges, 95, 100), at(plain, 95, 100));
  EXPECT_EQ(at(edges, 80, 60), at(plain, 80, 60));
  EXPECT_LT(differingPixels(plain, edges), 900);
}

TEST(Lines, ALineDrawingHasNoSurfacesAndHidesWhatIsBehindThem) {
  TestCell cell;
  cell.add("front", squareMesh(4), {0, 0, 0}, colored(1, 0, 0))
      .add("back", squareMesh(2), {0, 1, 0}, colored(0, 1, 0));
  cell.cell().scene.background_top = cell.cell().scene.background_bottom = {1, 1, 1};
  Studio studio(cell);
  const Picture drawing = studio.drawn({"edges=only"});
  for (int x = 50; x < 110; ++x) EXPECT_EQ(at(drawing, x, 80), (Rgb{255, 255, 255})) << x;
  EXPECT_LT(at(drawing, 48, 80).sum() + at(drawing, 47, 80).sum(), 1000);
}

TEST(Lines, AnOutlineGoesAroundAThingAlsoWhereItIsHidden) {
  TestCell cell;
  cell.add("front", squareMesh(4), {0, 0, 0}, colored(0, 0, 1))
      .add("back", squareMesh(2), {0, 1, 0}, colored(0, 1, 0));
  Studio studio(cell);
  const Picture plain = studio.drawn({});
  const Picture outlined = studio.drawn({"outlined=back"});
  // The hidden square covers pixels 64 to 96: the line lies just outside of it.
  for (const auto& [x, y] : {std::pair(62, 80), {97, 80}, {80, 62}, {80, 97}}) {
    const Rgb line = at(outlined, x, y);
    EXPECT_TRUE(line.r > 200 && line.b < 90) << x << ", " << y;
  }
  EXPECT_EQ(at(outlined, 80, 80), at(plain, 80, 80));
  EXPECT_EQ(at(outlined, 58, 80), at(plain, 58, 80));
  EXPECT_EQ(studio.drawn({"outlined=nobody"}).rgba, plain.rgba);
}

TEST(Lines, TheLineAroundAThingIsTwoAndAHalfPixelsWide) {
  // One pixel in the middle of nine by five.
  std::vector<std::uint8_t> covered(45, 0);
  covered[2 * 9 + 4] = 255;
  const auto line = outlineOf(covered, 9, 5);
  const auto row = [&](std::size_t y) {
    return std::vector<int>(line.begin() + static_cast<std::ptrdiff_t>(y * 9),
                            line.begin() + static_cast<std::ptrdiff_t>(y * 9 + 9));
  };
  EXPECT_EQ(row(0), (std::vector<int>{0, 0, 44, 195, 255, 195, 44, 0, 0}));
  EXPECT_EQ(row(1), (std::vector<int>{0, 0, 195, 255, 255, 255, 195, 0, 0}));
  EXPECT_EQ(row(2), (std::vector<int>{0, 0, 255, 255, 0, 255, 255, 0, 0}));
  EXPECT_EQ(row(3), row(1));
  EXPECT_EQ(row(4), row(0));

  std::vector<std::uint8_t> large(21 * 21, 0);
  large[10 * 21 + 10] = 255;
  const auto twice = outlineOf(large, 21, 21, 2);
  for (std::size_t off = 1; off <= 4; ++off) EXPECT_EQ(twice[10 * 21 + 10 + off], 255) << off;
  EXPECT_EQ(twice[10 * 21 + 15], 128);
  EXPECT_EQ(twice[10 * 21 + 16], 0);
}

TEST(Lines, EdgesOfFacesNarrowerThanAFewPixelsFade) {
  TestCell cell;
  for (int i = -20; i < 20; ++i) {
    cell.add("bar" + std::to_string(i), boxMesh({0.1, 0.1, 8}), {i * 0.2, 0, 0},
             colored(0.9F, 0.1F, 0.1F));
  }
  Studio studio(cell);
  const auto redness = [&](const std::vector<std::string>& words, double height_m) {
    CameraView view = frontView();
    view.ortho_height_m = height_m;
    const Picture picture = studio.drawn(words, view);
    int sum = 0;
    for (int x = 60; x < 100; ++x) sum += at(picture, x, 80).r;
    return sum;
  };
  EXPECT_GT(redness({"edges"}, 20), redness({}, 20) * 95 / 100);
  EXPECT_LT(redness({"edges"}, 1.5), redness({}, 1.5) * 95 / 100) << "near they are as ever";
}

TEST(Lines, ATrailIsDrawnInTheSceneAndFadesTowardsItsOldEnd) {
  TestCell cell;
  cell.add("plate", squareMesh(2), {0, 0, 0}, colored(0, 0, 0.2F));
  Studio studio(cell);
  FrameExtras extras;
  Trail trail;
  trail.runs.emplace_back();
  for (int i = 0; i <= 40; ++i) {
    trail.runs[0].push_back({{-4 + i * 0.2, 1, 0}, static_cast<float>(i) / 40.0F});
  }
  trail.runs.push_back({{{0, -1, std::nan("")}, 1}, {{1, -1, HUGE_VAL}, 1}});
  extras.trails.push_back(trail);
  const Picture frame = studio.drawn({}, frontView(), {"layer/gnomon"}, extras);
  EXPECT_GT(at(frame, 140, 80).r, 150);
  EXPECT_GT(at(frame, 140, 80).r, at(frame, 40, 80).r + 60);
  EXPECT_EQ(at(frame, 80, 80), at(studio.drawn({}), 80, 80)) << "hidden behind the plate";
}

TEST(Lines, AScaleBarIsTrueToThePicture) {
  TestCell cell;
  cell.add("plate", squareMesh(2), {0, 0, 0});
  auto context = makeOffscreenContext(Profile::reproducible);
  ASSERT_TRUE(context.has_value());
  const auto renderer = Renderer::create(**context, cell.cell(), Profile::reproducible);
  ASSERT_TRUE(renderer.has_value());
  const auto bar = [&](std::optional<double> ortho) {
    CameraView view = frontView();
    view.ortho_height_m = ortho;
    view.fov_deg = 90;
    const Camera camera(view, 640, 480, ClipDepth::zero_to_one, 64);
    return scaleBar(camera.metersPerPixel(camera.depthOf(view.target)), 180);
  };
  // 10 m over 480 pixels; and, 20 m away under 90 degrees, 40 m.
  EXPECT_EQ(bar(10)->text, "2 m");
  EXPECT_NEAR(bar(10)->pixels, 96, 1e-9);
  EXPECT_EQ(bar(std::nullopt)->text, "10 m");
  EXPECT_NEAR(bar(std::nullopt)->pixels, 120, 1e-9);
}

}  // namespace
}  // namespace rocinante
