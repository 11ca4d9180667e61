#pragma once

#include <vector>

#include "viewer/cull/draw_list.h"
#include "viewer/view/camera.h"

namespace rocinante {

/// Sorts from back to front by DrawItem::distance; a box that contains others comes after them
/// while the eye is outside: a glass cabin after the robot in it. Stable. Containment is not tested
/// among more than two thousand items.
void sortFromBackToFront(std::vector<DrawItem>& items, const SceneCatalog& catalog,
                         const Camera& camera);

}  // namespace rocinante
