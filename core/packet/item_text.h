#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/packet/packet.h"
#include "core/packet/state_items.h"

namespace rocinante {

/// True when the statement is about a device whose name matches one of `patterns`
/// (core/base/pattern.h): its joints, its pose, its presence, its look, what it carries or what is
/// drawn on it. False for `erase`, `event`, layers, and whatever is drawn in the world.
bool isAboutDevice(const Statement& statement, std::span<const std::string> patterns);

// Statements of a device.
std::string poseText(std::string_view device, const PoseValue& value);
std::string jointsText(std::string_view device, const std::vector<double>& values);
/// An order without names removes an order.
std::string orderText(std::string_view device, const std::vector<std::string>& names);
std::string jointText(std::string_view device, std::string_view name, double value);
std::string seenText(std::string_view device, LogTime time);

/// The statement that restates an item of each kind.
std::string statementText(const PresenceItem& item);
inline std::string statementText(const PositionsItem& item) {
  return jointsText(item.device, item.item.value);
}
inline std::string statementText(const OrderItem& item) {
  return orderText(item.device, item.item.value);
}
inline std::string statementText(const JointItem& item) {
  return jointText(item.device, item.joint, item.item.value);
}
inline std::string statementText(const PoseItem& item) {
  return poseText(item.device, item.item.value);
}
std::string statementText(const VisibilityItem& item);
std::string statementText(const ColorItem& item);
std::string statementText(const DrawingItem& item);
std::string statementText(const ViewItem& item);
std::string statementText(const SignalItem& item);
/// "signal PATH NAME": what a signal of `device`, or of none when that is empty, is called.
std::string signalNameText(std::string_view device, const SignalName& name);
/// A signal and whose it is; `device` is empty for one of none.
struct NamedSignal {
  std::string device;
  SignalName name;
  bool operator==(const NamedSignal&) const = default;
};
/// Reads signalNameText(); empty for anything else, also another spelling.
std::optional<NamedSignal> signalNamed(std::string_view text);

/// `SOURCE[@RUN] SEQUENCE TIME`, a header's text after its "RK1": what the state knows of a source.
std::string sourceText(std::string_view name, const SourceState& source);

}  // namespace rocinante
