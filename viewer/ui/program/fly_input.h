#pragma once

#include "core/base/time.h"
#include "viewer/ui/commands/viewer_requests.h"
#include "viewer/ui/model/view_model.h"
#include "viewer/ui/window/input_queue.h"

namespace rocinante {

/// Moves the view by the keys W, A, S, D, Q and E while the right mouse button is held on the
/// picture: the mouse then turns the view, and its wheel changes the speed. True in the frames of a
/// flight, whose mouse means nothing else. After Dear ImGui's NewFrame().
bool applyFlying(ViewModel& model, SteadyTime now, int height_px, ViewerRequests& requests);

/// Whether the press of this key is a part of flying rather than a command, during a flight.
bool isFlyKey(const KeyPress& press);

}  // namespace rocinante
