#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/kinematics/kinematics.h"

namespace rocinante {

enum class ValueKind : std::uint8_t {
  angle,   ///< radians
  length,  ///< metres
  turn,    ///< a part of a floating joint's quaternion
};

/// What a value of a joint measures; `component` is below valueCount of its type.
ValueKind kindOf(const Joint& joint, std::size_t component);
/// The value's name in `joint NAME=q` and `order`: the joint's, or NAME.x and so on.
std::string valueName(const Joint& joint, std::size_t component);

/// The names of the values of a full positional `joints`, in order.
std::vector<std::string> positionalNames(const Model& model);
/// Their values.
std::vector<double> positionalValues(const Model& model, const JointVector& joints);

/// The value of that name (Model::findJointValue); bad_argument with the reason when a sender has
/// none to give: it is unknown, fixed, mimics another, or has several.
Result<JointValue> drivenValue(const Model& model, std::string_view name);
/// bad_argument with the expected names when a full positional `joints` has another count.
Status checkValueCount(const Model& model, std::size_t count);

}  // namespace rocinante
