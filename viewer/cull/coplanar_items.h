#pragma once

#include <span>

#include "core/cell/posed_scene.h"
#include "viewer/cull/draw_list.h"
#include "viewer/view/camera.h"

namespace rocinante {

/// A list whose items may be lifted, with its catalog. Borrowed.
struct LiftedList {
  DrawList* list = nullptr;
  const SceneCatalog* catalog = nullptr;
};

/// Lifts surfaces of different visuals (of a link, of several links or devices) that currently lie
/// in one plane: docs/rendering.md, "Surfaces in one plane". The lift is larger than the distance
/// limit, so that the same surface shows while poses vibrate. Pure: the same items give the same
/// lifts in any order of devices. Stops after some hundred thousand pairs of neighbouring parts.
void liftCoplanarItems(std::span<const LiftedList> lists, const PosedScene& scene,
                       const Camera& camera);

}  // namespace rocinante
