#include "viewer/ui/model/view_model.h"

#include <gtest/gtest.h>

#include "core/cell/cell.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"
#include "viewer/ui/commands/key_commands.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;

class ViewedSession : public testing::Test {
 protected:
  void SetUp() override {
    test::writeText(folder_ / "arm.urdf", test::kArmUrdf);
    test::writeText(folder_ / "cell.toml",
                    "format = 1\n[[device]]\nname = \"arm\"\nmodel = \"arm.urdf\"\n"
                    "layer = \"robots\"\n[[layer]]\nname = \"robots\"\n"
                    "[[camera]]\nname = \"over\"\neye = [4, -4, 3]\ntarget = [0, 0, 0]\n"
                    "[[inset]]\ncamera = \"map\"\n");
    test::writeSession(folder_ / "s.mcap", {{0, "joints arm 0\nevent \"begun\"\n"},
                                            {1000, "hide layer/robots\njoints arm 1\n"},
                                            {2000, "event \"done\"\n"}});
    auto cell = loadCell(folder_ / "cell.toml", {});
    ASSERT_TRUE(cell.ok()) << cell.error().text();
    auto session = Timeline::open(folder_ / "s.mcap");
    ASSERT_TRUE(session.ok());
    auto model = ViewModel::make(std::move(*cell), std::move(*session), std::nullopt, {}, {});
    ASSERT_TRUE(model.ok()) << model.error().text();
    model_.emplace(std::move(*model));
    ASSERT_TRUE(model_->update(SteadyTime{}).ok());
  }
  void seek(Nanoseconds since_start) {
    model_->cursor()->seek(model_->cursor()->start() + since_start, SteadyTime{});
    ASSERT_TRUE(model_->update(SteadyTime{}).ok());
  }
  ViewerRequests press(std::string_view key) {
    ViewerRequests requests;
    const auto parsed = parseKey(key);
    EXPECT_TRUE(parsed.has_value()) << key;
    if (parsed) {
      EXPECT_TRUE(runKey(*parsed, {*model_, SteadyTime{}, 480, requests}));
    }
    return requests;
  }

  const test::TemporaryFolder folder_;
  std::optional<ViewModel> model_;
};

TEST_F(ViewedSession, ALayerFollowsThePacketsUntilThePersonChooses) {
  const CellLayer& layer = model_->cell().layers.front();
  EXPECT_TRUE(model_->layerVisibleByDefault(layer));
  seek(1500ms);
  EXPECT_FALSE(model_->layerVisibleByDefault(layer));
  EXPECT_FALSE(model_->chosenVisibility("layer/robots").has_value());
  EXPECT_TRUE(model_->setVisible("layer/robots", true));
  EXPECT_EQ(model_->chosenVisibility("layer/robots"), true);
  EXPECT_TRUE(model_->choice().linkVisible(model_->scene().devices[0], 1));
  EXPECT_TRUE(model_->setVisible("layer/robots", std::nullopt));
  EXPECT_FALSE(model_->chosenVisibility("layer/robots").has_value());
  EXPECT_FALSE(model_->choice().linkVisible(model_->scene().devices[0], 1));
  EXPECT_FALSE(model_->setVisible("layer/", true));
}

TEST_F(ViewedSession, TheDistanceIsOfTheChosenLinks) {
  model_->study_waits = true;
  model_->viewer.nearest_wanted = true;
  const auto asked = [&](const Selection& selected, const Selection& reference) {
    model_->selected = selected;
    model_->viewer.reference = reference;
    EXPECT_TRUE(model_->update(SteadyTime{}).ok());
    return model_->nearest() != nullptr ? model_->nearest()->wish : NearestQuery();
  };
  EXPECT_EQ(asked({"arm", "hand"}, {}), (NearestQuery{"arm", "hand", "", ""}));
  EXPECT_EQ(asked({"arm", "hand"}, {"leg", "foot"}), (NearestQuery{"arm", "hand", "leg", "foot"}));
  EXPECT_EQ(asked({"arm", "hand"}, {"arm", "base"}), (NearestQuery{"arm", "hand", "arm", "base"}));
  // There is no distance of a device from a part of itself.
  EXPECT_EQ(asked({"arm", ""}, {"arm", "base"}), (NearestQuery{"arm", "", "", ""}));
  EXPECT_EQ(asked({"arm", "hand"}, {"arm", "hand"}), (NearestQuery{"arm", "hand", "", ""}));
}

TEST_F(ViewedSession, EventsAreReachedForwardsAndBackwards) {
  const LogTime start = model_->cursor()->start();
  ASSERT_NE(model_->eventBeside(start, true), nullptr);
  EXPECT_EQ(model_->eventBeside(start, true)->text, "done");
  EXPECT_EQ(model_->eventBeside(start, false), nullptr);
  press(".");
  ASSERT_TRUE(model_->update(SteadyTime{}).ok());
  EXPECT_EQ(model_->shownTime(), start + 2s);
  press(",");
  ASSERT_TRUE(model_->update(SteadyTime{}).ok());
  EXPECT_EQ(model_->shownTime(), start);
}

