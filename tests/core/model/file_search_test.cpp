#include "core/model/file_search.h"

#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/stat.h>

#include "tests/core/model/model_test_support.h"

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

  // What is found, from the search root on; or why nothing is.
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
  const std::string outside = "it lies outside the search roots";
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
  EXPECT_EQ(found("meshes", cell()), "it is no regular file");
  ASSERT_EQ(::mkfifo((cell() / "pipe.obj").c_str(), 0600), 0);
  EXPECT_EQ(found("pipe.obj", cell()), "it is no regular file");
  EXPECT_EQ(found("https://example.org/a.stl", cell()), "files are not fetched from the network");
  EXPECT_EQ(found("$(find arm)/a.stl", cell()), "its name is an expression of a template");
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

TEST_F(FileSearchTest, AFileThatIsTooLargeOrNoFileIsNotRead) {
  EXPECT_TRUE(readWholeFile(cell() / "near.obj", 1).ok());
  EXPECT_EQ(readWholeFile(cell() / "near.obj", 0).error().kind, ErrorKind::unsupported);
  EXPECT_EQ(readWholeFile("/dev/zero", 100).error().kind, ErrorKind::unsupported);
  EXPECT_EQ(readWholeFile(cell() / "none", 100).error().kind, ErrorKind::not_found);
}

}  // namespace
}  // namespace rocinante
