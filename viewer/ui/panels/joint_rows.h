#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/cell/posed_scene.h"

namespace rocinante {

/// One value of a joint, as the panel of a device shows it.
struct JointRow {
  std::string name;
  double value = 0;
  bool said = false;  ///< else it stands at the model's own place
  bool mimics = false;
  bool in_radians = false;
  std::optional<double> lower, upper;  ///< its limits
  /// Where the value lies between them: 0 at the lower, 1 at the upper; may be beyond either.
  std::optional<double> part() const {
    if (!lower || !upper || !(*upper > *lower)) return std::nullopt;
    return (value - *lower) / (*upper - *lower);
  }
  bool outside() const { return (lower && value < *lower) || (upper && value > *upper); }
};

/// The joints of a device that move, in the order of its model, with the values that it is drawn
/// with; of joints with several values each. Only that of `link` when it names one that has one.
/// `state`: null when nothing was said.
std::vector<JointRow> jointRows(const Model& model, const DeviceState* state,
                                const std::string& link);

}  // namespace rocinante
