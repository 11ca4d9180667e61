#include "viewer/view/known_names.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"

namespace rocinante {
namespace {

constexpr const char* kGroupedObj =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\ng door_left\nf 1 2 3\ng frame\nf 1 2 3\n";

class NamesOfAPicture : public testing::Test {
 protected:
  void SetUp() override {
    test::writeText(folder_ / "arm.urdf", test::kArmUrdf);
    test::writeText(folder_ / "door.obj", kGroupedObj);
    test::writeText(folder_ / "cell.toml", R"(format = 1
[[device]]
name = "arm"
model = "arm.urdf"
layer = "robots"
[[device]]
name = "spare"
model = "arm.urdf"
optional = true
[[device]]
name = "door"
model = "door"
[[model]]
name = "door"
obj = "door.obj"
unit = "m"
up = "z"
geometry = "link"
[[model.link]]
name = "leaf"
groups = ["*"]
[[camera]]
name = "over"
eye = [4, -4, 3]
target = [0, 0, 0]
[[source]]
name = "planner"
ghost_of = { plan_arm = "arm" }
)");
    test::writeSession(folder_ / "s.mcap", {{0, "joints arm 0\n"},
                                            {1000, "add part door\nview side 0 -5 1 0 0 0 40\n"},
                                            {2000, "remove part\nadd nothing unknown_model\n"}});
    auto cell = loadCell(folder_ / "cell.toml", {});
    ASSERT_TRUE(cell.ok()) << cell.error().text();
    cell_ = std::move(*cell);
    names_.emplace(cell_);
  }

  /// The sentence; empty when there is nothing to say.
  std::string said(const std::string& path) {
    const Status checked = names_->check({path});
    return checked ? std::string() : checked.error().text();
  }

  const test::TemporaryFolder folder_;
  Cell cell_;
  std::optional<KnownNames> names_;
};

TEST_F(NamesOfAPicture, WhatTheCellHasIsKnown) {
  for (const char* path :
       {"arm", "arm/hand", "spare", "spare/base", "plan_arm", "plan_arm/hand", "*", "*/hand",
        "door#door_*", "door/leaf#frame", "*#frame", "layer/robots", "layer/grid"}) {
    EXPECT_EQ(said(path), "") << path;
  }
}

TEST_F(NamesOfAPicture, ASlipIsToldWithAHint) {
  EXPECT_EQ(said("amr"), "the cell has no device `amr`: did you mean `arm`?");
  EXPECT_EQ(said("arm/hnad"), "`arm` has no link `hnad`: did you mean `hand`?");
  EXPECT_EQ(said("*/elbow"), "no device has a link `elbow`: there are base, hand, leaf");
  EXPECT_EQ(said("door#doors_*"),
            "`door` has no part in a group `doors_*`: there are door_left, frame");
  EXPECT_EQ(said("layer/robot"), "unknown layer `robot`: did you mean `robots`?");
  RenderStyle style;
  style.trails.push_back({"ram", std::chrono::seconds(5)});
  EXPECT_FALSE(names_->check(style));
}

TEST_F(NamesOfAPicture, WhatTheLogAddsIsKnownAtEachOfItsMoments) {
  EXPECT_NE(said("part"), "");
  EXPECT_FALSE(names_->checkCamera("side"));
  names_->useLog(folder_ / "s.mcap");
  EXPECT_EQ(said("part"), "");
  EXPECT_EQ(said("part#frame"), "");
  EXPECT_EQ(said("part/hand"), "`part` has no link `hand`: there is only leaf");
  EXPECT_EQ(said("parts"),
            "neither the cell nor the log has a device `parts`: did you mean `part`?");
  EXPECT_NE(said("nothing"), "") << "an `add` of a model that the cell does not have draws nothing";
  EXPECT_TRUE(names_->checkCamera("side"));
  EXPECT_TRUE(names_->checkCamera("over"));
  EXPECT_TRUE(names_->checkCamera("@0,-5,1/0,0,0"));
  EXPECT_EQ(names_->checkCamera("sied").error().text(),
            "unknown camera `sied`: did you mean `side`?");
}

TEST_F(NamesOfAPicture, ACameraThatCannotStandIsNamedWithItsFault) {
  std::ofstream(folder_ / "bad.toml") << "format = 1\n[[camera]]\nname = \"here\"\n"
                                         "eye = [1, 1, 1]\ntarget = [1, 1, 1]\n";
  const auto bad = loadCell(folder_ / "bad.toml", {});
  ASSERT_TRUE(bad.ok()) << bad.error().text();
  EXPECT_EQ(KnownNames(*bad).checkCamera("here").error().text(),
            "unknown camera `here`: there are none; the cell has an error: " +
                (folder_ / "bad.toml").string() +
                ":5:10: error: `eye` and `target` are the same point [cell.no-direction]");
}

TEST_F(NamesOfAPicture, InALiveSessionDevicesMayComeButNotLinksOfNoModel) {
  names_->expectOthers();
  EXPECT_EQ(said("amr"), "");
  EXPECT_EQ(names_->doubtAbout("amr"),
            "the cell has no device `amr`; the option takes effect once a source adds it; did you "
            "mean `arm`?");
  EXPECT_EQ(names_->doubtAbout("arm/hand"), "");
  EXPECT_NE(said("amr/elbow"), "");
  EXPECT_NE(said("layer/robot"), "");
  EXPECT_TRUE(names_->checkCamera("later"));
}

}  // namespace
}  // namespace rocinante
