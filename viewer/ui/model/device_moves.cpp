#include "viewer/ui/model/device_moves.h"

#include <algorithm>
#include <array>

namespace rocinante {
namespace {

/// Of the packet that is folded over what is shown; no source of a session.
constexpr std::string_view kMover = "rocinante-view-moves";

const Pose* findIn(const DeviceMoves::Poses& poses, std::string_view device) {
  const auto found = poses.find(device);
  return found == poses.end() ? nullptr : &found->second;
}

}  // namespace

const Pose* DeviceMoves::find(std::string_view device) const { return findIn(poses_, device); }

const Pose* DeviceMoves::findSaved(std::string_view device) const { return findIn(saved_, device); }

std::optional<Pose> DeviceMoves::poseNow(const std::string& device) const {
  const Pose* const pose = find(device);
  return pose == nullptr ? std::nullopt : std::optional(*pose);
}

void DeviceMoves::set(const std::string& device, const std::optional<Pose>& pose) {
  if (pose) {
    poses_.insert_or_assign(device, *pose);
  } else {
    poses_.erase(device);
  }
  changed_ = true;
}

void DeviceMoves::put(const std::string& device, const std::optional<Pose>& pose) {
  settle();
  hold(device, pose);
  settle();
}

void DeviceMoves::hold(const std::string& device, const std::optional<Pose>& pose) {
  if (held_ && held_->device != device) settle();
  if (!held_) held_ = Step{device, poseNow(device), {}};
  if (poseNow(device) != pose) set(device, pose);
}

void DeviceMoves::settle() {
  if (!held_) return;
  Step step = std::move(*held_);
  held_.reset();
  step.after = poseNow(step.device);
  if (step.after == step.before) return;
  done_.push_back(std::move(step));
  if (done_.size() > kMostSteps) done_.erase(done_.begin());
  undone_.clear();
}

std::optional<std::string> DeviceMoves::apply(std::vector<Step>& from, std::vector<Step>& to,
                                              bool back) {
  if (from.empty()) return std::nullopt;
  Step step = std::move(from.back());
  from.pop_back();
  set(step.device, back ? step.before : step.after);
  std::string device = step.device;
  to.push_back(std::move(step));
  return device;
}

std::optional<std::string> DeviceMoves::undo() {
  settle();
  return apply(done_, undone_, true);
}

std::optional<std::string> DeviceMoves::redo() {
  settle();
  return apply(undone_, done_, false);
}

void DeviceMoves::saved(const std::string& device, const Pose& there) {
  // Back where it was when the cell was opened, there is nothing to remember.
  if (find(device) == nullptr) {
    saved_.erase(device);
  } else {
    saved_.insert_or_assign(device, there);
  }
}

std::vector<std::string> DeviceMoves::unsaved() const {
  std::vector<std::string> names;
  for (const auto& [device, pose] : poses_) {
    const Pose* const kept = findSaved(device);
    if (kept == nullptr || *kept != pose) names.push_back(device);
  }
  for (const auto& [device, pose] : saved_) {
    if (!poses_.contains(device)) names.push_back(device);
  }
  std::ranges::sort(names);
  return names;
}

const SessionState* DeviceMoves::over(const SessionState& shown, const Cell& cell, LogTime moment) {
  std::vector<std::array<double, 7>> numbers;
  std::vector<Statement> statements;
  // The statements are views into these.
  numbers.reserve(poses_.size());
  for (const auto& [name, pose] : poses_) {
    const CellDevice* const device = cell.findDevice(name);
    const DeviceState* const device_state = shown.findDevice(name);
    if (device == nullptr || (device_state != nullptr && device_state->pose)) continue;
    const Quat& turn = pose.orientation;
    numbers.push_back(
        {pose.position.x, pose.position.y, pose.position.z, turn.x, turn.y, turn.z, turn.w});
    Statement& statement = statements.emplace_back();
    statement.kind = StatementKind::pose;
    statement.name = name;
    statement.numbers = numbers.back();
    statement.carrier.first = device->on_device;
    statement.carrier.second = device->on_link;
  }
  if (statements.empty()) return &shown;
  Packet packet;
  packet.header.source = kMover;
  packet.statements = statements;
  auto moved = std::make_unique<SessionState>(shown);
  moved->apply(moment, packet);
  // `shown` may be the one before.
  state_ = std::move(moved);
  return state_.get();
}

}  // namespace rocinante
