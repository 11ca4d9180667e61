#include "viewer/ui/program/user_input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <memory>

#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"
#include "viewer/ui/window/interface_context.h"

namespace rocinante {
namespace {

/// A window of 800x600 whose picture begins 200 pixels from the left, with bare ground before it.
class UserInput : public testing::Test {
 protected:
  void SetUp() override {
    test::writeText(folder_ / "arm.urdf", test::kArmUrdf);
    auto model = ViewModel::make(std::move(*loadCell(folder_ / "arm.urdf", {})), std::nullopt,
                                 std::nullopt, {}, {});
    model_ = std::make_unique<ViewModel>(std::move(*model));
    ASSERT_TRUE(model_->update(SteadyTime{}).ok());
    ImGui::GetIO().Fonts->Build();
    model_->viewer.picture_part = {200, 0, 600, 500};
  }
  /// `types`: a line of text has the keyboard.
  std::optional<PictureClick> frame(bool types = false) {
    interface_.beginFrame(800, 600, &input_);
    ImGui::GetIO().WantTextInput = types;
    if (types) ImGui::GetCurrentContext()->WantTextInputNextFrame = 1;
    ViewerRequests requests;
    const auto click = applyUserInput(*model_, SteadyTime{}, input_.presses, requests);
    pointed_ = mouseOnPicture(*model_);
    ImGui::Render();
    input_.endFrame();
    return click;
  }
  std::optional<PictureClick> clickAt(double x, double y) {
    input_.mouse = {x, y};
    frame();
    input_.down[0] = true;
    frame();
    input_.down[0] = false;
    return frame();
  }

  test::TemporaryFolder folder_;
  InterfaceContext interface_{nullptr};
  std::unique_ptr<ViewModel> model_;
  FrameInput input_;
  std::optional<PicturePlace> pointed_;
};

TEST_F(UserInput, IsOfThePictureInItsOwnPixels) {
  const auto click = clickAt(500, 100);
  ASSERT_TRUE(click.has_value());
  EXPECT_EQ(click->x, 300);
  EXPECT_EQ(click->y, 100);
  ASSERT_TRUE(pointed_.has_value());
  EXPECT_EQ(*pointed_, PicturePlace(300, 100));
}

TEST_F(UserInput, ALineOfTextHasTheKeyboardButForKeysThatOpenAnother) {
  const EdgeStyle edges = model_->style().edges;
  input_.presses = {{GLFW_KEY_E, false, false, false}};
  frame(true);
  EXPECT_EQ(model_->style().edges, edges);
  EXPECT_EQ(keyTaker(*model_), KeyTaker::line);
  input_.presses = {{GLFW_KEY_P, false, false, true}};
  frame(true);
  EXPECT_TRUE(model_->viewer.panels.palette.shown);
  EXPECT_EQ(keyTaker(*model_), KeyTaker::nobody) << "until its line has it";
  model_->viewer.panels.palette.start.collects = false;
  EXPECT_EQ(keyTaker(*model_), KeyTaker::line);
}

TEST_F(UserInput, ALineThatTheLastFrameClosedTakesNoKeys) {
  frame(true);
  EXPECT_EQ(keyTaker(*model_), KeyTaker::line);
  frame();
  ImGui::GetIO().WantTextInput = true;  // Dear ImGui's is a frame late
  EXPECT_EQ(keyTaker(*model_), KeyTaker::commands);
}

TEST_F(UserInput, TheLetterOfTheKeyThatOpensALineIsNotTypedIntoIt) {
  input_.presses = {{GLFW_KEY_P, false, false, true}};
  input_.typed = "seek";
  frame();
  EXPECT_EQ(model_->viewer.panels.palette.start.letters, "seek");
  model_->viewer.panels.palette.shown = false;
  EXPECT_EQ(keyTaker(*model_), KeyTaker::commands);
}

TEST_F(UserInput, BesideThePictureMeansNothing) {
  EXPECT_FALSE(clickAt(100, 100).has_value());
  EXPECT_FALSE(clickAt(500, 550).has_value());
  EXPECT_FALSE(pointed_.has_value());
  const Vec3 eye = model_->cameraView().eye;
  input_.wheel = 3;
  frame();
  EXPECT_EQ(model_->cameraView().eye, eye);
  // What was pressed on the picture goes on beside it.
  input_.mouse = {500, 100};
  frame();
  input_.down[0] = true;
  frame();
  input_.mouse = {100, 100};
  frame();
  EXPECT_NE(model_->cameraView().eye, eye);
}

}  // namespace
}  // namespace rocinante
