#pragma once

#include <span>

#include "core/cell/posed_scene.h"
#include "viewer/cull/draw_list.h"
#include "viewer/view/camera.h"

namespace rocinante {

/// A list whose items may be lifted, with what its numbers mean. Borrowed.
struct LiftedList {
  DrawList* list = nullptr;
  const SceneCatalog* catalog = nullptr;
};

/// Lifts surfaces of different visuals (of a link, of several links or devices) that lie in one
/// plane now: docs/rendering.md, "Surfaces in one plane". What is near enough to be one plane is
/// lifted by more than that, so that the same surface shows while poses tremble. Pure: the same
/// items give the same lifts, whatever order devices have. Gives up looking (and finds nothing
/// more) after some hundred thousand pairs of parts that are near each other.
void liftCoplanarItems(std::span<const LiftedList> lists, const PosedScene& scene,
                       const Camera& camera);

}  // namespace rocinante
