#pragma once

#include <vector>

#include "viewer/render/fitted_cameras.h"
#include "viewer/render/renderer.h"
#include "viewer/ui/model/view_model.h"

namespace rocinante {

/// Points of the shown moment that a fitted view contains: of the visible devices that move, else
/// of all that is visible. Empty when nothing is.
std::vector<Vec3> cornersToFit(const ViewModel& model, const Renderer& renderer,
                               const FittedCameras& fitted);

/// The same for the selected object; for everything when nothing is selected.
std::vector<Vec3> selectedCorners(const ViewModel& model, const Renderer& renderer,
                                  const FittedCameras& fitted);

}  // namespace rocinante
