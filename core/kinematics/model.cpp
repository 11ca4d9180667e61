#include "core/kinematics/model.h"

#include <array>
#include <span>

namespace rocinante {
namespace {

template <class T>
std::optional<std::size_t> placeOf(std::string_view name, const std::vector<T>& items,
                                   const std::map<std::string, std::size_t, std::less<>>& index) {
  if (index.empty()) {
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (items[i].name == name) return i;
    }
    return std::nullopt;
  }
  const auto found = index.find(name);
  if (found == index.end()) return std::nullopt;
  return found->second;
}

bool isMovable(const Joint& joint) { return joint.type != JointType::fixed && !joint.mimic; }

}  // namespace

std::string_view nameOf(JointType type) {
  switch (type) {
    case JointType::fixed:
      return "fixed";
    case JointType::revolute:
      return "revolute";
    case JointType::continuous:
      return "continuous";
    case JointType::prismatic:
      return "prismatic";
    case JointType::planar:
      return "planar";
    case JointType::floating:
      return "floating";
  }
  return "fixed";
}

std::size_t valueCount(JointType type) {
  switch (type) {
    case JointType::fixed:
      return 0;
    case JointType::revolute:
    case JointType::continuous:
    case JointType::prismatic:
      return 1;
    case JointType::planar:
      return 3;
    case JointType::floating:
      return 7;
  }
  return 0;
}

std::optional<std::size_t> Model::findLink(std::string_view link_name) const {
  return placeOf(link_name, links, link_by_name);
}

std::optional<std::size_t> Model::findJoint(std::string_view joint_name) const {
  return placeOf(joint_name, joints, joint_by_name);
}

std::optional<JointValue> Model::findJointValue(std::string_view value_name) const {
  if (const auto joint = findJoint(value_name)) {
    if (!isMovable(joints[*joint]) || valueCount(joints[*joint].type) != 1) return std::nullopt;
    return JointValue{*joint, 0};
  }
  static constexpr std::array<std::string_view, 3> kPlanar = {"x", "y", "yaw"};
  static constexpr std::array<std::string_view, 7> kFloating = {"x",  "y",  "z", "qx",
                                                                "qy", "qz", "qw"};
  const std::size_t dot = value_name.rfind('.');
  if (dot == std::string_view::npos) return std::nullopt;
  const auto joint = findJoint(value_name.substr(0, dot));
  if (!joint || !isMovable(joints[*joint])) return std::nullopt;
  std::span<const std::string_view> components;
  if (joints[*joint].type == JointType::planar) components = kPlanar;
  if (joints[*joint].type == JointType::floating) components = kFloating;
  for (std::size_t i = 0; i < components.size(); ++i) {
    if (components[i] == value_name.substr(dot + 1)) return JointValue{*joint, i};
  }
  return std::nullopt;
}

std::vector<std::size_t> Model::movableJoints() const {
  std::vector<std::size_t> movable;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (isMovable(joints[i])) movable.push_back(i);
  }
  return movable;
}

std::size_t Model::positionalCount() const {
  std::size_t count = 0;
  for (const Joint& joint : joints) {
    if (isMovable(joint)) count += valueCount(joint.type);
  }
  return count;
}

}  // namespace rocinante
