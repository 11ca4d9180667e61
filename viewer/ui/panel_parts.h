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
/// `bottom`: how far down the window its panel may reach, in pixels.
void drawSceneTab(ViewModel& model, float bottom, ViewerWishes& wishes);
void drawLookTab(ViewModel& model);
void drawSourcesTab(ViewModel& model, SteadyTime now);
void drawEventsTab(ViewModel& model, SteadyTime now, ViewerWishes& wishes);

/// How much is drawn and what a frame costs, stage by stage.
void drawFrameTab(const ViewerStatus& status, ViewerWishes& wishes);

/// What is said of the session in the top right corner, all or the most needed; answers where it
/// ends.
float drawFigures(const ViewModel& model, const ViewerStatus& status, SteadyTime now, bool brief);
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
