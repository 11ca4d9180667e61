#include "core/search/file_search.h"

#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/stat.h>

#include "core/document/fault_list.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;
using Why = FoundFile::Why;

class FileSearchTest : public testing::Test {
 protected:
  FileSearchTest() {
    for (const char* file :
         {"cell/models/arm_description/urdf/arm.urdf", "cell/models/arm_description/meshes/a.stl",
          "cell/models/arm_description/materials/textures/skin.png", "cell/near.obj",
          "cell/with space.obj", "cell/meshes/b.stl", "outside/secret.obj", "other/extra.obj"}) {
      test::writeFile(folder_ / file, "x");
    }
    EXPECT_TRUE(search_.addRoot(cell()).ok());
  }
  fs::path cell() const { return folder_ / "cell"; }
  fs::path urdf() const { return cell() / "models/arm_description/urdf"; }

  // The found path, relative to the search root; or why nothing is found.
  std::string found(const std::string& name, const fs::path& beside) const {
    const FoundFile file = search_.find(name, beside);
    if (file.path.empty()) return file.problem();
    return (file.why == Why::found_elsewhere ? "elsewhere: " : "") +
           file.path.lexically_relative(folder_.path()).string();
  }

  test::TemporaryFolder folder_;
  FileSearch search_;
};

TEST_F(FileSearchTest, FindsEveryFormOfNameThatModelsUse) {
  const std::string mesh = "cell/models/arm_description/meshes/a.stl";
  for (const char* name :
       {"package://arm_description/meshes/a.stl", "package:///arm_description/meshes/a.stl",
        "model://arm_description/meshes/a.stl", "../meshes/a.stl", "..\\meshes\\a.stl",
        "file:../meshes/a.stl"}) {
    EXPECT_EQ(found(name, urdf()), mesh) << name;
  }
  EXPECT_EQ(found("package://meshes/b.stl", cell()), "cell/meshes/b.stl") << "no package name";
  EXPECT_EQ(found("near.obj", urdf()), "cell/near.obj") << "in a root";
  EXPECT_EQ(found("with%20space.obj", cell()), "cell/with space.obj");
  EXPECT_EQ(found("file://" + (cell() / "near.obj").string(), urdf()), "cell/near.obj");
  EXPECT_EQ(found((cell() / "near.obj").string(), urdf()), "cell/near.obj");
  EXPECT_EQ(found("skin.png", cell() / "models/arm_description/meshes"),
            "cell/models/arm_description/materials/textures/skin.png");
}

TEST_F(FileSearchTest, FindsAbsoluteNamesOfOtherMachinesByTheirLastParts) {
  for (const char* name : {"C:/Users/bob/robot/meshes/b.stl", "C:\\Users\\bob\\meshes\\b.stl",
                           "file:///C:/Users/bob/meshes/b.stl", "/opt/robots/meshes/b.stl",
                           "file:///usr/share/robots/meshes/b.stl"}) {
    EXPECT_EQ(found(name, urdf()), "elsewhere: cell/meshes/b.stl") << name;
  }
}

TEST_F(FileSearchTest, OpensNothingOutsideTheRoots) {
  const std::string outside = "it is outside the search roots";
  EXPECT_EQ(found("../outside/secret.obj", cell()), outside);
  EXPECT_EQ(found("meshes/../../outside/secret.obj", cell()), outside);
  EXPECT_EQ(found("package://../outside/secret.obj", cell()), outside);
  EXPECT_EQ(found((folder_ / "outside/secret.obj").string(), cell()), outside);
  EXPECT_EQ(found("file:///dev/zero", cell()), outside);
  fs::create_symlink(folder_ / "outside/secret.obj", cell() / "link.obj");
  EXPECT_EQ(found("link.obj", cell()), outside) << "a link out of the roots";
  fs::create_directory_symlink(folder_ / "outside", cell() / "linked");
  EXPECT_EQ(found("linked/secret.obj", cell()), outside);
  fs::create_symlink(cell() / "near.obj", cell() / "inside.obj");
  EXPECT_EQ(found("inside.obj", cell()), "cell/near.obj") << "a link within them";
}

TEST_F(FileSearchTest, RefusesWhatIsNoFileAndWhatIsNoName) {
  EXPECT_EQ(found("meshes", cell()), "it is not a regular file");
  ASSERT_EQ(::mkfifo((cell() / "pipe.obj").c_str(), 0600), 0);
  EXPECT_EQ(found("pipe.obj", cell()), "it is not a regular file");
  EXPECT_EQ(found("https://example.org/a.stl", cell()), "files are not fetched from the network");
  EXPECT_EQ(found("$(find arm)/a.stl", cell()), "its name is a template expression");
  for (const std::string& name : {std::string(), std::string("a\0b", 3), std::string(5000, 'a')}) {
    EXPECT_EQ(found(name, cell()), "there is no such file within the search roots");
  }
}

