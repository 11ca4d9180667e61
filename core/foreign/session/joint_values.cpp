#include "core/foreign/session/joint_values.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "core/cell/posed_scene.h"
#include "core/kinematics/kinematics.h"

namespace rocinante {
namespace {

/// The name of one value of a joint.
std::string valueName(const Joint& joint, std::size_t component) {
  constexpr std::array<std::string_view, 3> kPlanar = {".x", ".y", ".yaw"};
  constexpr std::array<std::string_view, 7> kFloating = {".x",  ".y",  ".z", ".qx",
                                                         ".qy", ".qz", ".qw"};
  std::string name = joint.name;
  if (joint.type == JointType::planar) name += kPlanar[component];
  if (joint.type == JointType::floating) name += kFloating[component];
  return name;
}

}  // namespace

ModelValues modelValues(const Model& model) {
  ModelValues values;
  const JointVector zero = zeroJoints(model);
  for (const std::size_t place : model.movableJoints()) {
    const Joint& joint = model.joints[place];
    for (std::size_t i = 0; i < valueCount(joint.type); ++i) {
      values.names.push_back(valueName(joint, i));
      values.own.push_back(zero.values[zero.first_value[place] + i]);
    }
  }
  return values;
}

std::vector<NamedValue> jointValues(const Model* model, const DeviceState& state) {
  std::vector<NamedValue> values;
  if (model != nullptr) {
    const JointVector joints = jointsOf(*model, &state);
    for (std::size_t place = 0; place < model->joints.size(); ++place) {
      const Joint& joint = model->joints[place];
      for (std::size_t i = 0; i < valueCount(joint.type); ++i) {
        values.push_back({valueName(joint, i), joints.values[joints.first_value[place] + i]});
      }
    }
    return values;
  }
  if (state.joints) {
    for (const double value : state.joints->value) {
      values.push_back({std::to_string(values.size() + 1), value});
    }
  }
  for (const auto& [name, item] : state.named_joints) values.push_back({name, item.value});
  return values;
}

std::set<std::string, std::less<>> addSpeedsAndEfforts(const DeviceState& state,
                                                       std::vector<NamedValue>& values) {
  constexpr std::array<std::pair<std::string_view, double NamedValue::*>, 2> kQuantities = {
      {{".velocity", &NamedValue::velocity}, {".effort", &NamedValue::effort}}};
  std::set<std::string, std::less<>> added;
  if (state.signals.empty()) return added;
  std::string name;
  for (NamedValue& value : values) {
    for (const auto& [ending, quantity] : kQuantities) {
      name.assign(value.name).append(ending);
      const auto signal = state.signals.find(SignalNameView({}, name));
      if (signal == state.signals.end()) continue;
      if (signal->second.value.kind != SignalKind::number) continue;
      // Of two values of one name, by position and by name, the first has it.
      if (added.insert(name).second) value.*quantity = signal->second.value.number;
    }
  }
  return added;
}

bool isRemoved(const DeviceState& state) {
  return state.presence && state.presence->value.presence == Presence::removed;
}

bool hasJoints(const DeviceState& state) {
  return state.joints.has_value() || !state.named_joints.empty();
}

}  // namespace rocinante
