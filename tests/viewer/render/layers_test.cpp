// What layers of a cell make of choices of what is seen, and of pixels; and a cell's own lights.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/viewer/support/test_scene.h"
#include "viewer/gl/offscreen_context.h"
#include "viewer/render/renderer.h"

namespace rocinante {
namespace {

using test::colored;
using test::squareMesh;
using test::TestCell;

constexpr int kPicturePx = 96;

/// 6 m high at the plane y = 0: 16 pixels a metre, (48, 48) in the middle.
CameraView squareOn() {
  CameraView view;
  view.eye = {0, -20, 0};
  view.target = {0, 0, 0};
  view.ortho_height_m = 6;
  return view;
}

/// A square of 4 m with groups `left` (x < 0) and `right`, and a collision shape of 2 m.
TestCell twoParts() {
  Mesh mesh = squareMesh(2);
  for (Vertex& vertex : mesh.vertices) vertex.position.x -= 1;
  const Mesh right = squareMesh(2);
  for (Vertex vertex : right.vertices) {
    vertex.position.x += 1;
    mesh.vertices.push_back(vertex);
  }
  for (const std::uint32_t index : right.indices) mesh.indices.push_back(index + 4);
  mesh.parts = {{"left", 0, 0, 6}, {"right", 0, 6, 6}};
  for (const Vertex& vertex : mesh.vertices) mesh.bounds.add(Vec3(vertex.position));
  TestCell cell;
  cell.add("sign", std::move(mesh), {0, 0, 0}, colored(0.8F, 0.8F, 0.8F));
  return cell;
}

struct Shade {
  int r, g, b;
  bool operator==(const Shade&) const = default;
};
void PrintTo(const Shade& color, std::ostream* out) {
  *out << "(" << color.r << ", " << color.g << ", " << color.b << ")";
}

/// A picture of the cell; one context and renderer for all of them.
class LayerStudio {
 public:
  explicit LayerStudio(const Cell& cell) : cell_(cell) {
    auto context = makeOffscreenContext(Profile::reproducible);
    EXPECT_TRUE(context.has_value());
    context_ = std::move(*context);
    auto renderer = Renderer::create(*context_, cell, Profile::reproducible);
    EXPECT_TRUE(renderer.has_value());
    renderer_.emplace(std::move(*renderer));
    target_.emplace(std::move(*FrameBuffer::create(renderer_->gl(), kPicturePx, kPicturePx, 1)));
  }

  Picture drawn(const std::vector<std::string>& words = {},
                const std::vector<std::string>& hide = {},
                const std::vector<std::string>& show = {}) {
    RenderStyle style;
    for (const std::string& word : words) EXPECT_TRUE(setStyle(style, word).has_value()) << word;
    std::vector<std::string> hidden = hide;
    hidden.emplace_back("layer/gnomon");
    const auto choice = ViewChoice::make(hidden, show);
    const SessionState nothing;
    const PosedScene scene = poseScene(cell_, nothing);
    const auto counts = renderer_->draw(SceneFrame{&scene, squareOn(), &*choice, &style}, *target_);
    EXPECT_TRUE(counts.has_value()) << (counts ? "" : counts.error().text());
    target_->resolve();
    return target_->read();
  }
  Renderer& renderer() { return *renderer_; }

