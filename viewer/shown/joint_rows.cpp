#include "viewer/shown/joint_rows.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string_view>

namespace rocinante {
namespace {

/// The SOURCE that said a value, if one did. `positional`: all values were said in order.
std::string ownerOf(const DeviceState* state, const std::string& name, bool positional) {
  if (state == nullptr) return {};
  const auto named = state->named_joints.find(name);
  if (named != state->named_joints.end()) return named->second.owner;
  return positional ? state->joints->owner : std::string();
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
      row.kind = kindOf(joint, component);
      row.mimics = joint.mimic.has_value();
      row.continuous = joint.type == JointType::continuous;
      if (!row.mimics) row.owner = ownerOf(state, row.name, positional);
      row.is_stated =
          row.mimics || positional || (state != nullptr && state->named_joints.contains(row.name));
      if (joint.limits && valueCount(joint.type) == 1 && joint.type != JointType::continuous) {
        row.lower = joint.limits->lower;
        row.upper = joint.limits->upper;
      }
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

SliderRange sliderRange(const JointRow& row) {
  if (row.lower && row.upper && *row.upper > *row.lower) return {*row.lower, *row.upper};
  switch (row.kind) {
    case ValueKind::angle:
      return {-std::numbers::pi, std::numbers::pi};
    case ValueKind::turn:
      return {-1, 1};
    case ValueKind::length:
      break;
  }
  constexpr double kFarthestShown = 1e9;
  double reach = 1;
  while (reach < std::abs(row.value) && reach < kFarthestShown) reach *= 10;
  return {-reach, reach};
}

double SliderRange::partOf(const JointRow& row, double value) const {
  if (row.continuous) value = std::remainder(value, 2 * std::numbers::pi);
  const double part = (value - lower) / (upper - lower);
  return std::isnan(part) ? 0.5 : std::clamp(part, 0.0, 1.0);
}

std::string moversOf(const DeviceState& state) {
  std::set<std::string> owners;
  if (state.pose) owners.insert(state.pose->owner);
  if (state.joints) owners.insert(state.joints->owner);
  for (const auto& [name, item] : state.named_joints) owners.insert(item.owner);
  std::string text;
  for (const std::string& owner : owners) text += (text.empty() ? "" : ", ") + owner;
  return text;
}

}  // namespace rocinante
