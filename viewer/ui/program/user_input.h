#pragma once

#include <optional>
#include <string_view>

#include "core/base/time.h"
#include "viewer/ui/model/view_model.h"
#include "viewer/ui/panels/panels.h"
#include "viewer/ui/window/window.h"

namespace rocinante {

/// A mouse click on the picture, in pixels from its top left.
struct PictureClick {
  double x = 0, y = 0;
  bool twice = false;  ///< turn about the point there
};

/// Applies one key of docs/programs/view.md. Keys for the program set `requests`.
void applyKey(ViewModel& model, const KeyPress& press, SteadyTime now, ViewerRequests& requests);

/// Parses a key of a script: "E", "shift+H", "space", "left", "F1", ","; empty when invalid.
std::optional<KeyPress> parseKey(std::string_view text);

/// Applies mouse and keyboard of this frame, as far as Dear ImGui has not used them itself. Returns
/// a click on the picture.
std::optional<PictureClick> applyUserInput(ViewModel& model, SteadyTime now, int width_px,
                                           int height_px, ViewerRequests& requests, Window& window);

}  // namespace rocinante
