#include "core/foreign/table/session_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "core/base/name_hint.h"
#include "core/base/pattern.h"
#include "core/cell/posed_scene.h"
#include "core/foreign/session/joint_values.h"
#include "core/math/transform.h"
#include "core/packet/item_text.h"

namespace rocinante {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<std::string_view, 7> kPoseColumns = {":x",  ":y",  ":z", ":qx",
                                                          ":qy", ":qz", ":qw"};

/// When one of them was stated last, in packets.
std::uint64_t lastOf(const Signals& signals) {
  std::uint64_t last = 0;
  for (const auto& [name, item] : signals) last = std::max(last, item.stated.packet);
  return last;
}

bool readsBackAsItself(std::string_view device) { return device.find('.') == device.npos; }

}  // namespace

SessionTable::SessionTable(const Cell* cell, std::vector<std::string> devices, bool with_signals)
    : cell_(cell), patterns_(std::move(devices)), with_signals_(with_signals) {}

bool SessionTable::chosen(std::string_view device) {
  if (patterns_.empty()) return true;
  const auto known = chosen_.find(device);
  if (known != chosen_.end()) return known->second;
  return chosen_.emplace(device, anyPatternMatches(patterns_, device)).first->second;
}

void SessionTable::notice(const SessionState& state, LogTime moment) {
  for (const auto& [name, device] : state.devices()) {
    if (device.last_write == moment && chosen(name)) noticeDevice(name, device);
  }
  if (patterns_.empty() && lastOf(state.signals()) != noticed_of_none_) {
    noticed_of_none_ = lastOf(state.signals());
    noticeSignals({}, state.signals(), of_none_);
  }
}

void SessionTable::noticeAll(const SessionState& state) {
  for (const auto& [name, device] : state.devices()) {
    if (chosen(name)) noticeDevice(name, device);
  }
  if (patterns_.empty()) noticeSignals({}, state.signals(), of_none_);
}

void SessionTable::noticeSignals(const std::string& device, const Signals& signals,
                                 SignalColumns& columns) {
  if (!with_signals_) return;
  for (const auto& [name, item] : signals) {
    const bool is_text = item.value.kind == SignalKind::text;
    SignalColumns& known = is_text ? texts_[device] : columns;
    known.try_emplace(name);
  }
}

void SessionTable::layOutSignals(const std::string& device, SignalColumns& columns) {
  std::size_t place = 0;
  for (auto& [name, column] : columns) {
    column.place = place++;
    columns_.push_back(signalNameText(device, name));
  }
}

template <class Columns, class Visit>
void SessionTable::eachSignal(Columns& columns, const Signals& signals, Visit visit) {
  // Both are sorted by name: one pass, without searching.
  auto column = columns.begin();
  for (const auto& [name, item] : signals) {
    while (column != columns.end() && SignalOrder()(column->first, name)) ++column;
    if (column == columns.end()) break;
    const bool is_number = item.value.kind != SignalKind::text;
    if (is_number && column->first == name) visit(column->second, item.value);
  }
}

void SessionTable::fillSignals(const SignalColumns& columns, const Signals& signals,
                               std::span<double> row) {
  eachSignal(columns, signals, [row](const SignalColumn& column, const SignalValue& value) {
    row[column.place] = value.number;
  });
}

void SessionTable::noticeUnits(const SessionState& state, LogTime moment) {
  if (!with_signals_) return;
  const auto notice = [moment](SignalColumn& column, const SignalValue& value) {
    if (value.kind != SignalKind::number || column.other_at) return;
    if (!column.unit) column.unit = value.unit;
    if (*column.unit == value.unit) return;
    column.other_unit = value.unit;
    column.other_at = moment;
  };
  for (auto& [name, device] : devices_) {
    if (device.signals.empty()) continue;
    const DeviceState* const now = state.findDevice(name);
    if (now != nullptr && !isRemoved(*now)) eachSignal(device.signals, now->signals, notice);
  }
  if (!of_none_.empty()) eachSignal(of_none_, state.signals(), notice);
}

