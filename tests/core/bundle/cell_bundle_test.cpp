#include "core/bundle/cell_bundle.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>

#include "core/bundle/cell_folder.h"
#include "core/kinematics/kinematics.h"
#include "tests/core/bundle/bundle_fixture.h"
#include "tests/support/shared_data.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

class CellBundleTest : public testing::Test {
 protected:
  CellBundle collected(const fs::path& cell, const CellOptions& options = {}) {
    auto bundle = collectCell(cell, options);
    EXPECT_TRUE(bundle.ok()) << bundle.error().text();
    return bundle.ok() ? std::move(*bundle) : CellBundle{};
  }
  /// Loads the bundle after its original files are gone.
  Cell loadedAlone(const CellBundle& bundle) {
    fs::remove_all(folder_.path());
    auto cell = loadBundle(bundle, "log:", {});
    EXPECT_TRUE(cell.ok()) << cell.error().text();
    return cell.ok() ? std::move(*cell) : Cell{};
  }
  static const Mesh* meshOf(const Cell& cell) {
    const Model* model = cell.modelOf(cell.devices.at(0));
    return model == nullptr ? nullptr : model->links.at(0).visuals.at(0).mesh.get();
  }

  test::TemporaryFolder folder_;
};

TEST_F(CellBundleTest, HoldsTheDecodersThatTheCellNames) {
  test::writeFile(folder_ / "cell/robots/my.decoders.toml", "# decoders");
  test::writeFile(folder_ / "cell/a.cell.toml",
                  "format = 1\ndecoders = \"robots/my.decoders.toml\"\n");
  const CellBundle bundle = collected(folder_ / "cell/a.cell.toml");
  EXPECT_THAT(test::namesIn(bundle), ElementsAre("a.cell.toml", "robots/my.decoders.toml"));
  const Cell cell = loadedAlone(bundle);
  EXPECT_EQ(test::fileText(cell.decoders), "# decoders");
  EXPECT_EQ(cell.shown(cell.decoders.string()), "log:robots/my.decoders.toml");
}

TEST_F(CellBundleTest, HoldsEveryFileThatACellNames) {
  test::writeTank(folder_ / "cell/tanks", "../skins/steel.png");
  test::writeFile(folder_ / "cell/skins/steel.png", "picture");
  test::writeFile(folder_ / "cell/arm.urdf", test::armWith("tanks/tank.obj"));
  test::writeFile(folder_ / "cell/not_named.urdf", "x");
  test::writeFile(folder_ / "cell/a.cell.toml",
                  "format = 1\n[[device]]\nname = \"a\"\nmodel = \"arm.urdf\"\n");
  const CellBundle bundle = collected(folder_ / "cell/a.cell.toml");
  EXPECT_EQ(bundle.manifest.main, "a.cell.toml");
  EXPECT_THAT(test::namesIn(bundle), ElementsAre("a.cell.toml", "arm.urdf", "skins/steel.png",
                                                 "tanks/tank.mtl", "tanks/tank.obj"));
  EXPECT_EQ(test::filesOf(bundle)["skins/steel.png"], "picture");

  const Cell cell = loadedAlone(bundle);
  EXPECT_EQ(cell.file, "log:a.cell.toml");
  ASSERT_NE(meshOf(cell), nullptr);
  const fs::path texture = meshOf(cell)->materials.at(0).diffuse_map;
  EXPECT_EQ(test::fileText(texture), "picture");
}

TEST_F(CellBundleTest, ItsFolderIsThereAsLongAsTheCell) {
  test::writeTank(folder_.path(), "steel.png");
  test::writeFile(folder_ / "steel.png", "picture");
  const CellBundle bundle = collected(folder_ / "tank.obj");
  fs::path texture;
  {
    const Cell cell = loadedAlone(bundle);
    texture = meshOf(cell)->materials.at(0).diffuse_map;
    EXPECT_TRUE(fs::exists(texture));
  }
  EXPECT_FALSE(fs::exists(texture));
  EXPECT_FALSE(fs::exists(texture.parent_path()));
}

TEST_F(CellBundleTest, PackagesAreFoundInWhatWasTheirFolder) {
  test::writeTank(folder_ / "ws/arm_description/meshes", "steel.png");
  test::writeFile(folder_ / "ws/arm_description/meshes/steel.png", "picture");
  test::writeFile(folder_ / "ws/arm_description/urdf/arm.urdf",
                  test::armWith("package://arm_description/meshes/tank.obj"));
  const CellBundle bundle = collected(folder_ / "ws/arm_description/urdf/arm.urdf");
  EXPECT_EQ(bundle.manifest.main, "arm_description/urdf/arm.urdf");
  EXPECT_NE(meshOf(loadedAlone(bundle)), nullptr);
}

