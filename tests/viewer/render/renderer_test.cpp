// What pixels hold, in frames of the reproducible profile.
#include "viewer/render/renderer.h"

#include <gtest/gtest.h>

#include <tuple>

#include "tests/support/environment.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_scene.h"
#include "viewer/gl/egl_context.h"
#include "viewer/gl/gl_table.h"
#include "viewer/gl/offscreen_context.h"
#include "viewer/picture/picture.h"

namespace rocinante {
namespace {

using test::colored;
using test::squareMesh;
using test::TestCell;

struct Rgb {
  int r, g, b;
  bool operator==(const Rgb&) const = default;
};
void PrintTo(const Rgb& color, std::ostream* out) {
  *out << "(" << color.r << ", " << color.g << ", " << color.b << ")";
}

Rgb at(const Picture& picture, int x, int y) {
  const std::uint8_t* p = &picture.rgba[static_cast<std::size_t>(y * picture.width + x) * 4];
  EXPECT_EQ(p[3], 255) << "a frame is opaque";
  return {p[0], p[1], p[2]};
}
bool isRed(const Rgb& c) { return c.r > 120 && c.g < 60 && c.b < 60; }
bool isGreen(const Rgb& c) { return c.g > 120 && c.r < 60 && c.b < 60; }
bool isBlue(const Rgb& c) { return c.b > 120 && c.r < 60 && c.g < 60; }
constexpr Rgb kBlack{0, 0, 0};

/// 10 m high at the plane y = 0: 20 pixels a metre, (100, 100) in the middle.
CameraView frontView() {
  CameraView view;
  view.eye = {0, -20, 0};
  view.target = {0, 0, 0};
  view.ortho_height_m = 10;
  return view;
}

Picture drawn(const Cell& cell, const PosedScene& scene, const CameraView& camera, int samples = 4,
              const std::vector<std::string>& hide = {"layer/gnomon"}) {
  auto context = makeOffscreenContext(Profile::reproducible);
  EXPECT_TRUE(context.has_value());
  auto renderer = Renderer::create(**context, cell, Profile::reproducible);
  EXPECT_TRUE(renderer.has_value()) << renderer.error().text();
  auto target = FrameBuffer::create(renderer->gl(), 200, 200, samples);
  EXPECT_TRUE(target.has_value()) << target.error().text();
  const auto choice = ViewChoice::make(hide, {});
  const auto counts = renderer->draw({&scene, camera, &*choice}, *target);
  EXPECT_TRUE(counts.has_value()) << counts.error().text();
  target->resolve();
  return target->read();
}

Picture drawn(TestCell& cell, const CameraView& camera = frontView(), int samples = 4) {
  return drawn(cell.cell(), cell.scene(), camera, samples);
}

TEST(Renderer, ARedBoxStandsWhereItMust) {
  for (const int samples : {1, 4}) {
    SCOPED_TRACE(samples);
    TestCell cell;
    // x from 1 to 3, z from 1 to 3: pixels 120 to 160 across, 40 to 80 down.
    cell.add("box", boxMesh({2, 2, 2}), {2, 0, 2}, colored(1, 0, 0));
    const Picture frame = drawn(cell, frontView(), samples);
    for (const auto& [x, y] : {std::pair(121, 41), {158, 41}, {121, 78}, {158, 78}, {140, 60}}) {
      EXPECT_TRUE(isRed(at(frame, x, y))) << x << ", " << y;
    }
    for (const auto& [x, y] : {std::pair(118, 60), {161, 60}, {140, 38}, {140, 82}, {60, 140}}) {
      EXPECT_EQ(at(frame, x, y), kBlack) << x << ", " << y;
    }
  }
}

TEST(Renderer, ColoursAtThePointsTintTheMaterial) {
  TestCell cell;
  Mesh mesh = boxMesh({2, 2, 2});
  mesh.colors.assign(mesh.vertices.size(), 0x00FF00FF);
  cell.add("box", mesh, {2, 0, 2}, std::nullopt);
  EXPECT_TRUE(isGreen(at(drawn(cell), 140, 60)));
}

TEST(Renderer, PerspectiveShrinksWithDistance) {
  CameraView view;
  view.eye = {0, -10, 0};
  view.target = {0, 0, 0};
  view.fov_deg = 90;  // 20 m high at y = 0: 10 pixels a metre
  TestCell cell;
  cell.add("a", squareMesh(4), {0, 0, 0}, colored(1, 0, 0));
  const Picture frame = drawn(cell, view);
  EXPECT_TRUE(isRed(at(frame, 81, 81)));
  EXPECT_EQ(at(frame, 77, 100), kBlack);
  TestCell farther;
  farther.add("a", squareMesh(4), {0, 10, 0}, colored(1, 0, 0));  // half as large
  const Picture far_frame = drawn(farther, view);
  EXPECT_TRUE(isRed(at(far_frame, 92, 92)));
  EXPECT_EQ(at(far_frame, 87, 100), kBlack);
}

TEST(Renderer, TheNearerThingHidesTheFartherWhicheverComesFirst) {
  const auto frameOf = [](double red_y, double green_y) {
    TestCell cell;
    cell.add("red", squareMesh(4), {0, red_y, 0}, colored(1, 0, 0))
        .add("green", squareMesh(4), {0, green_y, 0}, colored(0, 1, 0));
    return at(drawn(cell), 100, 100);
  };
  EXPECT_TRUE(isRed(frameOf(0, 1)));
  EXPECT_TRUE(isGreen(frameOf(1, 0)));
  // A tenth of a millimetre decides, 20 m away.
  EXPECT_TRUE(isRed(frameOf(0, 1e-4)));
  EXPECT_TRUE(isGreen(frameOf(1e-4, 0)));
}

TEST(Renderer, ATexturedSquareIsRightSideUp) {
  const test::TemporaryFolder folder;
  // Red and green above, blue and white below.
  const Picture quarters{
      2, 2, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255}};
  Picture large{64, 64, {}};
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const auto from = static_cast<std::size_t>((y / 32 * 2 + x / 32) * 4);
      large.rgba.insert(large.rgba.end(), &quarters.rgba[from], &quarters.rgba[from] + 4);
    }
  }
  ASSERT_TRUE(writePng(folder / "quarters.png", large, true).has_value());
  Material material = colored(1, 1, 1);
  material.diffuse_map = folder / "quarters.png";
  TestCell cell;
  cell.add("picture", squareMesh(8), {0, 0, 0}, material);
  const Picture frame = drawn(cell);
  EXPECT_TRUE(isRed(at(frame, 60, 60)));
  EXPECT_TRUE(isGreen(at(frame, 140, 60)));
  EXPECT_TRUE(isBlue(at(frame, 60, 140)));
  const Rgb white = at(frame, 140, 140);
  EXPECT_GT(white.r, 200);
  EXPECT_NEAR(white.r, white.b, 8);
}

