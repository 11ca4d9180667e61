/// Helpers of the panels. Only panels include this.
#pragma once

#include <imgui.h>

#include <span>
#include <string>
#include <string_view>

#include "viewer/shown/short_names.h"
#include "viewer/ui/model/line_start.h"
#include "viewer/ui/panels/panel_layout.h"
#include "viewer/ui/window/interface_context.h"
#include "viewer/ui/window/panel_style.h"

namespace rocinante {

/// Draws a line to type in, as wide as there is room. `takes_keyboard`: in a moment; what is typed
/// until then is in `start`, and is taken by the line. True when Enter was pressed.
bool drawTypedLine(const char* id, const char* hint, std::span<char> text, bool takes_keyboard,
                   LineStart& start);

/// Converts an interface length (for scale 1) to pixels of this screen.
inline float px(float length) { return length * ImGui::GetFontSize() / kFontPixels; }

constexpr ImGuiWindowFlags kPanelFlags =
    ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
    ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing;

/// Whether the text contains the word, ignoring case.
bool containsWord(std::string_view text, std::string_view word);

/// As wide as Dear ImGui draws it.
inline float drawnWidth(std::string_view text) {
  return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
}
/// Draws a text in the rest of the line, or in `room` pixels: where it has none, its middle is cut
/// out, and hovering shows the whole.
void drawCut(const std::string& text, PanelColor color = PanelColor::text, float room = 0);

/// The text in lines for the rest of this line, or for `room` pixels. A word that is wider is to be
/// broken by ImGui's own wrapping.
std::string linesOf(std::string_view text, float room = 0);

/// How far a list must be scrolled to show a row whole, from `scroll`: not at all when it is seen,
/// else so that it stands in the middle. `top` and `height` of the row from the list's beginning,
/// `room`: the list's height. Pixels. Pure.
float scrollToShow(float scroll, float top, float height, float room);

/// Whether a list that grows shows its newest row: not when the user has scrolled up from `most`,
/// the end of its way before it grew. Pure.
inline bool followsNewest(float scroll, float most) { return scroll >= most - 1; }

/// Whether a key of Dear ImGui went down or repeats.
inline bool keyPressed(ImGuiKey key) {
#if IMGUI_VERSION_NUM >= 18700
  return ImGui::IsKeyPressed(key);
#else
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key));
#endif
}

/// A tool tip at the mouse, in lines that end within the window.
void showTip(const char* text);
/// Adds a tool tip to the last drawn item.
inline void explain(const char* text) {
  if (ImGui::IsItemHovered()) showTip(text);
}
/// Tells the whole of what the last item shows less of.
inline void explainCut(const std::string& shown, const std::string& whole) {
  if (shown != whole) explain(whole.c_str());
}

}  // namespace rocinante
