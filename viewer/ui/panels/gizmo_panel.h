#pragma once

#include "viewer/ui/model/view_model.h"

namespace rocinante {

/// Draws the handles that move and turn the selected device, over the picture's part of the window,
/// and where the device is while one is held. Of the window, not of the picture.
void drawGizmo(ViewModel& model);

}  // namespace rocinante
