#include "viewer/ui/panels/view_cube_panel.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <cmath>

#include "tests/viewer/support/arm_window.h"

namespace rocinante {
namespace {

/// The cube lies at the top right of the window.
class ViewCubePanel : public test::ArmWindow {
 protected:
  ViewCubePanel() {
    frame();
    frame();
  }
  void drawOver() override { drawViewCube(*model_, {0, 0, 800, 600}); }
  Vec3 towardEye() {
    const CameraView view = model_->cameraView();
    return (view.eye - view.target) / lengthOf(view.eye - view.target);
  }
};

TEST_F(ViewCubePanel, AClickLooksFromTheSideThatIsThere) {
  const double distance = lengthOf(model_->cameraView().eye - model_->cameraView().target);
  moveTo({746, 54});
  press(true);
  press(false);
  EXPECT_FALSE(clicked_);
  // The view at the start is nearly from that corner.
  EXPECT_NEAR(lengthOf(towardEye() - Vec3(1, -1, 1) / std::sqrt(3.0)), 0, 1e-9);
  EXPECT_NEAR(lengthOf(model_->cameraView().eye - model_->cameraView().target), distance, 1e-9);
  // The top is above the middle then.
  moveTo({746, 54 - 16});
  press(true);
  press(false);
  EXPECT_GT(towardEye().z, 0.99);
}

TEST_F(ViewCubePanel, ADragTurnsTheViewAndClicksNothing) {
  const CameraView before = model_->cameraView();
  moveTo({746, 54});
  press(true);
  moveTo({766, 54});
  moveTo({786, 54});
  press(false);
  Turntable turned(before);
  turned.orbit(40, 0, 600);
  EXPECT_NEAR(lengthOf(model_->cameraView().eye - turned.view().eye), 0, 1e-9);
}

TEST_F(ViewCubePanel, BesideItThePictureHasTheMouse) {
  const CameraView before = model_->cameraView();
  moveTo({400, 300});
  press(true);
  press(false);
  EXPECT_TRUE(clicked_);
  EXPECT_EQ(model_->cameraView(), before);
}

TEST_F(ViewCubePanel, SwitchedOffItIsNotThere) {
  model_->viewer.panels.cube_shown = false;
  frame();
  moveTo({746, 54});
  press(true);
  press(false);
  EXPECT_TRUE(clicked_);
}

}  // namespace
}  // namespace rocinante
