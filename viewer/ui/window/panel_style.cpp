#include "viewer/ui/window/panel_style.h"

#include <imgui.h>

namespace rocinante {

namespace {

void useLightColors(ImGuiStyle& style) {
  ImGui::StyleColorsLight();
  style.Colors[ImGuiCol_Text] = ImVec4(0.10F, 0.12F, 0.14F, 1.0F);
  style.Colors[ImGuiCol_TextDisabled] = ImVec4(0.40F, 0.44F, 0.48F, 1.0F);
  style.Colors[ImGuiCol_WindowBg] = ImVec4(0.95F, 0.96F, 0.97F, 0.90F);
  style.Colors[ImGuiCol_PopupBg] = ImVec4(0.98F, 0.98F, 0.99F, 0.98F);
  style.Colors[ImGuiCol_TitleBgActive] = style.Colors[ImGuiCol_TitleBg] =
      ImVec4(0.83F, 0.87F, 0.90F, 0.98F);
  style.Colors[ImGuiCol_Header] = ImVec4(0.74F, 0.82F, 0.90F, 0.9F);
  style.Colors[ImGuiCol_HeaderHovered] = ImVec4(0.66F, 0.77F, 0.88F, 0.9F);
  style.Colors[ImGuiCol_Button] = ImVec4(0.76F, 0.83F, 0.90F, 1.0F);
  style.Colors[ImGuiCol_FrameBg] = ImVec4(0.84F, 0.87F, 0.90F, 1.0F);
  style.Colors[ImGuiCol_Tab] = ImVec4(0.86F, 0.89F, 0.92F, 1.0F);
  style.Colors[ImGuiCol_TabActive] = ImVec4(0.70F, 0.80F, 0.90F, 1.0F);
  style.Colors[ImGuiCol_TabHovered] = ImVec4(0.62F, 0.75F, 0.88F, 1.0F);
  style.Colors[ImGuiCol_CheckMark] = ImVec4(0.80F, 0.42F, 0.0F, 1.0F);
  style.Colors[ImGuiCol_SliderGrab] = ImVec4(0.85F, 0.48F, 0.05F, 1.0F);
}

}  // namespace

void stylePanels(bool light) {
  ImGui::StyleColorsDark();
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
  style.Colors[ImGuiCol_WindowBg] = ImVec4(0.09F, 0.11F, 0.13F, 0.86F);
  style.Colors[ImGuiCol_PopupBg] = ImVec4(0.09F, 0.11F, 0.13F, 0.95F);
  style.Colors[ImGuiCol_TitleBgActive] = style.Colors[ImGuiCol_TitleBg] =
      ImVec4(0.13F, 0.16F, 0.19F, 0.95F);
  style.Colors[ImGuiCol_Header] = ImVec4(0.22F, 0.30F, 0.38F, 0.8F);
  style.Colors[ImGuiCol_Button] = ImVec4(0.22F, 0.30F, 0.38F, 1.0F);
  style.Colors[ImGuiCol_FrameBg] = ImVec4(0.25F, 0.31F, 0.37F, 1.0F);
  style.Colors[ImGuiCol_Tab] = ImVec4(0.16F, 0.20F, 0.24F, 1.0F);
  style.Colors[ImGuiCol_TabActive] = ImVec4(0.30F, 0.40F, 0.50F, 1.0F);
  style.Colors[ImGuiCol_TabHovered] = ImVec4(0.34F, 0.46F, 0.58F, 1.0F);
  style.Colors[ImGuiCol_CheckMark] = ImVec4(1.0F, 0.66F, 0.25F, 1.0F);
  style.Colors[ImGuiCol_SliderGrab] = ImVec4(1.0F, 0.66F, 0.25F, 1.0F);
  if (light) useLightColors(style);
}

}  // namespace rocinante
