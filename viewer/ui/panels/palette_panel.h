#pragma once

#include "viewer/ui/commands/viewer_requests.h"
#include "viewer/ui/model/view_model.h"

namespace rocinante {

/// The command palette: a line to type in, and the matching commands with their keys. Runs the one
/// that is chosen; what it cannot do is a fault of the requests.
void drawPalette(ViewModel& model, SteadyTime now, ViewerRequests& requests);

}  // namespace rocinante
