#pragma once

#include "viewer/ui/model/view_model.h"

namespace rocinante {

/// A tab of the panel on the left.
void drawLookTab(ViewModel& model);

}  // namespace rocinante
