#pragma once

#include <imgui.h>

#include <string>

#include "viewer/ui/model/view_model.h"
#include "viewer/ui/window/panel_colors.h"

namespace rocinante {

/// Draws a line with the SOURCEs that move the device, or that none does.
void drawMovers(const ViewModel& model, const DeviceState* received);

/// Draws the row of buttons over a device's sliders: reset, copy as `--joints`, units, drive, and
/// the switch for the packet behind what is shown.
void drawDeviceTools(ViewModel& model, const PosedDevice& device);

/// Draws a red frame round the window while it drives.
void drawDriveFrame(const ViewModel& model);

/// What is said over the picture while joints are moved by hand; empty: nothing.
struct HandBanner {
  PanelColor color = PanelColor::by_hand;
  std::string what, hint;
};
HandBanner handBanner(const ViewModel& model);

}  // namespace rocinante