std::vector<SessionTable::SeveralUnits> SessionTable::severalUnits() const {
  std::vector<SeveralUnits> all;
  const auto add = [&all](const std::string& device, const SignalColumns& columns) {
    for (const auto& [name, column] : columns) {
      if (!column.other_at) continue;
      all.push_back(
          {signalNameText(device, name), *column.unit, column.other_unit, *column.other_at});
    }
  };
  for (const auto& [name, device] : devices_) add(name, device.signals);
  add({}, of_none_);
  return all;
}

/// Of the device itself in the cell, or the one that `add` names.
const Model* SessionTable::modelOf(const std::string& name, const DeviceState& state) const {
  if (state.presence && state.presence->value.presence == Presence::added) {
    const auto added = cell_->models.find(state.presence->value.model);
    if (added != cell_->models.end()) return added->second.get();
  }
  const CellDevice* const in_cell = cell_->findDevice(name);
  return in_cell == nullptr ? nullptr : cell_->modelOf(*in_cell);
}

void SessionTable::addJoint(Device& device, std::string_view joint) {
  std::string name(joint);
  if (device.joint_place.contains(name)) return;
  device.joint_place.emplace(name, device.joints.size());
  device.joints.push_back(std::move(name));
  device.own_values.push_back(kUnknown);
}

void SessionTable::noticeDevice(const std::string& name, const DeviceState& state) {
  const bool has_signals = with_signals_ && !state.signals.empty();
  if (!hasJoints(state) && !state.pose && !has_signals) return;
  auto [found, is_new] = devices_.try_emplace(name);
  Device& device = found->second;
  if (is_new && cell_ != nullptr) {
    device.model = modelOf(name, state);
  }
  if (state.pose) device.has_pose = true;
  noticeSignals(name, state.signals, device.signals);
  if (!hasJoints(state)) return;
  if (device.model != nullptr && device.positional.empty()) {
    ModelValues values = modelValues(*device.model);
    for (std::size_t i = 0; i < values.names.size(); ++i) {
      addJoint(device, values.names[i]);
      device.own_values[device.joint_place[values.names[i]]] = values.own[i];
    }
    device.positional = std::move(values.names);
  }
  // An order has the joints as the sender thinks of them; the state has them sorted by name.
  for (const auto& [source, order] : state.orders) {
    for (const std::string& joint : order.value) {
      if (state.named_joints.contains(joint)) addJoint(device, joint);
    }
  }
  for (const auto& [joint, value] : state.named_joints) addJoint(device, joint);
  if (!state.joints || state.joints->value.size() == device.positional.size()) return;
  if (state.joints->value.size() <= device.most_positional) return;
  for (std::size_t i = device.most_positional; i < state.joints->value.size(); ++i) {
    addJoint(device, std::to_string(i + 1));
  }
  device.most_positional = state.joints->value.size();
  device.has_bare_numbers = true;
}

void SessionTable::layOut() {
  columns_.clear();
  for (auto& [name, device] : devices_) {
    device.first_column = columns_.size();
    for (const std::string& joint : device.joints) columns_.push_back(name + "." + joint);
    if (device.has_pose) {
      for (const std::string_view part : kPoseColumns) columns_.push_back(name + std::string(part));
    }
    layOutSignals(name, device.signals);
  }
  first_of_none_ = columns_.size();
  layOutSignals({}, of_none_);
}

std::vector<std::string> SessionTable::texts() const {
  std::vector<std::string> names;
  for (const auto& [device, of_device] : texts_) {
    for (const auto& [name, place] : of_device) names.push_back(signalNameText(device, name));
  }
  return names;
}

std::string SessionTable::otherDevices() const {
  if (patterns_.empty()) return {};
  std::vector<std::string_view> others;
  for (const auto& [name, is_chosen] : chosen_) {
    if (!is_chosen) others.push_back(name);
  }
  return others.empty() ? std::string() : "; " + whatThereIs(patterns_.front(), others);
}

