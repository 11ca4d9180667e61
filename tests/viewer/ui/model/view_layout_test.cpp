#include "viewer/ui/model/view_layout.h"

#include <gtest/gtest.h>

#include "core/base/atomic_file.h"
#include "core/cell/cell.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"

namespace rocinante {
namespace {

constexpr char kText[] = R"(# A layout of rocinante view: --layout, or the command `layout`.
format = 1
theme = "light"
camera = "over"
plots = ["arm.turn", "signal - state"]
plots_height = 240.0
plots_hidden = true
insets = ["over:bottom-left:160x120px"]

[[panel]]
name = "device"
right = 10.0
top = 20.5

[[panel]]
name = "left"
width = 320.0
collapsed = true
)";

class Layouts : public testing::Test {
 protected:
  void SetUp() override {
    test::writeText(folder_ / "arm.urdf", test::kArmUrdf);
    test::writeText(folder_ / "cell.toml",
                    "format = 1\n[[device]]\nname = \"arm\"\nmodel = \"arm.urdf\"\n"
                    "[[camera]]\nname = \"over\"\neye = [4, -4, 3]\ntarget = [0, 0, 0]\n"
                    "[[inset]]\ncamera = \"over\"\n");
    model_.emplace(std::move(*ViewModel::make(std::move(*loadCell(folder_ / "cell.toml", {})),
                                              std::nullopt, std::nullopt, {}, {})));
    ASSERT_TRUE(model_->update(SteadyTime{}).ok());
  }

  const test::TemporaryFolder folder_;
  std::optional<ViewModel> model_;
};

TEST_F(Layouts, AreWrittenAndReadAgain) {
  const auto read = ViewLayout::parse(kText, "l.layout.toml");
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_EQ(read->text(), kText);
}

TEST_F(Layouts, AreWhatTheWindowHas) {
  const auto read = ViewLayout::parse(kText, "l.layout.toml");
  EXPECT_TRUE(applyLayout(*read, *model_).empty());
  EXPECT_TRUE(model_->viewer.panels.is_light);
  EXPECT_EQ(model_->cameraName(), "over");
  EXPECT_TRUE(model_->viewer.plots.hidden);
  EXPECT_EQ(model_->viewer.plots.curves().size(), 2U);
  EXPECT_EQ(layoutOf(*model_).text(), kText);
}

TEST_F(Layouts, NameWhatAWindowHasNot) {
  const auto read = ViewLayout::parse(
      "format = 1\ncamera = \"none\"\nplots = [\"leg.1\", \"?\", \"arm.turn\"]\n"
      "insets = [\"none:top-left\", \"\", \"map\"]\n",
      "l.layout.toml");
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_EQ(applyLayout(*read, *model_),
            (std::vector<std::string>{
                "there is no camera `none`", "no device is named `leg`, so `leg.1` is not plotted",
                "`?` is no value that can be plotted", "there is no camera `none` for an inset",
                "`` is not an inset: use CAMERA or CAMERA:CORNER, as map:top-left"}));
  EXPECT_EQ(model_->viewer.plots.curves().size(), 1U);
  EXPECT_EQ(model_->viewer.insets.size(), 1U);
}

TEST_F(Layouts, AreRefusedWithTheirPlace) {
  const auto fault = [](const char* text) {
    const auto read = ViewLayout::parse(text, "l.layout.toml");
    return read.ok() ? "" : read.error().text();
  };
  EXPECT_EQ(fault(""), "the format is not 1 (l.layout.toml:1:1)");
  EXPECT_EQ(fault("format = 1\ntheme = \"blue\"\n"),
            "the theme is neither dark nor light (l.layout.toml:2:9)");
  EXPECT_NE(fault("format = 1\nplot = []\n").find("plot"), std::string::npos);
}

TEST_F(Layouts, ReplaceLayoutsAlone) {
  const ViewLayout layout = layoutOf(*model_);
  ASSERT_TRUE(layout.save(folder_ / "a.layout.toml"));
  ASSERT_TRUE(layout.save(folder_ / "a.layout.toml"));
  const Status refused = layout.save(folder_ / "cell.toml");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::refused);
  EXPECT_NE(readFile(folder_ / "cell.toml", 4096)->find("[[device]]"), std::string::npos);
}

}  // namespace
}  // namespace rocinante
