#pragma once

#include <limits>
#include <set>
#include <string>
#include <vector>

#include "core/kinematics/model.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// The names of a model's positional values, in their order (a joint with several values has
/// JOINT.x and so on, as in packets), and what each is when nothing states it.
struct ModelValues {
  std::vector<std::string> names;
  std::vector<double> own;
};
ModelValues modelValues(const Model& model);

/// A value of a joint, radians or metres, and what signals state of it: NaN for nothing.
struct NamedValue {
  std::string name;
  double value = 0;
  double velocity = std::numeric_limits<double>::quiet_NaN();
  double effort = std::numeric_limits<double>::quiet_NaN();
};

/// Every joint value of a device. With a model: of all its movable and mimic joints, in its order,
/// as jointsOf() has them. Without (null): those stated, positional ones under their numbers from
/// 1.
std::vector<NamedValue> jointValues(const Model* model, const DeviceState& state);

/// Fills in what the device's signals JOINT.velocity and JOINT.effort say, where they are numbers;
/// returns their names.
std::set<std::string, std::less<>> addSpeedsAndEfforts(const DeviceState& state,
                                                       std::vector<NamedValue>& values);

bool isRemoved(const DeviceState& state);
bool hasJoints(const DeviceState& state);

}  // namespace rocinante
