#include "viewer/ui/panels/help_panel.h"

#include "viewer/ui/panels/panel_parts.h"

namespace rocinante {
namespace {

struct HelpLine {
  const char* keys;
  const char* means;
};

constexpr HelpLine kMouse[] = {{"left drag", "turn about the target"},
                               {"middle or right drag, Shift left", "pan"},
                               {"wheel", "zoom at the mouse"},
                               {"click", "select the object there"},
                               {"double click", "turn about that point"}};
constexpr HelpLine kTime[] = {{"Space", "play, pause"},
                              {"left, right", "a second; Shift: a tenth"},
                              {", .", "event before, after; Shift: packet"},
                              {"Home, End", "start or end of the log"},
                              {"M", "a mark at this moment"}};
constexpr HelpLine kLook[] = {{"1 to 9, 0", "cameras; initial view"},
                              {"F", "show all that moves; Shift: the selection"},
                              {"I", "insets on or off"},
                              {"E", "edges off, on, only"},
                              {"D", "shadows"},
                              {"L", "joints near a limit"},
                              {"W, T, C", "wireframe, see-through, collision"},
                              {"R", "trail of the selection"},
                              {"H", "hide the selection; Shift: show all"},
                              {"Esc", "close a list; clear the selection"}};
constexpr HelpLine kProgram[] = {{"S", "evidence picture, by rocinante render"},
                                 {"Tab", "panels on or off"},
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
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(size.x / 2, size.y / 2), ImGuiCond_Always, ImVec2(0.5F, 0.5F));
  ImGui::SetNextWindowSizeConstraints(ImVec2(0, 0),
                                      ImVec2(size.x - px(kPanelMargin), size.y - px(kPanelMargin)));
  ImGui::SetNextWindowFocus();
  ImGui::SetNextWindowBgAlpha(0.96F);
  ImGui::Begin("Mouse and keyboard", &model.help_shown,
               kPanelFlags | ImGuiWindowFlags_HorizontalScrollbar);
  const float left = ImGui::GetStyle().WindowPadding.x;
  const float top = ImGui::GetCursorPosY();
  drawLines("Mouse", kMouse, left, px(240));
  drawLines("Time", kTime, left, px(240));
  // Side by side if there is room, else one below the other.
  const bool wide = size.x >= px(940);
  const float beside = wide ? left + px(500) : left;
  if (wide) ImGui::SetCursorPosY(top);
  drawLines("Picture", kLook, beside, px(wide ? 84 : 240));
  drawLines("Program", kProgram, beside, px(wide ? 84 : 240));
  ImGui::End();
}

}  // namespace rocinante
