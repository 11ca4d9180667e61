#include "viewer/ui/panels/joint_rows.h"

#include <array>
#include <string_view>

namespace rocinante {
namespace {

constexpr std::array<std::string_view, 7> kFloatingValues{".x",  ".y",  ".z", ".qx",
                                                          ".qy", ".qz", ".qw"};
constexpr std::array<std::string_view, 3> kPlanarValues{".x", ".y", ".yaw"};

std::string valueName(const Joint& joint, std::size_t component) {
  if (joint.type == JointType::floating) {
    return joint.name + std::string(kFloatingValues.at(component));
  }
  if (joint.type == JointType::planar) {
    return joint.name + std::string(kPlanarValues.at(component));
  }
  return joint.name;
}

bool inRadians(const Joint& joint, std::size_t component) {
  return joint.type == JointType::revolute || joint.type == JointType::continuous ||
         (joint.type == JointType::planar && component == 2);
}

}  // namespace

std::vector<JointRow> jointRows(const Model& model, const DeviceState* state,
                                const std::string& link) {
  const JointVector joints = jointsOf(model, state);
  const bool positional =
      state != nullptr && state->joints && state->joints->value.size() == model.positionalCount();
  const auto wanted_link = link.empty() ? std::nullopt : model.findLink(link);
  std::vector<JointRow> rows;
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const Joint& joint = model.joints[i];
    if (wanted_link && joint.child != *wanted_link) continue;
    for (std::size_t component = 0; component < valueCount(joint.type); ++component) {
      JointRow row;
      row.name = valueName(joint, component);
      row.value = joints.values[joints.first_value[i] + component];
      row.mimics = joint.mimic.has_value();
      row.said =
          row.mimics || positional || (state != nullptr && state->named_joints.contains(row.name));
      row.in_radians = inRadians(joint, component);
      if (joint.limits && valueCount(joint.type) == 1 && joint.type != JointType::continuous) {
        row.lower = joint.limits->lower;
        row.upper = joint.limits->upper;
      }
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

}  // namespace rocinante
