#include <algorithm>

#include "core/packet/joint_order.h"
#include "core/packet/packet_limits.h"
#include "core/packet/state_folder.h"

namespace rocinante {
namespace {

Path pathOf(const PathView& view) {
  return {view.is_layer, std::string(view.first), std::string(view.second)};
}

Vec3 vectorOf(std::span<const double> numbers, std::size_t first) {
  return {numbers[first], numbers[first + 1], numbers[first + 2]};
}

}  // namespace

void StateFolder::foldStatement(const Statement& statement) {
  switch (statement.kind) {
    case StatementKind::joints:
      return foldJoints(statement);
    case StatementKind::order:
      return foldOrder(statement);
    case StatementKind::joint:
      return foldJoint(statement);
    case StatementKind::pose:
      return foldPose(statement);
    case StatementKind::add:
    case StatementKind::remove:
      return foldPresence(statement);
    case StatementKind::show:
    case StatementKind::hide:
      return foldVisibility(statement);
    case StatementKind::color:
      return foldColor(statement);
    case StatementKind::line:
    case StatementKind::points:
    case StatementKind::label:
      return foldDrawing(statement);
    case StatementKind::erase:
      return foldErase(statement);
    case StatementKind::event:
      return foldEvent(statement);
    case StatementKind::view:
      return foldView(statement);
    case StatementKind::signal:
    case StatementKind::signals:
      return foldSignals(statement);
    case StatementKind::seen:
      return foldSeen(statement);
  }
}

bool StateFolder::makeRoom(std::uint64_t before, std::uint64_t after) {
  if (after > before && state_.weight_ - before + after > limits::kStateBytes) {
    count(PacketFault::too_many);
    return false;
  }
  state_.weight_ += after - before;
  return true;
}

void StateFolder::count(PacketFault fault) { ++counts_->faults[static_cast<std::size_t>(fault)]; }

StateFolder::Device* StateFolder::deviceFor(std::string_view name) {
  if (Device* const* const known = state_.device_cache_.find(name)) return *known;
  auto found = state_.devices_.find(name);
  if (found == state_.devices_.end()) {
    if (state_.devices_.size() == limits::kDevices) {
      count(PacketFault::too_many);
      return nullptr;
    }
    if (!makeRoom(0, kDeviceWeight + name.size())) return nullptr;
    found = state_.devices_.emplace(std::string(name), DeviceState()).first;
  }
  state_.device_cache_.remember(found->first, &*found, state_.devices_.size());
  return &*found;
}

template <class T>
void StateFolder::writeItem(Device& device, std::optional<Item<T>>& slot, T value) {
  Item<T> item = itemOf(std::move(value));
  if (makeRoom(weightOf(slot), weightOf(item))) {
    slot = std::move(item);
    device.second.last_write = time_;
  } else {
    forgetIfEmpty(device.first);
  }
}

void StateFolder::foldJoints(const Statement& statement) {
  Device* const device = deviceFor(statement.name);
  if (device == nullptr) return;
  DeviceState& device_state = device->second;
  const JointsMeaning meaning = meaningOfJoints(&device_state, header_.source, statement);
  if (meaning.fault) {
    count(*meaning.fault);
    return forgetIfEmpty(statement.name);
  }
  if (meaning.names != nullptr) {
    return foldJointsByName(*device, *meaning.names, statement.numbers);
  }
  const std::uint64_t weight =
      kItemWeight + header_.source.size() + statement.numbers.size() * sizeof(double);
  if (makeRoom(weightOf(device_state.joints), weight)) {
    if (!device_state.joints) device_state.joints.emplace();
    device_state.joints->value.assign(statement.numbers.begin(), statement.numbers.end());
    claim(*device_state.joints);
    clearNamedJoints(device_state);
    device_state.last_write = time_;
  } else {
    forgetIfEmpty(statement.name);
  }
}

void StateFolder::foldJointsByName(Device& device, std::span<const std::string> names,
                                   std::span<const double> values) {
  // Joint names are usually numbered: neighbours in the statement are neighbours in the map too.
  NamedJoints& joints = device.second.named_joints;
  auto next = joints.begin();
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (next == joints.end() || !sameName(next->first, names[i])) next = joints.find(names[i]);
    if (!setNamedJoint(device.second, next, names[i], values[i])) break;
    if (next != joints.end()) ++next;
  }
  device.second.last_write = time_;
}

