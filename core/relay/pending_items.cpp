#include "core/relay/pending_items.h"

#include <algorithm>
#include <cmath>

namespace rocinante {
namespace {

double distance(const Vec3& a, const Vec3& b) {
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

/// The angle between two unit quaternions, radians; q and -q are one rotation.
double angle(const Quat& a, const Quat& b) {
  const double cosine = std::abs(a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w);
  return 2 * std::acos(std::min(cosine, 1.0));
}

const Item<SignalValue>* signalOf(const SessionState& state, const ItemKey& key) {
  return state.findSignal(key.name, {key.second, key.signal});
}

}  // namespace

ItemKey PendingItems::unitOf(const ItemKey& key) {
  return isDeviceValue(key) ? ItemKey{ItemKind::pose, false, 0, key.name, {}} : key;
}

bool PendingItems::isPaced(const ItemKey& key) {
  return isDeviceValue(key) || key.kind == ItemKind::signal;
}

bool PendingItems::isLargeChange(const SessionState& state, const ItemKey& key,
                                 const Unit& unit) const {
  if (!options_.min_change.any() || !isDeviceValue(key)) return true;
  const MinChange& least = options_.min_change;
  const DeviceState& device = *state.findDevice(key.name);
  if (key.kind == ItemKind::pose) {
    const PoseValue& value = device.pose->value;
    return !unit.pose || unit.pose->carrier != value.carrier ||
           distance(unit.pose->pose.position, value.pose.position) >= least.position ||
           angle(unit.pose->pose.orientation, value.pose.orientation) >= least.turn;
  }
  if (key.kind == ItemKind::joint) {
    const auto sent = unit.joints.find(key.second);
    const double value = device.named_joints.find(key.second)->second.value;
    return sent == unit.joints.end() || std::abs(sent->second - value) >= least.joint;
  }
  const std::vector<double>& values = device.joints->value;
  if (values.size() != unit.positions.size()) return true;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::abs(values[i] - unit.positions[i]) >= least.joint) return true;
  }
  return false;
}

/// Who owns a signal and its unit are no small change, however near the numbers are.
bool PendingItems::isHeld(const SessionState& state, const ItemKey& key, const Unit& unit) const {
  if (!unit.number || !unit.items.empty()) return false;
  const Item<SignalValue>& item = *signalOf(state, key);
  const SentNumber& sent = *unit.number;
  return std::abs(item.value.number - sent.value) < sent.least && item.value.unit == sent.unit &&
         item.owner == sent.owner;
}

void PendingItems::remember(const SessionState& state, const ItemKey& key, Unit& unit) const {
  if (key.kind == ItemKind::signal) {
    unit.number.reset();
    const Item<SignalValue>* const item = signalOf(state, key);
    if (item == nullptr || item->value.kind != SignalKind::number) return;
    const double least = options_.min_change.ofSignal(signalText(key));
    if (least > 0) unit.number = {item->value.number, least, item->value.unit, item->owner};
    return;
  }
  const DeviceState& device = *state.findDevice(key.name);
  switch (key.kind) {
    case ItemKind::positions:
      unit.positions = device.joints->value;
      unit.joints.clear();
      break;
    case ItemKind::joint:
      unit.joints[key.second] = device.named_joints.find(key.second)->second.value;
      break;
    default:
      unit.pose = device.pose->value;
  }
}

void PendingItems::written(const SessionState& state, ItemKey&& key, LogTime now) {
  const auto found = units_.try_emplace(unitOf(key)).first;
  Unit& unit = found->second;
  if (key.kind == ItemKind::signal && isHeld(state, key, unit)) {
    ++held_;
    return;
  }
  unit.matters = unit.matters || isLargeChange(state, key, unit);
  const bool is_paced = isPaced(key);
  if (!unit.items.insert(std::move(key)).second) ++conflated_;
  if (unit.place == Unit::Place::ready) return;
  LogTime due = now;
  if (is_paced && unit.sent && options_.interval)
    due = std::max(due, *unit.sent + *options_.interval);
  if (!unit.matters) due = std::max(due, now + kRest);
  if (unit.place == Unit::Place::waiting) {
    if (due == unit.due) return;
    waiting_.erase({unit.due, found});
  }
  unit.due = due;
  if (due <= now) {
    unit.place = Unit::Place::ready;
    ready_.push_back(found);
  } else {
    unit.place = Unit::Place::waiting;
    waiting_.emplace(due, found);
  }
}

