#include "core/packet/state_folder.h"
#include "core/packet/state_items.h"

namespace rocinante {

template <class T>
void StateFolder::eraseAll(std::optional<Item<T>>& slot) {
  state_.weight_ -= weightOf(slot);
  slot.reset();
}

template <class Map>
void StateFolder::eraseAll(Map& items) {
  for (auto item = items.begin(); item != items.end();) item = eraseFrom(items, item);
}

void StateFolder::forgetItemsOf(DeviceState& device) {
  std::apply([&](auto&... slots) { (eraseAll(slots), ...); }, device.slots());
}

void StateFolder::forgetPathsOf(std::string_view device) {
  const auto eraseRange = [&](auto& items) {
    auto [item, end] = pathsOf(items, device);
    while (item != end) item = eraseFrom(items, item);
  };
  eraseRange(state_.visibility_);
  eraseRange(state_.colors_);
}

bool StateFolder::isEmpty(const Device& device) const {
  bool has_items = false;
  const auto look = [&](const auto& slot) {
    if constexpr (requires { slot.empty(); }) {
      has_items = has_items || !slot.empty();
    } else {
      has_items = has_items || slot.has_value();
    }
  };
  std::apply([&](const auto&... slots) { (look(slots), ...); }, device.second.slots());
  if (has_items) return false;
  const auto hasPath = [&](const auto& items) {
    const auto [first, end] = pathsOf(items, device.first);
    return first != end;
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
  if (!device.named_joints.empty()) eraseAll(device.named_joints);
}

void StateFolder::eraseOrder(DeviceState& device, std::string_view source) {
  const auto order = device.orders.find(source);
  if (order != device.orders.end()) eraseFrom(device.orders, order);
}

template <class T>
bool StateFolder::isUnrepeated(const Item<T>& item, std::uint64_t first_packet) const {
  return item.stated.packet < first_packet && item.owner == header_.source;
}

template <class T>
void StateFolder::eraseUnrepeated(std::optional<Item<T>>& slot, std::uint64_t first_packet) {
  if (slot && isUnrepeated(*slot, first_packet)) eraseAll(slot);
}

template <class Map>
void StateFolder::eraseUnrepeated(Map& items, std::uint64_t first_packet) {
  for (auto item = items.begin(); item != items.end();) {
    const bool is_stale = isUnrepeated(item->second, first_packet);
    item = is_stale ? eraseFrom(items, item) : std::next(item);
  }
}

void StateFolder::eraseUnrepeated(SessionState::Drawings& drawings, std::uint64_t first_packet) {
  const std::string owner(header_.source);
  auto next = drawings.lower_bound({owner, std::string()});
  while (next != drawings.end() && next->first.first == owner) {
    Drawing& drawing = next->second;
    bool has_parts = false;
    for (std::size_t i = 0; i < drawing.parts.size(); ++i) {
      auto& part = drawing.parts[i];
      if (part && drawing.parts_stated[i].packet < first_packet) {
        state_.weight_ -= part->size() * sizeof(double);
        part.reset();
      }
      has_parts = has_parts || part;
    }
    next = has_parts ? std::next(next) : eraseFrom(drawings, next);
  }
}

void StateFolder::eraseUnrepeated(SessionState::Devices& devices, std::uint64_t first_packet) {
  for (auto device = devices.begin(); device != devices.end();) {
    std::apply([&](auto&... slots) { (eraseUnrepeated(slots, first_packet), ...); },
               device->second.slots());
    device = isEmpty(*device) ? eraseDevice(device) : std::next(device);
  }
}

void StateFolder::forgetUnrepeated(std::uint64_t first_packet) {
  // The devices last: one that has no item of its own stays for a path.
  std::apply(
      [&](auto& devices, auto&... others) {
        (eraseUnrepeated(others, first_packet), ...);
        eraseUnrepeated(devices, first_packet);
      },
      state_.ownMaps());
}

}  // namespace rocinante
