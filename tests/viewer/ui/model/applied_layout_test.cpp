#include "viewer/ui/model/applied_layout.h"

#include <gtest/gtest.h>

#include "core/cell/cell.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"

namespace rocinante {
namespace {

constexpr char kText[] = R"(# A layout of rocinante view: --layout, or the command `layout`.
format = 1
theme = "light"
camera = "over"
plots = ["arm.turn", "signal - state", "arm:x over d/dt arm.turn"]
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

TEST_F(Layouts, AreWhatTheWindowHas) {
  const auto read = ViewLayout::parse(kText, "l.layout.toml");
  EXPECT_TRUE(applyLayout(*read, *model_).empty());
  EXPECT_TRUE(model_->viewer.panels.is_light);
  EXPECT_EQ(model_->cameraName(), "over");
  EXPECT_TRUE(model_->viewer.plots.hidden);
  EXPECT_EQ(model_->viewer.plots.curves().size(), 2U);
  ASSERT_EQ(model_->viewer.plots.paths().size(), 1U);
  EXPECT_EQ(model_->viewer.plots.paths()[0].text(), "arm:x over d/dt arm.turn");
  EXPECT_EQ(model_->viewer.plots.height, 240) << "that of the layout, not of a first path";
  EXPECT_EQ(layoutOf(*model_).text(), kText);
}

TEST_F(Layouts, NameWhatAWindowHasNot) {
  const auto read = ViewLayout::parse(
      "format = 1\ncamera = \"none\"\nplots = [\"leg.1\", \"?\", \"arm.turn\", "
      "\"arm.turn over leg.1\", \"rate over arm.turn\"]\n"
      "insets = [\"none:top-left\", \"\", \"map\"]\n",
      "l.layout.toml");
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_EQ(applyLayout(*read, *model_),
            (std::vector<std::string>{
                "there is no camera `none`", "no device is named `leg`, so `leg.1` is not plotted",
                "`?` is no value that can be plotted",
                "no device is named `leg`, so `arm.turn over leg.1` is not plotted",
                "`rate over arm.turn` counts packets, and is no plot of one value over another",
                "there is no camera `none` for an inset",
                "`` is not an inset: use CAMERA or CAMERA:CORNER, as map:top-left"}));
  EXPECT_EQ(model_->viewer.plots.curves().size(), 1U);
  EXPECT_TRUE(model_->viewer.plots.paths().empty());
  EXPECT_EQ(model_->viewer.insets.size(), 1U);
}

TEST_F(Layouts, NameWhatThereIsNoRoomFor) {
  ViewLayout layout;
  layout.plots = ViewLayout::Plots{};
  for (std::size_t i = 0; i <= PlotBoard::kMaxPaths; ++i) {
    layout.plots->values.push_back("arm:x over signal - s" + std::to_string(i));
  }
  EXPECT_EQ(applyLayout(layout, *model_),
            std::vector<std::string>{"there is no room for the plot of `arm:x over signal - s6`"});
  EXPECT_EQ(model_->viewer.plots.paths().size(), PlotBoard::kMaxPaths);
}

}  // namespace
}  // namespace rocinante