TEST_F(FileSearchTest, RootsOfTheEnvironmentCountWhenAskedFor) {
  ::setenv("ROCINANTE_PATH", (folder_ / "other:/no/such/folder:").c_str(), 1);
  EXPECT_EQ(found("extra.obj", cell()), "there is no such file within the search roots");
  search_.addEnvironmentRoots();
  EXPECT_EQ(found("extra.obj", cell()), "other/extra.obj");
  ::unsetenv("ROCINANTE_PATH");
}

TEST_F(FileSearchTest, WhatLiesBesideAMeshOfAPackageMayBeOpened) {
  // As example-robot-data has it: a bare URDF, whose root is its own folder.
  test::writeFile(folder_ / "data/robots/anymal/meshes/base.dae", "x");
  test::writeFile(folder_ / "data/robots/anymal/meshes/skin.jpg", "x");
  test::writeFile(folder_ / "data/robots/anymal/materials/textures/skin2.png", "x");
  test::writeFile(folder_ / "data/robots/anymal/urdf/anymal.urdf", "x");
  const fs::path bare = folder_ / "data/robots/anymal/urdf";
  FileSearch search;
  ASSERT_TRUE(search.addRoot(bare).ok());
  search.setPackagesAbove(bare);
  const FoundFile mesh = search.find("package://data/robots/anymal/meshes/base.dae", bare);
  ASSERT_EQ(mesh.why, Why::found);
  const fs::path meshes = mesh.path.parent_path();
  EXPECT_EQ(search.find("skin.jpg", meshes).why, Why::outside) << "said by nobody";
  const FoundFile skin = search.find("skin.jpg", meshes, &mesh);
  EXPECT_EQ(skin.why, Why::found);
  EXPECT_EQ(fs::canonical(skin.path),
            fs::canonical(folder_ / "data/robots/anymal/meshes/skin.jpg"));
  EXPECT_EQ(search.find("skin2.png", meshes, &mesh).why, Why::found) << "../materials/textures";
  // And only the package.
  EXPECT_EQ(search.find("../../../../outside/secret.obj", meshes, &mesh).why, Why::outside);
  EXPECT_EQ(search.find("/etc/passwd", meshes, &mesh).why, Why::outside);
  fs::create_symlink("/etc/passwd", folder_ / "data/robots/anymal/meshes/link.png");
  EXPECT_EQ(search.find("link.png", meshes, &mesh).why, Why::outside);
}

TEST_F(FileSearchTest, MeshesAreFoundBesideAFolderOfModels) {
  test::writeFile(folder_ / "robot/meshes/part.STL", "x");
  test::writeFile(folder_ / "robot/meshes/skin.png", "x");
  test::writeFile(folder_ / "robot/notes.txt", "secret");
  test::writeFile(folder_ / "above.stl", "x");
  fs::create_symlink(folder_ / "robot/notes.txt", folder_ / "robot/meshes/notes.png");
  fs::create_symlink(folder_ / "outside/secret.obj", folder_ / "robot/meshes/secret.obj");
  for (const char* name : {"urdf", "robots", "xacro", "sdf", "models", "arm"}) {
    SCOPED_TRACE(name);
    const fs::path bare = folder_ / "robot" / name;
    test::writeFile(bare / "a.urdf", "x");
    FileSearch search;
    ASSERT_TRUE(search.addRoot(bare).ok());
    const FoundFile mesh = search.find("../meshes/part.STL", bare);
    if (std::string_view(name) == "arm") {
      EXPECT_EQ(mesh.why, Why::outside);
      EXPECT_EQ(mesh.hint(), "--search " + (fs::canonical(folder_.path()) / "robot").string() +
                                 " permits it, or `search` in the cell");
      continue;
    }
    ASSERT_EQ(mesh.why, Why::found);
    EXPECT_EQ(mesh.path, folder_ / "robot/meshes/part.STL");
    // What the mesh names, by the same rule.
    EXPECT_EQ(search.find("skin.png", folder_ / "robot/meshes", &mesh).why, Why::found);
    EXPECT_EQ(search.find("../notes.txt", folder_ / "robot/meshes", &mesh).why, Why::outside);
    for (const char* refused :
         {"../notes.txt", "../meshes/notes.png", "../meshes/secret.obj", "../../above.stl"}) {
      EXPECT_EQ(search.find(refused, bare).why, Why::outside) << refused;
    }
    EXPECT_EQ(search.find("../meshes/none.stl", bare).why, Why::missing);
  }
}

TEST_F(FileSearchTest, APackageBesideABareModelGivesItsMeshes) {
  test::writeFile(folder_ / "ws/art/meshes/c.stl", "x");
  test::writeFile(folder_ / "ws/art/private/key", "secret");
  test::writeFile(folder_ / "ws/robots/humanoid/r.urdf", "x");
  const fs::path bare = folder_ / "ws/robots/humanoid";
  FileSearch search;
  ASSERT_TRUE(search.addRoot(bare).ok());
  search.setPackagesAbove(bare);
  EXPECT_EQ(search.find("package://art/meshes/c.stl", bare).why, Why::found);
  EXPECT_EQ(search.find("model://art/meshes/../meshes/c.stl", bare).why, Why::found);
  EXPECT_EQ(search.find("package://art/private/key", bare).why, Why::outside);
  EXPECT_EQ(search.find("package://art/../robots/humanoid/../../art/private/key", bare).why,
            Why::outside);
}