TEST(Renderer, AMissingTextureIsAWarningAndItsSurfaceKeepsItsColor) {
  Material material = colored(1, 0, 0);
  material.diffuse_map = "/nowhere/at/all.png";
  TestCell cell;
  cell.add("picture", squareMesh(8), {0, 0, 0}, material);
  auto context = makeOffscreenContext(Profile::reproducible);
  auto renderer = Renderer::create(**context, cell.cell(), Profile::reproducible);
  ASSERT_EQ(renderer->warnings().size(), 1U);
  EXPECT_NE(renderer->warnings()[0].find("/nowhere/at/all.png"), std::string::npos);
  EXPECT_TRUE(isRed(at(drawn(cell), 100, 100)));
}

TEST(Renderer, HalfTransparentRedOverGreenIsHalfOfEach) {
  TestCell solid;
  solid.add("back", squareMesh(6), {0, 1, 0}, colored(0, 1, 0));
  const Rgb green = at(drawn(solid), 100, 100);
  TestCell alone;
  alone.add("front", squareMesh(2), {0, 0, 0}, colored(1, 0, 0));
  const Rgb red = at(drawn(alone), 100, 100);
  TestCell both;
  both.add("front", squareMesh(2), {0, 0, 0}, colored(1, 0, 0, 0.5F))
      .add("back", squareMesh(6), {0, 1, 0}, colored(0, 1, 0));
  const Rgb mixed = at(drawn(both), 100, 100);
  EXPECT_NEAR(mixed.r, (red.r + green.r) / 2, 2);
  EXPECT_NEAR(mixed.g, (red.g + green.g) / 2, 2);
}

