#pragma once

#include "viewer/ui/model/view_model.h"

namespace rocinante {

/// Moves and turns the selected device by the handles of its gizmo. True while the mouse holds one:
/// it means nothing else then. After Dear ImGui's NewFrame().
bool applyGizmo(ViewModel& model);

}  // namespace rocinante
