#include "viewer/ui/panel_parts.h"

namespace rocinante {
namespace {

struct HelpLine {
  const char* keys;
  const char* means;
};

constexpr HelpLine kMouse[] = {{"left drag", "turn about the target"},
                               {"middle or right drag, Shift left", "pan"},
                               {"wheel", "nearer, farther"},
                               {"click", "select what is there"},
                               {"double click", "turn about that point"}};
constexpr HelpLine kTime[] = {{"Space", "play, pause"},
                              {"left, right", "a second; Shift: a tenth"},
                              {", .", "event before, after"},
                              {"Home, End", "start, end of the log"},
                              {"M", "a mark at this moment"}};
constexpr HelpLine kLook[] = {{"1 to 9", "cameras"},
                              {"F", "show everything"},
                              {"I", "insets on, off"},
                              {"E", "edges off, on, only"},
                              {"D", "shadows"},
                              {"L", "joints near their limits"},
                              {"W, T, C", "wireframe, see-through, collision"},
                              {"R", "trail of what is selected"},
                              {"H", "hide it; Shift: show all again"},
                              {"Esc", "select nothing"}};
constexpr HelpLine kProgram[] = {{"S", "evidence picture by rocinante render"},
                                 {"Tab", "panels on, off"},
                                 {"? or F1", "this help"},
                                 {"Q", "close"}};

template <std::size_t kCount>
void drawLines(const char* title, const HelpLine (&lines)[kCount], float left, float keys_width) {
  ImGui::SetCursorPosX(left);
  ImGui::TextColored(ImVec4(1.0F, 0.66F, 0.25F, 1), "%s", title);
  for (const HelpLine& line : lines) {
    ImGui::SetCursorPosX(left);
    ImGui::TextUnformatted(line.keys);
    ImGui::SameLine(left + keys_width);
    ImGui::TextColored(ImVec4(0.74F, 0.78F, 0.82F, 1), "%s", line.means);
  }
}

}  // namespace

void drawHelp(ViewModel& model) {
  const ImGuiIO& io = ImGui::GetIO();
  ImGui::SetNextWindowPos(ImVec2(io.DisplaySize.x / 2, io.DisplaySize.y / 2), ImGuiCond_Always,
                          ImVec2(0.5F, 0.5F));
  ImGui::SetNextWindowFocus();
  ImGui::SetNextWindowBgAlpha(0.96F);
  ImGui::Begin("Mouse and keyboard", &model.help_shown, kPanelFlags);
  const float left = ImGui::GetCursorPosX();
  const float top = ImGui::GetCursorPosY();
  drawLines("Mouse", kMouse, left, 240);
  drawLines("Time", kTime, left, 240);
  ImGui::SetCursorPosY(top);
  drawLines("Picture", kLook, left + 440, 84);
  drawLines("Program", kProgram, left + 440, 84);
  ImGui::End();
}

}  // namespace rocinante
