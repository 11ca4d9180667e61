#include "viewer/ui/panels/pose_fields_panel.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <string>
#include <string_view>

#include "core/math/transform.h"
#include "tests/viewer/support/arm_window.h"
#include "viewer/ui/model/dock_layout.h"
#include "viewer/ui/model/pose_fields.h"
#include "viewer/ui/panels/panels.h"

namespace rocinante {
namespace {

/// The fields of the selected arm in a panel of that width, at the window's top left.
class DrawnPoseFields : public test::ArmWindow {
 protected:
  DrawnPoseFields() : ArmWindow("pose = { xyz = [0.1234567, 0, 0] }\n") {
    model_->selected = {"arm", ""};
    model_->viewer.gizmo.shown = true;
    frame();
    frame();
  }
  void drawOver() override {
    if (whole_) {
      ViewerRequests requests;
      static_cast<void>(drawPanels(*model_, ViewerStatus(), SteadyTime{}, requests));
      return;
    }
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({width_, 300});
    ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoTitleBar);
    drawPoseFields(*model_);
    ImGui::End();
    settlePoseFields(*model_);
  }
  const std::optional<PoseTyping>& typing() const {
    return model_->viewer.panels.pose_fields.typing;
  }
  const std::string& trouble() const { return model_->viewer.panels.pose_fields.trouble; }
  std::string text() const { return typing() ? typing()->text.data() : ""; }
  double x() const { return model_->scene().findDevice("arm")->base[3].x; }
  void click(const Vec2& at) {
    moveTo(at);
    press(true);
    press(false);
  }
  void key(int glfw) {
    input_.presses = {KeyPress{glfw}};
    frame();
    frame();
  }
  void type(const std::string& letters) {
    input_.typed = letters;
    frame();
    frame();
  }
  /// The tip of the last frame; null: there was none.
  static const ImGuiWindow* tip() {
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
      const bool is_tip = (window->Flags & ImGuiWindowFlags_Tooltip) != 0;
      if (is_tip && window->Active && !window->Hidden) return window;
    }
    return nullptr;
  }
  /// Clicks on what is in the panel until the field has the keyboard.
  bool open(std::string_view name) {
    for (double y = 6; y < 290; y += 7) {
      for (double at = width_ - 30; at > 30; at -= 25) {
        click({at, y});
        opened_at_ = {at, y};
        if (typing() && kPoseFields[typing()->field] == name) return true;
      }
    }
    return false;
  }

  float width_ = 280;
  bool whole_ = false;  ///< all panels, instead of this one
  Vec2 opened_at_{0, 0};
};

TEST_F(DrawnPoseFields, TakeWhatIsTypedWithEnter) {
  ASSERT_TRUE(open("x"));
  EXPECT_EQ(text(), "123.457") << "as exactly as it is kept";
  type("1.5m");
  EXPECT_EQ(text(), "1.5m") << "typed over";
  EXPECT_EQ(x(), 0.1234567);
  key(GLFW_KEY_ENTER);
  EXPECT_FALSE(typing().has_value());
  EXPECT_EQ(x(), 1.5);
  EXPECT_EQ(model_->moves.undo(), "arm");
  EXPECT_FALSE(model_->moves.canUndo());
  frame();
  EXPECT_EQ(x(), 0.1234567);
}

TEST_F(DrawnPoseFields, OnlyLookedIntoMoveNothing) {
  for (const std::string_view name : kPoseFields) ASSERT_TRUE(open(name)) << name;
  key(GLFW_KEY_ENTER);
  EXPECT_FALSE(typing().has_value());
  EXPECT_TRUE(model_->moves.poses().empty());
  EXPECT_FALSE(model_->moves.canUndo());
  EXPECT_EQ(trouble(), "");
}

TEST_F(DrawnPoseFields, PutBackWithEsc) {
  ASSERT_TRUE(open("yaw"));
  type("90");
  key(GLFW_KEY_ESCAPE);
  EXPECT_FALSE(typing().has_value());
  EXPECT_FALSE(model_->moves.canUndo());
  EXPECT_EQ(model_->selected.device, "arm");
}