void PendingItems::markStated(const SessionState& state, const ItemKey& key) {
  // The next change counts from what was said here, also of what came before this output was there.
  const bool counts_from_here = options_.min_change.any() && isPaced(key);
  const auto found =
      counts_from_here ? units_.try_emplace(unitOf(key)).first : units_.find(unitOf(key));
  if (found == units_.end()) return;
  Unit& unit = found->second;
  unit.items.erase(key);
  unit.matters = unit.matters && !unit.items.empty();
  if (counts_from_here) remember(state, key, unit);
  const bool is_idle = unit.place == Unit::Place::nowhere && key.kind == ItemKind::signal;
  if (is_idle && !unit.number && !unit.sent) units_.erase(found);
}

void PendingItems::cancelled(const ItemKey& key) {
  const auto found = units_.find(unitOf(key));
  if (found == units_.end()) return;
  found->second.number.reset();
  if (found->second.place == Unit::Place::nowhere) units_.erase(found);
}

void PendingItems::sweep(const SessionState& state) {
  std::erase_if(units_, [&](const auto& each) {
    const auto& [key, unit] = each;
    const bool is_there =
        isDeviceValue(key) ? state.findDevice(key.name) != nullptr : ownerOf(state, key) != nullptr;
    return unit.place == Unit::Place::nowhere && !is_there;
  });
  sweeps_at_ = std::max<std::size_t>(1024, 2 * units_.size());
}

void PendingItems::removed(std::string_view device) {
  // What became ready or waits finds its signal gone when its turn comes.
  ItemKey signal{ItemKind::signal, false, 0, std::string(device), {}};
  auto of_device = units_.lower_bound(signal);
  while (of_device != units_.end() && of_device->first.kind == ItemKind::signal &&
         of_device->first.name == device) {
    const bool is_idle = of_device->second.place == Unit::Place::nowhere;
    of_device = is_idle ? units_.erase(of_device) : std::next(of_device);
  }
  const ItemKey values{ItemKind::pose, false, 0, std::string(device), {}};
  const auto found = units_.find(values);
  if (found == units_.end()) return;
  if (found->second.place == Unit::Place::nowhere) {
    units_.erase(found);
  } else {
    found->second.items.clear();
    found->second.sent.reset();
  }
}

void PendingItems::advance(LogTime now) {
  while (!waiting_.empty() && waiting_.begin()->first <= now) {
    const auto unit = waiting_.begin()->second;
    waiting_.erase(waiting_.begin());
    unit->second.place = Unit::Place::ready;
    ready_.push_back(unit);
  }
}

std::vector<ItemKey> PendingItems::takeReady(const SessionState& state, LogTime now) {
  const auto front = ready_.front();
  ready_.pop_front();
  Unit& unit = front->second;
  std::vector<ItemKey> items;
  for (const ItemKey& key : unit.items) {
    if (ownerOf(state, key) == nullptr) continue;
    if (options_.min_change.any() && isPaced(key)) remember(state, key, unit);
    items.push_back(key);
  }
  unit.items.clear();
  unit.place = Unit::Place::nowhere;
  unit.matters = false;
  if (!items.empty()) unit.sent = now;
  // Only a device whose next send depends on this one is remembered.
  const ItemKey& key = front->first;
  const bool is_remembered = (options_.interval || options_.min_change.any()) &&
                             (isDeviceValue(key) ? state.findDevice(key.name) != nullptr
                                                 : isPaced(key) && ownerOf(state, key) != nullptr);
  if (!is_remembered) units_.erase(front);
  if (units_.size() >= sweeps_at_) sweep(state);
  return items;
}

}  // namespace rocinante
