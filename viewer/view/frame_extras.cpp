#include "viewer/view/frame_extras.h"

#include <algorithm>
#include <cmath>

namespace rocinante {
namespace {

constexpr double kNearLimitShare = 0.05;
constexpr double kLimitRounding = 1e-6;

}  // namespace

LimitLevel limitLevel(const JointLimits& limits, double value) {
  const double range = limits.upper - limits.lower;
  if (!std::isfinite(value)) return LimitLevel::beyond;
  if (!(range > 0) || !std::isfinite(range)) return LimitLevel::inside;
  const double slack = std::min(value - limits.lower, limits.upper - value) / range;
  if (slack < -kLimitRounding) return LimitLevel::beyond;
  return slack <= kNearLimitShare ? LimitLevel::near : LimitLevel::inside;
}

std::vector<std::vector<LimitLevel>> limitLevels(const PosedScene& scene,
                                                 const SessionState& state) {
  std::vector<std::vector<LimitLevel>> levels(scene.devices.size());
  for (std::size_t d = 0; d < scene.devices.size(); ++d) {
    if (scene.devices[d].model == nullptr) continue;
    const Model& model = *scene.devices[d].model;
    levels[d].assign(model.links.size(), LimitLevel::inside);
    const auto found = state.devices().find(scene.devices[d].name);
    const JointVector joints =
        jointsOf(model, found == state.devices().end() ? nullptr : &found->second);
    for (std::size_t j = 0; j < model.joints.size(); ++j) {
      const Joint& joint = model.joints[j];
      const bool bounded = joint.type == JointType::revolute || joint.type == JointType::prismatic;
      if (!bounded || !joint.limits) continue;
      levels[d][joint.child] = limitLevel(*joint.limits, joints.values[joints.first_value[j]]);
    }
  }
  return levels;
}

}  // namespace rocinante
