#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/packet/session_state.h"

// The items of a state, of every kind, for whoever walks over them: a visitor takes each kind by
// its type, so that a new kind does not compile until all who have to do with items say what they
// do with it. A new kind has a member of DeviceState or SessionState and its place in slots() or
// maps(), a type and eachItemIn() or eachItemOf() here, its text (item_text.h) and its weight
// (state_weight.h).
namespace rocinante {

/// An item of a device. Items are borrowed from the state, like everything else here.
template <class T>
struct DeviceItem {
  const std::string& device;
  const Item<T>& item;
  const std::string& owner() const { return item.owner; }
  /// The device that an item belongs to; null for those of a layer, of the world and of a SOURCE.
  const std::string* ofDevice() const { return &device; }
};
using PresenceItem = DeviceItem<PresenceValue>;
using PositionsItem = DeviceItem<std::vector<double>>;
using OrderItem = DeviceItem<std::vector<std::string>>;
using PoseItem = DeviceItem<PoseValue>;

struct JointItem : DeviceItem<double> {
  const std::string& joint;
};

template <class T>
struct PathItem {
  const Path& path;
  const Item<T>& item;
  const std::string& owner() const { return item.owner; }
  const std::string* ofDevice() const { return path.is_layer ? nullptr : &path.first; }
};
using VisibilityItem = PathItem<Visibility>;
using ColorItem = PathItem<ColorValue>;

/// A part of a drawing that is there.
struct DrawingItem {
  const std::string& source;
  const std::string& id;
  const Drawing& drawing;
  std::size_t part;  ///< from 0
  const std::string& owner() const { return source; }
  const std::string* ofDevice() const { return nullptr; }
};

struct ViewItem {
  const std::string& name;
  const Item<ViewValue>& item;
  const std::string& owner() const { return item.owner; }
  const std::string* ofDevice() const { return nullptr; }
};

/// Of a device or one of its links; of none when `device` is empty.
struct SignalItem {
  const std::string& device;
  const SignalName& name;
  const Item<SignalValue>& item;
  const std::string& owner() const { return item.owner; }
  const std::string* ofDevice() const { return device.empty() ? nullptr : &device; }
};

/// A visitor made of one function a kind.
template <class... Kinds>
struct ByKind : Kinds... {
  using Kinds::operator()...;
};
template <class... Kinds>
ByKind(Kinds...) -> ByKind<Kinds...>;

template <class T, class Visit>
void eachItemIn(const std::string& device, const std::optional<Item<T>>& slot, Visit& visit) {
  if (slot) visit(DeviceItem<T>{device, *slot});
}
template <class Visit>
void eachItemIn(const std::string& device, const DeviceState::Orders& orders, Visit& visit) {
  for (const auto& order : orders) visit(OrderItem{device, order.second});
}
template <class Visit>
void eachItemIn(const std::string& device, const DeviceState::NamedJoints& joints, Visit& visit) {
  for (const auto& [joint, item] : joints) visit(JointItem{{device, item}, joint});
}
template <class Visit>
void eachItemIn(const std::string& device, const Signals& signals, Visit& visit) {
  for (const auto& [name, item] : signals) visit(SignalItem{device, name, item});
}

/// The items of an element of one of a state's maps; of a device in the order of its slots.
template <class Visit>
void eachItemOf(const std::string& name, const DeviceState& device, Visit&& visit) {
  std::apply([&](const auto&... slots) { (eachItemIn(name, slots, visit), ...); }, device.slots());
}
template <class T, class Visit>
void eachItemOf(const Path& path, const Item<T>& item, Visit&& visit) {
  visit(PathItem<T>{path, item});
}
template <class Visit>
void eachItemOf(const SessionState::Drawings::key_type& id, const Drawing& drawing, Visit&& visit) {
  for (std::size_t part = 0; part < drawing.parts.size(); ++part) {
    if (drawing.parts[part]) visit(DrawingItem{id.first, id.second, drawing, part});
  }
}
template <class Visit>
void eachItemOf(const std::string& name, const Item<ViewValue>& item, Visit&& visit) {
  visit(ViewItem{name, item});
}
template <class Visit>
void eachItemOf(const SignalName& name, const Item<SignalValue>& item, Visit&& visit) {
  static const std::string of_none;
  visit(SignalItem{of_none, name, item});
}

/// Calls `visit` with each of the state's maps of items and its name, which listings use.
template <class Visit>
void eachMap(const SessionState& state, Visit&& visit) {
  std::size_t i = 0;
  std::apply([&](const auto&... maps) { (visit(SessionState::kMapNames[i++], maps), ...); },
             state.maps());
}

/// Calls `visit` with every item, device by device, then map by map.
template <class Visit>
void eachItem(const SessionState& state, Visit&& visit) {
  eachMap(state, [&](std::string_view, const auto& map) {
    for (const auto& [key, value] : map) eachItemOf(key, value, visit);
  });
}

/// The elements of a map that are of a device or its links: [first, second).
template <class Map>
auto pathsOf(Map& items, std::string_view device) {
  const auto first = items.lower_bound(Path{false, std::string(device), {}});
  auto end = first;
  while (end != items.end() && !end->first.is_layer && end->first.first == device) ++end;
  return std::pair(first, end);
}

/// True for the same items, where `same_device` compares two states of one device.
template <class SameDevice>
bool sameItems(const SessionState& a, const SessionState& b, SameDevice same_device) {
  const auto besideDevices = [](const SessionState& state) {
    return std::apply([](const auto&, const auto&... others) { return std::tie(others...); },
                      state.maps());
  };
  return besideDevices(a) == besideDevices(b) &&
         std::ranges::equal(a.devices(), b.devices(), [&](const auto& one, const auto& other) {
           return one.first == other.first && same_device(one.second, other.second);
         });
}

}  // namespace rocinante
