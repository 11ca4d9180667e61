#include "viewer/ui/program/gizmo_input.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <cmath>

#include "tests/viewer/support/arm_window.h"

namespace rocinante {
namespace {

/// The selected arm stands at the origin.
class GizmoInput : public test::ArmWindow {
 protected:
  GizmoInput() : ArmWindow("[[camera]]\nname = \"front\"\neye = [3, -4, 5]\ntarget = [0, 0, 0]\n") {
    model_->selected = {"arm", ""};
    model_->viewer.gizmo.shown = true;
    frame();
  }
  Vec2 pixelOf(const Vec3& world) const {
    return *PicturePlaces(model_->cameraView(), 800, 600).pixelOf(world);
  }
  /// The tip of the arrow along x.
  double tip() const {
    const PicturePlaces places(model_->cameraView(), 800, 600);
    return gizmoOf(*model_, places, kGizmoArrowPx)->size_m;
  }
  double x() const { return model_->scene().findDevice("arm")->base[3].x; }
};

TEST_F(GizmoInput, AnArrowMovesAlongItsAxisByStepsAndIsOneUndo) {
  const CameraView before = model_->cameraView();
  const double tip_m = tip();
  moveTo(pixelOf({tip_m, 0, 0}));
  press(true);
  moveTo(pixelOf({tip_m + 0.2, 0, 0}));
  moveTo(pixelOf({tip_m + 0.513, 0, 0}));
  press(false);
  EXPECT_FALSE(clicked_);
  EXPECT_EQ(model_->cameraView(), before);
  const double steps = x() / 0.1;
  EXPECT_NEAR(x(), 0.5, 1e-6);
  EXPECT_NEAR(steps, std::round(steps), 1e-6);
  EXPECT_EQ(model_->selected.device, "arm");
  EXPECT_EQ(model_->moves.undo(), "arm");
  EXPECT_FALSE(model_->moves.canUndo());
  frame();
  EXPECT_EQ(x(), 0);
}

TEST_F(GizmoInput, WithoutStepsItMovesFreely) {
  const double tip_m = tip();
  moveTo(pixelOf({tip_m, 0, 0}));
  press(true);
  model_->viewer.gizmo.snaps = false;
  moveTo(pixelOf({tip_m + 0.513, 0, 0}));
  press(false);
  EXPECT_NEAR(x(), 0.513, 0.03);  // the mouse is on whole pixels
}

TEST_F(GizmoInput, AnArrowThatLiesBesideThePictureIsNotGrabbed) {
  // So narrow that its tip is out of it, and its middle is not.
  model_->viewer.picture_part = {400, 0, 60, 600};
  frame();
  const PicturePlaces places(model_->cameraView(), 60, 600);
  const double tip_m = gizmoOf(*model_, places, kGizmoArrowPx)->size_m;
  const Vec2 from(400, 0);
  const Vec2 tip = *places.pixelOf({tip_m, 0, 0}) + from;
  ASSERT_TRUE(tip.x < 400 || tip.x >= 460);
  moveTo(tip);
  press(true);
  EXPECT_FALSE(model_->viewer.gizmo.drag.has_value());
  press(false);
  // Grabbed on the picture it goes on beside it.
  moveTo(*places.pixelOf({tip_m * 0.3, 0, 0}) + from);
  press(true);
  ASSERT_TRUE(model_->viewer.gizmo.drag.has_value());
  moveTo(*places.pixelOf({tip_m * 0.3 + 0.52, 0, 0}) + from);
  press(false);
  EXPECT_FALSE(model_->viewer.gizmo.drag.has_value());
  EXPECT_NEAR(x(), 0.5, 1e-6);
}

TEST_F(GizmoInput, BesideTheHandlesThePictureHasTheMouse) {
  moveTo({30, 30});
  press(true);
  press(false);
  EXPECT_TRUE(clicked_);
  EXPECT_TRUE(model_->moves.poses().empty());
  // Nothing to hold without a selection.
  const Vec2 at = pixelOf({tip(), 0, 0});
  model_->selected = {};
  moveTo(at);
  press(true);
  EXPECT_FALSE(model_->viewer.gizmo.drag.has_value());
}

}  // namespace
}  // namespace rocinante
