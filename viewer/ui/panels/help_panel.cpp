#include <algorithm>
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

struct HelpGroup {
  const char* title;
  std::vector<HelpLine> lines;
};

/// Where lines stand, from the window's left edge.
struct HelpColumn {
  float left = 0;
  float means = 0;     ///< where it begins what a key does
  bool below = false;  ///< the key, as there is no room beside it
  float wrap = -1;     ///< where lines end; below 0: nowhere
};

void drawGroup(const HelpGroup& group, const HelpColumn& column) {
  ImGui::PushTextWrapPos(column.wrap);
  ImGui::SetCursorPosX(column.left);
  ImGui::TextColored(panelInk(PanelColor::heading), "%s", group.title);
  for (const HelpLine& line : group.lines) {
    ImGui::SetCursorPosX(column.left);
    ImGui::TextUnformatted(line.keys.c_str());
    column.below ? ImGui::SetCursorPosX(column.means) : ImGui::SameLine(column.means);
    ImGui::TextColored(panelInk(PanelColor::dim_text), "%s", line.means.c_str());
  }
  ImGui::PopTextWrapPos();
}

float widestMeans(const std::vector<HelpGroup>& groups) {
  float widest = 0;
  for (const HelpGroup& group : groups) {
    for (const HelpLine& line : group.lines) widest = std::max(widest, drawnWidth(line.means));
  }
  return widest;
}

}  // namespace

void drawHelp(ViewModel& model) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(size.x / 2, size.y / 2), ImGuiCond_Always, ImVec2(0.5F, 0.5F));
  const ImVec2 most(size.x - px(kPanelMargin), size.y - px(kPanelMargin));
  ImGui::SetNextWindowSizeConstraints(ImVec2(0, 0), most);
  ImGui::SetNextWindowFocus();
  const std::vector<HelpGroup> first{{"Mouse", kMouse},
                                     {"Camera", keyLines(CommandGroup::camera)},
                                     {"Time", keyLines(CommandGroup::time)}};
  const std::vector<HelpGroup> second{{"Picture", keyLines(CommandGroup::picture)},
                                      {"Program", keyLines(CommandGroup::program)}};
  // Side by side if there is room, else one below the other.
  const bool wide = size.x >= px(940);
  const ImGuiStyle& style = ImGui::GetStyle();
  const float left = style.WindowPadding.x;
  HelpColumn column{left, left + px(150)};
  const float end = most.x - style.WindowPadding.x - style.ScrollbarSize;
  if (!wide && column.means + std::max(widestMeans(first), widestMeans(second)) > end) {
    column = {left, left + px(20), true, end};
  }
  // Lines that are wrapped need no second scroll bar.
  ImGui::Begin("Mouse and keyboard", &model.viewer.panels.help_shown,
               kPanelFlags | (column.below ? 0 : ImGuiWindowFlags_HorizontalScrollbar));
  const float top = ImGui::GetCursorPosY();
  for (const HelpGroup& group : first) drawGroup(group, column);
  if (wide) {
    ImGui::SetCursorPosY(top);
    column = {left + px(455), left + px(455 + 80)};
  }
  for (const HelpGroup& group : second) drawGroup(group, column);
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
