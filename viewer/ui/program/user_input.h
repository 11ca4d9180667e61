#pragma once

#include <optional>
#include <span>

#include "core/base/time.h"
#include "viewer/ui/commands/viewer_requests.h"
#include "viewer/ui/model/view_model.h"
#include "viewer/ui/program/pointer_pace.h"
#include "viewer/ui/window/input_queue.h"

namespace rocinante {

/// Applies mouse and keyboard of this frame, as far as Dear ImGui has not used them itself;
/// `presses` are its keys. Returns a click on the picture.
std::optional<PictureClick> applyUserInput(ViewModel& model, SteadyTime now,
                                           std::span<const KeyPress> presses,
                                           ViewerRequests& requests);

/// Who takes the keys of the coming frame.
KeyTaker keyTaker(const ViewModel& model);

/// Where the mouse points in the picture; empty: at a panel, elsewhere, or it drags something.
std::optional<PicturePlace> mouseOnPicture(const ViewModel& model);

}  // namespace rocinante