TEST_F(FileSearchTest, APackageIsCalledWhatItsPackageXmlSays) {
  const fs::path irb = cell() / "abb_irb140";
  test::writeFile(irb / "meshes/base.stl", "x");
  test::writeFile(irb / "urdf/irb.urdf", "x");
  const std::string name = "package://abb_irb140_support/meshes/base.stl";
  const FoundFile missing = search_.find(name, irb / "urdf");
  EXPECT_EQ(
      missing.problem(),
      "package `abb_irb140_support` is not found: no folder above the file or in a search root "
      "has this name or declares it in its package.xml");
  EXPECT_EQ(missing.hint(), "the folder `" + fs::canonical(irb).string() +
                                "` has such a file: --package abb_irb140_support=" +
                                fs::canonical(irb).string() + ", or [packages] in the cell");

  test::writeFile(irb / "package.xml",
                  "<?xml version=\"1.0\"?><!-- <name>no</name> -->\n<package format=\"2\">\n"
                  "<author email=\"a@b.c\">name</author> <name>\n abb_irb140_support </name>\n");
  const auto fresh = [&](const fs::path& root, const fs::path& beside) {
    FileSearch search;
    EXPECT_TRUE(search.addRoot(root).ok());
    return search.find(name, beside);
  };
  const FoundFile found = fresh(cell(), irb / "urdf");
  EXPECT_EQ(found.path, irb / "meshes/base.stl") << found.problem();
  EXPECT_EQ(found.package, fs::canonical(irb));
  EXPECT_EQ(fresh(cell(), cell() / "meshes").path, irb / "meshes/base.stl") << "in a root";
  EXPECT_EQ(fresh(irb, irb / "urdf").path, irb / "meshes/base.stl") << "the root itself";

  FileSearch bare;
  ASSERT_TRUE(bare.addRoot(irb / "urdf").ok());
  bare.setPackagesAbove(irb / "urdf");
  EXPECT_EQ(bare.find(name, irb / "urdf").why, Why::found);
  EXPECT_EQ(bare.find("../meshes/base.stl", irb / "urdf").why, Why::found)
      << "the package that it lies in is a root";
  EXPECT_EQ(bare.find("../../near.obj", irb / "urdf").why, Why::outside);
}

TEST_F(FileSearchTest, PackagesMeanTheFoldersThatTheyWereGiven) {
  test::writeFile(folder_ / "far/irb/meshes/base.stl", "x");
  test::writeFile(cell() / "abb/meshes/base.stl", "x");
  ASSERT_TRUE(search_.addPackage({"abb", folder_ / "far/irb"}).ok());
  ASSERT_TRUE(search_.addPackage({"abb", cell() / "abb"}).ok());
  EXPECT_EQ(found("package://abb/meshes/base.stl", cell()), "far/irb/meshes/base.stl")
      << "the first outranks the second, and a folder of the name";
  EXPECT_EQ(found("package://abb/meshes/none.stl", cell()),
            "package `abb` is `" + (folder_ / "far/irb").string() + "`, which has no such file");
  EXPECT_EQ(found("package://abb/../../outside/secret.obj", cell()),
            "it is outside the search roots");
  const Status refused = search_.addPackage({"gone", folder_ / "none"});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().what, "the folder of package `gone` does not exist");
}

TEST(QuotedPathInFault, KeepsTheFilesName) {
  EXPECT_EQ(quotedPathInFault("a/b.stl"), "`a/b.stl`");
  const std::string folders = "package://abb_irb140_support/" + std::string(60, 'm') + "/visual/";
  EXPECT_EQ(quotedPathInFault(folders + "base_link.dae"), "`.../visual/base_link.dae`");
  const std::string file = std::string(80, 'f') + ".dae";
  EXPECT_EQ(quotedPathInFault(folders + file), "`.../" + file + "`");
  EXPECT_EQ(quotedPathInFault("C:\\" + folders + "base_link.dae"), "`.../visual/base_link.dae`");
}

TEST_F(FileSearchTest, AFileThatIsTooLargeOrNoFileIsNotRead) {
  EXPECT_TRUE(readWholeFile(cell() / "near.obj", 1).ok());
  EXPECT_EQ(readWholeFile(cell() / "near.obj", 0).error().kind, ErrorKind::unsupported);
  EXPECT_EQ(readWholeFile("/dev/zero", 100).error().kind, ErrorKind::unsupported);
  EXPECT_EQ(readWholeFile(cell() / "none", 100).error().kind, ErrorKind::not_found);
}

}  // namespace
}  // namespace rocinante
