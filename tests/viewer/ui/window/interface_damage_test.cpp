#include "viewer/ui/window/interface_damage.h"

#include <gtest/gtest.h>

#include "viewer/ui/window/interface_context.h"

namespace rocinante {
namespace {

class Damage : public testing::Test {
 protected:
  void SetUp() override { ImGui::GetIO().Fonts->Build(); }
  /// A frame with a small panel of that text, and one beside it that stays.
  PixelRectangle frame(const char* text) {
    interface_.beginFrame(400, 300);
    const auto panel = [](const char* name, float x, const char* said) {
      ImGui::SetNextWindowPos(ImVec2(x, 20));
      ImGui::SetNextWindowSize(ImVec2(100, 50));
      ImGui::Begin(name, nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings);
      ImGui::TextUnformatted(said);
      ImGui::End();
    };
    panel("changing", 40, text);
    panel("staying", 250, "the same");
    ImGui::Render();
    return damage_.since(*ImGui::GetDrawData(), 400, 300);
  }

  InterfaceContext interface_{nullptr};
  InterfaceDamage damage_;
};

TEST_F(Damage, IsThePanelThatChangedAndNothingElse) {
  EXPECT_EQ(frame("4 s"), (PixelRectangle{0, 0, 400, 300}));
  frame("4 s");  // a panel appears over two frames
  EXPECT_EQ(frame("4 s"), (PixelRectangle{0, 0, 0, 0}));
  const PixelRectangle part = frame("5 s");
  EXPECT_LE(part.x, 40);
  EXPECT_GE(part.x + part.width, 140);
  EXPECT_LT(part.x + part.width, 200);
  EXPECT_LE(part.y, 20);
  EXPECT_LT(part.height, 60);
  EXPECT_EQ(frame("5 s").width, 0);
}

TEST_F(Damage, IsEverythingWhenTheWindowWasForgottenOrHasAnotherSize) {
  frame("4 s");
  frame("4 s");
  damage_.forget();
  EXPECT_EQ(frame("4 s"), (PixelRectangle{0, 0, 400, 300}));
  EXPECT_EQ(frame("4 s").width, 0);
  EXPECT_EQ(damage_.since(*ImGui::GetDrawData(), 500, 300), (PixelRectangle{0, 0, 500, 300}));
}

}  // namespace
}  // namespace rocinante
