#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/cell/posed_scene.h"
#include "viewer/view/camera.h"

namespace rocinante {

/// The view of a posed camera.
CameraView viewOf(const PosedCamera& camera);

/// The camera of that name (a session's `view` overrides the cell's camera). not_found, listing the
/// known ones.
Result<CameraView> chooseCamera(const std::string& name, const PosedScene& scene);

/// Whether a camera of that name can be looked through, or is built in: "fit", "map", or
/// "fit:DEVICE" of a device that the cell has or that is in the scene.
bool hasCamera(const std::string& name, const Cell& cell, const PosedScene& scene);

/// A viewpoint in numbers, in place of a camera's name: "@EX,EY,EZ/TX,TY,TZ", eye and target in
/// metres, then, each behind a slash, "fov=DEG", "ortho=HEIGHT_M" and "up=X,Y,Z". bad_argument.
Result<CameraView> parseViewpoint(std::string_view text);
/// The text that parses to exactly this view.
std::string viewpointText(const CameraView& view);

}  // namespace rocinante
