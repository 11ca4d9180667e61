#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/kinematics/model.h"
#include "core/math/vector.h"

namespace rocinante {

/// Values of all joints, mimic ones included: valueCount(type) per joint, at first_value[joint].
struct JointVector {
  std::vector<double> values;
  std::vector<std::size_t> first_value;
};

/// All joints at zero (a floating joint at identity); mimic joints at their offset.
JointVector zeroJoints(const Model& model);
/// Sets mimic joints from the joints that they mimic, along chains.
void applyMimics(const Model& model, JointVector& joints);
/// The pose of each link in the model's own space: double, exact on every CPU (docs/decisions/003).
std::vector<Mat4> linkPoses(const Model& model, const JointVector& joints);

/// Hash of the joints' names, types, order, links, origins, axes, limits and mimics: kin= of `add`.
/// The first eight bytes of XXH3-128 over the text that docs/cell-format.md, section "The
/// kinematics hash", defines; the same on every CPU.
std::uint64_t kinematicsHash(const Model& model);

}  // namespace rocinante
