#pragma once

#include "core/cell/posed_scene.h"
#include "core/report/json_text.h"

namespace rocinante {

/// The place of a camera in the world: a glTF camera looks along -z, y is up in its picture. Empty
/// when eye and target are one, or `up` is the direction of view.
std::optional<Pose> gltfCameraPose(const PosedCamera& camera);

/// A glTF camera of its kind and field of view.
Json gltfCamera(const PosedCamera& camera);

}  // namespace rocinante