 private:
  const Cell& cell_;
  std::unique_ptr<RenderContext> context_;
  std::optional<Renderer> renderer_;
  std::optional<FrameBuffer> target_;
};

Shade shadeAt(const Picture& picture, int x, int y) {
  const std::uint8_t* p = &picture.rgba[static_cast<std::size_t>(y * picture.width + x) * 4];
  return {p[0], p[1], p[2]};
}
Shade leftHalf(const Picture& picture) { return shadeAt(picture, 30, 44); }
Shade rightHalf(const Picture& picture) { return shadeAt(picture, 66, 44); }
constexpr Shade kBlackShade{0, 0, 0};

TEST(Layers, AViewersChoiceOfALayerStandsDirectlyBelowWhatItHolds) {
  TestCell made = twoParts();
  Cell& cell = made.cell();
  cell.devices[0].layer = "signs";
  cell.devices[0].tags = {"hall"};
  cell.layers = {{"signs", true},
                 {"bodies", true, {{"", "body", ""}}},
                 {"lefts", true, {{"sign", "", "left"}}}};
  const SessionState nothing;
  const PosedScene scene = poseScene(cell, nothing);
  const auto seen = [&](const std::vector<std::string>& hide,
                        const std::vector<std::string>& show) {
    const auto choice = ViewChoice::make(hide, show);
    std::string text;
    text += choice->partVisible(scene.devices[0], 0, "left") ? 'L' : 'l';
    text += choice->partVisible(scene.devices[0], 0, "right") ? 'R' : 'r';
    return text;
  };
  EXPECT_EQ(seen({}, {}), "LR");
  EXPECT_EQ(seen({"layer/lefts"}, {}), "lR");
  EXPECT_EQ(seen({"layer/lefts"}, {"sign/body"}), "lR") << "parts are nearer than their link";
  EXPECT_EQ(seen({"layer/lefts"}, {"sign#left"}), "LR");
  EXPECT_EQ(seen({"layer/bodies"}, {"sign"}), "lr") << "links are nearer than their device";
  EXPECT_EQ(seen({"layer/bodies"}, {"*/body"}), "LR");
  EXPECT_EQ(seen({"layer/hall"}, {}), "lr");
  EXPECT_EQ(seen({"layer/hall"}, {"sign"}), "LR");
  EXPECT_EQ(seen({"layer/hall"}, {"layer/signs"}), "lr") << "of one nearness what is hidden";
  EXPECT_EQ(seen({"*"}, {"layer/lefts"}), "Lr") << "--layers lefts";
  EXPECT_EQ(seen({"*"}, {"layer/lefts", "layer/hall"}), "LR");
  cell.layers[2].visible = false;
  const PosedScene hidden = poseScene(cell, nothing);
  EXPECT_FALSE(ViewChoice().partVisible(hidden.devices[0], 0, "left"));
  EXPECT_TRUE(ViewChoice::make({}, {"layer/lefts"})->partVisible(hidden.devices[0], 0, "left"));
  EXPECT_TRUE(ViewChoice::make({}, {"sign"})->partVisible(hidden.devices[0], 0, "left"));
}

TEST(Layers, PartsOfALayerAreLeftOutSeenThroughOrDrawnAsLines) {
  TestCell made = twoParts();
  Cell& cell = made.cell();
  LayerStudio studio(cell);
  const Picture plain = studio.drawn();
  ASSERT_EQ(leftHalf(plain), rightHalf(plain));
  ASSERT_NE(leftHalf(plain), kBlackShade);

  cell.layers = {{"lefts", false, {{"sign", "", "left"}}}};
  const Picture without = studio.drawn();
  EXPECT_EQ(leftHalf(without), kBlackShade);
  EXPECT_EQ(rightHalf(without), rightHalf(plain));
  EXPECT_EQ(studio.drawn({}, {}, {"layer/lefts"}).rgba, plain.rgba);

  cell.layers[0].visible = true;
  cell.layers[0].look.opacity = 0.5F;
  const Picture through = studio.drawn();
  EXPECT_NEAR(leftHalf(through).r, leftHalf(plain).r / 2, 1);
  EXPECT_EQ(rightHalf(through), rightHalf(plain));
  EXPECT_EQ(studio.drawn({"transparent=sign#left@0.5"}).rgba, through.rgba) << "the same bits";
  EXPECT_EQ(studio.drawn({"transparent=layer/lefts@1"}).rgba, plain.rgba) << "the viewer outranks";
  EXPECT_EQ(studio.drawn({"layer-looks=off"}).rgba, plain.rgba);

  cell.layers[0].look = {true, {}, {}};
  const Picture lines = studio.drawn();
  EXPECT_EQ(leftHalf(lines), kBlackShade);
  EXPECT_EQ(rightHalf(lines), rightHalf(plain));
  cell.layers[0].look = {};
  EXPECT_EQ(studio.drawn({"wireframe=layer/lefts"}).rgba, lines.rgba);
}

TEST(Layers, ALayersCollisionGeometryIsThatOfTheLook) {
  TestCell made = twoParts();
  Cell& cell = made.cell();
  auto model = std::make_shared<Model>(*cell.models["sign"]);
  Visual shape;
  shape.mesh = std::make_shared<const Mesh>(squareMesh(1));
  model->links[0].collisions.push_back(shape);
  cell.models["sign"] = model;
  LayerStudio studio(cell);
  const Picture only = studio.drawn({"collision=sign"});
  const Picture over = studio.drawn({"collision-over=sign"});
  ASSERT_NE(only.rgba, over.rgba);
  cell.layers = {{"shapes", true, {{"", "", ""}}, {{}, {}, CollisionLook::only}}};
  EXPECT_EQ(studio.drawn().rgba, only.rgba);
  EXPECT_EQ(studio.drawn({"collision-over=layer/shapes"}).rgba, over.rgba);
  cell.layers[0].look.collision = CollisionLook::over;
  EXPECT_EQ(studio.drawn().rgba, over.rgba);
}

/// As a loaded cell has them.
void setLights(Cell& cell, std::vector<CellLight> lights) {
  cell.scene.light_direction = glm::vec3(lights.front().direction);
  cell.scene.lights = std::move(lights);
}

TEST(Lights, EachLightsWhatFacesItInItsColour) {
  TestCell made = twoParts();
  Cell& cell = made.cell();
  LayerStudio studio(cell);
  const Picture plain = studio.drawn();
  const std::string inputs = studio.renderer().inputsHash();
  // Sky and ground alone.
  setLights(cell, {{{0, 1, 0}, {1, 1, 1}, 1}});
  const Shade dark = leftHalf(studio.drawn());
  EXPECT_LT(dark.r, leftHalf(plain).r);
  setLights(cell, {{{0, -1, 0}, {1, 1, 1}, 1}});
  const Shade white = leftHalf(studio.drawn());
  EXPECT_GT(white.g, dark.g);
  setLights(cell, {{{0, -1, 0}, {1, 0, 0}, 1}});
  const Shade red = leftHalf(studio.drawn());
  EXPECT_NEAR(red.r, white.r, 1);
  EXPECT_EQ(red.g, dark.g);
  EXPECT_EQ(red.b, dark.b);
  cell.scene.lights.push_back({{0, -3, 0}, {0, 1, 0}, 1});
  const Shade both = leftHalf(studio.drawn());
  EXPECT_EQ(both.r, red.r);
  EXPECT_NEAR(both.g, white.g, 1);
  setLights(cell, {{{0, -1, 0}, {1, 1, 1}, 0.25}, {{0, -1, 0}, {1, 1, 1}, 0.75}});
  EXPECT_NEAR(leftHalf(studio.drawn()).g, white.g, 1) << "light adds up";
  // At 60 degrees: half of it.
  setLights(cell, {{{std::sqrt(3.0), -1, 0}, {1, 1, 1}, 1}});
  const Shade aslant = leftHalf(studio.drawn());
  setLights(cell, {{{0, -1, 0}, {1, 1, 1}, 0.5}});
  EXPECT_NEAR(aslant.g, leftHalf(studio.drawn()).g, 1);
  cell.scene.lights.clear();
  cell.scene.light_direction = {0, -1, 0};
  EXPECT_EQ(studio.drawn().rgba, plain.rgba) << "nothing is left behind";
  EXPECT_EQ(studio.renderer().inputsHash(), inputs);
}

TEST(Lights, PlainShadingKeepsOneLightAndShadowsAreTheFirstOnes) {
  TestCell made = twoParts();
  Cell& cell = made.cell();
  // 1 m before the left half, where its shadow falls: the light comes from the left.
  made.add("lamp", squareMesh(1), {-2, -1, 0}, colored(0.5F, 0.5F, 0.5F));
  cell.scene.light_direction = {-1, -1, 0};
  LayerStudio studio(cell);
  const Picture plain = studio.drawn({"shading=plain"});
  const Picture unlit = studio.drawn({"shadows"});
  setLights(cell, {{{-1, -1, 0}, {1, 1, 1}, 1}, {{0, -1, 0}, {0, 0, 1}, 1}});
  EXPECT_EQ(studio.drawn({"shading=plain"}).rgba, plain.rgba);
  const Picture open = studio.drawn();
  const Picture shadowed = studio.drawn({"shadows"});
  EXPECT_NE(shadowed.rgba, unlit.rgba);
  // In the shadow of the first light the second one still lights.
  const int x = 48 - 16;
  EXPECT_LT(shadeAt(shadowed, x, 48).r, shadeAt(open, x, 48).r);
  EXPECT_LT(shadeAt(shadowed, x, 48).b, shadeAt(open, x, 48).b);
  EXPECT_GT(shadeAt(shadowed, x, 48).b, shadeAt(shadowed, x, 48).r + 20);
  EXPECT_EQ(rightHalf(shadowed), rightHalf(open));
}

}  // namespace
}  // namespace rocinante
