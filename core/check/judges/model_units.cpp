#include "core/check/judges/model_units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "core/base/count_text.h"
#include "core/check/judges/tally.h"

namespace rocinante {
namespace {

/// A limit in radians is hardly a whole number as large as this.
constexpr double kLeastDegrees = 30;

bool isWhole(double value) { return std::abs(value - std::round(value)) < 1e-9; }

bool looksLikeDegrees(const JointLimits& limits) {
  return std::max(std::abs(limits.lower), std::abs(limits.upper)) >= kLeastDegrees &&
         isWhole(limits.lower) && isWhole(limits.upper);
}

}  // namespace

void judgeModelUnits(const Cell& cell, Findings& findings) {
  // A model may have several names, such as its file's and its own: the shortest is shown.
  std::map<const Model*, std::string> names;
  for (const auto& [name, model] : cell.models) {
    if (model == nullptr) continue;
    const auto [place, is_new] = names.try_emplace(model.get(), name);
    if (!is_new && name.size() < place->second.size()) place->second = name;
  }
  for (const auto& [name, model] : cell.models) {
    if (model == nullptr || names.at(model.get()) != name) continue;
    std::size_t turning = 0, degrees = 0, still = 0;
    std::string first, first_still;
    for (const Joint& joint : model->joints) {
      const bool turns = joint.type == JointType::revolute;
      if (!joint.limits) continue;
      const bool moves =
          turns || joint.type == JointType::prismatic || joint.type == JointType::continuous;
      if (moves && joint.limits->velocity && *joint.limits->velocity == 0) {
        if (still++ == 0) first_still = joint.name;
      }
      if (!turns) continue;
      ++turning;
      if (!looksLikeDegrees(*joint.limits)) continue;
      if (degrees++ == 0) {
        first = fmt::format("{} [{:.6g}, {:.6g}]", joint.name, joint.limits->lower,
                            joint.limits->upper);
      }
    }
    if (degrees > 0 && 2 * degrees >= turning) {
      findings.push_back(makeFinding(
          "model.degrees", name,
          fmt::format("the limits of {} of model {} look like degrees, such as {}: no value in "
                      "radians exceeds them, so joint.limit and joint.degrees find nothing",
                      countText(degrees, "joint"), name, first)));
      findings.back().hint = "URDF and SDF take radians: multiply by pi / 180";
    }
    if (still > 0) {
      findings.push_back(makeFinding(
          "model.zero-velocity", name,
          fmt::format("the velocity limit of {} of model {} is 0, such as {}: it is taken as none, "
                      "so joint.velocity finds nothing",
                      countText(still, "joint"), name, first_still)));
      findings.back().hint = "write the largest speed, in rad/s or m/s";
    }
  }
}

}  // namespace rocinante
