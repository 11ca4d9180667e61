#pragma once

#include <string>

#include "core/model/posed_scene.h"
#include "core/result.h"
#include "viewer/render/camera.h"

namespace rocinante {

/// The view of a camera that the scene has placed.
CameraView viewOf(const PosedCamera& camera);

/// The camera of that name (a session's `view` outranks the cell's camera). not_found, naming those
/// that there are.
Result<CameraView> chooseCamera(const std::string& name, const PosedScene& scene);

}  // namespace rocinante
