// Layers that hold links and parts, tags of devices, looks of layers, and lights.
#include <gtest/gtest.h>

#include "core/cell/posed_scene.h"
#include "tests/core/cell/cell_fixture.h"

namespace rocinante {
namespace {

using test::stateOf;
using test::writeFile;

constexpr const char* kHead = R"(format = 1
[[device]]
name = "arm"
model = "arm.urdf"
layer = "robots"
tags = ["left"]
color = "#102030"
[[device]]
name = "gantry"
model = "gantry"
[[model]]
name = "gantry"
obj = "gantry.obj"
unit = "m"
up = "z"
[[model.link]]
name = "frame"
[[layer]]
name = "robots"
)";

class CellLayers : public test::CellFolder {
 protected:
  PosedScene scene(std::string_view layers, std::string_view lines = {}) {
    auto loaded = load(std::string(kHead) + std::string(layers));
    EXPECT_TRUE(loaded.ok());
    cell_ = std::move(*loaded);
    EXPECT_EQ(test::printed(cell_.faults), "");
    state_ = stateOf(lines);
    return poseScene(cell_, state_);
  }

  Cell cell_;
  SessionState state_;
};

constexpr const char* kLayers = R"([[layer]]
name = "left"
[[layer]]
name = "tips"
members = ["*/tip"]
[[layer]]
name = "bridges"
members = ["gantry#bridge*"]
)";

TEST_F(CellLayers, PacketsShowAndHideWhateverALayerHolds) {
  const auto seen = [&](std::string_view lines, std::string_view layers = kLayers) {
    const PosedScene posed = scene(layers, lines);
    const PosedDevice& arm = *posed.findDevice("arm");
    const PosedDevice& gantry = *posed.findDevice("gantry");
    std::string text;
    text += arm.partVisible(0, "") ? 'F' : 'f';
    text += arm.partVisible(1, "") ? 'T' : 't';
    text += gantry.partVisible(0, "bridge_left") ? 'B' : 'b';
    text += gantry.partVisible(0, "hand") ? 'H' : 'h';
    return text;
  };
  EXPECT_EQ(seen(""), "FTBH");
  EXPECT_EQ(seen("hide layer/left\n"), "ftBH") << "a tag is a layer";
  EXPECT_EQ(seen("hide layer/tips\n"), "FtBH");
  EXPECT_EQ(seen("hide layer/tips\nshow arm/tip\n"), "FtBH") << "all must be shown";
  EXPECT_EQ(seen("hide layer/bridges\n"), "FTbH");
  EXPECT_EQ(seen("hide gantry\n"), "FTbh");
  EXPECT_EQ(seen("hide layer/robots\nshow layer/left\n"), "ftBH");
  const std::string hidden = std::string(kLayers) + "visible = false\n";
  EXPECT_EQ(seen("", hidden), "FTbH");
  EXPECT_EQ(seen("show layer/bridges\n", hidden), "FTBH") << "packets outrank the cell";
  EXPECT_EQ(seen("show layer/bridges\nshow layer/bridges default\n", hidden), "FTbH");
}

TEST_F(CellLayers, AColourOfALayerStandsDirectlyBelowWhatTheLayerHolds) {
  const auto colors = [&](std::string_view lines) {
    const PosedScene posed = scene(kLayers, lines);
    const PosedDevice& arm = *posed.findDevice("arm");
    const PosedDevice& gantry = *posed.findDevice("gantry");
    return std::vector<std::uint32_t>{
        arm.partColor(0, "").value_or(0), arm.partColor(1, "").value_or(0),
        gantry.partColor(0, "bridge_left").value_or(0), gantry.partColor(0, "hand").value_or(0)};
  };
  using Colors = std::vector<std::uint32_t>;
  EXPECT_EQ(colors("color layer/left #ff0000\n"), Colors({0xFF0000FF, 0xFF0000FF, 0, 0}));
  EXPECT_EQ(colors("color layer/left #ff0000\ncolor layer/robots #00ff00\n"),
            Colors({0xFF0000FF, 0xFF0000FF, 0, 0}))
      << "of several the last one, tags after `layer`";
  EXPECT_EQ(colors("color arm #ff0000\ncolor layer/tips #0000ff80\n"),
            Colors({0xFF0000FF, 0x0000FF80, 0, 0}));
  EXPECT_EQ(colors("color layer/tips #0000ff\ncolor arm/tip default\n"),
            Colors({0x102030FF, 0x102030FF, 0, 0}));
  EXPECT_EQ(colors("color gantry/frame #ff0000\ncolor layer/bridges #00ff00\n"),
            Colors({0x102030FF, 0x102030FF, 0x00FF00FF, 0xFF0000FF}));
  EXPECT_EQ(colors("color gantry/frame #ff0000\ncolor layer/bridges default\n"),
            Colors({0x102030FF, 0x102030FF, 0, 0xFF0000FF}));
}

