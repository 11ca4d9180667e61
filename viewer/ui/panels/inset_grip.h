#pragma once

#include "viewer/ui/model/view_model.h"

namespace rocinante {

/// Shows how the mouse can change the inset that it is over, or that it holds: a frame and the
/// corner that changes its size. Draws nothing while the mouse is elsewhere.
void drawInsetGrip(const ViewModel& model);

}  // namespace rocinante
