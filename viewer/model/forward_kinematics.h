#pragma once

#include <string>
#include <vector>

#include "viewer/model/link_poses.h"
#include "viewer/model/pose_request.h"

namespace rocinante {

/// Poses of every link of the requested device, or of all present devices, in the order of cell and
/// model. `damage` as in posedState().
Result<std::vector<LinkPose>> forwardKinematics(const Cell& cell, const PoseRequest& request,
                                                StateDamage* damage = nullptr);

/// A table in metres.
std::string forwardKinematicsText(const std::vector<LinkPose>& links);

}  // namespace rocinante
