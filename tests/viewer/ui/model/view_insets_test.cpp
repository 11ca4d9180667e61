#include "viewer/ui/model/view_insets.h"

#include <gtest/gtest.h>

#include "tests/viewer/support/arm_model.h"
#include "viewer/ui/commands/command.h"

namespace rocinante {
namespace {

/// A window of 800x600 with an inset at the top right, as its last frame showed it.
class InsetsByMouse : public testing::Test {
 protected:
  void SetUp() override {
    model_->resetCamera();
    model_->viewer.inset_places = {{0, {548, 12, 240, 180}, {}}};
  }
  CellInset& inset() { return model_->viewer.insets.front().inset; }
  std::string fault(std::vector<std::string> words) {
    ViewerRequests requests;
    const std::string name = words.front();
    words.erase(words.begin());
    const auto done = runCommand(name, words, {*model_, SteadyTime{}, 600, requests});
    return done ? "" : done.error().what;
  }

  const test::TemporaryFolder folder_;
  const std::unique_ptr<ViewModel> model_ =
      test::modelOfArm(folder_,
                       "[[camera]]\nname = \"front\"\neye = [0, -4, 1]\ntarget = [0, 0, 0]\n"
                       "[[camera]]\nname = \"over\"\neye = [4, -4, 3]\ntarget = [0, 0, 0]\n"
                       "[[inset]]\ncamera = \"over\"\ntitle = \"from above\"\n");
};

TEST_F(InsetsByMouse, AreGrabbedWhereTheyAre) {
  EXPECT_FALSE(grabInset(*model_, 547, 12, 18).has_value());
  EXPECT_FALSE(grabInset(*model_, 788, 12, 18).has_value());
  const auto middle = grabInset(*model_, 600, 100, 18);
  ASSERT_TRUE(middle.has_value());
  EXPECT_FALSE(middle->sizes);
  EXPECT_TRUE(grabInset(*model_, 550, 190, 18)->sizes);
  EXPECT_FALSE(grabInset(*model_, 786, 14, 18)->sizes);
}

TEST_F(InsetsByMouse, GoIntoTheCornerWhereTheMouseIs) {
  const auto drag = grabInset(*model_, 600, 100, 18);
  dragInset(*model_, *drag, 100, 500, 800, 600, 1);
  EXPECT_EQ(inset().corner, InsetCorner::bottom_left);
  dragInset(*model_, *drag, 100, 100, 800, 600, 1);
  EXPECT_EQ(inset().corner, InsetCorner::top_left);
}

TEST_F(InsetsByMouse, GrowFromTheCornerAtTheEdge) {
  const auto drag = grabInset(*model_, 550, 190, 18);
  dragInset(*model_, *drag, 388, 312, 800, 600, 1);
  EXPECT_DOUBLE_EQ(inset().width, 0.5);
  EXPECT_DOUBLE_EQ(inset().height, 0.5);
  // No smaller than can be seen, wherever the mouse goes.
  dragInset(*model_, *drag, 5000, -5000, 800, 600, 1);
  EXPECT_DOUBLE_EQ(inset().width, 0.06);
  EXPECT_DOUBLE_EQ(inset().height, 0.08);
  inset().in_pixels = true;
  dragInset(*model_, *drag, 388, 312, 800, 600, 2);
  EXPECT_EQ(inset().width, 200);
  EXPECT_EQ(inset().height, 150);
}

TEST_F(InsetsByMouse, AreSwappedWithThePictureAndBack) {
  ASSERT_EQ(model_->cameraName(), "front");
  ASSERT_TRUE(swapInset(*model_, 0).ok());
  EXPECT_EQ(model_->cameraName(), "over");
  EXPECT_EQ(insetText(inset()), "front:top-right");
  EXPECT_EQ(insetTitle(inset()), "front");
  model_->holdCamera().orbit(20, 0, 600);
  ASSERT_TRUE(swapInset(*model_, 0).ok());
  EXPECT_EQ(model_->cameraName(), "front");
  EXPECT_EQ(inset().camera[0], '@');
  EXPECT_EQ(insetTitle(inset()), "free view");
  model_->viewer.inset_places.clear();
  EXPECT_FALSE(swapInset(*model_, 0).ok());
}

TEST_F(InsetsByMouse, AreChangedByCommandsToo) {
  EXPECT_EQ(fault({"inset", "1", "bottom-left"}), "");
  EXPECT_EQ(fault({"inset", "1", "160x120px"}), "");
  EXPECT_EQ(insetText(inset()), "over:bottom-left:160x120px");
  EXPECT_EQ(fault({"inset", "2", "top-left"}), "there is no inset 2, but 1 to 1");
  EXPECT_EQ(fault({"inset", "1", "0.0x4"}),
            "`0.0x4` is neither a corner, as top-left, nor a size, as 0.3x0.2 or 160x120px");
  EXPECT_EQ(fault({"swap-inset"}), "");
  EXPECT_EQ(model_->cameraName(), "over");
}

}  // namespace
}  // namespace rocinante
