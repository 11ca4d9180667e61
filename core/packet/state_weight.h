#pragma once

#include <string_view>

#include "core/packet/session_state.h"

// The weight of items against the state's memory limit: docs/packet-format.md, section "Limits".
// Depends only on what was stated, so that a state reached another way has the same room.
namespace rocinante {

inline constexpr std::uint64_t kSourceWeight = 256;
inline constexpr std::uint64_t kDeviceWeight = 512;
inline constexpr std::uint64_t kItemWeight = 128;
inline constexpr std::uint64_t kDrawingWeight = 256;
inline constexpr std::uint64_t kDrawingPartWeight = 40;
inline constexpr std::uint64_t kSignalWeight = 256;
inline constexpr std::uint64_t kOrderNameWeight = 32;

inline std::uint64_t weightOf(const Path& path) { return path.first.size() + path.second.size(); }

inline std::uint64_t weightOf(const Item<PresenceValue>& item) {
  return kItemWeight + item.owner.size() + item.value.model.size();
}
inline std::uint64_t weightOf(const Item<PoseValue>& item) {
  return kItemWeight + item.owner.size() + weightOf(item.value.carrier);
}
inline std::uint64_t weightOf(const Item<std::vector<double>>& item) {
  return kItemWeight + item.owner.size() + item.value.size() * sizeof(double);
}
inline std::uint64_t weightOf(const Item<double>& item) { return kItemWeight + item.owner.size(); }
/// Without the owner, which is the key of an order.
inline std::uint64_t weightOf(const Item<std::vector<std::string>>& order) {
  std::uint64_t weight = kItemWeight;
  for (const std::string& name : order.value) weight += kOrderNameWeight + name.size();
  return weight;
}
inline std::uint64_t weightOf(const Item<Visibility>& item) {
  return kItemWeight + item.owner.size();
}
inline std::uint64_t weightOf(const Item<ColorValue>& item) {
  return kItemWeight + item.owner.size();
}
inline std::uint64_t weightOf(const Item<ViewValue>& item) {
  return kItemWeight + item.owner.size() + weightOf(item.value.carrier);
}
inline std::uint64_t weightOf(const SignalName& name) {
  return name.link.size() + name.name.size();
}
inline std::uint64_t weightOf(const Item<SignalValue>& item) {
  return kSignalWeight + item.owner.size() + item.value.text.size() + item.value.unit.size();
}
inline std::uint64_t weightOf(const Drawing& drawing) {
  std::uint64_t weight = kDrawingWeight + weightOf(drawing.carrier) + drawing.text.size();
  for (const auto& part : drawing.parts) {
    weight += kDrawingPartWeight + (part ? part->size() * sizeof(double) : 0);
  }
  return weight;
}
inline std::uint64_t weightOf(const SourceState& source) {
  return kSourceWeight + source.run.size();
}

template <class T>
std::uint64_t weightOf(const std::optional<T>& item) {
  return item ? weightOf(*item) : 0;
}

/// The weight of a map's element: the key's names and the value.
inline std::uint64_t weightOf(std::string_view key) { return key.size(); }
inline std::uint64_t weightOf(const std::pair<std::string, std::string>& key) {
  return key.first.size() + key.second.size();
}

}  // namespace rocinante
