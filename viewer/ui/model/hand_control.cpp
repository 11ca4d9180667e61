#include "viewer/ui/model/hand_control.h"

#include <utility>

#include "core/kinematics/joint_values.h"

namespace rocinante {
namespace {

Error notDrawn() {
  return {ErrorKind::bad_argument,
          "in a live session packets move the joints: drive the device to move it by hand",
          {}};
}

Error withoutModel(const std::string& device) {
  return {ErrorKind::bad_argument, "the model of the device is not known", device};
}

}  // namespace

void HandControl::take(HandJoints joints) {
  joints_ = std::move(joints);
  changed_ = true;
}

Status HandControl::set(const PosedDevice& device, const DeviceState* received,
                        const std::string& value_name, double value) {
  if (device.model == nullptr) return withoutModel(device.name);
  if (use_ == HandUse::none) return notDrawn();
  HandJoints wanted = joints_;
  if (use_ == HandUse::sent && !joints_.devices().contains(device.name)) {
    // The other joints stay where they are, whatever another source says about them later.
    const auto values = positionalValues(*device.model, jointsOf(*device.model, received));
    if (Status taken = wanted.setAll(device.name, *device.model, values); !taken) return taken;
  }
  if (Status set = wanted.set(device.name, *device.model, value_name, value); !set) return set;
  joints_ = std::move(wanted);
  changed_ = true;
  return {};
}

Status HandControl::setAll(const PosedDevice& device, std::span<const double> values) {
  if (device.model == nullptr) return withoutModel(device.name);
  if (use_ == HandUse::none) return notDrawn();
  if (Status set = joints_.setAll(device.name, *device.model, values); !set) return set;
  changed_ = true;
  return {};
}

void HandControl::reset(const PosedDevice& device, const std::string& value_name) {
  changed_ = true;
  if (use_ != HandUse::sent || device.model == nullptr) {
    return joints_.reset(device.name, value_name);
  }
  if (!joints_.find(device.name, value_name)) return;
  const auto value = device.model->findJointValue(value_name);
  if (!value) return;
  const JointVector zero = zeroJoints(*device.model);
  const double home = zero.values[zero.first_value[value->joint] + value->component];
  static_cast<void>(joints_.set(device.name, *device.model, value_name, home));
}

void HandControl::reset(const PosedDevice& device) {
  changed_ = true;
  if (use_ != HandUse::sent || device.model == nullptr) return joints_.reset(device.name);
  if (!joints_.devices().contains(device.name)) return;
  const auto home = positionalValues(*device.model, zeroJoints(*device.model));
  static_cast<void>(joints_.setAll(device.name, *device.model, home));
}

void HandControl::resetAll() {
  joints_.clear();
  changed_ = true;
}

void HandControl::setSituation(bool live, bool playing) {
  const HandUse before = use_;
  use_ = !live ? HandUse::drawn : drive_ ? HandUse::sent : HandUse::none;
  const bool ends = playing || (use_ == HandUse::none && before != HandUse::none);
  if (ends && !joints_.empty()) resetAll();
}

const SessionState* HandControl::over(const SessionState& received, LogTime moment) {
  if (use_ != HandUse::drawn || joints_.empty()) {
    what_if_.reset();
    return &received;
  }
  what_if_ = std::make_unique<SessionState>(withHand(received, moment, joints_));
  return what_if_.get();
}

Status HandControl::drive(const std::string& endpoint, const std::string& source) {
  const auto to = Endpoint::parse(endpoint);
  if (!to) return to.error();
  DriveSettings settings;
  settings.source = source;
  auto opened = HandDrive::open(*to, settings);
  if (!opened) return opened.error();
  drive_.emplace(std::move(*opened));
  changed_ = true;
  return {};
}

void HandControl::stopDriving() {
  drive_.reset();
  changed_ = true;
}

void HandControl::sendDue(const PosedScene& scene, const SessionState& shown, SteadyTime now,
                          WallTime wall) {
  if (!drive_) return;
  const auto say = [&](const std::string& name) {
    const PosedDevice* const device = scene.findDevice(name);
    if (device == nullptr || device->model == nullptr) return;
    JointVector joints = jointsOf(*device->model, shown.findDevice(name));
    const auto set = joints_.devices().find(name);
    if (set != joints_.devices().end()) {
      for (const auto& [value_name, value] : set->second) {
        const auto at = device->model->findJointValue(value_name);
        if (at) joints.values[joints.first_value[at->joint] + at->component] = value;
      }
    } else if (use_ == HandUse::sent) {
      return;  // packets have it now
    }
    drive_->set(name, positionalValues(*device->model, joints));
  };
  for (const auto& [name, values] : joints_.devices()) say(name);
  // Those given back to the log or the model are still driven, to where that puts them.
  for (const std::string& name : drive_->devices()) {
    if (!joints_.devices().contains(name)) say(name);
  }
  drive_->tick(now, wall);
}

}  // namespace rocinante
