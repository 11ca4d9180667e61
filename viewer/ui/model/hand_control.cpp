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

Status HandControl::set(const PosedDevice& device, const std::string& value_name, double value) {
  if (device.model == nullptr) return withoutModel(device.name);
  if (use_ == HandUse::none) return notDrawn();
  if (Status set = joints_.set(device.name, *device.model, value_name, value); !set) return set;
  if (drive_) drive_->set(device.name, value_name, value);
  changed_ = true;
  return {};
}

Status HandControl::setAll(const PosedDevice& device, std::span<const double> values) {
  if (device.model == nullptr) return withoutModel(device.name);
  if (use_ == HandUse::none) return notDrawn();
  if (Status set = joints_.setAll(device.name, *device.model, values); !set) return set;
  if (drive_) {
    for (const std::string& name : positionalNames(*device.model)) {
      drive_->set(device.name, name, *joints_.find(device.name, name));
    }
  }
  changed_ = true;
  return {};
}

void HandControl::reset(const std::string& device, const std::string& value_name) {
  joints_.reset(device, value_name);
  if (drive_) drive_->release(device, value_name);
  changed_ = true;
}

void HandControl::reset(const std::string& device) {
  joints_.reset(device);
  if (drive_) drive_->release(device);
  changed_ = true;
}

void HandControl::resetAll() {
  joints_.clear();
  if (drive_) drive_->releaseAll();
  changed_ = true;
}

void HandControl::setSituation(bool live, bool playing) {
  if (playing) stopDriving();
  const HandUse before = std::exchange(use_, !live    ? HandUse::drawn
                                             : drive_ ? HandUse::sent
                                                      : HandUse::none);
  // What was drawn over the past was never meant to be sent, nor the other way round.
  const bool drawn_stays = use_ == before || (use_ == HandUse::drawn && before != HandUse::sent);
  const bool ends = playing || !drawn_stays;
  if (!ends || joints_.empty()) return;
  joints_.clear();
  changed_ = true;
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
  drive(std::move(*opened));
  last_endpoint_ = endpoint;
  last_source_ = source;
  return {};
}

void HandControl::drive(HandDrive opened) {
  drive_.emplace(std::move(opened));
  changed_ = entered_ = true;
}

Status HandControl::driveAgain() {
  if (!last_endpoint_.empty()) return drive(last_endpoint_, last_source_);
  return Error{ErrorKind::bad_argument, "say where to: `drive EP`, as drive 127.0.0.1:19960", {}};
}

void HandControl::stopDriving() {
  if (!drive_) return;
  drive_.reset();
  entered_ = false;
  changed_ = true;
}

void HandControl::sendDue(SteadyTime now, WallTime wall) {
  if (drive_) drive_->tick(now, wall);
}

}  // namespace rocinante
