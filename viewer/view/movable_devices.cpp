#include "viewer/view/movable_devices.h"

#include <algorithm>
#include <cmath>

namespace rocinante {
namespace {

/// Tolerance for a sender that repeats the cell's pose in fewer digits: metres, or parts of a unit
/// vector.
constexpr double kStandsStill = 1e-3;

bool sameBase(const Mat4& a, const Mat4& b) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) {
      if (!(std::abs(a[column][row] - b[column][row]) <= kStandsStill)) return false;
    }
  }
  return true;
}

bool hasMovingJoint(const PosedDevice& device) {
  return device.model != nullptr && std::ranges::any_of(device.model->joints, [](const Joint& one) {
           return one.type != JointType::fixed;
         });
}

}  // namespace

void addMovableDevices(const Cell& cell, const PosedScene& at_rest, const PosedScene& scene,
                       DeviceNames& names) {
  for (const CellSource& source : cell.sources) {
    names.insert(source.devices.begin(), source.devices.end());
  }
  for (const PosedDevice& device : scene.devices) {
    const PosedDevice* rest = at_rest.findDevice(device.name);
    if (hasMovingJoint(device) || rest == nullptr || !sameBase(rest->base, device.base)) {
      names.insert(device.name);
    }
  }
  // Devices carried by a movable one move too, along chains.
  for (bool more = true; more;) {
    more = false;
    for (const CellDevice& device : cell.devices) {
      if (!device.on_device.empty() && names.contains(device.on_device)) {
        more = names.insert(device.name).second || more;
      }
    }
  }
}

}  // namespace rocinante
