#pragma once

#include <string>
#include <vector>

#include "viewer/ui/model/view_model.h"
#include "viewer/view/view_layout.h"

namespace rocinante {

/// What the window shows now, and where.
ViewLayout layoutOf(const ViewModel& model);
/// Returns what of it this window does not have, a sentence each. A built-in camera is only wanted
/// then (ViewerState::built_in_wanted): its view needs the renderer.
std::vector<std::string> applyLayout(const ViewLayout& layout, ViewModel& model);

}  // namespace rocinante
