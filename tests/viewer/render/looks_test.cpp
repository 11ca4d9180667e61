// What optional looks do to the pixels of a frame.
#include <gtest/gtest.h>

#include "tests/viewer/render/looks_studio.h"

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

/// Every form that the help text of a look promises, of the device `box`: "edges=only",
/// "trail=box@0.5".
std::vector<std::string> wordsOf(const StyleKey& key) {
  const std::string begin = std::string(key.key) + "=";
  std::vector<std::string> words;
  if (key.values == "PATH@X,Y,Z~PATH@X,Y,Z") return {begin + "box@1,1,1~box@-1,0.5,1"};
  if (key.repeats) {
    words.push_back(begin + "box");
    if (key.values.find("#GROUP") != key.values.npos) words.push_back(begin + "box#2");
    if (key.values.find("@") != key.values.npos) words.push_back(begin + "box@0.5");
    return words;
  }
  std::string_view rest = key.values;
  while (!rest.empty()) {
    const std::size_t bar = std::min(rest.find('|'), rest.size());
    words.push_back(begin + std::string(rest.substr(0, bar)));
    rest.remove_prefix(std::min(bar + 1, rest.size()));
  }
  return words;
}

TEST(Looks, ALookLeavesNothingBehindInTheNextFrame) {
  TestCell cell;
  cell.cell().scene.grid = true;
  cell.add("box", boxMesh({2, 2, 2}), {0, 0, 0}, colored(1, 0, 0))
      .add("glass", boxMesh({1, 1, 1}), {2, 0, 0}, colored(0, 0, 1, 0.5F));
  Studio studio(cell, 4);
  const Picture plain = studio.drawn({});
  int drawn = 0;
  for (const StyleKey& key : styleKeys()) {
    for (const std::string& word : wordsOf(key)) {
      RenderStyle style;
      const Status set = setStyle(style, word);
      ASSERT_TRUE(set.ok()) << word << ": " << set.error().text();
      studio.drawn({word});
      EXPECT_EQ(studio.drawn({}).rgba, plain.rgba) << word;
      ++drawn;
    }
  }
  EXPECT_GE(drawn, 28);
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

TEST(Looks, ContactDarkensWhereSurfacesMeetAndNothingElse) {
  TestCell cell;
  // A plate of 10 cm on a wall, at 64 pixels a metre.
  cell.add("wall", boxMesh({9, 0.2, 9}), {0, 1, 0}, colored(0.8F, 0.8F, 0.8F))
      .add("plate", boxMesh({0.5, 0.1, 0.5}), {0, 0.85, 0}, colored(0.8F, 0.8F, 0.8F));
  Studio studio(cell, 4);
  for (const bool orthographic : {true, false}) {
    SCOPED_TRACE(orthographic ? "orthographic" : "perspective");
    CameraView view = frontView();
    view.ortho_height_m = 2.5;
    if (!orthographic) {
      view.ortho_height_m.reset();
      view.eye = {0, -2.2, 0};
    }
    const Picture open = studio.drawn({}, view);
    const Picture near = studio.drawn({"contact"}, view);
    // The wall beside the plate and above it, far from it, and the middle of the plate's front.
    EXPECT_LT(at(near, 100, 80).sum(), at(open, 100, 80).sum() - 20);
    EXPECT_LT(at(near, 80, 60).sum(), at(open, 80, 60).sum() - 20);
    EXPECT_EQ(at(near, 145, 15), at(open, 145, 15));
    EXPECT_EQ(at(near, 80, 80), at(open, 80, 80));
    EXPECT_EQ(studio.drawn({"contact"}, view).rgba, near.rgba);
  }
}

TEST(Looks, ContactFallsOnTheGroundBelowWhatStandsOnIt) {
  TestCell cell;
  cell.cell().scene.grid = true;
  cell.cell().scene.background_top = cell.cell().scene.background_bottom = {0.7F, 0.7F, 0.7F};
  cell.add("box", boxMesh({2, 2, 2}), {0, 0, 1}, colored(0.9F, 0.9F, 0.9F));
  Studio studio(cell, 4);
  CameraView view;
  view.eye = {0, -6, 3};
  view.target = {0, 0, 0.5};
  const Picture open = studio.drawn({}, view);
  const Picture near = studio.drawn({"contact"}, view);
  int darker = 0, lighter = 0;
  for (std::size_t i = 0; i < open.rgba.size(); i += 4) {
    darker += near.rgba[i] + 8 < open.rgba[i] ? 1 : 0;
    lighter += near.rgba[i] > open.rgba[i] + 1 ? 1 : 0;
  }
  EXPECT_GT(darker, 60);
  EXPECT_EQ(lighter, 0);
  EXPECT_EQ(at(near, 5, 150), at(open, 5, 150));
  // Without the ground nothing is near the box.
  EXPECT_EQ(studio.drawn({"contact"}, view, {"layer/gnomon", "layer/grid"}).rgba,
            studio.drawn({}, view, {"layer/gnomon", "layer/grid"}).rgba);
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

TEST(Looks, AxesOfLinksAreDrawnOverEverythingInTheirColours) {
  TestCell cell;
  cell.add("box", squareMesh(4), {0, 0, 0}, colored(0.5F, 0.5F, 0.5F));
  Studio studio(cell);
  const Picture plain = studio.drawn({});
  const Picture axes = studio.drawn({"axes=box"});
  // From the front x points to the right and z up; y away from the eye.
  EXPECT_GT(at(axes, 80 + 20, 80).r, at(axes, 80 + 20, 80).g + 60);
  EXPECT_GT(at(axes, 80, 80 - 20).b, at(axes, 80, 80 - 20).r + 60);
  EXPECT_EQ(at(axes, 80 - 20, 80), at(plain, 80 - 20, 80));
  EXPECT_EQ(at(axes, 80 + 45, 80), at(plain, 80 + 45, 80)) << "34 pixels long";
  EXPECT_EQ(differingPixels(studio.drawn({"axes=*"}), axes), 0);
  EXPECT_EQ(differingPixels(studio.drawn({"axes=other"}), plain), 0);
  EXPECT_EQ(differingPixels(studio.drawn({"axes=box"}, frontView(), {"layer/gnomon", "box"}),
                            studio.drawn({}, frontView(), {"layer/gnomon", "box"})),
            0)
      << "nothing of what is hidden";
}

TEST(Looks, ADistanceIsALineBetweenTwoPointsWithItsLength) {
  TestCell cell;
  cell.add("a", squareMesh(1), {-3, 0, -2}, colored(0.1F, 0.1F, 0.1F))
      .add("b", squareMesh(1), {3, 0, -2}, colored(0.1F, 0.1F, 0.1F));
  Studio studio(cell);
  const Picture plain = studio.drawn({});
  const Picture line = studio.drawn({"measure=a@0,0,0~b@0,0,0"});
  // On the line, away from the label at its middle.
  EXPECT_GT(at(line, 80 - 24, 80 + 32).r, 200);
  EXPECT_LT(at(line, 80 - 24, 80 + 32).b, 120);
  EXPECT_GT(differingPixels(line, studio.drawn({"measure=a@0,0,0~b@0,0,0", "lengths=m"})), 10);
  EXPECT_EQ(differingPixels(studio.drawn({"measure=a@0,0,0~c@0,0,0"}), plain), 0);
}

TEST(Looks, BearWithScenesThatAreNone) {
  const std::vector<std::string> all{"shadows",    "edges",
                                     "limits",     "ghosts=clear",
                                     "scale-bar",  "labels=apart",
                                     "outlined=*", "collision-over=*",
                                     "axes=*",     "measure=far@0,0,0~nowhere@0,0,0"};
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
