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

/// The part of the window between the panels at its sides.
struct FreeMiddle {
  float left = 0, right = 0;
};

/// Draws them between the panels at the sides; where a narrow window leaves no room there, below
/// `right_end`, where the panels at the right end, or over the panels' lower ends, above `bottom`.
/// `said` becomes their texts.
void drawPictureLines(const std::vector<PictureLine>& lines, const FreeMiddle& middle,
                      float right_end, float bottom, std::vector<std::string>& said);

}  // namespace rocinante
