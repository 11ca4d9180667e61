#pragma once

#include <string>
#include <vector>

#include "core/cell/posed_scene.h"
#include "core/report/json_name.h"
#include "recorder/gltf/gltf_meshes.h"

namespace rocinante {

/// The place of a camera in the world: a glTF camera looks along -z, y is up in its picture. Empty
/// when eye and target are one, or `up` is the direction of view.
std::optional<Pose> gltfCameraPose(const PosedCamera& camera);

/// A glTF camera of its kind and field of view.
Json gltfCamera(const PosedCamera& camera);

/// The node that turns our space, z up, into glTF's, y up. Its children are in ours.
Json gltfWorld();

/// Nodes of what a link shows, in the link's space: "DEVICE/LINK#1" and on.
std::vector<Json> gltfVisuals(GltfMeshes& meshes, const PosedDevice& device, std::size_t link);

/// A link alone as a .glb, in its own space, coloured as `device` is. Empty when it shows nothing.
/// unsupported beyond 2 GiB. `gaps` receives what is missing.
Result<Bytes> gltfOfLink(const PosedDevice& device, std::size_t link,
                         std::vector<std::string>& gaps);

}  // namespace rocinante
