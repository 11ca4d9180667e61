#pragma once

#include <optional>
#include <string_view>

#include "core/base/time.h"
#include "viewer/ui/model/view_model.h"
#include "viewer/ui/panels/panels.h"
#include "viewer/ui/window/window.h"

namespace rocinante {

/// Where the mouse was clicked on the picture, in pixels from its top left.
struct PictureClick {
  double x = 0, y = 0;
  bool twice = false;  ///< turn about what is there
};

/// One key, as docs/programs/view.md has them. What is not the model's is wished for.
void applyKey(ViewModel& model, const KeyPress& press, SteadyTime now, ViewerRequests& requests);

/// The key that a script names: "E", "shift+H", "space", "left", "F1", ","; empty for no key.
std::optional<KeyPress> parseKey(std::string_view text);

/// Mouse and keyboard of this frame, as Dear ImGui has them and has not used them itself. Answers a
/// click on the picture.
std::optional<PictureClick> applyUserInput(ViewModel& model, SteadyTime now, int width_px,
                                           int height_px, ViewerRequests& requests, Window& window);

}  // namespace rocinante
