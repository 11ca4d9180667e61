#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "viewer/ui/commands/palette_entries.h"
#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/panels/panels.h"

namespace rocinante {
namespace {

constexpr float kPaletteWidth = 560;
constexpr std::size_t kMaxLines = 200;
constexpr float kLinesShown = 12;

void runEntry(const PaletteEntry& entry, ViewModel& model, SteadyTime now,
              ViewerRequests& requests) {
  std::vector<std::string> words = splitWords(entry.line);
  const std::string name = words.front();
  if (entry.incomplete) {
    // Its argument is typed now.
    model.viewer.panels.palette.open(name + " ");
    return;
  }
  model.viewer.panels.palette.shown = false;
  words.erase(words.begin());
  const CommandStage stage{model, now, model.viewer.picture_part.height, requests};
  if (const Status done = runCommand(name, words, stage); !done) {
    requests.fault = done.error().text();
  }
}

void drawEntry(const PaletteEntry& entry, bool chosen, bool* clicked) {
  const float left = ImGui::GetCursorPosX();
  const float right = left + ImGui::GetContentRegionAvail().x;
  *clicked = ImGui::Selectable("##entry", chosen);
  const bool seen = ImGui::IsItemVisible();
  if (!seen) return;
  const bool over = ImGui::IsItemHovered();
  const float key_width = entry.key.empty() ? 0 : ImGui::CalcTextSize(entry.key.c_str()).x;
  ImGui::SameLine(left);
  ImGui::TextUnformatted(entry.line.c_str());
  const float named = ImGui::CalcTextSize(entry.line.c_str()).x;
  // What it means, cut where the key begins.
  const float from = left + std::max(px(190), named + px(16));
  const float room = right - from - key_width - px(12);
  if (room > px(40)) {
    ImGui::SameLine(from);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const std::string means = cutInMiddle(entry.means, room, drawnWidth);
    ImGui::GetWindowDrawList()->AddText(corner, panelColor(PanelColor::dim_text), means.c_str());
    ImGui::Dummy(ImVec2(room, ImGui::GetTextLineHeight()));
    if (over && means != entry.means) ImGui::SetTooltip("%s", entry.means.c_str());
  }
  if (key_width > 0) {
    ImGui::SameLine(right - key_width);
    ImGui::TextUnformatted(entry.key.c_str());
  }
}

}  // namespace

void drawPalette(ViewModel& model, SteadyTime now, ViewerRequests& requests) {
  PaletteState& palette = model.viewer.panels.palette;
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const float width = std::min(px(kPaletteWidth), size.x - px(2 * kPanelMargin));
  ImGui::SetNextWindowPos(ImVec2(size.x / 2, px(4 * kPanelMargin)), ImGuiCond_Always,
                          ImVec2(0.5F, 0));
  ImGui::SetNextWindowSize(ImVec2(width, 0));
  if (palette.just_opened) ImGui::SetNextWindowFocus();
  ImGui::Begin("palette", nullptr,
               (kPanelFlags & ~ImGuiWindowFlags_AlwaysAutoResize) | ImGuiWindowFlags_NoTitleBar |
                   ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoScrollbar |
                   ImGuiWindowFlags_NoScrollWithMouse);
  const bool focused = ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows);
  const bool opened = std::exchange(palette.just_opened, false);
  const std::string before = palette.text.data();
  const bool entered = drawTypedLine("##command", "a command", palette.text, opened, palette.start);
  if (before != palette.text.data()) palette.chosen = 0;
  const std::vector<PaletteEntry> entries =
      matchingEntries(palette.text.data(), paletteEntries(model), kMaxLines);
  const std::size_t chosen_before = palette.chosen;
  if (keyPressed(ImGuiKey_DownArrow)) ++palette.chosen;
  if (keyPressed(ImGuiKey_UpArrow) && palette.chosen > 0) --palette.chosen;
  palette.chosen = std::min(palette.chosen, entries.empty() ? 0 : entries.size() - 1);

  const PaletteEntry* picked = nullptr;
  if (entries.empty()) ImGui::TextDisabled("no matching command");
  const float pitch = ImGui::GetTextLineHeightWithSpacing();
  const float room =
      size.y - px(kPanelMargin) - ImGui::GetStyle().WindowPadding.y - ImGui::GetCursorScreenPos().y;
  const float most = std::clamp(std::floor(room / pitch), 1.0F, kLinesShown);
  const float rows = std::min(static_cast<float>(entries.size()), most);
  ImGui::BeginChild("entries", ImVec2(0, rows * pitch));
  for (std::size_t i = 0; i < entries.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    bool clicked = false;
    drawEntry(entries[i], i == palette.chosen, &clicked);
    if (clicked) picked = &entries[i];
    if (i == palette.chosen && chosen_before != palette.chosen) ImGui::SetScrollHereY();
    ImGui::PopID();
  }
  ImGui::EndChild();
  ImGui::End();
  if (entered && !entries.empty()) picked = &entries[palette.chosen];
  // ImGui takes the keyboard from a line at Enter: one that names nothing is corrected.
  if (entered && entries.empty()) palette.just_opened = true;
  if (picked != nullptr) {
    const PaletteEntry entry = *picked;
    runEntry(entry, model, now, requests);
  } else if (keyPressed(ImGuiKey_Escape) ||
             (!focused && !opened && ImGui::IsMouseClicked(ImGuiMouseButton_Left))) {
    palette.shown = false;
  }
}

}  // namespace rocinante
