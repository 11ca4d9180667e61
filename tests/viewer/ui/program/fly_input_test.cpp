#include "viewer/ui/program/fly_input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include "tests/viewer/support/arm_window.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;

/// With a frame each 20 ms.
class FlyInput : public test::ArmWindow {
 protected:
  FlyInput() {
    model_->viewer.fly.setSceneSize(6);
    input_.mouse = {400, 300};
    frame();
  }
  ViewerRequests frame() {
    now_ += 20ms;
    return ArmWindow::frame();
  }
  Vec3 eye() { return model_->cameraView().eye; }
};

TEST_F(FlyInput, AKeyMovesTheViewOnlyWithTheRightButton) {
  input_.held = {GLFW_KEY_W};
  const Vec3 before = eye();
  frame();
  EXPECT_EQ(eye(), before);
  input_.down[1] = true;
  EXPECT_TRUE(frame().measure_scene);
  frame();
  const double flown = lengthOf(eye() - before);
  EXPECT_NEAR(flown, 1.0 / 60 + 0.02, 1e-6);
  input_.held.clear();
  frame();
  EXPECT_NEAR(lengthOf(eye() - before), flown, 1e-12);
  EXPECT_TRUE(model_->viewer.fly.active());
  input_.down[1] = false;
  frame();
  EXPECT_FALSE(model_->viewer.fly.active());
}

TEST_F(FlyInput, ItsKeysAreNoCommandsThen) {
  input_.down[1] = true;
  input_.presses = {{GLFW_KEY_Q}, {GLFW_KEY_S, true}};
  const ViewerRequests flying = frame();
  EXPECT_FALSE(flying.close);
  EXPECT_FALSE(flying.save_live);
  input_.down[1] = false;
  frame();
  input_.presses = {{GLFW_KEY_Q}};
  EXPECT_TRUE(frame().close);
}

TEST_F(FlyInput, TheButtonAloneStillPans) {
  Turntable panned(model_->cameraView());
  panned.pan(30, 10, 600);
  input_.down[1] = true;
  frame();
  input_.mouse = {430, 310};
  frame();
  EXPECT_NEAR(lengthOf(eye() - panned.view().eye), 0, 1e-9);
}

TEST_F(FlyInput, InAFlightTheMouseLooksAroundAndItsWheelChangesTheSpeed) {
  input_.down[1] = true;
  input_.held = {GLFW_KEY_W};
  frame();
  input_.held.clear();
  frame();
  const Vec3 before = eye();
  const Vec3 target = model_->cameraView().target;
  input_.mouse = {430, 310};
  input_.wheel = 1;
  frame();
  EXPECT_NEAR(lengthOf(eye() - before), 0, 1e-9);
  EXPECT_GT(lengthOf(model_->cameraView().target - target), 0.01);
  EXPECT_DOUBLE_EQ(model_->viewer.fly.speed(), 1.25);
}

TEST_F(FlyInput, BesideThePictureNobodyFliesButWhoBeganOnIt) {
  model_->viewer.picture_part = {200, 0, 600, 500};
  input_.mouse = {100, 300};
  frame();
  const Vec3 before = eye();
  input_.down[1] = true;
  input_.held = {GLFW_KEY_W};
  EXPECT_FALSE(frame().measure_scene);
  frame();
  EXPECT_EQ(eye(), before);
  EXPECT_FALSE(model_->viewer.fly.active());
  input_.down[1] = false;
  input_.mouse = {400, 300};
  frame();
  input_.down[1] = true;
  frame();
  input_.mouse = {100, 300};
  frame();
  const Vec3 beside = eye();
  frame();
  EXPECT_NE(eye(), beside);
}

TEST_F(FlyInput, WhoTypesDoesNotFly) {
  model_->viewer.panels.palette.shown = true;
  input_.down[1] = true;
  input_.held = {GLFW_KEY_W};
  const Vec3 before = eye();
  frame();
  frame();
  EXPECT_EQ(eye(), before);
}

}  // namespace
}  // namespace rocinante
