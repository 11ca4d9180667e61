#include "core/kinematics/joint_values.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

#include "core/base/figure_text.h"
#include "core/base/name_hint.h"
#include "core/base/plain_text.h"

namespace rocinante {
namespace {

constexpr std::array<std::string_view, 7> kFloatingValues{".x",  ".y",  ".z", ".qx",
                                                          ".qy", ".qz", ".qw"};
constexpr std::array<std::string_view, 3> kPlanarValues{".x", ".y", ".yaw"};

Error refusedValue(std::string what) { return {ErrorKind::bad_argument, std::move(what), ""}; }

}  // namespace

ValueKind kindOf(const Joint& joint, std::size_t component) {
  switch (joint.type) {
    case JointType::revolute:
    case JointType::continuous:
      return ValueKind::angle;
    case JointType::planar:
      return component == 2 ? ValueKind::angle : ValueKind::length;
    case JointType::floating:
      return component < 3 ? ValueKind::length : ValueKind::turn;
    case JointType::fixed:
    case JointType::prismatic:
      break;
  }
  return ValueKind::length;
}

std::string valueName(const Joint& joint, std::size_t component) {
  if (joint.type == JointType::floating) {
    return joint.name + std::string(kFloatingValues.at(component));
  }
  if (joint.type == JointType::planar) {
    return joint.name + std::string(kPlanarValues.at(component));
  }
  return joint.name;
}

std::vector<std::string> positionalNames(const Model& model) {
  std::vector<std::string> names;
  for (const std::size_t i : model.movableJoints()) {
    const Joint& joint = model.joints[i];
    for (std::size_t component = 0; component < valueCount(joint.type); ++component) {
      names.push_back(valueName(joint, component));
    }
  }
  return names;
}

std::vector<double> positionalValues(const Model& model, const JointVector& joints) {
  std::vector<double> values;
  for (const std::size_t i : model.movableJoints()) {
    const std::size_t first = joints.first_value[i];
    for (std::size_t component = 0; component < valueCount(model.joints[i].type); ++component) {
      values.push_back(joints.values[first + component]);
    }
  }
  return values;
}

Result<JointValue> drivenValue(const Model& model, std::string_view name) {
  if (const auto value = model.findJointValue(name)) return *value;
  const std::string shown = plainText(name);
  if (const auto joint = model.findJoint(name)) {
    const Joint& found = model.joints[*joint];
    if (found.mimic) {
      return refusedValue(fmt::format("joint `{}` mimics `{}` and cannot have its own value", shown,
                                      plainText(model.joints[found.mimic->joint].name)));
    }
    if (found.type == JointType::fixed) {
      return refusedValue(fmt::format("joint `{}` is fixed", shown));
    }
    return refusedValue(fmt::format("joint `{0}` is {1}: its values are `{0}.x` and so on", shown,
                                    nameOf(found.type)));
  }
  const std::vector<std::string> names = positionalNames(model);
  const std::string hint = plainText(didYouMean(name, {names.begin(), names.end()}));
  return refusedValue(
      fmt::format("the model has no joint `{}`{}{}", shown, hint.empty() ? "" : "; ", hint));
}

Status checkValueCount(const Model& model, std::size_t count) {
  if (count == model.positionalCount()) return {};
  const std::vector<std::string> names = positionalNames(model);
  std::string what =
      fmt::format("{}, but the model takes {}", countText(count, "joint value"), names.size());
  if (!names.empty() && names.size() <= 32) {
    what += plainText(fmt::format(": {}", fmt::join(names, " ")));
  }
  return refusedValue(std::move(what));
}

}  // namespace rocinante
