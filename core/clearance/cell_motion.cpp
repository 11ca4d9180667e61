#include "core/clearance/cell_motion.h"

#include <algorithm>
#include <cmath>

#include "core/math/transform.h"
#include "core/math/trigonometry.h"

namespace rocinante {
namespace {

/// The shorter way round.
double turnBetween(double from, double to) {
  const double turn = to - from;
  if (!(std::fabs(turn) > kPi)) return turn;
  return turn - 2 * kPi * std::floor(turn / (2 * kPi) + 0.5);
}

/// `to`, or its opposite when that is nearer: both are the same rotation.
Quat nearerOf(const Quat& from, const Quat& to) {
  const double dot = from.w * to.w + from.x * to.x + from.y * to.y + from.z * to.z;
  return dot < 0 ? Quat{-to.w, -to.x, -to.y, -to.z} : to;
}

Quat unitOf(const Quat& quaternion) { return normalized(quaternion).value_or(Quat{1, 0, 0, 0}); }

/// Half of the turn between two unit quaternions.
Quat halfTurn(const Quat& from, const Quat& to) {
  const Quat end = nearerOf(from, to);
  return unitOf({from.w + end.w, from.x + end.x, from.y + end.y, from.z + end.z});
}

double angleBetween(const Quat& from, const Quat& to) {
  const Quat end = nearerOf(from, to);
  const double w = end.w - from.w, x = end.x - from.x, y = end.y - from.y, z = end.z - from.z;
  const double chord = std::sqrt(w * w + x * x + y * y + z * z);
  return 4 * arcSine(std::min(chord / 2, 1.0));
}

Pose halfWayOf(const Pose& a, const Pose& b) {
  return {(a.position + b.position) * 0.5, halfTurn(a.orientation, b.orientation)};
}

Quat turnOf(const double* floating) {
  return unitOf({floating[6], floating[3], floating[4], floating[5]});
}

void halveJoint(JointType type, const double* a, const double* b, double* half) {
  const std::size_t count = valueCount(type);
  for (std::size_t i = 0; i < count; ++i) half[i] = a[i] + (b[i] - a[i]) * 0.5;
  if (type == JointType::continuous) half[0] = a[0] + turnBetween(a[0], b[0]) * 0.5;
  if (type == JointType::planar) half[2] = a[2] + turnBetween(a[2], b[2]) * 0.5;
  if (type != JointType::floating) return;
  if (std::equal(a + 3, a + 7, b + 3)) return;
  const Quat turn = halfTurn(turnOf(a), turnOf(b));
  half[3] = turn.x;
  half[4] = turn.y;
  half[5] = turn.z;
  half[6] = turn.w;
}

void addJoint(JointType type, const double* a, const double* b, LinkTravel& travel) {
  switch (type) {
    case JointType::fixed:
      return;
    case JointType::revolute:
      travel.turn_rad += std::fabs(b[0] - a[0]);
      return;
    case JointType::continuous:
      travel.turn_rad += std::fabs(turnBetween(a[0], b[0]));
      return;
    case JointType::prismatic:
      travel.slide_m += std::fabs(b[0] - a[0]);
      return;
    case JointType::planar:
      travel.slide_m += lengthOf({b[0] - a[0], b[1] - a[1], 0});
      travel.turn_rad += std::fabs(turnBetween(a[2], b[2]));
      return;
    case JointType::floating:
      travel.slide_m += lengthOf({b[0] - a[0], b[1] - a[1], b[2] - a[2]});
      travel.turn_rad += angleBetween(turnOf(a), turnOf(b));
      return;
  }
}

std::optional<LinkId> parentOf(const CellPlacement& placement, LinkId at) {
  const PlacedDevice& device = placement.devices[at.device];
  const auto& joint = device.model->links[at.link].parent_joint;
  if (joint) return LinkId{at.device, device.model->joints[*joint].parent};
  return device.carrier;
}

std::vector<LinkId> chainOf(const CellPlacement& placement, LinkId link) {
  std::vector<LinkId> chain{link};
  while (const auto parent = parentOf(placement, chain.back())) chain.push_back(*parent);
  std::ranges::reverse(chain);
  return chain;
}

/// Carriers first. poseScene() has left no loops.
void putInOrder(CellPlacement& placement) {
  std::vector<bool> is_placed(placement.devices.size(), false);
  std::vector<std::size_t> chain;
  for (std::size_t first = 0; first < placement.devices.size(); ++first) {
    std::optional<std::size_t> at = first;
    while (at && !is_placed[*at]) {
      is_placed[*at] = true;
      chain.push_back(*at);
      const auto& carrier = placement.devices[*at].carrier;
      at = carrier ? std::optional(carrier->device) : std::nullopt;
    }
    for (; !chain.empty(); chain.pop_back()) placement.order.push_back(chain.back());
  }
}

}  // namespace

CellPlacement placementOf(const PosedScene& scene, const SessionState& state) {
  CellPlacement placement;
  for (const PosedDevice& posed : scene.devices) {
    if (posed.ghost) continue;
    placement.device_by_name.emplace(posed.name, placement.devices.size());
    PlacedDevice& device = placement.devices.emplace_back();
    device.name = posed.name;
    device.model = posed.model;
    device.joints = jointsOf(*posed.model, state.findDevice(posed.name));
    device.pose = posed.pose;
    device.pose.orientation = unitOf(posed.pose.orientation);
    device.link_world = posed.link_world;
  }
  for (const PosedDevice& posed : scene.devices) {
    if (posed.ghost || posed.carrier.empty()) continue;
    PlacedDevice& device = placement.devices[placement.device_by_name.find(posed.name)->second];
    const auto carrier = placement.device_by_name.find(posed.carrier);
    if (carrier == placement.device_by_name.end()) {
      device.pose = poseOf(posed.base);  // on a ghost: where that has put it
      continue;
    }
    const Model& below = *placement.devices[carrier->second].model;
    device.carrier =
        LinkId{carrier->second, below.findLink(posed.carrier_link).value_or(below.root)};
  }
  putInOrder(placement);
  return placement;
}

bool sameStructure(const CellPlacement& a, const CellPlacement& b) {
  return std::ranges::equal(a.devices, b.devices, [](const PlacedDevice& x, const PlacedDevice& y) {
    return x.name == y.name && x.model == y.model && x.carrier == y.carrier;
  });
}

void placeMoved(CellPlacement& placement, const CellPlacement& before) {
  std::vector<bool> has_moved(placement.devices.size(), true);
  for (const std::size_t at : placement.order) {
    PlacedDevice& device = placement.devices[at];
    const PlacedDevice& was = before.devices[at];
    has_moved[at] = device.joints.values != was.joints.values || !(device.pose == was.pose) ||
                    (device.carrier && has_moved[device.carrier->device]);
    if (!has_moved[at]) {
      device.link_world = was.link_world;
      continue;
    }
    Mat4 base = matrixOf(device.pose);
    if (device.carrier) {
      base = placement.devices[device.carrier->device].link_world[device.carrier->link] * base;
    }
    device.link_world = linkPoses(*device.model, device.joints);
    for (Mat4& link : device.link_world) link = base * link;
  }
}

CellPlacement halfWay(const CellPlacement& a, const CellPlacement& b) {
  CellPlacement half = a;
  for (std::size_t i = 0; i < half.devices.size(); ++i) {
    PlacedDevice& device = half.devices[i];
    const PlacedDevice& end = b.devices[i];
    if (!(device.pose == end.pose)) device.pose = halfWayOf(device.pose, end.pose);
    for (std::size_t joint = 0; joint < device.model->joints.size(); ++joint) {
      const std::size_t first = device.joints.first_value[joint];
      halveJoint(device.model->joints[joint].type, a.devices[i].joints.values.data() + first,
                 end.joints.values.data() + first, device.joints.values.data() + first);
    }
  }
  placeMoved(half, a);
  return half;
}

CellTravel travelBetween(const CellPlacement& a, const CellPlacement& b) {
  CellTravel travel(a.devices.size());
  for (const std::size_t at : a.order) {
    const PlacedDevice& start = a.devices[at];
    const PlacedDevice& end = b.devices[at];
    const Model& model = *start.model;
    std::vector<LinkTravel>& links = travel[at];
    links.resize(model.links.size());
    const auto place = [&](std::size_t link) { return positionOf(start.link_world[link]); };
    LinkTravel& root = links[model.root];
    if (start.carrier) {
      root = travel[start.carrier->device][start.carrier->link];
      root.reach_m +=
          lengthOf(place(model.root) -
                   positionOf(a.devices[start.carrier->device].link_world[start.carrier->link]));
    }
    root.slide_m += lengthOf(end.pose.position - start.pose.position);
    root.turn_rad += angleBetween(start.pose.orientation, end.pose.orientation);
    for (const std::size_t i : model.update_order) {
      const Joint& joint = model.joints[i];
      LinkTravel& child = links[joint.child];
      child = links[joint.parent];
      child.reach_m += lengthOf(place(joint.child) - place(joint.parent));
      const std::size_t first = start.joints.first_value[i];
      addJoint(joint.type, start.joints.values.data() + first, end.joints.values.data() + first,
               child);
    }
  }
  return travel;
}

std::optional<LinkId> commonCarrier(const CellPlacement& placement, LinkId a, LinkId b) {
  const std::vector<LinkId> up_a = chainOf(placement, a), up_b = chainOf(placement, b);
  std::optional<LinkId> common;
  for (std::size_t i = 0; i < std::min(up_a.size(), up_b.size()) && up_a[i] == up_b[i]; ++i) {
    common = up_a[i];
  }
  return common;
}

}  // namespace rocinante
