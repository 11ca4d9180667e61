#include "viewer/ui/model/applied_layout.h"

#include <gtest/gtest.h>

#include <functional>

#include "tests/viewer/support/arm_model.h"
#include "tests/viewer/support/layout_text.h"
#include "viewer/ui/panels/picture_lines.h"

namespace rocinante {
namespace {

class Layouts : public testing::Test {
 protected:
  const test::TemporaryFolder folder_;
  const std::unique_ptr<ViewModel> model_ =
      test::modelOfArm(folder_,
                       "[[camera]]\nname = \"over\"\neye = [4, -4, 3]\ntarget = [0, 0, 0]\n"
                       "[[inset]]\ncamera = \"over\"\n");
};

TEST_F(Layouts, AreWhatTheWindowHas) {
  const auto read = ViewLayout::parse(test::kLayoutText, "l.layout.toml");
  EXPECT_TRUE(applyLayout(*read, *model_).empty());
  EXPECT_TRUE(model_->viewer.panels.is_light);
  EXPECT_EQ(model_->cameraName(), "over");
  EXPECT_TRUE(model_->viewer.plots.hidden);
  EXPECT_EQ(model_->viewer.plots.curves().size(), 2U);
  ASSERT_EQ(model_->viewer.plots.paths().size(), 2U);
  EXPECT_EQ(model_->viewer.plots.paths()[0].text(), "arm:x over d/dt arm.turn");
  EXPECT_EQ(model_->viewer.plots.paths()[1].text(), "arm/hand:y over arm/hand:x");
  EXPECT_EQ(model_->viewer.plots.height, 240) << "that of the layout, not of a first path";
  EXPECT_EQ(layoutOf(*model_).text(), test::kLayoutText);
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
                "`?` cannot be plotted: it is not the name of a value",
                "no device is named `leg`, so `arm.turn over leg.1` is not plotted",
                "`rate over arm.turn` is not plotted: counts of packets have no x-y plot",
                "there is no camera `none` for an inset",
                "`` is not an inset: use CAMERA or CAMERA:CORNER, as map:top-left"}));
  EXPECT_EQ(model_->viewer.plots.curves().size(), 1U);
  EXPECT_TRUE(model_->viewer.plots.paths().empty());
  EXPECT_EQ(model_->viewer.insets.size(), 1U);
}

TEST_F(Layouts, AreNotedInPlaceOfTheOneBefore) {
  const auto notes = [&] {
    std::vector<std::string> texts;
    for (const PictureNote& note : model_->viewer.panels.notes) texts.push_back(note.text);
    return texts;
  };
  model_->viewer.panels.notes.push_back({"of the cell", true});
  noteLeftOut("the layout", {"one", "two"}, *model_);
  EXPECT_EQ(notes(),
            (std::vector<std::string>{"of the cell", "the layout: one", "the layout: two"}));
  noteLeftOut("l.layout.toml", {"one"}, *model_);
  EXPECT_EQ(notes(), (std::vector<std::string>{"of the cell", "l.layout.toml: one"}));
  noteLeftOut("l.layout.toml", {}, *model_);
  EXPECT_EQ(notes(), std::vector<std::string>{"of the cell"});
}

TEST_F(Layouts, NameSignalsThatNoPacketStates) {
  ViewLayout layout;
  layout.plots = ViewLayout::Plots{};
  layout.plots->values = {"signal arm load", "signal arm nothing", "d/dt signal arm nothing",
                          "arm.turn over signal - gone", "arm.turn"};
  EXPECT_TRUE(applyLayout(layout, *model_).empty());
  EXPECT_TRUE(unstatedSignals(*model_).empty()) << "nothing is known of a log";
  auto picture = std::make_shared<StudyPicture>();
  model_->viewer.picture = picture;
  EXPECT_TRUE(unstatedSignals(*model_).empty()) << "it is not read";
  picture->stated =
      std::make_shared<const std::vector<SeriesKey>>(1, *parseSeriesKey("signal arm load"));
  EXPECT_EQ(unstatedSignals(*model_), (std::vector<SeriesKey>{*parseSeriesKey("signal arm nothing"),
                                                              *parseSeriesKey("signal - gone")}));
  const auto lines = pictureLines(*model_, ViewerStatus(), SteadyTime{});
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].what,
            "no packet of the log states `signal arm nothing`, so its plot is empty");
}

TEST_F(Layouts, HaveCamerasThatFitADevice) {
  ViewLayout layout;
  layout.camera = "fit:arm";
  layout.insets = {"fit:arm:top-left", "fit:leg", "fit:"};
  EXPECT_EQ(applyLayout(layout, *model_),
            (std::vector<std::string>{
                "no device is named `leg`, so there is no camera `fit:leg` for an inset",
                "there is no camera `fit:` for an inset"}));
  EXPECT_EQ(model_->viewer.built_in_wanted, "fit:arm");
  ASSERT_EQ(model_->viewer.insets.size(), 1U);
  EXPECT_EQ(model_->viewer.insets[0].inset.camera, "fit:arm");
  layout.insets.reset();
  layout.camera = "fit:leg";
  model_->useCamera("over");
  EXPECT_EQ(applyLayout(layout, *model_),
            std::vector<std::string>{"no device is named `leg`, so there is no camera `fit:leg`"});
  EXPECT_EQ(model_->viewer.built_in_wanted, "");
  EXPECT_EQ(model_->cameraName(), "over");
}

TEST_F(Layouts, GiveWayToTheCameraThatIsUsedAfterThem) {
  ViewLayout layout;
  layout.camera = "map";
  const auto wantedAfter = [&](const std::function<void()>& use) {
    EXPECT_TRUE(applyLayout(layout, *model_).empty());
    EXPECT_EQ(model_->viewer.built_in_wanted, "map");
    use();
    return model_->viewer.built_in_wanted;
  };
  EXPECT_EQ(wantedAfter([&] { model_->useCamera("over"); }), "");
  EXPECT_EQ(wantedAfter([&] { model_->holdCamera().zoom(1); }), "");
  EXPECT_EQ(wantedAfter([&] { model_->holdCamera().zoom(1); }), "") << "that was held already";
  EXPECT_EQ(wantedAfter([&] { model_->resetCamera(); }), "");
  CellCamera own;
  own.name = "own";
  EXPECT_EQ(wantedAfter([&] { model_->addCamera(own); }), "");
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
