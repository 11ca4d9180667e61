#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "core/base/time.h"
#include "viewer/ui/model/view_model.h"
#include "viewer/ui/panels/panels.h"
#include "viewer/ui/window/panel_colors.h"

namespace rocinante {

/// A line or two that the window says over the picture.
struct PictureLine {
  std::string key;  ///< as NoticeKey has it
  std::string what;
  std::string hint{};                   ///< below it, dimmed; may be empty
  PanelColor color = PanelColor::text;  ///< of `what`
  bool stays = false;                   ///< as NoticeKey has it
  bool central = false;                 ///< nothing is shown that it would hide
};

/// What the window has to say now, the most important first; after the panels, as it has what
/// folded figures would say.
std::vector<PictureLine> pictureLines(const ViewModel& model, const ViewerStatus& status,
                                      SteadyTime now);

/// Where they stand, in pixels.
struct NoticeRoom {
  PanelRectangle free;       ///< the part of the picture that nothing covers
  bool over_panels = false;  ///< there is none: it is a part of what lies over the picture
};

/// Draws them as a stack at the top of the room: a mode that is on first, then the newest; a few,
/// and how many more there are. A click dismisses one. Texts that are not dismissed become
/// model.viewer.panels.lines, whether there is room for them or not.
void drawPictureLines(ViewModel& model, const std::vector<PictureLine>& lines,
                      const NoticeRoom& room);

}  // namespace rocinante
