#include "viewer/ui/panels/plot_parts.h"

#include <algorithm>
#include <array>

#include "viewer/shown/state_shape.h"
#include "viewer/ui/panels/panel_parts.h"

namespace rocinante {
namespace {

/// Of states: seen on a dark and on a light ground, and under their texts.
constexpr std::size_t kHues = 360;
struct Tone {
  float saturation, value;
};
constexpr std::array<Tone, 3> kStateTones{{{0.55F, 0.95F}, {0.75F, 0.68F}, {0.32F, 0.80F}}};

}  // namespace

ImU32 curveColor(std::size_t number, float opacity) {
  return panelColor(curveColorOf(number), opacity);
}

ImU32 stateColor(std::string_view text) {
  if (text == "true") return curveColor(2);
  if (text == "false") return panelColor(PanelColor::state_false);
  const std::size_t number = colorOfState(text, kHues * kStateTones.size());
  const auto& [saturation, value] = kStateTones[number / kHues];
  float red = 0, green = 0, blue = 0;
  ImGui::ColorConvertHSVtoRGB(static_cast<float>(number % kHues) / kHues, saturation, value, red,
                              green, blue);
  return ImGui::ColorConvertFloat4ToU32(ImVec4(red, green, blue, 1));
}

ImU32 inkOn(ImU32 ground) {
  const auto part = [ground](int shift) { return ground >> shift & 0xFFU; };
  return drawnColor(blackOrWhiteOn(part(IM_COL32_R_SHIFT) << 24U | part(IM_COL32_G_SHIFT) << 16U |
                                   part(IM_COL32_B_SHIFT) << 8U | 0xFFU));
}

ImU32 fadedInk(float part) {
  ImVec4 ink = ImGui::GetStyleColorVec4(ImGuiCol_Text);
  ink.w *= part;
  return ImGui::ColorConvertFloat4ToU32(ink);
}

std::optional<SeriesKey> poseKeyOf(const ViewModel& model, const Selection& shown,
                                   const char* part) {
  if (model.session() == nullptr) return std::nullopt;
  if (!shown.link.empty()) {
    const Selection& in = model.viewer.reference;
    return SeriesKey{SeriesKey::Kind::link, shown.device, part, shown.link, in.device, in.link};
  }
  const DeviceState* const state = model.received().findDevice(shown.device);
  if (state == nullptr || !state->pose) return std::nullopt;
  return SeriesKey{SeriesKey::Kind::pose, shown.device, part};
}

void dragFromItem(ViewModel& model, const std::vector<SeriesKey>& keys) {
  if (model.session() == nullptr || !model.viewer.plots.dragged.empty()) return;
  if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, px(4))) {
    model.viewer.plots.dragged = keys;
  }
}

void drawDraggable(ViewModel& model, const char* id, const std::string& text, ImGuiCol ink,
                   const std::vector<SeriesKey>& keys) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  ImGui::InvisibleButton(id, ImVec2(std::max(size.x, 1.0F), std::max(size.y, 1.0F)));
  ImGui::GetWindowDrawList()->AddText(corner, ImGui::GetColorU32(ink), text.c_str());
  dragFromItem(model, keys);
}

void drawPlotButton(ViewModel& model, const char* id, const std::vector<SeriesKey>& keys) {
  if (model.session() == nullptr || keys.empty()) return;
  const float side = px(kPlotButtonSide);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetTextLineHeight();
  const bool pressed = ImGui::InvisibleButton(id, ImVec2(side, height));
  const PlotBoard::Curve* const curve = model.viewer.plots.find(keys.front());
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const float top = corner.y + (height - side) / 2;
  const ImVec2 low(corner.x, top), high(corner.x + side, top + side);
  if (curve != nullptr) {
    list->AddRectFilled(low, high, curveColor(curve->color));
  } else {
    const float faint = ImGui::IsItemHovered() ? 0.9F : 0.4F;
    list->AddRect(low, high, fadedInk(faint));
    // A little curve.
    const std::array<ImVec2, 4> line{
        ImVec2(low.x + px(2), high.y - px(3)), ImVec2(low.x + px(4), low.y + px(4)),
        ImVec2(low.x + px(7), low.y + px(7)), ImVec2(high.x - px(2), low.y + px(3))};
    list->AddPolyline(line.data(), 4, fadedInk(faint), 0, px(1.2F));
  }
  const bool full = model.viewer.plots.curves().size() >= PlotBoard::kMaxCurves;
  explain(curve != nullptr ? "no longer plot it"
          : full           ? "20 curves are plotted: remove one first"
                           : "plot it over time: click, or drag it to the plots");
  dragFromItem(model, keys);
  if (!pressed || !model.viewer.plots.dragged.empty()) return;
  const bool all = std::ranges::all_of(
      keys, [&](const SeriesKey& key) { return model.viewer.plots.find(key) != nullptr; });
  for (const SeriesKey& key : keys) {
    if (all) {
      model.viewer.plots.remove(key);
    } else {
      model.viewer.plots.add(key);
    }
  }
}

void drawPlotButton(ViewModel& model, const SeriesKey& key) {
  drawPlotButton(model, ("plot " + key.text()).c_str(), {key});
}

}  // namespace rocinante
