#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "core/base/time.h"
#include "viewer/ui/model/view_model.h"
#include "viewer/ui/panels/panels.h"

namespace rocinante {

/// A line or two that the window says over the picture.
struct PictureLine {
  const char* name;  ///< of its little window
  std::string what;
  std::string hint{};    ///< below it, dimmed; may be empty
  ImVec4 color;          ///< of `what`
  bool central = false;  ///< nothing is shown that it would hide
};

/// What the window has to say now, the most important first.
std::vector<PictureLine> pictureLines(const ViewModel& model, const ViewerStatus& status,
                                      SteadyTime now);

/// Draws them over the picture, which has that part of the window; where it is too narrow, over
/// what is beside it, too. `said` becomes their texts.
void drawPictureLines(const std::vector<PictureLine>& lines, const PanelRectangle& picture,
                      std::vector<std::string>& said);

}  // namespace rocinante
