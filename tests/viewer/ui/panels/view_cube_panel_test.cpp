#include "viewer/ui/panels/view_cube_panel.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <memory>

#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"
#include "viewer/ui/program/user_input.h"
#include "viewer/ui/window/interface_context.h"

namespace rocinante {
namespace {

/// A window of 800x600 without panels, whose cube lies at its top right.
class ViewCubePanel : public testing::Test {
 protected:
  void SetUp() override {
    test::writeText(folder_ / "arm.urdf", test::kArmUrdf);
    auto cell = loadCell(folder_ / "arm.urdf", {});
    ASSERT_TRUE(cell.ok());
    auto model = ViewModel::make(std::move(*cell), std::nullopt, std::nullopt, {}, {});
    ASSERT_TRUE(model.ok());
    model_ = std::make_unique<ViewModel>(std::move(*model));
    ASSERT_TRUE(model_->update(SteadyTime{}).ok());
    ImGui::GetIO().Fonts->Build();
    model_->viewer.picture_part = {0, 0, 800, 600};
    frame();
    frame();
  }
  void frame() {
    interface_.beginFrame(800, 600, &input_);
    drawViewCube(*model_, {0, 0, 800, 600});
    ViewerRequests requests;
    clicked_ = applyUserInput(*model_, SteadyTime{}, {}, requests).has_value();
    ImGui::Render();
    input_.endFrame();
  }
  void moveTo(double x, double y) {
    input_.mouse = {x, y};
    frame();
  }
  void press(bool down) {
    input_.down[0] = down;
    frame();
  }
  Vec3 towardEye() {
    const CameraView view = model_->cameraView();
    return (view.eye - view.target) / lengthOf(view.eye - view.target);
  }

  test::TemporaryFolder folder_;
  InterfaceContext interface_{nullptr};
  std::unique_ptr<ViewModel> model_;
  FrameInput input_;
  bool clicked_ = false;
};

TEST_F(ViewCubePanel, AClickLooksFromTheSideThatIsThere) {
  const double distance = lengthOf(model_->cameraView().eye - model_->cameraView().target);
  moveTo(746, 54);
  press(true);
  press(false);
  EXPECT_FALSE(clicked_);
  // The view at the start is nearly from that corner.
  EXPECT_NEAR(lengthOf(towardEye() - Vec3(1, -1, 1) / std::sqrt(3.0)), 0, 1e-9);
  EXPECT_NEAR(lengthOf(model_->cameraView().eye - model_->cameraView().target), distance, 1e-9);
  // The top is above the middle then.
  moveTo(746, 54 - 16);
  press(true);
  press(false);
  EXPECT_GT(towardEye().z, 0.99);
}

TEST_F(ViewCubePanel, ADragTurnsTheViewAndClicksNothing) {
  const CameraView before = model_->cameraView();
  moveTo(746, 54);
  press(true);
  moveTo(766, 54);
  moveTo(786, 54);
  press(false);
  Turntable turned(before);
  turned.orbit(40, 0, 600);
  EXPECT_NEAR(lengthOf(model_->cameraView().eye - turned.view().eye), 0, 1e-9);
}

TEST_F(ViewCubePanel, BesideItThePictureHasTheMouse) {
  const CameraView before = model_->cameraView();
  moveTo(400, 300);
  press(true);
  press(false);
  EXPECT_TRUE(clicked_);
  EXPECT_EQ(model_->cameraView(), before);
}

TEST_F(ViewCubePanel, SwitchedOffItIsNotThere) {
  model_->viewer.panels.cube_shown = false;
  frame();
  moveTo(746, 54);
  press(true);
  press(false);
  EXPECT_TRUE(clicked_);
}

}  // namespace
}  // namespace rocinante
