#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/base/figure_text.h"
#include "viewer/ui/live/source_rows.h"
#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/panels/panels.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxWithoutSearch = 12;
constexpr std::size_t kMaxRowsShown = 16;
constexpr std::uint64_t kManyRestarts = 10;

/// With its largest width, so that columns do not move while figures change.
void drawRight(const std::string& text, const ImVec4& color) {
  const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0F, room));
  ImGui::TextColored(color, "%s", text.c_str());
}

/// At most four characters: 250, 1.2k, 34k, 1.2M.
std::string shortCount(double count) {
  if (count < 9999.5) return fmt::format("{:.0f}", count);
  if (count < 999'500) return fmt::format("{:.0f}k", count / 1e3);
  return fmt::format("{:.1f}M", count / 1e6);
}

/// Shows a slow source's rate instead of 0 per second.
std::string rateText(const LiveSource& source) {
  if (source.rate_hz == 0 || source.rate_hz >= 9.95) return shortCount(source.rate_hz);
  return fmt::format("{:.1f}", source.rate_hz);
}

void explainRow(const SourceRow& row) {
  if (!ImGui::IsItemHovered()) return;
  std::string text = row.name;
  if (row.live == nullptr) {
    text += "\nthe cell expects it, and nothing has come from it";
  } else {
    const LiveSource& live = *row.live;
    text +=
        fmt::format("\n{}, {} lost on the way here", countText(live.packets, "packet"), live.lost);
    if (live.late > 0) text += fmt::format("\n{} late or twice", live.late);
    if (live.restarts > 0) text += "\nbegan anew " + countText(live.restarts, "time");
    if (live.restarts > kManyRestarts) text += ": do two senders use this name?";
    if (live.is_mixed) {
      text += "\nheard whole and also filtered by a relay: listen to one of them only";
    }
    if (live.faulty_lines > 0) {
      text += "\n" + countText(live.faulty_lines, "faulty line") + ": rocinante spy shows them";
    }
  }
  if (row.wanted_hz) {
    text += fmt::format("\nthe cell wants {:g} to {:g} packets/s", row.wanted_hz->first,
                        row.wanted_hz->second);
  }
  ImGui::SetTooltip("%s", text.c_str());
}

/// `name`: as there is room for it.
void drawSourceRow(const SourceRow& row, const std::string& name) {
  const ImVec4 plain = ImGui::GetStyleColorVec4(ImGuiCol_Text);
  const ImVec4 dim = ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled);
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const bool faulty =
      row.live != nullptr &&
      (row.live->faulty_lines > 0 || row.live->restarts > kManyRestarts || row.live->is_mixed);
  ImGui::PushStyleColor(ImGuiCol_Text, row.is_silent ? dim : plain);
  ImGui::Selectable((name + "###source").c_str(), false, ImGuiSelectableFlags_SpanAllColumns);
  ImGui::PopStyleColor();
  explainRow(row);
  if (faulty) {
    ImGui::SameLine();
    ImGui::TextColored(panelInk(PanelColor::fault), "!");
  }
  ImGui::TableNextColumn();
  if (row.live != nullptr)
    drawRight(rateText(*row.live), row.off_rate ? panelInk(PanelColor::fault) : plain);
  ImGui::TableNextColumn();
  if (row.live != nullptr) {
    drawRight(shortCount(static_cast<double>(row.live->lost)),
              row.live->lost > 0 ? panelInk(PanelColor::fault) : plain);
  }
  ImGui::TableNextColumn();
  drawRight(row.live == nullptr ? "never" : ageText(row.silent),
            row.is_silent ? panelInk(PanelColor::fault) : plain);
}

}  // namespace

void drawSourcesTab(ViewModel& model, SteadyTime now) {
  std::vector<SourceRow> rows = model.sourceRows(now);
  if (rows.empty()) {
    ImGui::TextDisabled("nothing has come yet");
    return;
  }
  if (rows.size() > kMaxWithoutSearch) {
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##find source", "find a source",
                             model.viewer.panels.source_filter.data(),
                             model.viewer.panels.source_filter.size());
    std::erase_if(rows, [&](const SourceRow& row) {
      return !containsWord(row.name, model.viewer.panels.source_filter.data());
    });
  }
  const float pitch = ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y;
  const auto shown = static_cast<float>(std::clamp<std::size_t>(rows.size(), 1, kMaxRowsShown));
  // What the columns of numbers leave, and a sign behind it.
  const ImGuiStyle& style = ImGui::GetStyle();
  const float name_room = ImGui::GetContentRegionAvail().x - px(44 + 44 + 50 + 12) -
                          8 * style.CellPadding.x - style.ScrollbarSize;
  if (!ImGui::BeginTable("sources", 4, ImGuiTableFlags_ScrollY,
                         ImVec2(0, (shown + 1) * pitch + px(4)))) {
    return;
  }
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableSetupColumn("source", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("/s", ImGuiTableColumnFlags_WidthFixed, px(44));
  ImGui::TableSetupColumn("lost", ImGuiTableColumnFlags_WidthFixed, px(44));
  ImGui::TableSetupColumn("heard", ImGuiTableColumnFlags_WidthFixed, px(50));
  ImGui::TableHeadersRow();
  std::vector<std::string> names;
  for (const SourceRow& row : rows) names.push_back(row.name);
  const std::vector<std::string>& shown_names =
      model.viewer.panels.short_names.of("sources", std::move(names), name_room, drawnWidth);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(rows.size()), pitch);
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      ImGui::PushID(i);
      const auto place = static_cast<std::size_t>(i);
      drawSourceRow(rows[place], shown_names[place]);
      ImGui::PopID();
    }
  }
  ImGui::EndTable();
}

}  // namespace rocinante
