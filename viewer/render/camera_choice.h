#pragma once

#include <string>

#include "core/model/cell.h"
#include "core/model/posed_scene.h"
#include "viewer/render/camera.h"

namespace rocinante {

/// The camera of that name: the cell's, else a source's `view` in the session. One that rides
/// (`on`, or `in` of a view) has its eye and target in the carrier's space; one that follows has
/// them relative to the carrier's position, with the world's axes. not_found, naming the cameras
/// that there are, for an unknown name, and when the carrier is not there at this moment.
Result<CameraView> chooseCamera(const std::string& name, const Cell& cell,
                                const SessionState& state, const PosedScene& scene);

/// A camera of the cell where the scene puts it.
Result<CameraView> placeCamera(const CellCamera& camera, const PosedScene& scene);

}  // namespace rocinante