TEST_F(CellBundleTest, RootsOfWhoeverAttachesComeAlongWithoutTheirPlace) {
  test::writeTank(folder_ / "opt/share/arm_description", "steel.png");
  test::writeFile(folder_ / "opt/share/arm_description/steel.png", "picture");
  test::writeFile(folder_ / "home/me/arm.urdf",
                  test::armWith("package://arm_description/tank.obj"));
  CellOptions options;
  options.search = {folder_ / "opt/share"};
  const CellBundle bundle = collected(folder_ / "home/me/arm.urdf", options);
  EXPECT_THAT(test::namesIn(bundle),
              ElementsAre("arm.urdf", "search/1/share/arm_description/steel.png",
                          "search/1/share/arm_description/tank.mtl",
                          "search/1/share/arm_description/tank.obj"));
  EXPECT_THAT(bundle.manifest.search, ElementsAre("search/1/share"));
  const Cell cell = loadedAlone(bundle);
  EXPECT_NE(meshOf(cell), nullptr);
  EXPECT_TRUE(cell.faults.empty());
}

TEST_F(CellBundleTest, PackagesInFoldersOfOtherNamesComeAlong) {
  test::writeTank(folder_ / "robots/irb/meshes", "steel.png");
  test::writeFile(folder_ / "robots/irb/meshes/steel.png", "picture");
  test::writeFile(folder_ / "robots/cell/arm.urdf",
                  test::armWith("package://irb_support/meshes/tank.obj"));
  test::writeFile(folder_ / "robots/cell/a.cell.toml",
                  "format = 1\npackages = { irb_support = \"../irb\" }\n"
                  "[[device]]\nmodel = \"arm.urdf\"\n");
  CellOptions options;
  options.packages = {{"irb_support", folder_ / "robots/irb"}};
  const CellBundle bundle = collected(folder_ / "robots/cell/a.cell.toml", options);
  const CellBundle bare = collected(folder_ / "robots/cell/arm.urdf", options);
  EXPECT_EQ(bare.manifest.packages.at("irb_support"), "irb");
  EXPECT_EQ(bundle.manifest.packages.at("irb_support"), "irb");
  // From here on the original is gone.
  const Cell cell = loadedAlone(bundle);
  ASSERT_NE(meshOf(cell), nullptr);
  EXPECT_FALSE(meshOf(cell)->materials.at(0).diffuse_map.empty());
  EXPECT_NE(meshOf(loadedAlone(bare)), nullptr);
}

TEST_F(CellBundleTest, EnvironmentRootsMeanNothingAfterwards) {
  test::writeTank(folder_ / "env/pkg", "steel.png");
  test::writeFile(folder_ / "env/pkg/steel.png", "picture");
  test::writeFile(folder_ / "cell/arm.urdf", test::armWith("package://pkg/tank.obj"));
  ::setenv("ROCINANTE_PATH", (folder_ / "env").c_str(), 1);
  CellOptions options;
  options.search_environment = true;
  const CellBundle bundle = collected(folder_ / "cell/arm.urdf", options);
  ::unsetenv("ROCINANTE_PATH");
  EXPECT_NE(meshOf(loadedAlone(bundle)), nullptr);
}

TEST_F(CellBundleTest, LinksAndAbsoluteNamesLeadWhereTheyLed) {
  test::writeTank(folder_ / "cell/v2", "skin.png");
  test::writeFile(folder_ / "cell/v2/steel.png", "picture");
  fs::create_symlink("steel.png", folder_ / "cell/v2/skin.png");
  fs::create_symlink("v2", folder_ / "cell/current");
  test::writeFile(folder_ / "cell/arm.urdf",
                  test::armWith("file://" + (folder_ / "cell/current/tank.obj").string()));
  fs::create_symlink("arm.urdf", folder_ / "cell/newest.urdf");
  const CellBundle bundle = collected(folder_ / "cell/newest.urdf");
  EXPECT_THAT(test::namesIn(bundle),
              ElementsAre("newest.urdf", "v2/steel.png", "v2/tank.mtl", "v2/tank.obj"));
  const Cell cell = loadedAlone(bundle);
  EXPECT_TRUE(cell.faults.empty()) << cell.faults[0].print();
  ASSERT_NE(meshOf(cell), nullptr);
  EXPECT_EQ(test::fileText(meshOf(cell)->materials.at(0).diffuse_map), "picture");
}

TEST_F(CellBundleTest, NamesThatAreNoUtf8ComeAlong) {
  test::writeTank(folder_.path(), "caf\xe9.png");
  test::writeFile(folder_ / "caf\xe9.png", "picture");
  const CellBundle bundle = collected(folder_ / "tank.obj");
  EXPECT_THAT(test::namesIn(bundle), ElementsAre("caf%E9.png", "tank.mtl", "tank.obj"));
  const Cell cell = loadedAlone(bundle);
  EXPECT_EQ(test::fileText(meshOf(cell)->materials.at(0).diffuse_map), "picture");
}