TEST(Renderer, AHiddenLayerIsGone) {
  TestCell cell;
  cell.cell().layers = {{"tanks", true}};
  cell.add("tank", squareMesh(4), {0, 0, 0}, colored(1, 0, 0), "tanks");
  EXPECT_TRUE(isRed(at(drawn(cell), 100, 100)));
  const Picture without =
      drawn(cell.cell(), cell.scene(), frontView(), 4, {"layer/tanks", "layer/gnomon"});
  EXPECT_EQ(at(without, 100, 100), kBlack);
}

TEST(Renderer, AWindowInItsWallShowsAllOverFromEverySide) {
  // Coplanar: the window is cut differently from the wall, so their depths round differently.
  Mesh mesh = squareMesh(20);
  const Mesh window = squareMesh(3);
  for (Vertex vertex : window.vertices) {
    vertex.position += glm::vec3(0.123F, 0, 0.456F);
    mesh.vertices.push_back(vertex);
  }
  for (const std::uint32_t index : window.indices) mesh.indices.push_back(index + 4);
  mesh.parts.push_back({"window", 1, 6, 6});
  mesh.materials = {colored(1, 0, 0), colored(0, 0, 1)};
  for (const Vec3& eye :
       {Vec3(0, -20, 0), Vec3(19, -3, 1), Vec3(-10, -8, 7), Vec3(0.5, -2.5, -18)}) {
    SCOPED_TRACE(eye.x);
    TestCell cell;
    cell.add("house", mesh, {0, 0, 0});
    CameraView view;
    view.eye = eye;
    view.target = {0.123, 0, 0.456};
    view.fov_deg = 30;
    const Camera camera(view, 200, 200, ClipDepth::zero_to_one, 0);
    const Picture frame = drawn(cell, view);
    int judged = 0;
    for (double x = -1.4; x <= 1.4; x += 0.1) {
      for (double z = -1.4; z <= 1.4; z += 0.1) {
        const Vec4 clip = camera.clipOf({0.123 + x, 0, 0.456 + z});
        const int px = static_cast<int>((clip.x / clip.w + 1) * 100);
        const int py = static_cast<int>((1 - clip.y / clip.w) * 100);
        if (px < 0 || py < 0 || px >= 200 || py >= 200) continue;
        // A pixel that the edge of the window crosses is a mixture.
        const auto pixelsTo = [&](double edge_x, double edge_z) {
          const Vec4 edge = camera.clipOf({0.123 + edge_x, 0, 0.456 + edge_z});
          const double dx = (edge.x / edge.w - clip.x / clip.w) * 100;
          const double dy = (edge.y / edge.w - clip.y / clip.w) * 100;
          return std::sqrt(dx * dx + dy * dy);
        };
        if (pixelsTo(x < 0 ? -1.5 : 1.5, z) < 2 || pixelsTo(x, z < 0 ? -1.5 : 1.5) < 2) continue;
        ++judged;
        const Rgb color = at(frame, px, py);
        ASSERT_GT(color.b, color.r) << px << ", " << py;
      }
    }
    EXPECT_GT(judged, 100);
  }
}

TEST(Renderer, ABackOfAnotherMaterialShowsOnlyFromBehind) {
  Mesh mesh = squareMesh(4);
  mesh.indices.insert(mesh.indices.end(), {0, 2, 1, 0, 3, 2});
  mesh.parts.push_back({"back", 1, 6, 6});
  mesh.materials = {colored(1, 0, 0), colored(0, 0, 1)};
  TestCell cell;
  cell.add("sheet", mesh, {0, 0, 0});
  EXPECT_TRUE(isRed(at(drawn(cell), 100, 100)));
  CameraView behind = frontView();
  behind.eye = {0, 20, 0};
  EXPECT_GT(at(drawn(cell, behind), 100, 100).b, 60);
  EXPECT_EQ(at(drawn(cell, behind), 100, 100).r, 0);
}