TEST_F(DrawnPoseFields, AreLeftByAClickBesideThem) {
  ASSERT_TRUE(open("y"));
  type("250");
  click({600, 500});
  frame();
  EXPECT_FALSE(typing().has_value());
  ASSERT_NE(model_->moves.find("arm"), nullptr);
  EXPECT_EQ(model_->moves.find("arm")->position, Vec3(0.1234567, 0.25, 0));
  // The selection that went with the click took the fields along.
  ASSERT_TRUE(open("z"));
  type("1");
  model_->selected = {};
  frame();
  EXPECT_FALSE(typing().has_value());
  EXPECT_EQ(model_->moves.find("arm")->position.z, 0.001);
}

TEST_F(DrawnPoseFields, AreLeftByTab) {
  ASSERT_TRUE(open("x"));
  type("2000");
  key(GLFW_KEY_TAB);
  frame();
  ASSERT_TRUE(typing().has_value());
  EXPECT_EQ(kPoseFields[typing()->field], "y");
  EXPECT_EQ(text(), "0");
  EXPECT_EQ(x(), 2);
  type("30");
  key(GLFW_KEY_ENTER);
  EXPECT_EQ(x(), 2);
  EXPECT_EQ(model_->moves.undo(), "arm");
  EXPECT_TRUE(model_->moves.canUndo());
}

/// In two columns and in one.
TEST_F(DrawnPoseFields, AreGoneThroughByTabInTheirOrder) {
  for (const float width : {280.0F, 130.0F}) {
    width_ = width;
    frame();
    ASSERT_TRUE(open("x"));
    std::string order;
    for (std::size_t i = 0; i < kPoseFields.size(); ++i) {
      ASSERT_TRUE(typing().has_value());
      order += std::string(kPoseFields[typing()->field]) + " ";
      if (i < 3) type(std::to_string(100 * (i + 1)));
      if (i + 1 < kPoseFields.size()) key(GLFW_KEY_TAB);
      frame();
    }
    key(GLFW_KEY_ENTER);
    EXPECT_EQ(order, "x y z roll pitch yaw ");
    EXPECT_EQ(model_->movablePose("arm")->position, Vec3(0.1, 0.2, 0.3));
  }
}

TEST_F(DrawnPoseFields, HaveATipWhileNothingIsTypedAndNothingIsWrong) {
  ASSERT_TRUE(open("x"));
  frame();
  EXPECT_EQ(tip(), nullptr) << "it is typed into";
  type("banana");
  EXPECT_EQ(tip(), nullptr);
  key(GLFW_KEY_ENTER);
  frame();
  EXPECT_NE(trouble(), "");
  EXPECT_EQ(tip(), nullptr) << "the sentence stands below";
  click(opened_at_);
  type("12");
  key(GLFW_KEY_ENTER);
  frame();
  EXPECT_EQ(trouble(), "");
  EXPECT_EQ(tip(), nullptr) << "the next field is below, and the mouse rests";
  moveTo({opened_at_.x + 1, opened_at_.y});
  frame();
  EXPECT_NE(tip(), nullptr);
  // Nor after a number that was put back.
  click(opened_at_);
  type("7");
  key(GLFW_KEY_ESCAPE);
  frame();
  EXPECT_FALSE(typing().has_value());
  EXPECT_EQ(tip(), nullptr);
}

TEST_F(DrawnPoseFields, SayWhatIsWrongAndMoveNothing) {
  ASSERT_TRUE(open("x"));
  type("12q");
  key(GLFW_KEY_ENTER);
  EXPECT_EQ(trouble(), "x of arm: `12q` is not a length: 120, 120mm, 0.12m");
  EXPECT_FALSE(model_->moves.canUndo());
  ASSERT_TRUE(open("x"));
  EXPECT_EQ(text(), "123.457");
  type("12");
  key(GLFW_KEY_ENTER);
  EXPECT_EQ(trouble(), "");
  EXPECT_EQ(x(), 0.012);
}

