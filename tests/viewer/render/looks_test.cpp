// What optional looks do to the pixels of a frame.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/viewer/render/test_scene.h"
#include "viewer/render/outline_pass.h"
#include "viewer/render/renderer.h"
#include "viewer/render/scale_bar.h"

namespace rocinante {
namespace {

using test::colored;
using test::squareMesh;
using test::TestCell;

struct Rgb {
  int r, g, b;
  int sum() const { return r + g + b; }
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

/// 10 m high at the plane y = 0: 16 pixels a metre, (80, 80) in the middle.
CameraView frontView() {
  CameraView view;
  view.eye = {0, -20, 0};
  view.target = {0, 0, 0};
  view.ortho_height_m = 10;
  return view;
}

RenderStyle styled(const std::vector<std::string>& words) {
  RenderStyle style;
  for (const std::string& word : words) EXPECT_TRUE(setStyle(style, word).has_value()) << word;
  return style;
}

/// One context and one renderer for all pictures of a cell.
class Studio {
 public:
  explicit Studio(TestCell& cell, int samples = 1) : cell_(cell), scene_(cell.scene()) {
    auto context = makeOsmesaContext();
    EXPECT_TRUE(context.has_value());
    context_ = std::move(*context);
    auto renderer = Renderer::create(*context_, cell.cell(), Profile::reproducible);
    EXPECT_TRUE(renderer.has_value()) << renderer.error().text();
    renderer_.emplace(std::move(*renderer));
    auto target = FrameBuffer::create(renderer_->gl(), 160, 160, samples);
    EXPECT_TRUE(target.has_value());
    target_.emplace(std::move(*target));
  }

  Picture drawn(const std::vector<std::string>& words, const CameraView& view = frontView(),
                const std::vector<std::string>& hide = {"layer/gnomon"},
                const FrameExtras& extras = {}) {
    const RenderStyle style = styled(words);
    const auto choice = ViewChoice::make(hide, {});
    EXPECT_TRUE(choice.has_value());
    SceneFrame frame{&scene_, view, &*choice, &style, &extras};
    const auto counts = renderer_->draw(frame, *target_);
    EXPECT_TRUE(counts.has_value()) << (counts ? "" : counts.error().text());
    target_->resolve();
    return target_->read();
  }

  /// Whose each pixel of such a frame is ("name", empty: nobody's), and whether depth agrees.
  std::vector<std::string> owners(const std::vector<std::string>& words) {
    const RenderStyle style = styled(words);
    const ViewChoice choice;
    const SceneFrame frame{&scene_, frontView(), &choice, &style};
    const auto ids = renderer_->identity(frame, *target_);
    const auto depth = renderer_->depth(frame, *target_);
    EXPECT_TRUE(ids.has_value() && depth.has_value());
    std::vector<std::string> names;
    for (std::size_t i = 0; i < ids->ids.size(); ++i) {
      EXPECT_EQ(std::isfinite(depth->metres[i]), ids->ids[i] != 0) << i;
      names.push_back(ids->ids[i] == 0 ? "" : ids->names[ids->ids[i] - 1].device);
    }
    return names;
  }

  PosedScene& scene() { return scene_; }

