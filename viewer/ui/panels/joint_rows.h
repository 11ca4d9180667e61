#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/cell/posed_scene.h"

namespace rocinante {

/// One joint value for the panel of a device.
struct JointRow {
  std::string name;
  double value = 0;
  bool said = false;  ///< false: at the model's default
  bool mimics = false;
  bool in_radians = false;
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

}  // namespace rocinante
