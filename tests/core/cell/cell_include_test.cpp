#include <gtest/gtest.h>

#include "tests/core/cell/cell_fixture.h"

namespace rocinante {
namespace {

class CellInclude : public test::CellFolder {
 protected:
  std::vector<std::string> deviceNames(const Cell& cell) {
    std::vector<std::string> names;
    for (const CellDevice& device : cell.devices) names.push_back(device.name);
    return names;
  }
};

TEST_F(CellInclude, NamesInAnIncludedFileAreLookedForBesideIt) {
  test::writeFile(folder_ / "site/site.cell.toml", R"(format = 1
search = ["parts"]
[[device]]
name = "arm"
model = "arm.urdf"
[[device]]
name = "bolt"
model = "bolt"
[[model]]
name = "bolt"
obj = "bolt.obj"
unit = "mm"
up = "z"
[[layer]]
name = "robots"
)");
  test::writeFile(folder_ / "site/arm.urdf", "<robot name='other'><link name='only'/></robot>");
  test::writeFile(folder_ / "site/parts/bolt.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const auto cell = load(R"(format = 1
include = ["site/site.cell.toml"]
[[device]]
model = "arm.urdf"
name = "mine"
layer = "robots"
)");
  ASSERT_TRUE(cell.ok()) << cell.error().text();
  EXPECT_EQ(test::printed(cell->faults, folder_.path()), "");
  EXPECT_EQ(deviceNames(*cell), (std::vector<std::string>{"mine", "arm", "bolt"}));
  EXPECT_EQ(cell->modelOf(cell->devices[0])->name, "arm");
  EXPECT_EQ(cell->modelOf(cell->devices[1])->name, "other") << "the same text, another file";
  EXPECT_EQ(cell->devices[1].model, "site/arm.urdf");
  EXPECT_EQ(cell->modelOf(cell->devices[2])->links[0].visuals[0].mesh->triangleCount(), 1U);
  EXPECT_EQ(cell->files.size(), 5U) << "all of them, for attaching";
}

TEST_F(CellInclude, TheDecodersOfWhatIncludesAreUsed) {
  test::writeFile(folder_ / "site/site.cell.toml", "format = 1\ndecoders = \"site.toml\"\n");
  test::writeFile(folder_ / "site/site.toml", "");
  test::writeFile(folder_ / "mine.toml", "");
  const std::string below = "format = 1\ninclude = [\"site/site.cell.toml\"]\n";
  const auto theirs = load(below);
  ASSERT_TRUE(theirs.ok()) << theirs.error().text();
  EXPECT_EQ(theirs->decoders.filename(), "site.toml");
  EXPECT_EQ(theirs->files.size(), 3U) << "all of them, for attaching";
  const auto mine = load(below + "decoders = \"mine.toml\"\n");
  ASSERT_TRUE(mine.ok()) << mine.error().text();
  EXPECT_EQ(mine->decoders.filename(), "mine.toml");
  const auto missing = load("format = 1\ndecoders = \"nowhere.toml\"\n");
  ASSERT_TRUE(missing.ok()) << missing.error().text();
  EXPECT_TRUE(missing->decoders.empty());
  ASSERT_EQ(missing->faults.size(), 1U);
  EXPECT_EQ(missing->faults[0].rule, "cell.missing-file");
  EXPECT_EQ(missing->faults[0].line, 2U);
}

TEST_F(CellInclude, WhatIncludesOutranksWhatIsIncluded) {
  test::writeFile(folder_ / "below.cell.toml", R"(format = 1
[[camera]]
name = "overview"
eye = [1, 0, 0]
target = [0, 0, 0]
[[camera]]
name = "top"
eye = [0, 0, 9]
target = [0, 0, 0]
[scene]
grid = false
grid_size_m = 3
)");
  const auto cell = load(R"(format = 1
include = ["below.cell.toml"]
[[camera]]
name = "overview"
eye = [2, 0, 0]
target = [0, 0, 0]
[scene]
grid_size_m = 4
)");
  ASSERT_TRUE(cell.ok());
  ASSERT_EQ(cell->cameras.size(), 2U);
  EXPECT_EQ(cell->findCamera("overview")->eye.x, 2.0);
  EXPECT_FALSE(cell->scene.grid);
  EXPECT_EQ(cell->scene.grid_size_m, 4.0);
  EXPECT_EQ(test::printed(cell->faults, folder_.path()),
            "below.cell.toml:3:8: note: [[camera]] `overview` is replaced by that of "
            "test.cell.toml:4, which includes this file [cell.replaced]\n");
}

TEST_F(CellInclude, TwoIncludedFilesMayNotClaimOneName) {
  test::writeFile(folder_ / "a.cell.toml", "format = 1\n[[layer]]\nname = 'l'\n");
  test::writeFile(folder_ / "b.cell.toml", "format = 1\n[[layer]]\nname = 'l'\nvisible = false\n");
  EXPECT_EQ(faultsOf("format = 1\ninclude = ['a.cell.toml', 'b.cell.toml']\n"),
            "b.cell.toml:3:8: error: a second [[layer]] is named `l` (that of a.cell.toml:3 is "
            "used) [cell.duplicate-name]\n");
}

TEST_F(CellInclude, AFileThatSeveralIncludeIsReadOnce) {
  test::writeFile(folder_ / "common.cell.toml", "format = 1\n[[layer]]\nname = 'l'\n");
  test::writeFile(folder_ / "a.cell.toml", "format = 1\ninclude = ['common.cell.toml']\n");
  test::writeFile(folder_ / "b.cell.toml",
                  "format = 1\ninclude = ['common.cell.toml']\n[[layer]]\nname = 'l'\n");
  const auto cell = load("format = 1\ninclude = ['a.cell.toml', 'b.cell.toml']\n");
  ASSERT_TRUE(cell.ok());
  EXPECT_EQ(cell->layers.size(), 1U);
  EXPECT_EQ(cell->faults.size(), 1U);
  EXPECT_EQ(cell->faults[0].rule, "cell.replaced") << "b includes it, wherever else it stands";
}

TEST_F(CellInclude, ACircleIsRefusedWithBothPlaces) {
  test::writeFile(folder_ / "a.cell.toml", "format = 1\ninclude = ['b.cell.toml']\n");
  test::writeFile(folder_ / "b.cell.toml", "format = 1\n\ninclude = ['./a.cell.toml']\n");
  EXPECT_EQ(faultsOf("format = 1\ninclude = ['a.cell.toml']\n"),
            "b.cell.toml:3:12: error: `./a.cell.toml` is not included: it is the file that "
            "includes this one, at a.cell.toml:2 (files cannot include each other in a circle) "
            "[cell.include-loop]\n");
  EXPECT_EQ(faultsOf("format = 1\ninclude = ['test.cell.toml']\n"),
            "test.cell.toml:2:12: error: `test.cell.toml` is not included: it is this very file "
            "(files cannot include each other in a circle) [cell.include-loop]\n");
}

TEST_F(CellInclude, DepthAndNumberAreBounded) {
  for (int i = 0; i < 100; ++i) {
    const std::string next = std::to_string(i + 1) + ".cell.toml";
    test::writeFile(folder_ / ("deep" + std::to_string(i) + ".cell.toml"),
                    "format = 1\ninclude = ['deep" + next + "']\n");
    test::writeFile(folder_ / ("wide" + std::to_string(i) + ".cell.toml"), "format = 1\n");
  }
  const auto deep = load("format = 1\ninclude = ['deep0.cell.toml']\n");
  ASSERT_TRUE(deep.ok());
  ASSERT_EQ(deep->faults.size(), 1U);
  EXPECT_EQ(deep->faults[0].rule, "cell.too-many");
  EXPECT_EQ(deep->files.size(), 17U);
  std::string text = "format = 1\ninclude = [";
  for (int i = 0; i < 100; ++i) text += "'wide" + std::to_string(i) + ".cell.toml', ";
  const auto wide = load(text + "]\n");
  ASSERT_TRUE(wide.ok());
  EXPECT_EQ(wide->files.size(), 64U);
  EXPECT_EQ(wide->faults.size(), 37U);
}

TEST_F(CellInclude, WhatCannotBeReadIsAFaultAndTheRestLoads) {
  test::writeFile(folder_ / "broken.cell.toml", "format = 1\n[[device]\n");
  test::writeFile(folder_ / "later.cell.toml", "format = 2\n[[layer]]\nname = 'l'\n");
  const std::string faults = faultsOf(
      "format = 1\ninclude = ['broken.cell.toml', 'later.cell.toml', 'none.cell.toml', "
      "'../../../../../../../../etc/passwd', 7]\n[[device]]\nmodel = 'arm.urdf'\n");
  EXPECT_NE(faults.find("test.cell.toml:2:12: error: `broken.cell.toml` is not included: "),
            std::string::npos)
      << faults;
  EXPECT_NE(faults.find("(broken.cell.toml:2:"), std::string::npos) << faults;
  EXPECT_NE(faults.find("the cell has format 2"), std::string::npos) << faults;
  EXPECT_NE(faults.find("`none.cell.toml` is not included: there is no such file"),
            std::string::npos)
      << faults;
  EXPECT_NE(faults.find("passwd` is not included: "), std::string::npos) << faults;
  EXPECT_NE(faults.find("[cell.wrong-kind]"), std::string::npos) << faults;
}

TEST_F(CellInclude, ThreeLinesAreACell) {
  const auto cell = load("format = 1\n[[device]]\nmodel = 'models/arm.urdf'\n");
  ASSERT_TRUE(cell.ok());
  EXPECT_EQ(test::printed(cell->faults), "");
  ASSERT_EQ(cell->devices.size(), 1U);
  EXPECT_EQ(cell->devices[0].name, "arm");
  EXPECT_EQ(
      faultsOf("format = 1\n[[device]]\nmodel = 'arm.urdf'\n[[device]]\nmodel = 'arm.urdf'\n"),
      "test.cell.toml:4:1: error: a second [[device]] is named `arm` (the first one is used) "
      "[cell.duplicate-name]\n");
}

}  // namespace
}  // namespace rocinante