bool StateFolder::setNamedJoint(DeviceState& device, NamedJoints::iterator found,
                                std::string_view name, double value) {
  const std::uint64_t weight = kItemWeight + header_.source.size();
  if (found != device.named_joints.end()) {
    if (!makeRoom(weightOf(found->second), weight)) return false;
    found->second.value = value;
    claim(found->second);
    return true;
  }
  if (device.named_joints.size() == limits::kJointValues) {
    count(PacketFault::too_many);
    return false;
  }
  if (!makeRoom(0, name.size() + weight)) return false;
  device.named_joints.emplace(std::string(name), itemOf(value));
  return true;
}

void StateFolder::foldOrder(const Statement& statement) {
  Device* const device = deviceFor(statement.name);
  if (device == nullptr) return;
  DeviceState& device_state = device->second;
  if (statement.names.empty()) {
    eraseOrder(device_state, header_.source);
    device_state.last_write = time_;
  } else {
    auto order = itemOf(std::vector<std::string>(statement.names.begin(), statement.names.end()));
    const auto found = device_state.orders.find(header_.source);
    const std::uint64_t before =
        found == device_state.orders.end() ? 0 : weightOf(found->first) + weightOf(found->second);
    if (makeRoom(before, header_.source.size() + weightOf(order))) {
      device_state.orders.insert_or_assign(std::string(header_.source), std::move(order));
      device_state.last_write = time_;
    }
  }
  forgetIfEmpty(statement.name);
}

void StateFolder::foldJoint(const Statement& statement) {
  Device* const device = deviceFor(statement.name);
  if (device == nullptr) return;
  for (std::size_t i = 0; i < statement.names.size(); ++i) {
    const std::string_view name = statement.names[i];
    const auto found = device->second.named_joints.find(name);
    if (!setNamedJoint(device->second, found, name, statement.numbers[i])) break;
    device->second.last_write = time_;
  }
  forgetIfEmpty(statement.name);
}

void StateFolder::foldPose(const Statement& statement) {
  Device* const device = deviceFor(statement.name);
  if (device == nullptr) return;
  const std::span<const double> q = statement.numbers;
  PoseValue value;
  value.pose.position = vectorOf(q, 0);
  value.pose.orientation = Quat(q[6], q[3], q[4], q[5]);
  value.carrier = pathOf(statement.carrier);
  writeItem(*device, device->second.pose, std::move(value));
}

void StateFolder::foldPresence(const Statement& statement) {
  Device* const device = deviceFor(statement.name);
  if (device == nullptr) return;
  PresenceValue value;
  if (statement.kind == StatementKind::remove) {
    forgetItemsOf(device->second);
    forgetPathsOf(statement.name);
    value.presence = Presence::removed;
  } else {
    value.model = statement.text;
    value.kinematics = statement.kinematics;
  }
  writeItem(*device, device->second.presence, std::move(value));
}

template <class T>
void StateFolder::writePathItem(std::map<Path, Item<T>>& items, const PathView& view, T value) {
  Device* const device = view.is_layer ? nullptr : deviceFor(view.first);
  if (device == nullptr && !view.is_layer) return;
  Path path = pathOf(view);
  Item<T> item = itemOf(std::move(value));
  const auto found = items.find(path);
  bool is_written = false;
  if (found != items.end()) {
    is_written = makeRoom(weightOf(found->second), weightOf(item));
    if (is_written) found->second = std::move(item);
  } else if (items.size() == limits::kPaths) {
    count(PacketFault::too_many);
  } else if (makeRoom(0, weightOf(path) + weightOf(item))) {
    is_written = true;
    items.emplace(std::move(path), std::move(item));
  }
  if (device == nullptr) return;
  if (is_written) {
    device->second.last_write = time_;
  } else {
    forgetIfEmpty(view.first);
  }
}

void StateFolder::foldVisibility(const Statement& statement) {
  Visibility value;
  value.kind = statement.kind == StatementKind::hide ? Visibility::Kind::hidden
               : statement.is_default                ? Visibility::Kind::by_default
                                                     : Visibility::Kind::shown;
  writePathItem(state_.visibility_, statement.path, value);
}

