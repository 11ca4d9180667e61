#pragma once

#include <gtest/gtest.h>
#include <imgui.h>

#include <memory>
#include <string>

#include "tests/viewer/support/arm_model.h"
#include "viewer/ui/program/user_input.h"
#include "viewer/ui/window/interface_context.h"

namespace rocinante::test {

/// A window of 800x600 that shows modelOfArm() and no panels, whose frames come when the test says
/// so.
class ArmWindow : public testing::Test {
 protected:
  /// `more`: of modelOfArm().
  explicit ArmWindow(const std::string& more = {}) : model_(modelOfArm(folder_, more)) {
    ImGui::GetIO().Fonts->Build();
    model_->viewer.picture_part = {0, 0, 800, 600};
  }
  /// What is in it beside the picture.
  virtual void drawOver() {}
  /// A frame that sees `input_`, at `now_`.
  ViewerRequests frame() {
    interface_.beginFrame(800, 600, &input_);
    drawOver();
    ViewerRequests requests;
    clicked_ = applyUserInput(*model_, now_, interface_.presses(), requests).has_value();
    ImGui::Render();
    input_.endFrame();
    EXPECT_TRUE(model_->update(now_).ok());
    return requests;
  }
  void moveTo(const Vec2& at) {
    input_.mouse = {at.x, at.y};
    frame();
  }
  void press(bool down) {
    input_.down[0] = down;
    frame();
  }

  const TemporaryFolder folder_;
  InterfaceContext interface_{nullptr};
  std::unique_ptr<ViewModel> model_;
  FrameInput input_;
  SteadyTime now_{};
  bool clicked_ = false;  ///< the picture, in the last frame
};

}  // namespace rocinante::test
