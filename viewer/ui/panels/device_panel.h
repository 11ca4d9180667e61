#pragma once

#include "viewer/ui/model/view_model.h"

namespace rocinante {

/// Values of the selected device's joints, below `top` where there is room; answers where they end.
float drawDevicePanel(ViewModel& model, float top);

}  // namespace rocinante