TEST_F(CellBundleTest, ACellThatDoesNotLoadWholeIsRefusedNamingWhatIsMissing) {
  test::writeFile(folder_ / "arm.urdf", test::armWith("meshes/gone.obj"));
  const auto bundle = collectCell(folder_ / "arm.urdf", {});
  ASSERT_FALSE(bundle.ok());
  EXPECT_THAT(bundle.error().what, HasSubstr("loads with errors"));
  EXPECT_THAT(bundle.error().what, HasSubstr("meshes/gone.obj"));
  EXPECT_THAT(bundle.error().where, HasSubstr("arm.urdf:2"));
}

TEST_F(CellBundleTest, AMissingTextureIsAWarningThatStays) {
  test::writeTank(folder_.path(), "gone.png");
  const CellBundle bundle = collected(folder_ / "tank.obj");
  ASSERT_EQ(bundle.warnings.size(), 1U);
  const Cell cell = loadedAlone(bundle);
  const auto warning = std::ranges::find(cell.faults, Severity::warning, &Finding::severity);
  ASSERT_NE(warning, cell.faults.end());
  EXPECT_THAT(warning->text, HasSubstr("gone.png"));
  EXPECT_EQ(warning->file, "log:tank.mtl");
}

// A stranger's cell that names what is ours.
TEST_F(CellBundleTest, WhatOnlyTheCellNamesAsARootIsNotTakenAlong) {
  test::writeFile(folder_ / "home/.ssh/id_rsa", "secret");
  test::writeFile(folder_ / "home/pictures/me.png", "secret");
  test::writeTank(folder_ / "home/pictures", "me.png");
  fs::create_directories(folder_ / "home/got/cell");
  fs::create_symlink(folder_ / "home/.ssh", folder_ / "home/got/cell/keys");
  fs::create_symlink(folder_ / "home/pictures/me.png", folder_ / "home/got/cell/skin.png");
  test::writeFile(
      folder_ / "home/got/cell/box.urdf",
      "<robot name='r'><link name='l'><visual><geometry><box size='1 1 1'/></geometry>"
      "<material name='m'><texture filename='id_rsa'/></material></visual></link></robot>");
  const std::string device = "[[device]]\nname = \"a\"\nmodel = \"box.urdf\"\n";
  const struct {
    const char* what;
    std::string cell, file, allowed;
  } cases[] = {
      {"a folder", "search = [\"" + (folder_ / "home/.ssh").string() + "\"]\n" + device, "id_rsa",
       "home/.ssh"},
      {"a folder above", "search = [\"../../.ssh\"]\n" + device, "id_rsa", "home/.ssh"},
      {"a link to a folder", "search = [\"keys\"]\n" + device, "id_rsa", "home/.ssh"},
      {"a package",
       "packages = { p = \"../../pictures\" }\n[[device]]\nname = \"a\"\nmodel = "
       "\"package://p/arm.urdf\"\n",
       "arm.urdf", "home/pictures"},
      {"decoders", "search = [\"../..\"]\ndecoders = \".ssh/id_rsa\"\n", "id_rsa", "home/.ssh"},
      {"a linked picture",
       "search = [\"../../pictures\"]\n[[material]]\ntexture = \"skin.png\"\n" + device, "me.png",
       "home/pictures"},
  };
  test::writeFile(folder_ / "home/pictures/arm.urdf", test::armWith("tank.obj"));
  for (const auto& each : cases) {
    SCOPED_TRACE(each.what);
    test::writeFile(folder_ / "home/got/cell/c.cell.toml", "format = 1\n" + each.cell);
    const auto refused = collectCell(folder_ / "home/got/cell/c.cell.toml", {});
    ASSERT_FALSE(refused.ok());
    EXPECT_THAT(refused.error().what,
                HasSubstr("this file lies outside its folder, where the cell itself says to look; "
                          "--search "));
    EXPECT_THAT(refused.error().where, testing::EndsWith(each.file));
    CellOptions options;
    options.search = {folder_ / each.allowed};
    EXPECT_TRUE(collectCell(folder_ / "home/got/cell/c.cell.toml", options).ok());
    EXPECT_TRUE(collectCell(folder_ / "home/got/cell/c.cell.toml", {}, MissingMeshes::refused,
                            BundleRoots::all)
                    .ok());
  }
}