TEST_F(CellLayers, TheNearestLayersLookStandsAndAColourOfPacketsOutranksItsOpacity) {
  const std::string layers =
      "opacity = 0.5\ncollision = 'over'\n"
      "[[layer]]\nname = 'left'\nwireframe = true\n"
      "[[layer]]\nname = 'tips'\nmembers = ['arm/tip']\nopacity = 0.25\nwireframe = false\n"
      "[[layer]]\nname = 'hands'\nmembers = ['gantry#hand']\nopacity = 0.75\n";
  const auto looks = [&](std::string_view lines) {
    const PosedScene posed = scene(layers, lines);
    EXPECT_TRUE(posed.has_looks && posed.has_collision);
    const PosedDevice& arm = *posed.findDevice("arm");
    return std::vector<LayerLook>{arm.partLook(0, ""), arm.partLook(1, ""),
                                  posed.findDevice("gantry")->partLook(0, "hand"),
                                  posed.findDevice("gantry")->partLook(0, "frame")};
  };
  const auto over = CollisionLook::over;
  using Looks = std::vector<LayerLook>;
  EXPECT_EQ(looks(""), Looks({{true, 0.5F, over}, {false, 0.25F, over}, {{}, 0.75F, {}}, {}}));
  EXPECT_EQ(looks("color layer/tips #ff0000\n"),
            Looks({{true, 0.5F, over}, {false, {}, over}, {{}, 0.75F, {}}, {}}));
  EXPECT_EQ(looks("color arm #ff0000\ncolor arm/tip default\ncolor gantry #00ff00\n"),
            Looks({{true, {}, over}, {false, 0.25F, over}, {}, {}}));
  const PosedScene plain = scene(kLayers);
  EXPECT_FALSE(plain.has_looks || plain.has_collision);
}

TEST_F(CellLayers, AGhostIsInTheLayersOfItsOriginalAndInItsOwn) {
  const PosedScene posed = scene(
      "[[layer]]\nname = 'left'\n[[layer]]\nname = 'plans'\nmembers = ['plan/foot']\n"
      "[[source]]\nname = 'planner'\nghost_of = { plan = 'arm' }\n",
      "joints plan 1\n");
  const PosedDevice& ghost = *posed.findDevice("plan");
  EXPECT_TRUE(ghost.inLayer("robots", 0) && ghost.inLayer("left", 1));
  EXPECT_TRUE(ghost.inLayer("plans", 0));
  EXPECT_FALSE(ghost.inLayer("plans", 1) || posed.findDevice("arm")->inLayer("plans", 0));
}

