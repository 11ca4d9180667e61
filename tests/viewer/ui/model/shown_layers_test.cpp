#include "viewer/ui/model/shown_layers.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"
#include "viewer/ui/model/view_model.h"

namespace rocinante {
namespace {

constexpr auto kHidden = ShownPart::hidden, kSome = ShownPart::some, kAll = ShownPart::all;

/// Two arms in the layer `my arms`, one of them also in `spare`, whose hand is in `hands`.
class ShownLayers : public testing::Test {
 protected:
  ViewModel open(const std::string& spare = "", std::vector<std::string> hide = {}) {
    test::writeText(folder_ / "arm.urdf", test::kArmUrdf);
    test::writeText(folder_ / "c.cell.toml", R"(format = 1
[[device]]
name = "a"
model = "arm.urdf"
layer = "my arms"
[[device]]
name = "b"
model = "arm.urdf"
layer = "my arms"
tags = ["spare"]
[[layer]]
name = "my arms"
[[layer]]
name = "spare"
)" + spare + R"(
[[layer]]
name = "hands"
members = ["a/hand"]
[[layer]]
name = "empty"
visible = false
)");
    auto cell = loadCell(folder_ / "c.cell.toml", {});
    EXPECT_TRUE(cell.ok()) << cell.error().text();
    auto model = ViewModel::make(std::move(*cell), std::nullopt, std::nullopt, std::move(hide), {});
    EXPECT_TRUE(model.ok());
    EXPECT_TRUE(model->update(SteadyTime{}).ok());
    return std::move(*model);
  }
  static std::vector<ShownPart> layers(const ViewModel& model) {
    auto shown = shownLayers(model.cell(), model.scene(), model.choice());
    EXPECT_EQ(shown.back(), ShownPart::nothing);
    shown.pop_back();
    return shown;
  }
  using Layers = std::vector<ShownPart>;

  const test::TemporaryFolder folder_;
};

TEST_F(ShownLayers, AreWhatThePictureHasOfThem) {
  EXPECT_EQ(layers(open()), (Layers{kAll, kAll, kAll}));
  // The cell hides a layer that shares a device.
  EXPECT_EQ(layers(open("visible = false")), (Layers{kSome, kHidden, kAll}));
  ViewModel model = open();
  ASSERT_TRUE(model.setVisible("a", false));
  EXPECT_EQ(layers(model), (Layers{kSome, kAll, kHidden}));
  EXPECT_EQ(shownDevice(model.scene().devices[0], model.choice()), kHidden);
  ASSERT_TRUE(model.setVisible("layer/my%20arms", false));
  EXPECT_EQ(layers(model), (Layers{kHidden, kHidden, kHidden}));
  EXPECT_EQ(shownDevice(model.scene().devices[1], model.choice()), kHidden) << "by its layer";
  ASSERT_TRUE(model.setVisible("a/hand", true));
  EXPECT_EQ(layers(model), (Layers{kSome, kHidden, kAll}));
  EXPECT_EQ(shownLink(model.scene().devices[0], 1, model.choice()), kAll);
}

TEST_F(ShownLayers, AreKnownHoweverTheirNamesWereWritten) {
  ViewModel model = open("", {"layer/my arms"});
  EXPECT_EQ(layers(model)[0], kHidden);
  EXPECT_EQ(model.chosenVisibility("layer/my%20arms"), false);
  ASSERT_TRUE(model.setVisible("layer/my%20arms", true));
  EXPECT_EQ(layers(model)[0], kAll);
  ASSERT_TRUE(model.setVisible("layer/my%20arms", std::nullopt));
  EXPECT_EQ(model.chosenVisibility("layer/my arms"), std::nullopt);
  EXPECT_TRUE(model.hiddenPaths().empty() && model.shownPaths().empty());
  EXPECT_FALSE(model.setVisible("", false));
}

TEST_F(ShownLayers, OneDeviceIsShownAlone) {
  ViewModel model = open();
  ASSERT_TRUE(model.setVisible("a", false));
  ASSERT_TRUE(model.showOnly("a"));
  EXPECT_EQ(model.hiddenPaths(), std::vector<std::string>{"b"}) << "what was chosen before is gone";
  EXPECT_EQ(shownDevice(model.scene().devices[0], model.choice()), kAll);
  EXPECT_FALSE(model.showOnly("a/hand"));
  EXPECT_FALSE(model.showOnly("c"));
  EXPECT_EQ(model.hiddenPaths(), std::vector<std::string>{"b"});
}

TEST(ShownPartName, TellsWhatABoxAloneDoesNot) {
  EXPECT_STREQ(nameOf(ShownPart::nothing), "nothing to show");
  EXPECT_STREQ(nameOf(ShownPart::hidden), "hidden");
  EXPECT_STREQ(nameOf(ShownPart::some), "partly shown");
  EXPECT_STREQ(nameOf(ShownPart::all), "shown");
}

}  // namespace
}  // namespace rocinante