TEST_F(CellBundleTest, ABareModelTakesMeshesAndTexturesOfItsPackageAndNothingElse) {
  test::writeFile(folder_ / "pkg/package.xml", "<package><name>pkg</name></package>");
  test::writeFile(folder_ / "pkg/private/notes", "secret");
  test::writeFile(folder_ / "pkg/textures/skin.png", "picture");
  const auto urdf = [&](const char* texture) {
    test::writeFile(
        folder_ / "pkg/urdf/a.urdf",
        "<robot name='r'><link name='l'><visual><geometry><box size='1 1 1'/></geometry>"
        "<material name='m'><texture filename='" +
            std::string(texture) + "'/></material></visual></link></robot>");
  };
  urdf("package://pkg/textures/skin.png");
  EXPECT_THAT(test::namesIn(collected(folder_ / "pkg/urdf/a.urdf")),
              ElementsAre("pkg/textures/skin.png", "pkg/urdf/a.urdf"));
  urdf("package://pkg/private/notes");
  EXPECT_FALSE(collectCell(folder_ / "pkg/urdf/a.urdf", {}).ok());
}

TEST_F(CellBundleTest, MeshesBesideTheFolderOfAUrdfComeAlong) {
  test::writeTank(folder_ / "robot/meshes", "steel.png");
  test::writeFile(folder_ / "robot/meshes/steel.png", "picture");
  test::writeFile(folder_ / "robot/urdf/arm.urdf", test::armWith("../meshes/tank.obj"));
  const CellBundle bundle = collected(folder_ / "robot/urdf/arm.urdf");
  EXPECT_THAT(test::namesIn(bundle), ElementsAre("meshes/steel.png", "meshes/tank.mtl",
                                                 "meshes/tank.obj", "urdf/arm.urdf"));
  EXPECT_NE(meshOf(loadedAlone(bundle)), nullptr);
}

TEST_F(CellBundleTest, ACellThatIsNotThereIsSaid) {
  const auto bundle = collectCell(folder_ / "none.cell.toml", {});
  ASSERT_FALSE(bundle.ok());
  EXPECT_EQ(bundle.error().kind, ErrorKind::not_found);
}

TEST_F(CellBundleTest, TheSameFilesElsewhereMakeTheSameBundle) {
  for (const char* place : {"one/cell", "two/deeper/cell"}) {
    test::writeTank(folder_ / place, "steel.png");
    test::writeFile(folder_ / place / "steel.png", "picture");
  }
  EXPECT_EQ(manifestText(collected(folder_ / "one/cell/tank.obj").manifest),
            manifestText(collected(folder_ / "two/deeper/cell/tank.obj").manifest));
}

TEST_F(CellBundleTest, RealRobotsComeBackWhole) {
  ROCINANTE_NEEDS_SHARED_DATA("robots");
  for (const char* robot : {"robots/puma560_description/urdf/puma560_robot.urdf",
                            "robots/kuka_iiwa/model.urdf", "robots/franka_panda/panda.urdf",
                            "robots/r2d2/r2d2.urdf", "env/waste_yard/waste_yard.obj"}) {
    SCOPED_TRACE(robot);
    const auto original = loadCell(test::sharedData(robot), {});
    ASSERT_TRUE(original.ok());
    const CellBundle bundle = collected(test::sharedData(robot));
    const auto cell = loadBundle(bundle, "log:", {});
    ASSERT_TRUE(cell.ok()) << cell.error().text();
    EXPECT_EQ(cell->files.size(), original->files.size());
    EXPECT_EQ(kinematicsHash(*cell->modelOf(cell->devices[0])),
              kinematicsHash(*original->modelOf(original->devices[0])));
    for (const BundleManifest::File& file : bundle.manifest.files) {
      EXPECT_TRUE(isBundleName(file.name)) << file.name;
    }
  }
}

TEST(LayOut, NeverReplacesOrFollowsWhatIsThere) {
  const test::TemporaryFolder folder;
  CellBundle bundle;
  bundle.manifest.files = {{"a", 1, ""}};
  bundle.contents = {Bytes(1)};
  fs::create_symlink(folder / "target", folder / "a");
  EXPECT_FALSE(layOut(bundle, folder.path()).ok());
  EXPECT_FALSE(fs::exists(folder / "target"));
}

TEST(LayOut, FoldersWithoutEndAreRefusedBeforeTheyAreMade) {
  const test::TemporaryFolder folder;
  CellBundle bundle;
  for (int i = 0; i < 200; ++i) {
    std::string name = "f" + std::to_string(i);
    while (name.size() < 1000) name += "/a";
    bundle.manifest.files.push_back({name, 1, ""});
    bundle.contents.emplace_back(1);
  }
  EXPECT_FALSE(layOut(bundle, folder.path()).ok());
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(LayOut, AFileNamedAsAFolderIsRefused) {
  const test::TemporaryFolder folder;
  CellBundle bundle;
  bundle.manifest.files = {{"a", 1, ""}, {"a/b", 1, ""}};
  bundle.contents = {Bytes(1), Bytes(1)};
  EXPECT_FALSE(layOut(bundle, folder.path()).ok());
}

}  // namespace
}  // namespace rocinante
