#pragma once

#include <string>
#include <vector>

#include "core/cell/posed_scene.h"
#include "viewer/model/pose_request.h"

namespace rocinante {

/// A link's pose in world space.
struct LinkPose {
  std::string link;  ///< "LINK", or "DEVICE/LINK" with several devices
  Pose pose;
};

/// Poses of every link of the requested device, or of all present devices, in the order of cell and
/// model. `damage` as in posedState().
Result<std::vector<LinkPose>> forwardKinematics(const Cell& cell, const PoseRequest& request,
                                                StateDamage* damage = nullptr);

/// A table in metres, and a JSON object of links after `format` and `warnings` (if any). A link
/// named `format` or `warnings` replaces that entry.
std::string forwardKinematicsText(const std::vector<LinkPose>& links);
std::string forwardKinematicsJson(const std::vector<LinkPose>& links,
                                  const std::vector<std::string>& warnings = {});

}  // namespace rocinante
