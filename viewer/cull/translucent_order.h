#pragma once

#include <vector>

#include "viewer/cull/draw_list.h"
#include "viewer/view/camera.h"

namespace rocinante {

/// From back to front by DrawItem::distance; a box that holds others comes after all that it holds
/// while the eye is outside of it: a glass cabin after the robot in it. What is equal keeps its
/// order. Among more than two thousand items what others hold is not looked for.
void sortFromBackToFront(std::vector<DrawItem>& items, const SceneCatalog& catalog,
                         const Camera& camera);

}  // namespace rocinante
