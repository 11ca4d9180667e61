#include "core/foreign/session/known_signals.h"

namespace rocinante {

std::string ownerText(const SignalOwner& owner) {
  if (owner.first.empty()) return "-";
  return owner.second.empty() ? owner.first : owner.first + "/" + owner.second;
}

void KnownSignals::notice(const SessionState& state) {
  const auto add_all = [this](const std::string& device, const rocinante::Signals& signals) {
    for (const auto& [name, item] : signals) {
      add({device, name.link}, name.name, item.value.kind, item.value.unit);
    }
  };
  add_all({}, state.signals());
  for (const auto& [name, device] : state.devices()) add_all(name, device.signals);
}

void KnownSignals::notice(const Packet& packet) {
  for (const Statement& statement : packet.statements) {
    if (!isSignal(statement.kind) || statement.is_default) continue;
    const SignalOwner owner{statement.path.first, statement.path.second};
    for (std::size_t i = 0; i < statement.names.size(); ++i) {
      add(owner, statement.names[i], statement.signal_kinds[i], statement.unit);
    }
  }
}

void KnownSignals::add(const SignalOwner& owner, std::string_view name, SignalKind kind,
                       std::string_view unit) {
  const auto of_owner = by_owner_.find(owner);
  Signal* signal = nullptr;
  if (of_owner != by_owner_.end()) {
    const auto known = of_owner->second.find(name);
    if (known != of_owner->second.end()) signal = &known->second;
  }
  if (signal == nullptr) {
    if (count_ == most_) {
      ++beyond_.values;
      if (!unit.empty()) ++beyond_.units;
      return;
    }
    ++count_;
    ++growth_;
    signal = &by_owner_[owner].emplace(std::string(name), Signal{kind, {}}).first->second;
  }
  if (unit.empty()) return;
  if (signal->unit.empty()) ++growth_;
  signal->unit = unit;
}

}  // namespace rocinante
