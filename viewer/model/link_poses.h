#pragma once

#include <string>
#include <vector>

#include "core/cell/posed_scene.h"

namespace rocinante {

/// A link's pose in world space.
struct LinkPose {
  std::string link;  ///< "LINK", or "DEVICE/LINK" with several devices
  Pose pose;
};

/// Poses of every link of `device` (empty: of all present devices) in a state, in the order of cell
/// and model. Pure, with the same bits on every processor and in a browser.
std::vector<LinkPose> linkPoses(const Cell& cell, const SessionState& state,
                                const std::string& device = {});

/// A JSON object of links after `format` and `warnings` (if any). A link named `format` or
/// `warnings` replaces that entry.
std::string forwardKinematicsJson(const std::vector<LinkPose>& links,
                                  const std::vector<std::string>& warnings = {});

}  // namespace rocinante
