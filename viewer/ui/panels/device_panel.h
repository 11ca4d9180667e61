#pragma once

#include "core/base/time.h"
#include "viewer/ui/model/view_model.h"

namespace rocinante {

/// Draws the inspected device (ViewModel::inspected) with its joints below `top` if there is room;
/// returns their bottom.
float drawDevicePanel(ViewModel& model, float top, SteadyTime now);

}  // namespace rocinante