TEST_F(ViewedSession, AMarkIsKeptBesideTheLogAndListed) {
  seek(500ms);
  EXPECT_FALSE(press("M").mark.has_value());
  EXPECT_TRUE(model_->viewer.panels.mark.shown);
  ASSERT_TRUE(model_->addMark("look here"));
  ASSERT_EQ(model_->events().size(), 3U);
  EXPECT_EQ(model_->events()[1].text, "look here");
  EXPECT_TRUE(std::filesystem::exists(folder_ / "s.mcap.marks"));
  EXPECT_FALSE(model_->addMark("").has_value());
}

TEST_F(ViewedSession, KeysSwitchLooksOfWhatIsSelected) {
  press("E");
  EXPECT_EQ(model_->style().edges, EdgeStyle::over);
  press("W");
  EXPECT_EQ(model_->style().wireframe, std::vector<std::string>{"*"});
  press("W");
  EXPECT_TRUE(model_->style().wireframe.empty());
  model_->selected = {"arm", "hand"};
  press("T");
  ASSERT_EQ(model_->style().transparent.size(), 1U);
  EXPECT_EQ(model_->style().transparent[0].path, "arm/hand");
  EXPECT_EQ(model_->frameStyle().outlined, std::vector<std::string>{"arm/hand"});
  EXPECT_TRUE(model_->style().outlined.empty());
  press("H");
  EXPECT_EQ(model_->chosenVisibility("arm/hand"), false);
  press("shift+H");
  EXPECT_FALSE(model_->chosenVisibility("arm/hand").has_value());
  press("escape");
  EXPECT_EQ(model_->selected, Selection{});
}

TEST_F(ViewedSession, TrailsAndLimitsFollowTheMoment) {
  model_->selected = {"arm", "hand"};
  press("R");
  seek(1200ms);
  ASSERT_EQ(model_->extras().trails.size(), 1U);
  ASSERT_FALSE(model_->extras().trails[0].runs.empty());
  EXPECT_TRUE(model_->extras().limits.empty());
  press("L");
  ASSERT_TRUE(*model_->update(SteadyTime{}));
  EXPECT_EQ(model_->extras().limits.size(), model_->scene().devices.size());
  EXPECT_FALSE(*model_->update(SteadyTime{})) << "nothing changed since";
}

TEST_F(ViewedSession, KeysWishForWhatTheProgramDoes) {
  EXPECT_TRUE(press("F").fit);
  EXPECT_TRUE(press("S").evidence);
  EXPECT_TRUE(press("Q").close);
  press("F1");
  EXPECT_TRUE(model_->viewer.panels.help_shown);
  press("escape");
  EXPECT_FALSE(model_->viewer.panels.help_shown);
  press("tab");
  EXPECT_FALSE(model_->viewer.panels.shown);
  ASSERT_EQ(model_->viewer.insets.size(), 1U);
  press("I");
  EXPECT_FALSE(model_->viewer.insets[0].shown);
  EXPECT_FALSE(parseKey("hyper").has_value());
  EXPECT_FALSE(parseKey("").has_value());
}

TEST_F(ViewedSession, ShiftStepsFromDatagramToDatagram) {
  TimelineCursor& cursor = *model_->cursor();
  const auto at = [&] { return cursor.position(SteadyTime{}) - cursor.start(); };
  const auto stepTo = [&](const char* key) {
    press(key);
    EXPECT_TRUE(model_->update(SteadyTime{}).ok());
    return at();
  };
  EXPECT_EQ(stepTo("shift+."), 1000ms);
  EXPECT_EQ(stepTo("shift+."), 2000ms);
  EXPECT_EQ(stepTo("shift+."), 2000ms);
  seek(1999ms);
  EXPECT_EQ(stepTo("shift+,"), 1000ms);
  EXPECT_EQ(stepTo("shift+,"), 0ms);
  EXPECT_EQ(stepTo("shift+,"), 0ms);
  EXPECT_FALSE(cursor.playing());
}

TEST_F(ViewedSession, ZeroGoesBackToTheFirstView) {
  model_->holdCamera().orbit(100, 30, 720);
  EXPECT_TRUE(model_->cameraName().empty());
  EXPECT_TRUE(press("0").reset);
  model_->resetCamera();
  EXPECT_EQ(model_->cameraName(), "over");
  EXPECT_TRUE(press("shift+F").fit_selected);
  EXPECT_FALSE(press("shift+F").fit);
}

}  // namespace
}  // namespace rocinante