TEST(Renderer, ThingsAreLitFromBothSidesWhateverTheirWinding) {
  Mesh turned = squareMesh(4);
  std::swap(turned.indices[1], turned.indices[2]);
  std::swap(turned.indices[4], turned.indices[5]);
  TestCell plain;
  plain.add("a", squareMesh(4), {0, 0, 0}, colored(1, 1, 1));
  TestCell other;
  other.add("a", turned, {0, 0, 0}, colored(1, 1, 1));
  EXPECT_EQ(at(drawn(plain), 100, 100), at(drawn(other), 100, 100));
}

TEST(Renderer, SessionsDrawLinesPointsAndLabels) {
  TestCell cell;
  PosedScene scene = cell.scene();
  Drawing line;
  line.kind = StatementKind::line;
  line.rgba = 0xFF0000FF;
  line.size_px = 4;
  line.parts = {std::vector<double>{-4, 0, 2, 4, 0, 2}, std::nullopt,
                std::vector<double>{-4, 0, 1, -2, 0, 1}};
  Drawing points;
  points.kind = StatementKind::points;
  points.rgba = 0x00FF00FF;
  points.size_px = 11;
  points.parts = {std::vector<double>{0, 0, -1}};
  Drawing label;
  label.kind = StatementKind::label;
  label.rgba = 0xFFFFFFFF;
  label.text = "X";
  label.parts = {std::vector<double>{-3, 0, -3}};
  scene.drawings = {
      {"s", "l", &line, Mat4(1.0)}, {"s", "p", &points, Mat4(1.0)}, {"s", "t", &label, Mat4(1.0)}};
  const Picture frame = drawn(cell.cell(), scene, frontView());
  EXPECT_EQ(at(frame, 100, 60), (Rgb{255, 0, 0}));
  EXPECT_EQ(at(frame, 100, 57), kBlack);
  EXPECT_EQ(at(frame, 100, 63), kBlack);
  EXPECT_EQ(at(frame, 40, 80), (Rgb{255, 0, 0}));
  EXPECT_EQ(at(frame, 100, 80), kBlack) << "a missing part is a gap";
  EXPECT_EQ(at(frame, 100, 120), (Rgb{0, 255, 0}));
  EXPECT_EQ(at(frame, 107, 120), kBlack);
  int lit = 0;
  for (int y = 130; y < 170; ++y) {
    for (int x = 40; x < 80; ++x) lit += at(frame, x, y).r > 200 ? 1 : 0;
  }
  EXPECT_GT(lit, 15) << "the label is legible";
  const Picture bare = drawn(cell.cell(), scene, frontView(), 4,
                             {"layer/lines", "layer/points", "layer/labels", "layer/gnomon"});
  EXPECT_EQ(at(bare, 100, 60), kBlack);
  EXPECT_EQ(at(bare, 100, 120), kBlack);
}

TEST(Renderer, LinesThatPassTheEyeAreCutNotFolded) {
  CameraView view;
  view.eye = {0, -10, 0};
  view.target = {0, 0, 0};
  view.fov_deg = 90;
  TestCell cell;
  PosedScene scene = cell.scene();
  Drawing line;
  line.kind = StatementKind::line;
  line.rgba = 0xFF0000FF;
  line.size_px = 4;
  line.parts = {std::vector<double>{0, 0, -1, 0, -30, -1}};  // from the middle to behind the eye
  scene.drawings = {{"s", "l", &line, Mat4(1.0)}};
  const Picture frame = drawn(cell.cell(), scene, view);
  EXPECT_EQ(at(frame, 100, 150), (Rgb{255, 0, 0}));
  EXPECT_EQ(at(frame, 100, 195), (Rgb{255, 0, 0}));
  for (int y = 0; y < 100; ++y) EXPECT_EQ(at(frame, 100, y), kBlack);
}

TEST(Renderer, ABackgroundRunsFromTopToBottom) {
  TestCell cell;
  cell.cell().scene.background_top = {1, 0, 0};
  cell.cell().scene.background_bottom = {0, 0, 1};
  const Picture frame = drawn(cell);
  EXPECT_GT(at(frame, 5, 1).r, 250);
  EXPECT_GT(at(frame, 5, 198).b, 250);
}

