#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/cell/posed_scene.h"
#include "core/kinematics/kinematics.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// One link of one device of a placement.
struct LinkId {
  std::size_t device = 0, link = 0;  ///< into CellPlacement::devices, into the model's links
  auto operator<=>(const LinkId&) const = default;
};

/// A device with what moves it, and where that puts its links.
struct PlacedDevice {
  std::string name;
  const Model* model = nullptr;  ///< of the cell
  JointVector joints;
  Pose pose;                      ///< in the carrier's link, or in the world
  std::optional<LinkId> carrier;  ///< empty: the world
  std::vector<Mat4> link_world;   ///< of each link
};

/// Where every device of a cell is at a moment, ghosts left out; a plain value.
struct CellPlacement {
  std::vector<PlacedDevice> devices;
  std::vector<std::size_t> order;  ///< of devices: carriers before what they carry
  std::map<std::string, std::size_t, std::less<>> device_by_name;
};

/// The placement that poseScene() draws.
CellPlacement placementOf(const PosedScene& scene, const SessionState& state);
/// Whether both have the same devices, models and carriers: then there is a motion between them.
bool sameStructure(const CellPlacement& a, const CellPlacement& b);
/// Computes `link_world` from joints and poses; of devices that are where they are in `before`, of
/// the same structure, takes it from there.
void placeMoved(CellPlacement& placement, const CellPlacement& before);

/// The placement half way between two of the same structure. Every joint goes evenly from one value
/// to the other, a continuous joint and the yaw of a planar one the shorter way; poses and floating
/// joints go straight and turn evenly about one axis.
CellPlacement halfWay(const CellPlacement& a, const CellPlacement& b);

/// Bounds of how much the links of one device move between two placements, summed over all joints
/// and poses from the world to the link.
struct LinkTravel {
  double turn_rad = 0, slide_m = 0;
  double reach_m = 0;  ///< length of the line through the origins of all links on the way
};
using CellTravel = std::vector<std::vector<LinkTravel>>;  ///< by device and link
CellTravel travelBetween(const CellPlacement& a, const CellPlacement& b);

/// The last link that both hang from; empty when that is the world.
std::optional<LinkId> commonCarrier(const CellPlacement& placement, LinkId a, LinkId b);

}  // namespace rocinante
