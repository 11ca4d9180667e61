#pragma once

#include "core/base/time.h"
#include "viewer/ui/model/view_model.h"

namespace rocinante {

/// Draws the joint values of a device, or of `link` alone if it has a joint: each with a slider
/// that moves it (HandControl), and its value, which a double click lets type. Above `bottom`, the
/// lowest pixel for the panel. Scrolls when there are more.
void drawJointSliders(ViewModel& model, const PosedDevice& device, const std::string& link,
                      float bottom, SteadyTime now);

}  // namespace rocinante