 private:
  TestCell& cell_;
  PosedScene scene_;
  std::unique_ptr<RenderContext> context_;
  std::optional<Renderer> renderer_;
  std::optional<FrameBuffer> target_;
};

int differingPixels(const Picture& a, const Picture& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    count += std::equal(&a.rgba[i], &a.rgba[i] + 4, &b.rgba[i]) ? 0 : 1;
  }
  return count;
}

TEST(Looks, ALookLeavesNothingBehindInTheNextFrame) {
  TestCell cell;
  cell.cell().scene.grid = true;
  cell.add("box", boxMesh({2, 2, 2}), {0, 0, 0}, colored(1, 0, 0))
      .add("glass", boxMesh({1, 1, 1}), {2, 0, 0}, colored(0, 0, 1, 0.5F));
  Studio studio(cell, 4);
  const Picture plain = studio.drawn({});
  for (const StyleKey& key : styleKeys()) {
    const std::string word =
        std::string(key.key) + "=" +
        (key.repeats ? "box" : std::string(key.values.substr(key.values.find_last_of('|') + 1)));
    for (const std::string& one : {word, std::string(key.key)}) {
      RenderStyle style;
      if (setStyle(style, one)) studio.drawn({one});
    }
    EXPECT_EQ(studio.drawn({}).rgba, plain.rgba) << word;
  }
}

TEST(Looks, AShadowFallsAwayFromTheLightAndNotOnWhatCastsIt) {
  TestCell cell;
  // Light from the front, the right and above: the shadow of the small plate falls on the wall
  // behind it, down and to the left: 1 m back is 1 m left and 1 m down.
  cell.cell().scene.light_direction = {1, -1, 1};
  cell.add("wall", squareMesh(9), {0, 1, 0}, colored(0.8F, 0.8F, 0.8F))
      .add("plate", squareMesh(2), {1, 0, 1}, colored(0.8F, 0.8F, 0.8F));
  Studio studio(cell);
  const Picture lit = studio.drawn({});
  const Picture shaded = studio.drawn({"shadows"});
  EXPECT_EQ(at(shaded, 96, 64), at(lit, 96, 64)) << "the plate itself";
  EXPECT_EQ(at(shaded, 130, 120), at(lit, 130, 120)) << "the wall elsewhere";
  // The plate's shadow covers x and z from -1 to 1: pixels 64 to 96 each way, the plate hides a
  // quarter of them.
  EXPECT_LT(at(shaded, 72, 88).sum(), at(lit, 72, 88).sum() - 100);
  EXPECT_LT(at(shaded, 66, 94).sum(), at(lit, 66, 94).sum() - 100);
  EXPECT_EQ(at(shaded, 62, 98), at(lit, 62, 98));
}

TEST(Looks, LitSurfacesHaveNoAcneHoweverTheLightGrazesThem) {
  for (const glm::vec3 light : {glm::vec3(0.05F, -1, 0.02F), {1, -0.08F, 0.3F}, {0.3F, -0.2F, 1}}) {
    TestCell cell;
    cell.cell().scene.light_direction = light;
    cell.add("wall", squareMesh(9), {0, 0, 0}, colored(0.8F, 0.8F, 0.8F))
        .add("ball", boxMesh({0.5, 0.5, 0.5}), {30, 30, 0}, colored(1, 1, 1));
    Studio studio(cell);
    EXPECT_EQ(differingPixels(studio.drawn({}), studio.drawn({"shadows"})), 0);
  }
}

TEST(Looks, AThingStandsOnItsShadow) {
  TestCell cell;
  cell.cell().scene.light_direction = {0.6F, -0.6F, 1};
  cell.cell().scene.grid = true;
  cell.cell().scene.background_top = cell.cell().scene.background_bottom = {0.7F, 0.7F, 0.7F};
  cell.add("box", boxMesh({2, 2, 2}), {0, 0, 1}, colored(0.9F, 0.9F, 0.9F));
  Studio studio(cell);
  CameraView above;
  above.eye = {0, 0, 20};
  above.target = {0, 0, 0};
  above.up = {0, 1, 0};
  above.ortho_height_m = 10;
  const Picture lit = studio.drawn({}, above);
  const Picture shaded = studio.drawn({"shadows"}, above);
  // From above the box covers pixels 64 to 96. Its shadow goes to the left and back (up).
  EXPECT_LT(at(shaded, 60, 70).sum(), at(lit, 60, 70).sum() - 60);
  int dark = 0;
  for (int x = 40; x < 64; ++x) dark += at(shaded, x, 70) == at(lit, x, 70) ? 0 : 1;
  // 2 m high and 0.6 over 1: 1.2 m, or 19 pixels, of which none is missing beside the box.
  EXPECT_NEAR(dark, 19, 2);
  EXPECT_FALSE(at(shaded, 63, 70) == at(lit, 63, 70));
  EXPECT_EQ(at(shaded, 110, 90), at(lit, 110, 90));
}

TEST(Looks, EdgesAreDrawnAlongABoxAndHiddenOnesAreNot) {
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

TEST(Looks, ALineDrawingHasNoSurfacesAndHidesWhatIsBehindThem) {
  TestCell cell;
  cell.add("front", squareMesh(4), {0, 0, 0}, colored(1, 0, 0))
      .add("back", squareMesh(2), {0, 1, 0}, colored(0, 1, 0));
  cell.cell().scene.background_top = cell.cell().scene.background_bottom = {1, 1, 1};
  Studio studio(cell);
  const Picture drawing = studio.drawn({"edges=only"});
  for (int x = 50; x < 110; ++x) EXPECT_EQ(at(drawing, x, 80), (Rgb{255, 255, 255})) << x;
  EXPECT_LT(at(drawing, 48, 80).sum() + at(drawing, 47, 80).sum(), 1000);
}

TEST(Looks, AnOutlineGoesAroundAThingAlsoWhereItIsHidden) {
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

TEST(Looks, TheLineAroundAThingIsTwoAndAHalfPixelsWide) {
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

TEST(Looks, WireframeShowsWhatIsBehindAndTransparentBoth) {
  TestCell cell;
  cell.add("front", squareMesh(4), {0, 0, 0}, colored(0, 0, 1))
      .add("back", squareMesh(3), {0, 1, 0}, colored(0, 1, 0));
  Studio studio(cell);
  const Picture wire = studio.drawn({"wireframe=front"});
  EXPECT_GT(at(wire, 70, 75).g, 150);
  EXPECT_EQ(at(wire, 70, 75).b, 0);
  // The diagonal of the square, which is no edge of it, is there.
  EXPECT_GT(at(wire, 80, 79).b + at(wire, 80, 80).b + at(wire, 79, 79).b, 150);
  const Picture clear = studio.drawn({"transparent=front@0.5"});
  EXPECT_GT(at(clear, 80, 80).g, 60);
  EXPECT_GT(at(clear, 80, 80).b, 60);
  EXPECT_EQ(studio.drawn({"transparent=front@0"}).rgba,
            studio.drawn({}, frontView(), {"layer/gnomon", "front"}).rgba);
}

/// Two squares one behind the other in one part, with a picture that is clear on one side: on the
/// left of the first, on the right of the second.
Mesh fencesWithHoles(double first_y, double second_y) {
  Picture picture{16, 16, {}};
  for (int i = 0; i < 16 * 16; ++i) {
    const std::uint8_t alpha = i % 16 < 8 ? 0 : 255;
    picture.rgba.insert(picture.rgba.end(), {255, 255, 255, alpha});
  }
  Mesh mesh = squareMesh(4);
  const Mesh one = mesh;
  for (Vertex vertex : one.vertices) {
    vertex.position.y += static_cast<float>(second_y);
    vertex.texture.x = 1 - vertex.texture.x;
    mesh.vertices.push_back(vertex);
  }
  for (std::size_t i = 0; i < 4; ++i) mesh.vertices[i].position.y += static_cast<float>(first_y);
  for (const std::uint32_t index : one.indices) mesh.indices.push_back(index + 4);
  mesh.parts[0].index_count = 12;
  mesh.materials[0].diffuse_map = "fence.png";
  mesh.materials[0].diffuse_bytes = std::make_shared<const Bytes>(encodePng(picture));
  mesh.bounds = {};
  for (const Vertex& vertex : mesh.vertices) mesh.bounds.add(Vec3(vertex.position));
  return mesh;
}

TEST(Looks, ThroughTheHolesOfAPictureOneSeesTheSamePartBehindIt) {
  for (const bool nearer_first : {true, false}) {
    TestCell cell;
    cell.add("fence", fencesWithHoles(nearer_first ? 0 : 1, nearer_first ? 1 : 0), {0, 0, 0});
    Studio studio(cell);
    for (const char* shading : {"shading=standard", "shading=plain"}) {
      const Picture drawn = studio.drawn({shading});
      EXPECT_GT(at(drawn, 60, 80).sum(), 300) << nearer_first << shading;
      EXPECT_GT(at(drawn, 100, 80).sum(), 300) << nearer_first << shading;
    }
  }
}

TEST(Looks, CollisionGeometryStandsInPlaceOfVisualsOrOverThem) {
  TestCell cell;
  cell.add("box", boxMesh({2, 2, 2}), {0, 0, 0}, colored(0, 0, 1));
  auto model = std::make_shared<Model>(*cell.cell().models.at("box"));
  Visual hull;
  hull.mesh = std::make_shared<const Mesh>(boxMesh({4, 4, 1}));
  model->links[0].collisions.push_back(hull);
  cell.cell().models["box"] = model;
  Studio studio(cell);
  const Picture plain = studio.drawn({});
  const Picture hulls = studio.drawn({"collision=box"});
  EXPECT_EQ(at(hulls, 80, 68), (Rgb{0, 0, 0})) << "of the visual nothing is left";
  EXPECT_GT(at(hulls, 52, 80).r, 120);
  const Picture both = studio.drawn({"collision-over=box"});
  EXPECT_EQ(at(both, 80, 68), at(plain, 80, 68));
  EXPECT_GT(at(both, 52, 80).r, 20);
  EXPECT_GT(at(both, 80, 80).b, 40);
  EXPECT_EQ(studio.drawn({"collision=nobody"}).rgba, plain.rgba);
}

TEST(Looks, IdentityAndDepthAreOfWhatTheFrameShows) {
  TestCell cell;
  cell.add("box", boxMesh({2, 2, 2}), {0, 0, 0}).add("wall", squareMesh(8), {0, 3, 0});
  auto model = std::make_shared<Model>(*cell.cell().models.at("box"));
  Visual hull;
  hull.mesh = std::make_shared<const Mesh>(boxMesh({4, 4, 1}));
  model->links[0].collisions.push_back(hull);
  cell.cell().models["box"] = model;
  Studio studio(cell);
  const auto ownerAt = [](const std::vector<std::string>& owners, int x, int y) {
    return owners[static_cast<std::size_t>(y * 160 + x)];
  };
  // The box covers pixels 64 to 96 each way, its hull 48 to 112 across and 72 to 88 down.
  const auto plain = studio.owners({});
  EXPECT_EQ(ownerAt(plain, 80, 66), "box");
  EXPECT_EQ(ownerAt(plain, 50, 80), "wall");
  EXPECT_EQ(ownerAt(plain, 5, 80), "");
  const auto hulls = studio.owners({"collision=box"});
  EXPECT_EQ(ownerAt(hulls, 80, 66), "wall");
  EXPECT_EQ(ownerAt(hulls, 50, 80), "box");
  const auto both = studio.owners({"collision-over=box"});
  EXPECT_EQ(ownerAt(both, 80, 66), "box");
  EXPECT_EQ(ownerAt(both, 50, 80), "box");
  // Through a wireframe one sees what is behind it.
  const auto wires = studio.owners({"wireframe=box"});
  EXPECT_EQ(ownerAt(wires, 70, 76), "wall");
  EXPECT_EQ(ownerAt(wires, 64, 76), "box");
  EXPECT_EQ(studio.owners({"wireframe=wall", "collision=box"}),
            studio.owners({"collision=box", "wireframe=wall"}));
  EXPECT_EQ(studio.owners({"edges"}), plain);
  EXPECT_EQ(studio.owners({"edges=only"}), plain);
  EXPECT_EQ(studio.owners({"transparent=*@0.2"}), plain);
}

TEST(Looks, LinksNearAndPastTheirLimitsAreAmberAndRed) {
  TestCell cell;
  cell.add("near", squareMesh(2), {-2, 0, 0}, colored(0, 0, 1))
      .add("past", squareMesh(2), {2, 0, 0}, colored(0, 0, 1));
  Studio studio(cell);
  FrameExtras extras;
  extras.limits = {{LimitLevel::near}, {LimitLevel::beyond}};
  const Picture tinted = studio.drawn({"limits"}, frontView(), {"layer/gnomon"}, extras);
  EXPECT_TRUE(at(tinted, 48, 80).r > 150 && at(tinted, 48, 80).g > 90);
  EXPECT_TRUE(at(tinted, 112, 80).r > 150 && at(tinted, 112, 80).g < 60);
  EXPECT_EQ(studio.drawn({}, frontView(), {"layer/gnomon"}, extras).rgba, studio.drawn({}).rgba);
}

TEST(Looks, AClearGhostNeverFightsWithWhatItIsAGhostOf) {
  TestCell cell;
  cell.add("actual", boxMesh({3, 3, 3}), {0, 0, 0}, colored(0.9F, 0.1F, 0.1F))
      .add("plan", boxMesh({3, 3, 3}), {0, 0, 0}, colored(0.4F, 0.6F, 1, 0.35F));
  Studio studio(cell);
  CameraView view;
  view.eye = {6, -8, 5};
  view.target = {0, 0, 0};
  studio.scene().devices[1].ghost = true;
  const Picture actual = studio.drawn({}, view, {"layer/gnomon", "plan"});
  // Off by what rounding makes, and by nothing.
  for (const double off : {0.0, 1e-9, -1e-7, 1e-6}) {
    studio.scene().devices[1].link_world[0][3].x = off;
    const Picture both = studio.drawn({"ghosts=clear"}, view);
    EXPECT_LT(differingPixels(both, actual), 60) << off << ": its rim alone may show";
    EXPECT_EQ(at(both, 80, 80), at(actual, 80, 80));
  }
  studio.scene().devices[1].link_world[0][3].x = 3.0;
  EXPECT_GT(differingPixels(studio.drawn({"ghosts=clear"}, view), actual), 1500);
}

TEST(Looks, WhatIsTranslucentFarBehindAClearGhostShowsThroughIt) {
  TestCell cell;
  cell.add("plan", boxMesh({3, 3, 3}), {0, 0, 0}, colored(0.4F, 0.6F, 1, 0.35F))
      .add("cover", squareMesh(6), {0, 4, 0}, colored(0.9F, 0.1F, 0.1F, 0.8F));
  Studio studio(cell);
  studio.scene().devices[0].ghost = true;
  const Rgb through = at(studio.drawn({"ghosts=clear"}), 80, 80);
  const Rgb alone =
      at(studio.drawn({"ghosts=clear"}, frontView(), {"layer/gnomon", "cover"}), 80, 80);
  EXPECT_GT(through.r, alone.r + 40);
}

TEST(Looks, EdgesOfFacesNarrowerThanAFewPixelsFade) {
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

TEST(Looks, ACloseViewWithoutPerspectiveHasFineDepthsInALargeSite) {
  TestCell cell;
  cell.add("tag", squareMesh(0.5), {0, -0.0002, 0}, colored(0.9F, 0.1F, 0.1F))
      .add("plate", squareMesh(0.8), {0, 0, 0}, colored(0.1F, 0.9F, 0.1F))
      .add("wall", squareMesh(2000), {0, 3, 0}, colored(0.2F, 0.2F, 0.2F));
  Studio studio(cell);
  CameraView view = frontView();
  view.ortho_height_m = 1;
  const Picture close = studio.drawn({}, view);
  EXPECT_GT(at(close, 80, 80).r, at(close, 80, 80).g) << "a fifth of a millimetre before the plate";
  EXPECT_LT(at(close, 80, 80 + 50).r, at(close, 80, 80 + 50).g);
}

TEST(Looks, ATrailIsDrawnInTheSceneAndFadesTowardsItsOldEnd) {
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

TEST(Looks, AScaleBarIsTrueToThePicture) {
  TestCell cell;
  cell.add("plate", squareMesh(2), {0, 0, 0});
  auto context = makeOsmesaContext();
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

TEST(Looks, BearWithScenesThatAreNone) {
  const std::vector<std::string> all{"shadows",   "edges",        "limits",     "ghosts=clear",
                                     "scale-bar", "labels=apart", "outlined=*", "collision-over=*"};
  TestCell empty;
  Studio nothing(empty);
  EXPECT_EQ(at(nothing.drawn(all), 80, 80), (Rgb{0, 0, 0}));

  TestCell cell;
  Mesh point = squareMesh(0);
  cell.add("point", point, {0, 0, 0}, colored(1, 0, 0))
      .add("far", squareMesh(2), {1e12, -3e11, 1e12}, colored(1, 0, 0))
      .add("nowhere", squareMesh(2), {0, 0, 0}, colored(1, 0, 0))
      .add("glass", squareMesh(4), {0, 0, 0}, colored(0, 0, 1, 0.4F));
  Studio studio(cell);
  studio.scene().devices[2].link_world[0][3].x = std::nan("");
  const Picture frame = studio.drawn(all);
  EXPECT_GT(at(frame, 80, 80).b, 40);
  std::vector<std::string> wire = all;
  wire.insert(wire.end(), {"wireframe=*", "edges=only"});
  studio.drawn(wire);
  CameraView inside = frontView();
  inside.ortho_height_m.reset();
  inside.eye = {0.1, 1e-9, 0};
  studio.drawn(all, inside);
  studio.drawn(wire, inside);
}

}  // namespace
}  // namespace rocinante
