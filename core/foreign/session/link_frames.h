#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/cell/posed_scene.h"

namespace rocinante {

/// The space that everything is in.
inline constexpr std::string_view kWorldFrame = "world";

/// A space in its parent.
struct FramePose {
  std::string parent;
  std::string child;
  Pose pose;
  bool operator==(const FramePose&) const = default;
};

/// The name of a path's space: "world" for none, DEVICE, or DEVICE/LINK.
std::string frameName(std::string_view device, std::string_view link = {});

/// The spaces of a device: DEVICE in the world, its root link in DEVICE, and every other link,
/// DEVICE/LINK, in its parent's. Composed they are PosedDevice::link_world, but for rounding.
std::vector<FramePose> deviceFrames(const PosedDevice& device);

}  // namespace rocinante
