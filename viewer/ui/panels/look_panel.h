#pragma once

#include "viewer/ui/model/view_model.h"

namespace rocinante {

/// Draws a tab of the left panel.
void drawLookTab(ViewModel& model);

}  // namespace rocinante
