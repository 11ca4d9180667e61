#pragma once

#include <imgui.h>

#include "viewer/ui/interface_context.h"
#include "viewer/ui/panel_layout.h"
#include "viewer/ui/panels.h"

/// The panels that drawPanels() is made of. Only viewer/ui includes this.
namespace rocinante {

/// A length of the interface in pixels of this screen: all of ours are given for scale 1.
inline float px(float length) { return length * ImGui::GetFontSize() / kFontPixels; }

constexpr ImGuiWindowFlags kPanelFlags =
    ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
    ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing;

// Tabs of the panel on the left.
void drawSceneTab(ViewModel& model, ViewerWishes& wishes);
void drawLookTab(ViewModel& model);
void drawSourcesTab(ViewModel& model, SteadyTime now);
void drawEventsTab(ViewModel& model, SteadyTime now, ViewerWishes& wishes);

/// The figures in the top right corner, all or the most needed; answers where they end.
float drawFigures(const ViewModel& model, const ViewerStatus& status, SteadyTime now, bool brief,
                  ViewerWishes& wishes);
/// Values of the selected device's joints, below `top` where there is room; answers where they end.
float drawDevicePanel(ViewModel& model, float top);
/// The time line at the bottom, with its events.
void drawTimeBar(ViewModel& model, Transport& transport, SteadyTime now);
void drawHelp(ViewModel& model);

/// Whether the word is somewhere in the text, whatever the case of its letters.
bool containsWord(std::string_view text, std::string_view word);

/// A tool tip for what was drawn last.
inline void explain(const char* text) {
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text);
}

}  // namespace rocinante
