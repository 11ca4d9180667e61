#include <gtest/gtest.h>

#include <algorithm>

#include "core/cell/posed_scene.h"
#include "core/kinematics/kinematics.h"
#include "tests/core/cell/cell_fixture.h"

namespace rocinante {
namespace {

class CellMaterials : public test::CellFolder {
 protected:
  CellMaterials() {
    test::writeFile(folder_ / "two.mtl",
                    "newmtl steel\nKd 0.5 0.5 0.5\nKs 0.1 0.1 0.1\nnewmtl paint\nKd 1 0 0\n"
                    "map_Kd old.png\n");
    test::writeFile(folder_ / "two.obj",
                    "mtllib two.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\ng frame\nusemtl steel\nf 1 2 3\n"
                    "usemtl paint\nf 1 2 3\ng door_left\nusemtl paint\nf 1 2 3\n");
    test::writeFile(folder_ / "old.png", "");
    test::writeFile(folder_ / "skins/new.png", "");
  }
  static constexpr std::string_view kTwo = R"(format = 1
[[device]]
name = "box_1"
model = "two"
[[device]]
name = "box_2"
model = "two"
[[device]]
name = "arm"
model = "arm.urdf"
[[model]]
name = "two"
obj = "two.obj"
unit = "m"
up = "z"
[[model.link]]
name = "base"
groups = ["frame"]
[[model.link]]
name = "door"
parent = "base"
groups = ["door*"]
joint = { name = "hinge", type = "revolute", axis = [0, 0, 1] }
)";
  Result<Cell> loadWith(const std::string& materials) {
    std::string text(kTwo);
    text.append(materials);
    return load(text);
  }
  // The looks of a link's parts, in drawing order.
  static std::vector<Material> looks(const Model& model, std::size_t link) {
    std::vector<Material> found;
    for (const Visual& visual : model.links[link].visuals) {
      for (const std::size_t part : visual.mesh_parts) {
        found.push_back(visual.material
                            ? *visual.material
                            : visual.mesh->materials[visual.mesh->parts[part].material]);
      }
    }
    return found;
  }
};

TEST_F(CellMaterials, AMaterialIsChangedByName) {
  const auto cell = loadWith(R"([[material]]
material = "steel"
specular = "#ffffff"
shininess = 80
)");
  ASSERT_TRUE(cell.ok());
  EXPECT_EQ(test::printed(cell->faults), "");
  const auto base = looks(*cell->modelOf(cell->devices[0]), 0);
  ASSERT_EQ(base.size(), 2U);
  EXPECT_EQ(base[0].name, "paint") << "unchanged ones come first";
  EXPECT_FALSE(base[0].diffuse_map.empty());
  EXPECT_EQ(base[1].specular, glm::vec3(1.0F));
  EXPECT_EQ(base[1].shininess, 80.0F);
  EXPECT_EQ(base[1].diffuse, glm::vec4(0.5F, 0.5F, 0.5F, 1.0F)) << "the rest stays";
  EXPECT_EQ(cell->modelOf(cell->devices[0]), cell->modelOf(cell->devices[1])) << "still shared";
}

TEST_F(CellMaterials, ADeviceAndALinkAndAGroupCanBeChosen) {
  const auto cell = loadWith(R"([[material]]
device = "box_?"
link = "door"
group = "door_*"
texture = "skins/new.png"
texture_scale = [2, 3]
[[material]]
device = "box_2"
color = "#00ff0080"
)");
  ASSERT_TRUE(cell.ok());
  EXPECT_EQ(test::printed(cell->faults), "");
  const Model &first = *cell->modelOf(cell->devices[0]), &second = *cell->modelOf(cell->devices[1]);
  EXPECT_EQ(looks(first, 0)[0].name, "steel");
  EXPECT_EQ(looks(first, 1)[0].diffuse_map.filename(), "new.png");
  EXPECT_EQ(looks(first, 1)[0].diffuse, glm::vec4(1.0F)) << "a picture is seen as it is";
  EXPECT_EQ(looks(first, 1)[0].map_scale, glm::vec2(2.0F, 3.0F));
  EXPECT_EQ(looks(second, 0)[0].diffuse, glm::vec4(0.0F, 1.0F, 0.0F, 128 / 255.0F));
  EXPECT_TRUE(looks(second, 1)[0].diffuse_map.empty()) << "a later colour takes the picture away";
  EXPECT_EQ(first.links[0].visuals[0].mesh, second.links[0].visuals[0].mesh)
      << "geometry is shared";
  EXPECT_EQ(kinematicsHash(first), kinematicsHash(second));
  const auto in_files = [&](const std::filesystem::path& path) {
    return std::ranges::find(cell->files, path) != cell->files.end();
  };
  EXPECT_TRUE(in_files(folder_ / "skins/new.png"));
}

TEST_F(CellMaterials, OpacityAndWrapCanBeChosen) {
  const auto cell = loadWith(R"([[material]]
link = "door"
texture = "skins/new.png"
texture_rotation_deg = 90
texture_wrap = "clamp"
alpha = "mask"
alpha_cutoff = 0.25
)");
  ASSERT_TRUE(cell.ok());
  EXPECT_EQ(test::printed(cell->faults), "");
  const Material door = looks(*cell->modelOf(cell->devices[0]), 1)[0];
  EXPECT_NEAR(door.map_rotation, 1.5707963F, 1e-6F);
  EXPECT_EQ(door.wrap_u, TextureWrap::clamp_to_edge);
  EXPECT_EQ(door.wrap_v, TextureWrap::clamp_to_edge);
  EXPECT_EQ(door.alpha_mode, AlphaMode::mask);
  EXPECT_EQ(door.alpha_cutoff, 0.25F);
  const auto wrong = loadWith("[[material]]\nalpha = 'glass'\n[[material]]\nalpha_cutoff = 2\n");
  ASSERT_TRUE(wrong.ok());
  EXPECT_NE(test::printed(wrong->faults).find("`glass` is not one of blend, opaque, mask"),
            std::string::npos);
  EXPECT_NE(test::printed(wrong->faults).find("`alpha_cutoff` is between 0 and 1"),
            std::string::npos);
}

TEST_F(CellMaterials, ADeviceThatIsAddedByItsOwnModelKeepsItsLooks) {
  const auto cell = loadWith("[[material]]\ndevice = 'box_1'\ncolor = '#0000ff'\n");
  ASSERT_TRUE(cell.ok());
  const PosedScene scene =
      poseScene(*cell, test::stateOf("add box_1 two\nadd box_2 two\nadd box_3 two\n"));
  EXPECT_EQ(looks(*scene.findDevice("box_1")->model, 0)[0].diffuse, glm::vec4(0, 0, 1, 1));
  EXPECT_EQ(looks(*scene.findDevice("box_2")->model, 0)[0].name, "steel");
  EXPECT_EQ(scene.findDevice("box_2")->model, scene.findDevice("box_3")->model);
  const PosedScene other = poseScene(*cell, test::stateOf("add box_1 arm.urdf\n"));
  EXPECT_EQ(other.findDevice("box_1")->model->name, "arm");
}

TEST_F(CellMaterials, FaultsSayWhereAndWhat) {
  std::string text(kTwo);
  text.append(R"([[material]]
link = "door"
[[material]]
device = "nobody"
color = "#000000"
[[material]]
texture = "none.png"
shininess = -1
)");
  const std::string faults = faultsOf(text);
  EXPECT_EQ(faults,
            "test.cell.toml:24:1: error: [[material]] changes nothing (give it a color, texture, "
            "specular, emission or shininess) [cell.missing-key]\n"
            "test.cell.toml:26:1: warning: this [[material]] matches nothing in the cell "
            "(`device`, `link`, `group` and `material` must all match) [cell.unused-material]\n"
            "test.cell.toml:30:11: warning: the texture `none.png` is not used: there is no such "
            "file within the search roots (add its folder to `search` in the cell, or use "
            "--search) [model.missing-texture]\n"
            "test.cell.toml:31:13: error: `shininess` is between 0 and 1000 [cell.bad-number]\n");
}

}  // namespace
}  // namespace rocinante