bool SessionTable::wasWritten(const SessionState& state, LogTime moment) {
  if (!of_none_.empty()) {
    const std::uint64_t last = lastOf(state.signals());
    if (std::exchange(written_of_none_, last) != last) return true;
  }
  for (const auto& [name, device] : devices_) {
    const DeviceState* const now = state.findDevice(name);
    if (now != nullptr && now->last_write == moment) return true;
  }
  return false;
}

void SessionTable::fill(const SessionState& state, std::span<double> row) {
  std::fill(row.begin(), row.end(), kUnknown);
  for (const auto& [name, device] : devices_) {
    const DeviceState* const now = state.findDevice(name);
    if (now == nullptr || isRemoved(*now)) continue;
    const std::size_t width = device.joints.size();
    if (hasJoints(*now)) fillJoints(device, *now, row.subspan(device.first_column, width));
    const auto behind = row.subspan(device.first_column + width);
    if (now->pose) fillPose(name, state, now->pose->value, behind.first(kPoseColumns.size()));
    if (device.signals.empty()) continue;
    const std::size_t first = device.has_pose ? kPoseColumns.size() : 0;
    fillSignals(device.signals, now->signals, behind.subspan(first, device.signals.size()));
  }
  if (!of_none_.empty()) fillSignals(of_none_, state.signals(), row.subspan(first_of_none_));
}

void SessionTable::fillJoints(const Device& device, const DeviceState& state,
                              std::span<double> row) const {
  std::copy(device.own_values.begin(), device.own_values.end(), row.begin());
  if (state.joints) {
    const std::vector<double>& values = state.joints->value;
    if (values.size() == device.positional.size()) {
      // The model's own values are the first columns, in its order.
      std::copy(values.begin(), values.end(), row.begin());
    } else {
      for (std::size_t i = 0; i < values.size(); ++i) {
        const auto place = device.joint_place.find(std::to_string(i + 1));
        if (place != device.joint_place.end()) row[place->second] = values[i];
      }
    }
  }
  // Both are sorted by name: one pass, without searching.
  auto place = device.joint_place.begin();
  for (const auto& [joint, item] : state.named_joints) {
    while (place != device.joint_place.end() && place->first < joint) ++place;
    if (place == device.joint_place.end()) break;
    if (place->first == joint) row[place->second] = item.value;
  }
}

void SessionTable::fillPose(const std::string& name, const SessionState& state,
                            const PoseValue& pose, std::span<double> row) {
  Pose in_world = pose.pose;
  if (!pose.carrier.first.empty()) {
    if (cell_ == nullptr) {
      carried_.insert(name);
      return;
    }
    const PosedScene scene = poseScene(*cell_, state);
    const PosedDevice* const posed = scene.findDevice(name);
    if (posed == nullptr) {
      carried_.insert(name);
      return;
    }
    in_world = poseOf(posed->base);
  }
  row[0] = in_world.position.x;
  row[1] = in_world.position.y;
  row[2] = in_world.position.z;
  row[3] = in_world.orientation.x;
  row[4] = in_world.orientation.y;
  row[5] = in_world.orientation.z;
  row[6] = in_world.orientation.w;
}

std::vector<std::string> SessionTable::remarks() const {
  std::vector<std::string> sentences;
  for (const auto& [name, device] : devices_) {
    if (device.has_bare_numbers) {
      sentences.push_back(fmt::format(
          "{0} sends {1} joint values by position, and no model names them: they are {0}.1 to "
          "{0}.{1} (a cell with its model does: --cell)",
          name, device.most_positional));
    }
    if (!readsBackAsItself(name)) {
      sentences.push_back(
          fmt::format("the name of {} holds a point: `source --csv` would take what is before the "
                      "first one for "
                      "the device",
                      name));
    }
  }
  return sentences;
}

std::vector<std::string> SessionTable::gaps() const {
  std::vector<std::string> sentences;
  for (const std::string& name : carried_) {
    sentences.push_back(fmt::format(
        "where {} is carried by another device its pose in the world is not known, and left out{}",
        name, cell_ == nullptr ? " (--cell knows it)" : ": the cell does not have the device"));
  }
  return sentences;
}

}  // namespace rocinante
