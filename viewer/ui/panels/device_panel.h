#pragma once

#include "viewer/ui/model/view_model.h"

namespace rocinante {

/// Draws the selected device's joint values below `top` if there is room; returns their bottom.
float drawDevicePanel(ViewModel& model, float top);

}  // namespace rocinante
