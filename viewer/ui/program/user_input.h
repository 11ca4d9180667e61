#pragma once

#include <optional>

#include "core/base/time.h"
#include "viewer/ui/commands/viewer_requests.h"
#include "viewer/ui/model/view_model.h"
#include "viewer/ui/program/pointer_pace.h"
#include "viewer/ui/window/window.h"

namespace rocinante {

/// Applies mouse and keyboard of this frame, as far as Dear ImGui has not used them itself. Returns
/// a click on the picture.
std::optional<PictureClick> applyUserInput(ViewModel& model, SteadyTime now, int width_px,
                                           int height_px, ViewerRequests& requests, Window& window);

/// Where the mouse points in the picture; empty: at a panel, elsewhere, or it drags something.
std::optional<PicturePlace> mouseOnPicture();

}  // namespace rocinante
