#pragma once

#include <string>
#include <vector>

#include "core/cell/posed_scene.h"
#include "viewer/model/pose_request.h"

namespace rocinante {

/// A link where it stands in the world.
struct LinkPose {
  std::string link;  ///< "LINK", or "DEVICE/LINK" where several devices are told
  Pose pose;
};

/// Of every link of the device that is asked for, or of all devices that are there; in the order of
/// cell and model. `damage` as posedState() has it.
Result<std::vector<LinkPose>> forwardKinematics(const Cell& cell, const PoseRequest& request,
                                                StateDamage* damage = nullptr);

/// A table in metres for people; for scripts an object of links with `format` before them, which a
/// link of that very name takes the place of; so it is with `warnings`, where there are any.
std::string forwardKinematicsText(const std::vector<LinkPose>& links);
std::string forwardKinematicsJson(const std::vector<LinkPose>& links,
                                  const std::vector<std::string>& warnings = {});

}  // namespace rocinante
