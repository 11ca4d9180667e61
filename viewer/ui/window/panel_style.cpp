#include "viewer/ui/window/panel_style.h"

#include <imgui.h>

#include <cmath>

namespace rocinante {
namespace {

/// One Dear ImGui context is there at a time, and so is one theme.
bool is_light_now = false;

struct StyledColor {
  ImGuiCol where;
  PanelColor color;
};
constexpr StyledColor kStyled[] = {
    {ImGuiCol_Text, PanelColor::text},
    {ImGuiCol_TextDisabled, PanelColor::dim_text},
    {ImGuiCol_TextSelectedBg, PanelColor::selected_text},
    {ImGuiCol_WindowBg, PanelColor::panel},
    {ImGuiCol_PopupBg, PanelColor::popup},
    {ImGuiCol_TitleBg, PanelColor::title},
    {ImGuiCol_TitleBgActive, PanelColor::title},
    {ImGuiCol_TableHeaderBg, PanelColor::table_head},
    {ImGuiCol_Header, PanelColor::row},
    {ImGuiCol_HeaderHovered, PanelColor::row_hovered},
    {ImGuiCol_HeaderActive, PanelColor::row_held},
    {ImGuiCol_Button, PanelColor::button},
    {ImGuiCol_ButtonHovered, PanelColor::button_hovered},
    {ImGuiCol_ButtonActive, PanelColor::button_held},
    {ImGuiCol_FrameBg, PanelColor::field},
    {ImGuiCol_FrameBgHovered, PanelColor::field_hovered},
    {ImGuiCol_FrameBgActive, PanelColor::field_held},
    {ImGuiCol_Tab, PanelColor::tab},
    {ImGuiCol_TabActive, PanelColor::tab_chosen},
    {ImGuiCol_TabUnfocused, PanelColor::tab},
    {ImGuiCol_TabUnfocusedActive, PanelColor::tab_chosen},
    {ImGuiCol_TabHovered, PanelColor::tab_hovered},
    {ImGuiCol_CheckMark, PanelColor::check_mark},
    {ImGuiCol_SliderGrab, PanelColor::slider_thumb},
    {ImGuiCol_SliderGrabActive, PanelColor::slider_thumb_held},
    {ImGuiCol_PlotHistogram, PanelColor::progress},
};

}  // namespace

void stylePanels(bool light) {
  is_light_now = light;
  light ? ImGui::StyleColorsLight() : ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 6;
  style.FrameRounding = 4;
  style.GrabRounding = 4;
  style.ChildRounding = 4;
  style.TabRounding = 4;
  style.WindowBorderSize = 0;
  style.WindowPadding = ImVec2(12, 10);
  style.ItemSpacing = ImVec2(8, 6);
  style.IndentSpacing = 18;
  style.DisabledAlpha = kDisabledOpacity;
  for (const auto& [where, color] : kStyled) style.Colors[where] = panelInk(color);
}

ImU32 drawnColor(std::uint32_t rgba) {
  return IM_COL32(rgba >> 24U, rgba >> 16U & 0xFFU, rgba >> 8U & 0xFFU, rgba & 0xFFU);
}

ImU32 panelColor(PanelColor color, float opacity) {
  const std::uint32_t rgba = colorOf(color, is_light_now);
  const float alpha = std::round(static_cast<float>(rgba & 0xFFU) * opacity);
  return drawnColor((rgba & 0xFFFFFF00U) | static_cast<std::uint32_t>(alpha));
}

ImVec4 panelInk(PanelColor color) { return ImGui::ColorConvertU32ToFloat4(panelColor(color)); }

}  // namespace rocinante