TEST_F(DrawnPoseFields, ThatWereHiddenAreForgotten) {
  ASSERT_TRUE(open("x"));
  type("12");
  interface_.beginFrame(800, 600, &input_);  // without panels
  ImGui::Render();
  frame();
  frame();
  EXPECT_FALSE(typing().has_value());
  EXPECT_FALSE(model_->moves.canUndo());
}

TEST_F(DrawnPoseFields, AreThereWithTheHandlesAlone) {
  model_->viewer.gizmo.shown = false;
  EXPECT_FALSE(open("x"));
}

TEST_F(DrawnPoseFields, StandInTwoColumnsInANarrowDock) {
  width_ = kLeastRightWidth;
  frame();
  for (const std::string_view name : kPoseFields) ASSERT_TRUE(open(name)) << name;
  const Vec2 yaw = opened_at_;
  ASSERT_TRUE(open("z"));
  EXPECT_EQ(opened_at_.y, yaw.y);
  EXPECT_LT(opened_at_.x, yaw.x - 50);
}

TEST_F(DrawnPoseFields, StandBelowEachOtherWhereThatIsTooNarrow) {
  width_ = 130;
  frame();
  for (const std::string_view name : kPoseFields) ASSERT_TRUE(open(name)) << name;
  const Vec2 yaw = opened_at_;
  ASSERT_TRUE(open("z"));
  EXPECT_LT(opened_at_.y, yaw.y - 20);
}

TEST_F(DrawnPoseFields, OfWhatPacketsPlaceTakeNoText) {
  test::writeSession(folder_ / "s.mcap", {{0, "pose arm 1 0 0 0 0 0 1\n"}});
  auto cell = loadCell(folder_ / "cell.toml", {});
  auto session = Timeline::open(folder_ / "s.mcap");
  ASSERT_TRUE(cell.ok() && session.ok());
  model_ = std::make_unique<ViewModel>(
      ViewModel::make(std::move(*cell), std::move(*session), std::nullopt, {}, {}).value());
  ASSERT_TRUE(model_->update(SteadyTime{}).ok());
  model_->selected = {"arm", ""};
  model_->viewer.gizmo.shown = true;
  EXPECT_EQ(model_->movablePose("arm").error().what, "packets say where the device is");
  EXPECT_FALSE(open("x"));
}

TEST_F(DrawnPoseFields, StandInThePanelOfTheDevice) {
  whole_ = true;
  model_->viewer.panels.places.peeked = nameOf(DockEdge::right);
  frame();
  frame();
  const PanelRectangle panel = model_->viewer.panels.places.drawn.at("device");
  ASSERT_GT(panel.width, 0);
  for (float y = panel.y + 5; !typing() && y < panel.y + panel.height; y += 7) {
    click({panel.x + 70, y});
  }
  ASSERT_TRUE(typing().has_value());
  EXPECT_EQ(kPoseFields[typing()->field], "x");
  type("1.5m");
  key(GLFW_KEY_ENTER);
  EXPECT_FALSE(typing().has_value());
  EXPECT_EQ(x(), 1.5);
}

TEST_F(DrawnPoseFields, BeginTheDragThatLeavesThem) {
  ASSERT_TRUE(open("x"));
  type("500");
  model_->viewer.picture_part = {300, 0, 500, 600};
  frame();
  const PicturePlaces places(model_->cameraView(), 500, 600);
  const auto gizmo = gizmoOf(*model_, places, kGizmoArrowPx);
  ASSERT_TRUE(gizmo.has_value());
  const auto tip = places.pixelOf(gizmo->origin + gizmo->axes[2] * gizmo->size_m);
  ASSERT_TRUE(tip.has_value());
  moveTo({tip->x + 300, tip->y});
  press(true);
  EXPECT_TRUE(model_->viewer.gizmo.drag.has_value());
  frame();
  press(false);
  EXPECT_EQ(x(), 0.5);
}

}  // namespace
}  // namespace rocinante
