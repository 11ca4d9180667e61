#include "core/series/stated_values.h"

#include <algorithm>
#include <charconv>

namespace rocinante {

std::optional<double> jointStated(const DeviceState& device_state, std::string_view name,
                                  const std::vector<std::string>& names) {
  if (const auto named = device_state.named_joints.find(name);
      named != device_state.named_joints.end()) {
    return named->second.value;
  }
  if (!device_state.joints) return std::nullopt;
  const std::vector<double>& values = device_state.joints->value;
  if (!names.empty()) {
    const auto found = std::ranges::find(names, name);
    if (found == names.end() || names.size() != values.size()) return std::nullopt;
    return values[static_cast<std::size_t>(found - names.begin())];
  }
  std::size_t number = 0;
  const char* const end = name.data() + name.size();
  const auto [stop, fault] = std::from_chars(name.data(), end, number);
  if (fault != std::errc{} || stop != end || number == 0 || number > values.size()) {
    return std::nullopt;
  }
  return values[number - 1];
}

std::optional<double> signalStated(const SessionState& state, const SeriesKey& key) {
  const Item<SignalValue>* const item = state.findSignal(key.name, {key.link, key.part});
  if (item == nullptr || item->value.kind == SignalKind::text) return std::nullopt;
  return item->value.number;
}

std::optional<std::string> stateStated(const SessionState& state, const SeriesKey& key) {
  const Item<SignalValue>* const item = state.findSignal(key.name, {key.link, key.part});
  if (item == nullptr || item->value.kind == SignalKind::number) return std::nullopt;
  if (item->value.kind == SignalKind::text) return item->value.text;
  return item->value.number != 0 ? "true" : "false";
}

}  // namespace rocinante
