#pragma once

#include <imgui.h>

#include "viewer/ui/panels.h"

/// The panels that drawPanels() is made of. Only viewer/ui includes this.
namespace rocinante {

constexpr float kPanelMargin = 10;
constexpr float kScenePanelWidth = 292;
constexpr float kDevicePanelWidth = 300;
constexpr ImGuiWindowFlags kPanelFlags =
    ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
    ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing;

// Tabs of the panel on the left.
void drawSceneTab(ViewModel& model, ViewerWishes& wishes);
void drawLookTab(ViewModel& model);
void drawEventsTab(ViewModel& model, SteadyTime now, ViewerWishes& wishes);

/// The figures in the top right corner; answers where they end.
float drawFigures(const ViewModel& model, const ViewerStatus& status, ViewerWishes& wishes);
/// Values of the selected device's joints, below `top`; answers where they end.
float drawDevicePanel(ViewModel& model, float top);
/// The time line at the bottom, with its events.
void drawTimeBar(ViewModel& model, Transport& transport, SteadyTime now);
void drawHelp(ViewModel& model);

/// A tool tip for what was drawn last.
inline void explain(const char* text) {
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text);
}

}  // namespace rocinante
