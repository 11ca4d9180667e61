#pragma once

#include <imgui.h>

#include "viewer/ui/window/panel_colors.h"

namespace rocinante {

/// Sets colours and spacing of all panels; call once, after making the ImGui context.
void stylePanels(bool light);

/// A colour of the table, of the theme that stylePanels() set last, for draw lists. `opacity`: of
/// what it has there, 0 to 1.
ImU32 panelColor(PanelColor color, float opacity = 1);
/// The same for Dear ImGui's own texts.
ImVec4 panelInk(PanelColor color);
/// A colour of 0xRRGGBBAA.
ImU32 drawnColor(std::uint32_t rgba);

}  // namespace rocinante
