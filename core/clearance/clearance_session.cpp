#include "core/clearance/clearance_session.h"

#include "core/math/transform.h"

namespace rocinante {

ClearanceSession::ClearanceSession(const Cell& cell) : cell_(cell), judge_(cell) {}

void ClearanceSession::take(LogTime time, const Packet& packet, const SessionState& state) {
  if (cell_.clearances.empty()) return;
  if (!judge_.hasBegun()) return restart(time, state);
  if (has_moved_ && time - first_ > kGathered) settle();
  // A restatement may also take back what it does not repeat.
  if (packet.header.restated || packet.header.reset) return gatherAll(time, state);
  changes_.clear();
  for (const Statement& statement : packet.statements) {
    if (!movesDevice(statement.kind)) continue;
    const auto found = next_.device_by_name.find(statement.name);
    const DeviceState* const device_state = state.findDevice(statement.name);
    const bool is_there = found != next_.device_by_name.end() && device_state != nullptr;
    if (!keepsStructure(statement.kind, device_state,
                        is_there ? &next_.devices[found->second] : nullptr)) {
      return gatherAll(time, state);
    }
    if (is_there) changes_.push_back(found->second);
  }
  for (const std::size_t device : changes_) {
    if (touched_[device]) settle();
  }
  for (const std::size_t at : changes_) {
    PlacedDevice& device = next_.devices[at];
    const DeviceState* const device_state = state.findDevice(device.name);
    device.joints = jointsOf(*device.model, device_state);
    if (device_state->pose) device.pose = device_state->pose->value.pose;
    touch(at, time);
  }
}

/// Whether the device stays where it hangs: otherwise the whole cell is posed anew.
bool ClearanceSession::keepsStructure(StatementKind kind, const DeviceState* device_state,
                                      const PlacedDevice* device) const {
  if (kind == StatementKind::add || kind == StatementKind::remove) return false;
  if (device == nullptr || kind != StatementKind::pose) return true;
  if (!device_state->pose) return false;
  const Path& carrier = device_state->pose->value.carrier;
  if (carrier.is_layer || carrier.first.empty()) return !device->carrier;
  const auto found = next_.device_by_name.find(carrier.first);
  if (found == next_.device_by_name.end() || !device->carrier) return false;
  const Model& below = *next_.devices[found->second].model;
  const auto link =
      carrier.second.empty() ? std::optional(below.root) : below.findLink(carrier.second);
  return link && *device->carrier == LinkId{found->second, *link};
}

void ClearanceSession::gatherAll(LogTime time, const SessionState& state) {
  const PosedScene scene = poseScene(cell_, state);
  CellPlacement placement = placementOf(scene, state);
  if (!sameStructure(placement, next_)) return restart(time, state);
  const auto differs = [&](std::size_t i) {
    return placement.devices[i].joints.values != next_.devices[i].joints.values ||
           !(placement.devices[i].pose == next_.devices[i].pose);
  };
  changes_.clear();
  for (std::size_t i = 0; i < placement.devices.size(); ++i) {
    if (differs(i)) changes_.push_back(i);
  }
  for (const std::size_t device : changes_) {
    if (touched_[device]) settle();
  }
  for (const std::size_t device : changes_) {
    next_.devices[device] = std::move(placement.devices[device]);
    touch(device, time);
  }
}

void ClearanceSession::touch(std::size_t device, LogTime time) {
  if (!has_moved_) first_ = time;
  has_moved_ = true;
  touched_[device] = true;
  last_ = time;
}

void ClearanceSession::settle() {
  if (!has_moved_) return;
  has_moved_ = false;
  touched_.assign(touched_.size(), false);
  judge_.step(last_, next_);
}

void ClearanceSession::restart(LogTime time, const SessionState& state) {
  settle();
  const PosedScene scene = poseScene(cell_, state);
  next_ = placementOf(scene, state);
  touched_.assign(next_.devices.size(), false);
  judge_.begin(time, scene, next_);
}

}  // namespace rocinante
