#pragma once

#include "viewer/ui/view_model.h"

namespace rocinante {

void drawHelp(ViewModel& model);

}  // namespace rocinante