TEST(Renderer, TheGridLiesBelowWhatStandsOnTheGround) {
  CameraView view;
  view.eye = {0, -3, 4};
  view.target = {0, 0, 0};
  TestCell bare;
  bare.cell().scene.grid = true;
  EXPECT_NE(drawn(bare, view),
            drawn(bare.cell(), bare.scene(), view, 4, {"layer/grid", "layer/gnomon"}));
  Mesh floor = squareMesh(6);
  for (Vertex& vertex : floor.vertices) {
    vertex.position = {vertex.position.x, vertex.position.z, 0};
    vertex.normal = {0, 0, 1};
  }
  TestCell cell;
  cell.cell().scene.grid = true;
  cell.cell().scene.light_direction = {0, 0, 1};
  cell.add("floor", floor, {0, 0, 0}, colored(1, 0, 0));
  const Picture frame = drawn(cell, view);
  for (int y = 60; y < 140; ++y) {
    for (int x = 60; x < 140; ++x) ASSERT_TRUE(isRed(at(frame, x, y))) << x << ", " << y;
  }
}

TEST(FrameBuffer, RefusesSizesAndSamplesThatCannotBe) {
  auto context = makeOffscreenContext(Profile::reproducible);
  const auto gl = fillGlTable([&](const char* name) { return (*context)->procAddress(name); });
  ASSERT_TRUE(gl.has_value());
  for (const auto& [width, height, samples] : {std::tuple(0, 10, 1),
                                               {10, -1, 1},
                                               {1 << 20, 10, 1},
                                               {10, 10, 0},
                                               {10, 10, 3},
                                               {10, 10, 64}}) {
    const auto frame = FrameBuffer::create(*gl, width, height, samples);
    ASSERT_FALSE(frame.has_value()) << width << "x" << height << " " << samples;
    EXPECT_EQ(frame.error().kind, ErrorKind::bad_argument);
  }
}

TEST(GlTable, NamesTheFirstFunctionThatIsMissing) {
  const auto gl = fillGlTable([](const char*) -> GlProc { return nullptr; });
  ASSERT_FALSE(gl.has_value());
  EXPECT_NE(gl.error().what.find("glActiveTexture"), std::string::npos);
}

TEST(EglContext, OneThatEndsLeavesTheCurrentOneCurrent) {
  auto first = makeEglContext();
  if (!first) GTEST_SKIP() << first.error().text();
  const auto second = makeEglContext();
  ASSERT_TRUE(second.has_value()) << second.error().text();
  first->reset();
  const auto gl = fillGlTable([&](const char* name) { return (*second)->procAddress(name); });
  EXPECT_TRUE(gl.has_value()) << gl.error().text();
}

TEST(EglContext, DrawsTheSameBytesAsOsmesa) {
  auto egl = makeEglContext();
  if (!egl) GTEST_SKIP() << egl.error().text();
  const test::Environment only_osmesa(
      std::map<std::string, std::string>{{kContextVariable, "osmesa"}});
  auto osmesa = makeOffscreenContext(Profile::reproducible);
  if (!osmesa) GTEST_SKIP() << osmesa.error().text();
  TestCell cell;
  cell.cell().scene.grid = true;
  cell.add("box", boxMesh({2, 2, 2}), {1, 0, 1}, colored(1, 0.5F, 0.2F, 0.7F))
      .add("ball", sphereMesh(1), {-1, 2, 0}, colored(0.2F, 0.5F, 1));
  const PosedScene scene = cell.scene();
  const auto choice = ViewChoice::make({}, {});
  CameraView view;
  Picture frames[2];
  for (const bool use_egl : {true, false}) {
    auto context = use_egl ? std::move(egl) : std::move(osmesa);
    auto renderer = Renderer::create(**context, cell.cell(), Profile::fast);
    ASSERT_TRUE(renderer.has_value()) << renderer.error().text();
    if (renderer->key().renderer != "llvmpipe") GTEST_SKIP() << "EGL gives a GPU here";
    auto target = FrameBuffer::create(renderer->gl(), 320, 240, 4);
    ASSERT_TRUE(target.has_value());
    ASSERT_TRUE(renderer->draw({&scene, view, &*choice}, *target).has_value());
    target->resolve();
    frames[use_egl ? 1 : 0] = target->read();
  }
  EXPECT_TRUE(frames[0] == frames[1]);
}

}  // namespace
}  // namespace rocinante