void StateFolder::foldColor(const Statement& statement) {
  ColorValue value;
  if (!statement.is_default) value.rgba = statement.rgba;
  writePathItem(state_.colors_, statement.path, value);
}

void StateFolder::foldDrawing(const Statement& statement) {
  const std::pair key{std::string(header_.source), std::string(statement.name)};
  const auto found = state_.drawings_.find(key);
  const bool is_new = found == state_.drawings_.end();
  if (is_new && state_.drawings_.size() == limits::kDrawings) {
    return count(PacketFault::too_many);
  }
  // The other parts stay only if this part has the same kind and part count.
  const bool goes_on = !is_new && found->second.kind == statement.kind &&
                       found->second.parts.size() == statement.part_count;
  const std::uint64_t before = is_new ? 0 : weightOf(key) + weightOf(found->second);
  const std::uint64_t numbers_weight = statement.numbers.size() * sizeof(double);
  std::uint64_t after = weightOf(key) + kDrawingWeight + statement.carrier.first.size() +
                        statement.carrier.second.size() + statement.text.size() +
                        kDrawingPartWeight * statement.part_count + numbers_weight;
  const std::size_t slot = statement.part_index - 1;
  if (goes_on) {
    for (std::size_t i = 0; i < found->second.parts.size(); ++i) {
      const auto& part = found->second.parts[i];
      if (i != slot && part) after += part->size() * sizeof(double);
    }
  }
  if (!makeRoom(before, after)) return;

  Drawing& drawing = is_new ? state_.drawings_[key] : found->second;
  if (!goes_on) {
    drawing.parts.assign(statement.part_count, std::nullopt);
    drawing.parts_stated.assign(statement.part_count, StatedMark());
  }
  drawing.kind = statement.kind;
  // A label has no colour: it is white, on the dark plate that a viewer draws below it.
  const bool colored = statement.kind != StatementKind::label;
  drawing.rgba = colored ? statement.rgba : 0xFFFFFFFFU;
  const double default_px =
      statement.kind == StatementKind::points ? limits::kDefaultPointPx : limits::kDefaultLinePx;
  drawing.size_px = statement.size_px.value_or(default_px);
  drawing.carrier = pathOf(statement.carrier);
  drawing.text = statement.text;
  drawing.parts[slot].emplace(statement.numbers.begin(), statement.numbers.end());
  drawing.parts_stated[slot].packet = state_.packets_;
}

void StateFolder::foldErase(const Statement& statement) {
  const std::string source(header_.source);
  auto drawing = state_.drawings_.lower_bound({source, std::string(statement.name)});
  const bool all = statement.name.empty();
  while (drawing != state_.drawings_.end() && drawing->first.first == source &&
         (all || drawing->first.second == statement.name)) {
    drawing = eraseFrom(state_.drawings_, drawing);
  }
}

void StateFolder::foldEvent(const Statement& statement) {
  if (!header_.by.empty()) return;
  if (state_.events_.size() == limits::kEvents) return count(PacketFault::too_many);
  state_.events_.push_back({time_, std::string(header_.source), std::string(statement.text)});
}

void StateFolder::foldView(const Statement& statement) {
  const std::span<const double> q = statement.numbers;
  ViewValue value;
  value.eye = vectorOf(q, 0);
  value.target = vectorOf(q, 3);
  value.fov_deg = q[6];
  value.up = vectorOf(q, 7);
  value.ortho_height_m = statement.ortho_height_m;
  value.carrier = pathOf(statement.carrier);
  Item<ViewValue> item = itemOf(std::move(value));
  const auto found = state_.views_.find(statement.name);
  if (found != state_.views_.end()) {
    if (makeRoom(weightOf(found->second), weightOf(item))) found->second = std::move(item);
  } else if (state_.views_.size() == limits::kViews) {
    count(PacketFault::too_many);
  } else if (makeRoom(0, statement.name.size() + weightOf(item))) {
    state_.views_.emplace(std::string(statement.name), std::move(item));
  }
}

void StateFolder::foldSeen(const Statement& statement) {
  if (header_.by.empty()) return;
  const auto device = state_.devices_.find(statement.name);
  if (device == state_.devices_.end()) return;
  device->second.last_write = std::min(time_, LogTime(Nanoseconds(statement.seen_ns)));
}

}  // namespace rocinante
