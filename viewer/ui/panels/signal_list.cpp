#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/base/plain_text.h"
#include "viewer/shown/signal_rows.h"
#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/panels/panels.h"
#include "viewer/ui/panels/plot_parts.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxSignalRows = 8;
constexpr float kLeastSignalWidth = 230;
constexpr float kNamePart = 0.55F;  // of the width

std::string wholeName(const SignalName& name) {
  return plainText(name.link.empty() ? name.name : name.link + " " + name.name);
}

/// `shown_name`: as there is room for it.
void drawSignal(ViewModel& model, const std::string& device, const SignalName& name,
                const Item<SignalValue>& item, const std::string& shown_name) {
  const SignalValue& value = item.value;
  const SeriesKey key{SeriesKey::Kind::signal, device, name.name, name.link};
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  if (model.session() != nullptr) {
    drawPlotButton(model, key);
    ImGui::SameLine(0, px(kPlotButtonGap));
  }
  drawDraggable(model, "name", shown_name, ImGuiCol_Text, {key});
  explain(fmt::format("{}\nstated last by {}", key.text(), plainText(item.owner)).c_str());
  ImGui::TableNextColumn();
  drawCut(signalValueText(value));
}

}  // namespace

void drawSignals(ViewModel& model, const std::string& device, const std::string& link,
                 const Signals& signals) {
  std::vector<const Signals::value_type*> rows;
  for (const auto& each : signals) {
    if (link.empty() || each.first.link == link) rows.push_back(&each);
  }
  if (rows.empty()) return;
  const float pitch = ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y;
  const auto shown = static_cast<float>(std::min(rows.size(), kMaxSignalRows));
  // A panel that fits its contents gives a table no width of its own.
  const float width = std::max(ImGui::GetContentRegionAvail().x, px(kLeastSignalWidth));
  const ImVec2 size(width, shown * pitch + px(4));
  if (!ImGui::BeginTable("signals", 2, ImGuiTableFlags_ScrollY, size)) return;
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, width * kNamePart);
  ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
  std::vector<std::string> names;
  for (const auto* row : rows) names.push_back(wholeName(row->first));
  const float button = model.session() != nullptr ? px(kPlotButtonSide + kPlotButtonGap) : 0.0F;
  const std::vector<std::string>& short_names = model.viewer.panels.short_names.of(
      "signals of " + device, std::move(names), width * kNamePart - button, drawnWidth);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(rows.size()), pitch);
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const auto& [name, item] = *rows[static_cast<std::size_t>(i)];
      ImGui::PushID(i);
      drawSignal(model, device, name, item, short_names[static_cast<std::size_t>(i)]);
      ImGui::PopID();
    }
  }
  ImGui::EndTable();
}

}  // namespace rocinante
