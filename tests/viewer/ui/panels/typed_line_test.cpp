#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <string>
#include <string_view>
#include <vector>

#include "tests/viewer/support/arm_window.h"
#include "viewer/ui/panels/panels.h"

namespace rocinante {
namespace {

/// Of 1280x720 with all panels; each frame has what was typed since the last one.
class TypedLines : public test::ArmWindow {
 protected:
  ViewerRequests frame(const std::string& letters, const std::vector<KeyPress>& presses = {}) {
    for (const char letter : letters) {
      ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(letter));
    }
    interface_.beginFrame(1280, 720);
    ViewerRequests requests;
    drawPanels(*model_, ViewerStatus(), SteadyTime{}, requests);
    static_cast<void>(applyUserInput(*model_, SteadyTime{}, presses, requests));
    ImGui::Render();
    return requests;
  }

  const KeyPress ctrl_p_{GLFW_KEY_P, false, false, true}, ctrl_o_{GLFW_KEY_O, false, false, true};
  const KeyPress enter_{GLFW_KEY_ENTER};
};

TEST_F(TypedLines, TakeEveryLetterHoweverFewTheFrames) {
  frame("ab", {ctrl_p_});
  ASSERT_TRUE(model_->viewer.panels.palette.shown);
  for (const char* letter : {"c", "d", "e", "f", "g"}) frame(letter);
  frame("");
  EXPECT_STREQ(model_->viewer.panels.palette.text.data(), "abcdefg");
}

TEST_F(TypedLines, TakeAWholeCommandOfOneFrame) {
  EXPECT_FALSE(frame("screenshot a.png", {ctrl_p_, enter_}).screenshot);
  std::optional<std::filesystem::path> asked;
  for (int i = 0; i < 4 && !asked; ++i) asked = frame("").screenshot;
  ASSERT_TRUE(asked);
  EXPECT_EQ(*asked, "a.png");
  EXPECT_FALSE(model_->viewer.panels.palette.shown);
}

TEST_F(TypedLines, OfFilesTakeAPathOfOneFrame) {
  frame((folder_ / "arm.urdf").string(), {ctrl_o_, enter_});
  std::vector<std::filesystem::path> asked;
  for (int i = 0; i < 4 && asked.empty(); ++i) asked = frame("").open;
  ASSERT_EQ(asked.size(), 1U);
  EXPECT_EQ(asked.front(), folder_ / "arm.urdf");
}

TEST_F(TypedLines, ThatNamedNothingTakeTheKeyboardBack) {
  frame("zzz", {ctrl_p_});
  for (int i = 0; i < 3; ++i) frame("");
  FrameInput keyboard;
  keyboard.presses = {enter_};
  tellInput(ImGui::GetIO(), keyboard);
  frame("");
  keyboard.endFrame();
  tellInput(ImGui::GetIO(), keyboard);
  for (int i = 0; i < 3; ++i) frame("");
  ASSERT_TRUE(model_->viewer.panels.palette.shown);
  frame("fit");
  frame("");
  EXPECT_TRUE(std::string_view(model_->viewer.panels.palette.text.data()).ends_with("fit"));
}

TEST(LineStart, KeepsLettersOfAllKeyboards) {
  LineStart start;
  start.type('x');  // nothing waits for it
  start.begin();
  for (const char32_t letter : {U'a', U'\u00fc', U'\u20ac', U'\n', U'\x7f', U'\x85'}) {
    start.type(letter);
  }
  EXPECT_EQ(start.letters, "a\xC3\xBC\xE2\x82\xAC");
}

}  // namespace
}  // namespace rocinante
