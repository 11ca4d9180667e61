#include "core/packet/packet_limits.h"
#include "core/packet/state_folder.h"

namespace rocinante {

void StateFolder::foldSignals(const Statement& statement) {
  if (statement.is_default) return cancelSignal(statement);
  const PathView& path = statement.path;
  Device* const device = path.first.empty() ? nullptr : deviceFor(path.first);
  if (device == nullptr && !path.first.empty()) return;
  Signals& signals = device == nullptr ? state_.signals_ : device->second.signals;
  // As joints: neighbours in the statement are usually neighbours in the map.
  auto next = signals.begin();
  bool is_written = false;
  for (std::size_t i = 0; i < statement.names.size(); ++i) {
    const std::string_view name = statement.names[i];
    const bool is_next = next != signals.end() && sameName(next->first.name, name) &&
                         sameName(next->first.link, path.second);
    if (!is_next) next = signals.find(SignalNameView(path.second, name));
    // One that has no room keeps no other from its value.
    is_written = setSignal(signals, next, statement, i) || is_written;
    if (next != signals.end()) ++next;
  }
  if (device == nullptr) return;
  if (is_written) {
    device->second.last_write = time_;
  } else {
    forgetIfEmpty(path.first);
  }
}

bool StateFolder::setSignal(Signals& signals, Signals::iterator found, const Statement& statement,
                            std::size_t index) {
  const SignalKind kind = statement.signal_kinds[index];
  const bool is_text = kind == SignalKind::text;
  if (found != signals.end()) {
    SignalValue& value = found->second.value;
    const bool keeps_unit = statement.kind == StatementKind::signals &&
                            kind == SignalKind::number && value.kind == kind;
    const std::uint64_t after = kSignalWeight + header_.source.size() +
                                (is_text ? statement.text.size() : 0) +
                                (keeps_unit ? value.unit.size() : statement.unit.size());
    if (!makeRoom(weightOf(found->second), after)) return false;
    value.kind = kind;
    value.number = statement.numbers[index];
    if (is_text || !value.text.empty()) value.text = is_text ? statement.text : std::string_view();
    if (!keeps_unit) value.unit = statement.unit;
    claim(found->second);
    return true;
  }
  if (state_.signal_count_ == limits::kSignals) {
    count(PacketFault::too_many);
    return false;
  }
  SignalName name{std::string(statement.path.second), std::string(statement.names[index])};
  SignalValue value{kind, statement.numbers[index], {}, std::string(statement.unit)};
  if (is_text) value.text = statement.text;
  Item<SignalValue> item = itemOf(std::move(value));
  if (!makeRoom(0, weightOf(name) + weightOf(item))) return false;
  signals.emplace(std::move(name), std::move(item));
  ++state_.signal_count_;
  return true;
}

void StateFolder::cancelSignal(const Statement& statement) {
  const PathView& path = statement.path;
  const SignalNameView name(path.second, statement.names.front());
  if (path.first.empty()) {
    const auto signal = state_.signals_.find(name);
    if (signal != state_.signals_.end()) eraseFrom(state_.signals_, signal);
    return;
  }
  const auto device = state_.devices_.find(path.first);
  if (device == state_.devices_.end()) return;
  const auto signal = device->second.signals.find(name);
  if (signal == device->second.signals.end()) return;
  eraseFrom(device->second.signals, signal);
  device->second.last_write = time_;
  forgetIfEmpty(path.first);
}

}  // namespace rocinante
