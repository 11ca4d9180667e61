#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/cell/posed_scene.h"
#include "core/kinematics/joint_values.h"

namespace rocinante {

/// One joint value for the panel of a device.
struct JointRow {
  std::string name;  ///< of the value: Model::findJointValue, unless it mimics
  double value = 0;
  ValueKind kind = ValueKind::length;
  bool is_stated = false;  ///< false: at the model's default
  bool mimics = false;
  bool continuous = false;             ///< turns without end
  std::string owner;                   ///< the SOURCE that said it; empty: none did
  std::optional<double> lower, upper;  ///< its limits
  /// Position between the limits: 0 at the lower, 1 at the upper; may be outside.
  std::optional<double> part() const {
    if (!lower || !upper || !(*upper > *lower)) return std::nullopt;
    return (value - *lower) / (*upper - *lower);
  }
  bool outside() const { return (lower && value < *lower) || (upper && value > *upper); }
};

/// The movable joints of a device in model order with their drawn values, one row per value. Only
/// the joint of `link` if it has one. `state`: null when nothing was received.
std::vector<JointRow> jointRows(const Model& model, const DeviceState* state,
                                const std::string& link);

/// What a slider for a value covers: its limits; without any, a turn to either side, a quaternion's
/// part from -1 to 1, or a length of 1, 10, 100 ... metres to either side that includes the value.
struct SliderRange {
  double lower = -1, upper = 1;
  /// From 0 to 1. A joint that turns without end is shown within its turn; NaN in the middle.
  double partOf(const JointRow& row, double value) const;
  double valueAt(double part) const { return lower + (upper - lower) * part; }
};
SliderRange sliderRange(const JointRow& row);

/// The SOURCEs that said where a device and its joints are, joined by commas; empty when none did.
std::string moversOf(const DeviceState& state);

}  // namespace rocinante
