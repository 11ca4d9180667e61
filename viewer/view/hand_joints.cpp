#include "viewer/view/hand_joints.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/base/figure_text.h"
#include "core/base/number_list.h"
#include "core/base/plain_text.h"
#include "core/cell/view_path.h"
#include "core/kinematics/joint_values.h"
#include "core/packet/packet_text.h"

namespace rocinante {
namespace {

Error refusedJoints(std::string what) { return {ErrorKind::bad_argument, std::move(what), ""}; }

/// The devices of the cell that have joints to set.
std::vector<const CellDevice*> jointedDevices(const Cell& cell) {
  std::vector<const CellDevice*> jointed;
  for (const CellDevice& device : cell.devices) {
    const Model* const model = cell.modelOf(device);
    if (model != nullptr && model->positionalCount() > 0) jointed.push_back(&device);
  }
  return jointed;
}

Result<const CellDevice*> deviceOf(const Cell& cell, std::string_view name) {
  if (name.empty()) {
    const auto jointed = jointedDevices(cell);
    if (jointed.size() == 1) return jointed.front();
    return refusedJoints(jointed.empty()
                             ? std::string("no device of the cell has joints")
                             : fmt::format("the cell has {} with joints: write DEVICE=VALUES",
                                           countText(jointed.size(), "device")));
  }
  const auto path = parseViewPath(name);
  if (!path) return path.error();
  const bool is_device =
      !path->all_devices && !path->has_group && !path->path.is_layer && path->path.second.empty();
  const CellDevice* const device = is_device ? cell.findDevice(path->path.first) : nullptr;
  if (device == nullptr) {
    return refusedJoints(fmt::format("the cell has no device `{}`", plainText(name)));
  }
  return device;
}

}  // namespace

Status HandJoints::set(const std::string& device, const Model& model, const std::string& value_name,
                       double value) {
  if (auto driven = drivenValue(model, value_name); !driven) return driven.error();
  if (!std::isfinite(value)) return refusedJoints("a joint's value must be finite");
  devices_[device][value_name] = value;
  return {};
}

Status HandJoints::setAll(const std::string& device, const Model& model,
                          std::span<const double> values) {
  if (Status fits = checkValueCount(model, values.size()); !fits) return fits;
  if (!std::ranges::all_of(values, [](double value) { return std::isfinite(value); })) {
    return refusedJoints("a joint's value must be finite");
  }
  const std::vector<std::string> names = positionalNames(model);
  if (names.empty()) return {};
  Values& mine = devices_[device];
  for (std::size_t i = 0; i < names.size(); ++i) mine[names[i]] = values[i];
  return {};
}

void HandJoints::reset(const std::string& device, const std::string& value_name) {
  const auto found = devices_.find(device);
  if (found == devices_.end()) return;
  found->second.erase(value_name);
  if (found->second.empty()) devices_.erase(found);
}

void HandJoints::reset(const std::string& device) { devices_.erase(device); }

std::optional<double> HandJoints::find(std::string_view device, std::string_view value_name) const {
  const auto found = devices_.find(device);
  if (found == devices_.end()) return std::nullopt;
  const auto value = found->second.find(value_name);
  return value == found->second.end() ? std::nullopt : std::optional(value->second);
}

std::size_t HandJoints::count() const {
  std::size_t count = 0;
  for (const auto& [device, values] : devices_) count += values.size();
  return count;
}

JointStatements::JointStatements(JointsByDevice joints) : joints_(std::move(joints)) {
  // The statements are views into these, so they are filled before any is taken.
  names_.reserve(joints_.size());
  numbers_.reserve(joints_.size());
  for (const auto& [device, values] : joints_) {
    auto& names = names_.emplace_back();
    auto& numbers = numbers_.emplace_back();
    for (const auto& [name, value] : values) {
      names.emplace_back(name);
      numbers.push_back(value);
    }
    Statement& statement = statements_.emplace_back();
    statement.kind = StatementKind::joint;
    statement.name = device;
    statement.names = names;
    statement.numbers = numbers;
  }
}

SessionState withHand(const SessionState& received, LogTime moment, const HandJoints& hand) {
  const JointStatements statements(hand.devices());
  Packet packet;
  packet.header.source = kHandSource;
  packet.statements = statements.all();
  SessionState state = received;
  state.apply(moment, packet);
  return state;
}

Status setJoints(HandJoints& hand, const Cell& cell, std::string_view text) {
  // Numbers have no `=`.
  const std::size_t equals = text.rfind('=');
  const bool named = equals != std::string_view::npos;
  const auto device = deviceOf(cell, named ? text.substr(0, equals) : std::string_view());
  if (!device) return device.error();
  const CellDevice& posed = **device;
  const Model* const model = cell.modelOf(posed);
  if (model == nullptr) {
    return refusedJoints(
        fmt::format("the model of device `{}` could not be read", plainText(posed.name)));
  }
  if (posed.optional) {
    return refusedJoints(
        fmt::format("device `{}` is not there before it is added", plainText(posed.name)));
  }
  const auto values = parseNumbers(named ? text.substr(equals + 1) : text);
  if (!values) return values.error();
  return hand.setAll(posed.name, *model, *values);
}

std::string jointsText(const Cell& cell, const std::string& device,
                       std::span<const double> values) {
  const auto jointed = jointedDevices(cell);
  const bool only = jointed.size() == 1 && jointed.front()->name == device;
  return fmt::format("{}{}{}", only ? "" : encodeName(device), only ? "" : "=",
                     fmt::join(values, " "));
}

}  // namespace rocinante
