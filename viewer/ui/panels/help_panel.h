#pragma once

#include "viewer/ui/model/view_model.h"

namespace rocinante {

void drawHelp(ViewModel& model);

}  // namespace rocinante