TEST_F(CellLayers, WhatALayerHoldsIsHeldToTheCell) {
  const std::string head = kHead;
  EXPECT_EQ(faultsOf(head + R"([[layer]]
name = "left"
members = ["arm/tipp", "garm", "gantry#brigde*", "layer/x", "arm/", 3, "*/none", "*#hand"]
wireframe = "yes"
opacity = 2
collision = "in"
)"),
            "test.cell.toml:22:12: error: device `arm` has no link `tipp` [cell.unknown-link]\n"
            "test.cell.toml:22:24: warning: `members` of [[layer]] names `garm`, which the cell "
            "does not have (did you mean `arm`?) [cell.unknown-device]\n"
            "test.cell.toml:22:32: error: `brigde*` is not a group of those meshes "
            "[cell.unknown-group]\n"
            "test.cell.toml:22:50: error: `layer/x` cannot be a member of a layer (DEVICE, "
            "DEVICE/LINK, either with #GROUP, and * for every device) [cell.bad-name]\n"
            "test.cell.toml:22:61: error: `arm/` cannot be a member of a layer (DEVICE, "
            "DEVICE/LINK, either with #GROUP, and * for every device) [cell.bad-name]\n"
            "test.cell.toml:22:69: error: `members` of [[layer]] holds an integer, where strings "
            "are expected [cell.wrong-kind]\n"
            "test.cell.toml:22:72: error: no device has a link `none` [cell.unknown-link]\n"
            "test.cell.toml:23:13: error: `wireframe` of [[layer]] is a string, where true or "
            "false is expected [cell.wrong-kind]\n"
            "test.cell.toml:24:11: error: `opacity` is between 0 and 1 [cell.bad-number]\n"
            "test.cell.toml:25:13: error: `in` is not a way to draw collision geometry (off, only "
            "or over) [cell.unknown-word]\n");
  EXPECT_EQ(faultsOf(head),
            "test.cell.toml:6:8: warning: no [[layer]] is named `left` [cell.unknown-layer]\n");
}

TEST_F(CellLayers, TheFirstLightIsTheKeyLightAndIncludedOnesComeAfter) {
  writeFile(folder_ / "lamps.cell.toml",
            "format = 1\n[[light]]\nname = 'lamp'\ndirection = [1, 0, 0]\n"
            "[[light]]\nname = 'sun'\ndirection = [0, 1, 0]\n[scene]\ngrid = false\n");
  const auto cell = load(
      "format = 1\ninclude = ['lamps.cell.toml']\n[[light]]\nname = 'sun'\ndirection = [0, 0, 2]\n"
      "color = '#ff8000'\nstrength = 1.5\n");
  ASSERT_TRUE(cell.ok());
  ASSERT_EQ(cell->scene.lights.size(), 2U);
  EXPECT_EQ(cell->scene.lights[0].direction, Vec3(0, 0, 2));
  EXPECT_EQ(cell->scene.lights[0].strength, 1.5);
  EXPECT_EQ(cell->scene.lights[1].direction, Vec3(1, 0, 0));
  EXPECT_EQ(cell->scene.lights[1].color, glm::vec3(1, 1, 1));
  EXPECT_EQ(cell->scene.light_direction, glm::vec3(0, 0, 2));
}

TEST_F(CellLayers, LightsAreHeldToTheirLimits) {
  EXPECT_EQ(faultsOf("format = 1\n[[light]]\nname = 'a'\ndirection = [0, 0, 0]\n"
                     "[[light]]\nname = 'b'\ndirection = [0, 0, 1]\nstrength = -1\n"
                     "[[light]]\nname = 'c'\n[scene]\nlight = [0, 0, 1]\n"),
            "test.cell.toml:4:13: error: `direction` has no length [cell.no-direction]\n"
            "test.cell.toml:8:12: error: `strength` is between 0 and 100 [cell.bad-number]\n"
            "test.cell.toml:9:1: error: [[light]] lacks `direction` [cell.missing-key]\n"
            "test.cell.toml:12:9: warning: `light` of [scene] has no effect: the cell has "
            "[[light]]s (the first [[light]] is the key light) [cell.useless-light]\n");
  std::string many = "format = 1\n";
  for (int i = 0; i < 9; ++i) {
    many += "[[light]]\nname = 'l" + std::to_string(i) + "'\ndirection = [0, 0, 1]\n";
  }
  EXPECT_EQ(faultsOf(many),
            "test.cell.toml:27:8: error: the cell has more than 8 lights [cell.too-many]\n");
}

}  // namespace
}  // namespace rocinante
