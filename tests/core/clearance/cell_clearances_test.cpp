// How `[[clearance]]` is read: docs/cell-format.md, "Clearances".
#include <gtest/gtest.h>

#include "core/cell/cell.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"

namespace rocinante {
namespace {

class CellClearances : public testing::Test {
 protected:
  Cell read(const std::string& tables) {
    test::writeFile(folder_ / "arm.urdf", "<robot name=\"arm\"><link name=\"base\"/></robot>");
    test::writeFile(folder_ / "cell.toml",
                    "format = 1\n[[device]]\nname = \"arm\"\nmodel = \"arm.urdf\"\n" + tables);
    auto cell = loadCell(folder_ / "cell.toml", {});
    EXPECT_TRUE(cell.ok());
    return cell.ok() ? std::move(*cell) : Cell{};
  }
  /// The rule of the only fault; all of them when there are several.
  std::string ruleOf(const std::string& table) {
    const Cell cell = read("[[clearance]]\n" + table);
    std::string rules;
    for (const Finding& fault : cell.faults) rules += (rules.empty() ? "" : " ") + fault.rule;
    return rules;
  }

  test::TemporaryFolder folder_;
};

TEST_F(CellClearances, AreReadWithTheirNamesAndExceptions) {
  const Cell cell = read(
      "[[clearance]]\nbetween = [\"arm/base\", \"layer/tanks\"]\nmin_m = 0.05\n"
      "except = [[\"arm*\", \"tank_?\"], [\"a\\\\*\", \"b*\"]]\n"
      "[[clearance]]\nname = \"folds\"\nself = \"arm\"\nmin_m = 0\n");
  EXPECT_TRUE(cell.faults.empty());
  ASSERT_EQ(cell.clearances.size(), 2U);
  EXPECT_EQ(cell.clearances[0].name, "arm/base to layer/tanks");
  EXPECT_EQ(cell.clearances[0].between, ClearancePatterns("arm/base", "layer/tanks"));
  EXPECT_FALSE(cell.clearances[0].is_self);
  EXPECT_EQ(cell.clearances[0].min_m, 0.05);
  ASSERT_EQ(cell.clearances[0].except.size(), 2U);
  EXPECT_EQ(cell.clearances[0].except[0], ClearancePatterns("arm*", "tank_?"));
  EXPECT_EQ(cell.clearances[1].name, "folds");
  EXPECT_TRUE(cell.clearances[1].is_self);
  EXPECT_EQ(cell.clearances[1].min_m, 0);
}

TEST_F(CellClearances, FaultsAreNamedAndTheTableIsLeftOut) {
  EXPECT_EQ(ruleOf("min_m = 1\n"), "cell.missing-key");
  EXPECT_EQ(ruleOf("between = [\"arm\", \"*\"]\nself = \"arm\"\nmin_m = 1\n"), "cell.missing-key");
  EXPECT_EQ(ruleOf("self = \"arm\"\n"), "cell.missing-key");
  EXPECT_EQ(ruleOf("self = \"\"\nmin_m = 1\n"), "cell.empty");
  EXPECT_EQ(ruleOf("self = 3\nmin_m = 1\n"), "cell.wrong-kind");
  EXPECT_EQ(ruleOf("self = \"arm\"\nmin_m = -1\n"), "cell.bad-number");
  EXPECT_EQ(ruleOf("self = \"arm\"\nmin_m = 1e9\n"), "cell.bad-number");
  EXPECT_EQ(ruleOf("between = [\"arm\"]\nmin_m = 1\n"), "cell.wrong-kind");
  EXPECT_EQ(ruleOf("between = [\"arm\", \"\"]\nmin_m = 1\n"), "cell.wrong-kind");
  EXPECT_EQ(ruleOf("between = \"arm\"\nmin_m = 1\n"), "cell.wrong-kind");
  EXPECT_EQ(ruleOf("self = \"arm\"\nmin_m = 1\nexcept = [\"a\", \"b\"]\n"),
            "cell.wrong-kind cell.wrong-kind");
  EXPECT_EQ(ruleOf("self = \"arm\"\nmin_m = 1\nexcept = \"a\"\n"), "cell.wrong-kind");
  EXPECT_EQ(ruleOf("self = \"amr\"\nmin_m = 1\n"), "cell.unknown-device");
  const Finding unknown = read("[[clearance]]\nself = \"amr\"\nmin_m = 1\n").faults.at(0);
  EXPECT_EQ(unknown.severity, Severity::error) << "the gate would judge nothing";
  EXPECT_EQ(unknown.hint, "did you mean `arm`?");
  EXPECT_EQ(ruleOf("between = [\"arm/tip\", \"*\"]\nmin_m = 1\n"), "cell.unknown-link");
  EXPECT_EQ(ruleOf("self = \"arm\"\nmin_m = 1\nminimum = 2\n"), "cell.unknown-key");
  EXPECT_TRUE(read("[[clearance]]\nself = \"arm\"\nmin_m = -1\n").clearances.empty());
}

TEST_F(CellClearances, OfADeviceWithItselfTakeWhatSrdfDisables) {
  const std::string arm =
      "<robot name='arm'><link name='base'/><link name='a*'/><link name='tip'/>"
      "<joint name='j' type='fixed'><parent link='base'/><child link='a*'/></joint>"
      "<joint name='k' type='fixed'><parent link='base'/><child link='tip'/></joint></robot>";
  const std::string beside =
      "<robot name='arm'><group name='all'/>"
      "<disable_collisions link1='base' link2='tip' reason='Never'/>"
      "<disable_collisions link1='base' link2='tip'/>"
      "<disable_collisions link1='base' link2='of another gripper'/></robot>";
  const std::string named = "<robot><disable_collisions link1='tip' link2='a*'/></robot>";
  test::writeFile(folder_ / "big.urdf", arm);
  test::writeFile(folder_ / "big.srdf", beside);
  test::writeFile(folder_ / "more.srdf", named);
  const std::string device = "[[device]]\nname = \"big\"\nmodel = \"big.urdf\"\n";
  const Cell cell = read(device +
                         "[[clearance]]\nself = \"*\"\nmin_m = 0\nsrdf = \"more.srdf\"\n"
                         "[[clearance]]\nself = \"big/base\"\nmin_m = 0\n"
                         "[[clearance]]\nself = \"arm\"\nmin_m = 0\n"
                         "[[clearance]]\nbetween = [\"big\", \"arm\"]\nmin_m = 0\n");
  EXPECT_TRUE(cell.faults.empty());
  ASSERT_EQ(cell.clearances.size(), 4U);
  const std::vector<ClearancePatterns> both{{"big/tip", "big/a\\*"}, {"big/base", "big/tip"}};
  EXPECT_EQ(cell.clearances[0].except, both);
  EXPECT_EQ(cell.clearances[1].except, std::vector{both[1]});
  EXPECT_TRUE(cell.clearances[2].except.empty());
  EXPECT_TRUE(cell.clearances[3].except.empty());
  // They are files of the cell, which are attached and hashed with it.
  std::vector<std::string> files;
  for (const auto& file : cell.files) files.push_back(file.filename().string());
  EXPECT_EQ(files, (std::vector<std::string>{"arm.urdf", "big.srdf", "big.urdf", "cell.toml",
                                             "more.srdf"}));
}

TEST_F(CellClearances, FaultsOfSrdfHaveTheirPlace) {
  const std::string self = "self = \"arm\"\nmin_m = 1\nsrdf = \"x.srdf\"\n";
  EXPECT_EQ(ruleOf(self), "cell.missing-file");
  EXPECT_EQ(ruleOf("between = [\"arm\", \"*\"]\nmin_m = 1\nsrdf = \"x.srdf\"\n"),
            "cell.missing-key");
  const auto ruleOfSrdf = [&](const std::string& text) {
    test::writeFile(folder_ / "x.srdf", text);
    return ruleOf(self);
  };
  EXPECT_EQ(ruleOfSrdf(""), "urdf.xml");
  EXPECT_EQ(ruleOfSrdf("<robot><disable_collisions"), "urdf.xml");
  EXPECT_EQ(ruleOfSrdf("<sdf/>"), "urdf.no-robot");
  EXPECT_EQ(ruleOfSrdf("<robot><disable_collisions link1='a'/></robot>"), "urdf.missing-attribute");
  EXPECT_EQ(ruleOfSrdf("<robot/>"), "");
  std::string many = "<robot>";
  for (int i = 0; i <= 20'000; ++i) many += "<disable_collisions link1='base' link2='b'/>";
  EXPECT_EQ(ruleOfSrdf(many + "</robot>"), "urdf.too-many");
}

TEST_F(CellClearances, OfOneNameCountOnce) {
  const std::string table = "[[clearance]]\nname = \"x\"\nself = \"arm\"\nmin_m = 1\n";
  const Cell cell = read(table + table);
  EXPECT_EQ(cell.clearances.size(), 1U);
  ASSERT_EQ(cell.faults.size(), 1U);
  EXPECT_EQ(cell.faults[0].rule, "cell.duplicate-name");
}

}  // namespace
}  // namespace rocinante
