#include "viewer/ui/window/panel_style.h"

#include <imgui.h>

namespace rocinante {

void stylePanels() {
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
}

}  // namespace rocinante
