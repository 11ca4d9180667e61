#include "core/foreign/foxglove/signal_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace rocinante {
namespace {

/// The parts between points; the whole name where they cannot be nested.
std::vector<std::string> keysOf(const std::string& name, const KnownSignals::Signals& signals) {
  std::vector<std::string> keys;
  std::size_t begin = 0;
  while (true) {
    const std::size_t point = name.find('.', begin);
    keys.push_back(name.substr(begin, point - begin));
    if (keys.back().empty()) return {name};
    if (point == name.npos) return keys;
    if (signals.contains(std::string_view(name).substr(0, point))) return {name};
    begin = point + 1;
  }
}

const char* typeOf(SignalKind kind) {
  if (kind == SignalKind::number) return "number";
  return kind == SignalKind::boolean ? "boolean" : "string";
}

}  // namespace

SignalJson::SignalJson(const KnownSignals::Signals& signals) {
  for (const auto& [name, signal] : signals)
    fields_.emplace(name, Field{keysOf(name, signals), signal});
}

bool SignalJson::isOf(const KnownSignals::Signals& signals) const {
  return std::ranges::equal(fields_, signals, [](const auto& field, const auto& signal) {
    return field.first == signal.first && field.second.signal == signal.second;
  });
}

std::string SignalJson::schema() const {
  const auto object = [] {
    return nlohmann::json{{"type", "object"}, {"properties", nlohmann::json::object()}};
  };
  nlohmann::json schema = object();
  for (const auto& [name, field] : fields_) {
    nlohmann::json* at = &schema["properties"];
    for (std::size_t i = 0; i + 1 < field.keys.size(); ++i) {
      nlohmann::json& inner = (*at)[field.keys[i]];
      if (inner.is_null()) inner = object();
      at = &inner["properties"];
    }
    nlohmann::json& leaf = (*at)[field.keys.back()];
    leaf["type"] = typeOf(field.signal.kind);
    if (!field.signal.unit.empty()) leaf["description"] = field.signal.unit;
  }
  return schema.dump();
}

std::string SignalJson::message(std::span<const StatedSignal> signals, bool only_new) const {
  nlohmann::json message = nlohmann::json::object();
  for (const StatedSignal& signal : signals) {
    if (only_new && !signal.is_new) continue;
    const auto field = fields_.find(signal.name);
    if (field == fields_.end()) continue;
    nlohmann::json* at = &message;
    for (const std::string& key : field->second.keys) at = &(*at)[key];
    const SignalValue& value = *signal.value;
    if (value.kind == SignalKind::number) *at = value.number;
    if (value.kind == SignalKind::boolean) *at = value.number != 0;
    if (value.kind == SignalKind::text) *at = value.text;
  }
  return message.dump();
}

}  // namespace rocinante
