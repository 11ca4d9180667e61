#include "core/packet/state_folder.h"

namespace rocinante {

void StateFolder::forgetItemsOf(DeviceState& device) {
  eraseOptional(device.presence);
  eraseOptional(device.pose);
  eraseOptional(device.joints);
  clearNamedJoints(device);
  eraseWhere(device.orders, [](const auto&) { return true; });
  device.orders_said.clear();
}

void StateFolder::forgetPathsOf(std::string_view device) {
  const auto eraseRange = [&](auto& items) {
    auto item = items.lower_bound(Path{false, std::string(device), {}});
    while (item != items.end() && !item->first.is_layer && item->first.first == device) {
      item = eraseFrom(items, item);
    }
  };
  eraseRange(state_.visibility_);
  eraseRange(state_.colors_);
}

bool StateFolder::isEmpty(const Device& device) const {
  const DeviceState& said = device.second;
  if (said.presence || said.pose || said.joints || !said.named_joints.empty() ||
      !said.orders.empty()) {
    return false;
  }
  const auto hasPath = [&](const auto& items) {
    const auto item = items.lower_bound(Path{false, device.first, {}});
    return item != items.end() && !item->first.is_layer && item->first.first == device.first;
  };
  return !hasPath(state_.visibility_) && !hasPath(state_.colors_);
}

void StateFolder::forgetIfEmpty(std::string_view name) {
  const auto device = state_.devices_.find(name);
  if (device == state_.devices_.end() || !isEmpty(*device)) return;
  eraseDevice(device);
}

SessionState::Devices::iterator StateFolder::eraseDevice(SessionState::Devices::iterator device) {
  state_.weight_ -= kDeviceWeight + device->first.size();
  state_.device_cache_.forget(device->first);
  return state_.devices_.erase(device);
}

void StateFolder::clearNamedJoints(DeviceState& device) {
  if (device.named_joints.empty()) return;
  eraseWhere(device.named_joints, [](const auto&) { return true; });
}

void StateFolder::eraseOrder(DeviceState& device, std::string_view source) {
  const auto order = device.orders.find(source);
  if (order == device.orders.end()) return;
  device.orders_said.erase(device.orders_said.find(source));
  eraseFrom(device.orders, order);
}

void StateFolder::forgetUnrepeatedDrawings(std::uint64_t first_packet) {
  const std::string owner(header_.source);
  auto next = state_.drawings_.lower_bound({owner, std::string()});
  while (next != state_.drawings_.end() && next->first.first == owner) {
    Drawing& drawing = next->second;
    bool has_parts = false;
    for (std::size_t i = 0; i < drawing.parts.size(); ++i) {
      auto& part = drawing.parts[i];
      if (part && drawing.parts_said[i].packet < first_packet) {
        state_.weight_ -= part->size() * sizeof(double);
        part.reset();
      }
      has_parts = has_parts || part;
    }
    next = has_parts ? std::next(next) : eraseFrom(state_.drawings_, next);
  }
}

void StateFolder::forgetUnrepeated(std::uint64_t first_packet) {
  const std::string_view source = header_.source;
  const auto isStale = [&](const auto& item) {
    return item.said.packet < first_packet && item.owner == source;
  };
  const auto eraseStale = [&](auto& slot) {
    if (slot && isStale(*slot)) eraseOptional(slot);
  };
  eraseWhere(state_.visibility_, isStale);
  eraseWhere(state_.colors_, isStale);
  eraseWhere(state_.views_, isStale);
  forgetUnrepeatedDrawings(first_packet);
  for (auto device = state_.devices_.begin(); device != state_.devices_.end();) {
    DeviceState& said = device->second;
    eraseStale(said.presence);
    eraseStale(said.pose);
    eraseStale(said.joints);
    eraseWhere(said.named_joints, isStale);
    const auto order_said = said.orders_said.find(source);
    if (order_said != said.orders_said.end() && order_said->second.packet < first_packet) {
      eraseOrder(said, source);
    }
    device = isEmpty(*device) ? eraseDevice(device) : std::next(device);
  }
}

}  // namespace rocinante
