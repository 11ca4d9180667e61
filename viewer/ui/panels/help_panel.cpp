#include <string>
#include <vector>

#include "viewer/ui/commands/key_commands.h"
#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/panels/panels.h"

namespace rocinante {
namespace {

struct HelpLine {
  std::string keys, means;
};

const std::vector<HelpLine> kMouse = {{"left drag", "turn about the target"},
                                      {"middle or right drag", "pan; so does Shift and left"},
                                      {"right and WASD, QE", "fly; Shift: faster; wheel: speed"},
                                      {"wheel", "zoom at the mouse"},
                                      {"click", "select the object there"},
                                      {"double click", "turn about that point"}};

/// The keys of a group, each with what it does.
std::vector<HelpLine> keyLines(CommandGroup group) {
  std::vector<HelpLine> lines;
  for (const Command& command : allCommands()) {
    if (command.group != group || command.shortcuts.empty()) continue;
    if (!command.keys_shown.empty()) {
      lines.push_back({std::string(command.keys_shown), std::string(command.means)});
      continue;
    }
    for (const Shortcut& shortcut : command.shortcuts) {
      lines.push_back({shownKey(shortcut.key),
                       std::string(shortcut.means.empty() ? command.means : shortcut.means)});
    }
  }
  return lines;
}

void drawLines(const char* title, const std::vector<HelpLine>& lines, float left,
               float keys_width) {
  ImGui::SetCursorPosX(left);
  ImGui::TextColored(panelInk(PanelColor::heading), "%s", title);
  for (const HelpLine& line : lines) {
    ImGui::SetCursorPosX(left);
    ImGui::TextUnformatted(line.keys.c_str());
    ImGui::SameLine(left + keys_width);
    ImGui::TextColored(panelInk(PanelColor::dim_text), "%s", line.means.c_str());
  }
}

}  // namespace

void drawHelp(ViewModel& model) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(size.x / 2, size.y / 2), ImGuiCond_Always, ImVec2(0.5F, 0.5F));
  ImGui::SetNextWindowSizeConstraints(ImVec2(0, 0),
                                      ImVec2(size.x - px(kPanelMargin), size.y - px(kPanelMargin)));
  ImGui::SetNextWindowFocus();
  ImGui::Begin("Mouse and keyboard", &model.viewer.panels.help_shown,
               kPanelFlags | ImGuiWindowFlags_HorizontalScrollbar);
  const float left = ImGui::GetStyle().WindowPadding.x;
  const float top = ImGui::GetCursorPosY();
  constexpr float kKeysWidth = 150;
  drawLines("Mouse", kMouse, left, px(kKeysWidth));
  drawLines("Camera", keyLines(CommandGroup::camera), left, px(kKeysWidth));
  drawLines("Time", keyLines(CommandGroup::time), left, px(kKeysWidth));
  // Side by side if there is room, else one below the other.
  const bool wide = size.x >= px(940);
  const float beside = wide ? left + px(455) : left;
  const float keys_width = px(wide ? 80 : kKeysWidth);
  if (wide) ImGui::SetCursorPosY(top);
  drawLines("Picture", keyLines(CommandGroup::picture), beside, keys_width);
  drawLines("Program", keyLines(CommandGroup::program), beside, keys_width);
  ImGui::End();
}

void drawHelpButton(ViewModel& model) {
  bool& shown = model.viewer.panels.help_shown;
  const float size = ImGui::GetTextLineHeight() + px(4);
  ImGui::PushStyleVar(ImGuiStyleVar_FrameRounding, size / 2);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0, 0));
  if (ImGui::Button("?##help", ImVec2(size, size))) shown = !shown;
  ImGui::PopStyleVar(2);
  explain(("mouse and keyboard (" + shownKeys(*findCommand("help")) + ")").c_str());
}

}  // namespace rocinante
