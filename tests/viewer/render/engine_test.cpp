// What the draw stage owes: frames that depend on nothing drawn before, whatever the geometry.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/viewer/support/test_scene.h"
#include "viewer/gl/offscreen_context.h"
#include "viewer/render/renderer.h"

namespace rocinante {
namespace {

using test::colored;
using test::squareMesh;
using test::TestCell;

/// A renderer of one cell that draws frame after frame.
class Engine : public ::testing::Test {
 protected:
  void open(Cell& cell) {
    auto context = makeOffscreenContext(Profile::reproducible);
    ASSERT_TRUE(context.has_value());
    context_ = std::move(*context);
    auto renderer = Renderer::create(*context_, cell, Profile::reproducible);
    ASSERT_TRUE(renderer.has_value()) << renderer.error().text();
    renderer_.emplace(std::move(*renderer));
    auto target = FrameBuffer::create(renderer_->gl(), 120, 90, 1);
    ASSERT_TRUE(target.has_value());
    target_.emplace(std::move(*target));
  }
  Picture drawn(const PosedScene& scene, const CameraView& camera, Shading shading) {
    RenderStyle style;
    style.shading = shading;
    SceneFrame frame;
    frame.scene = &scene;
    frame.camera = camera;
    frame.choice = &choice_;
    frame.style = &style;
    const auto counts = renderer_->draw(frame, *target_);
    EXPECT_TRUE(counts.has_value()) << counts.error().text();
    if (counts) counts_ = *counts;
    target_->resolve();
    return target_->read();
  }
  void TearDown() override {
    target_.reset();
    renderer_.reset();
  }

  ViewChoice choice_ = *ViewChoice::make({}, {});
  DrawCounts counts_;
  std::unique_ptr<RenderContext> context_;
  std::optional<Renderer> renderer_;
  std::optional<FrameBuffer> target_;
};

TEST_F(Engine, AFrameIsTheSameWhateverWasDrawnBefore) {
  TestCell cell;
  cell.add("red", boxMesh({1, 1, 1}), {0, 0, 0}, colored(1, 0, 0))
      .add("glass", boxMesh({1, 1, 1}), {1, -1, 0}, colored(0, 1, 0, 0.4F))
      .add("ball", sphereMesh(0.7), {-1, 0, 0.5}, colored(0.2F, 0.4F, 1));
  open(cell.cell());
  const PosedScene scene = cell.scene();
  PosedScene moved = scene;
  for (PosedDevice& device : moved.devices) device.link_world[0][3].z += 0.25;
  CameraView near, far;
  near.eye = {2, -3, 1};
  far.eye = {9, -8, 5};
  const Picture plain = drawn(scene, near, Shading::plain);
  const Picture standard = drawn(scene, near, Shading::standard);
  EXPECT_NE(plain, standard);
  EXPECT_NE(drawn(moved, near, Shading::plain), plain);
  drawn(scene, far, Shading::standard);
  EXPECT_EQ(drawn(scene, near, Shading::plain), plain);
  EXPECT_EQ(drawn(scene, near, Shading::standard), standard);
}

TEST_F(Engine, TheStagesOfAFrameAreTimed) {
  TestCell cell;
  cell.add("ball", sphereMesh(0.7), {0, 0, 0});
  open(cell.cell());
  drawn(cell.scene(), {}, Shading::standard);
  EXPECT_GT(counts_.times.cull.wall_ns, 0);
  EXPECT_GT(counts_.times.draw.wall_ns, 0);
  EXPECT_GE(counts_.times.draw.cpu_ns, 0);
}

TEST_F(Engine, TrianglesWithoutAreaOrWithoutNumbersDrawNothingElse) {
  TestCell alone;
  alone.add("square", squareMesh(2), {0, 0, 0}, colored(1, 0, 0));
  open(alone.cell());
  CameraView view;
  view.eye = {0, -6, 0};
  const Picture expected = drawn(alone.scene(), view, Shading::standard);
  TearDown();

  TestCell cell;
  cell.add("square", squareMesh(2), {0, 0, 0}, colored(1, 0, 0));
  Mesh line = squareMesh(2);
  line.indices = {0, 0, 1, 1, 1, 1};
  cell.add("no area", line, {0, 0, 0}, colored(0, 1, 0));
  Mesh lost = squareMesh(2);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (Vertex& vertex : lost.vertices) vertex.position = {nan, nan, nan};
  cell.add("no numbers", lost, {0, 0, 0}, colored(0, 0, 1));
  open(cell.cell());
  EXPECT_EQ(drawn(cell.scene(), view, Shading::standard), expected);
  PosedScene scene = cell.scene();
  scene.devices[1].link_world[0][3] = Vec4(HUGE_VAL, 0, 0, 1);
  scene.devices[2].link_world[0][0][0] = std::nan("");
  EXPECT_EQ(drawn(scene, view, Shading::standard), expected);
}

TEST_F(Engine, PlainShadingLightsBothSidesAlike) {
  const auto middleOf = [&](bool turned) {
    Mesh mesh = squareMesh(4);
    if (turned) {
      std::swap(mesh.indices[1], mesh.indices[2]);
      std::swap(mesh.indices[4], mesh.indices[5]);
      for (Vertex& vertex : mesh.vertices) vertex.normal = -vertex.normal;
    }
    TestCell cell;
    cell.add("a", mesh, {0, 0, 0}, colored(0.5F, 0.25F, 1));
    open(cell.cell());
    CameraView view;
    view.eye = {0, -6, 0};
    const Picture frame = drawn(cell.scene(), view, Shading::plain);
    TearDown();
    const std::size_t at = (45 * 120 + 60) * 4;
    return std::vector<std::uint8_t>(&frame.rgba[at], &frame.rgba[at + 4]);
  };
  // Straight at the light: all of it, as display values.
  EXPECT_EQ(middleOf(false), (std::vector<std::uint8_t>{128, 64, 255, 255}));
  EXPECT_EQ(middleOf(true), middleOf(false));
}

TEST(FrameBuffer, SaysThatMemoryLacks) {
  auto context = makeOffscreenContext(Profile::reproducible);
  auto gl = fillGlTable([&](const char* name) { return (*context)->procAddress(name); });
  ASSERT_TRUE(gl.has_value());
  gl->GetError = []() -> GLenum { return GL_OUT_OF_MEMORY; };
  const auto frame = FrameBuffer::create(*gl, 64, 64, 4);
  ASSERT_FALSE(frame.has_value());
  EXPECT_EQ(frame.error().kind, ErrorKind::refused);
  EXPECT_EQ(frame.error().what, "not enough memory for a frame of 64x64 with 4 samples");
}

}  // namespace
}  // namespace rocinante
