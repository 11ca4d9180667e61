#pragma once

#include "viewer/ui/model/view_model.h"

namespace rocinante {

/// Draws where the device or link is, in the world or in the chosen reference, and lets choose it.
void drawPose(ViewModel& model, const Selection& shown);

/// Draws how near the device is to the reference, or to the nearest other one, and the switch for
/// it.
void drawNearest(ViewModel& model, const Selection& shown);

/// Draws the switch for the packet behind what is shown, and, if it is on, the packet. Needs a log.
/// Above `bottom`.
void drawPacketBehind(ViewModel& model, const PosedDevice& device, const Selection& shown,
                      float bottom);

}  // namespace rocinante
