#include "core/behaviour/track_recorder.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "core/behaviour/session_track.h"
#include "core/cell/posed_scene.h"
#include "core/kinematics/joint_values.h"
#include "core/session/message_folder.h"

namespace rocinante {
namespace {

constexpr Nanoseconds kBurst = std::chrono::milliseconds(10);
constexpr std::size_t kJoints = 0, kPose = 1;  // series

bool isOn(const Path& carrier, const PathView& path) {
  return path.first == carrier.first && path.second == carrier.second &&
         path.is_layer == carrier.is_layer;
}

/// True for a pose in another space than `state` has it.
bool isCarriedAnew(const SessionState& state, const Statement& pose) {
  const DeviceState* const found = state.findDevice(pose.name);
  return !isOn(found != nullptr && found->pose ? found->pose->value.carrier : Path(), pose.carrier);
}

bool isAbsent(const DeviceState* state) {
  return state == nullptr ||
         (state->presence && state->presence->value.presence == Presence::removed);
}

}  // namespace

TrackRecorder::TrackRecorder(const Cell& cell, SessionTrack& track,
                             const std::vector<std::string>& links)
    : cell_(cell), track_(track), links_(links) {
  for (const CellDevice& device : cell.devices) {
    if (const Model* model = cell.modelOf(device)) recording(device.name, model);
  }
}

void TrackRecorder::begin(SessionState state) {
  state_ = std::move(state);
  counts_before_ = state_.counts();
  std::vector<std::string> names;
  for (const auto& [name, device] : state_.devices()) names.push_back(name);
  for (const std::string& name : names) addDevice(name, track_.start);
  numbers_.begin(state_, track_.start);
  facts_are_restated_ = true;
  noteFacts(track_.start);
}

void TrackRecorder::add(LogTime time, const Packet& packet) {
  // Packets of one burst, such as the parts of a long line, are one change.
  if (facts_due_ && time - *facts_due_ >= kBurst) noteFacts(*facts_due_);
  touched_.clear();
  says_facts_ = false;
  if (packet.header.part) sayFact();
  for (const Statement& statement : packet.statements) read(statement);
  const Applied applied = foldPacket(state_, time, packet, &track_.events);
  for (Recording* device : touched_) {
    if (applied == Applied::yes) keep(*device, time, packet.header.restated);
    device->is_touched = device->says_presence = false;
    device->says_joints = device->says_pose = device->says_all_joints = false;
    device->says_values.clear();
  }
  if (applied != Applied::yes) {
    new_names_.clear();
    numbers_.drop();
    return;
  }
  if (numbers_.keep(state_, time, packet.header.restated)) says_facts_ = true;
  for (const std::string& name : std::exchange(new_names_, {})) addDevice(name, time);
  if (!says_facts_) return;
  const bool is_of_signals = !facts_due_ && !looks_everywhere_;
  facts_are_restated_ = packet.header.restated && (!facts_due_ || facts_are_restated_);
  if (!facts_due_) facts_due_ = time;
  if (is_of_signals) noteFacts(time);  // each packet says its own
}

Status TrackRecorder::finish() {
  if (facts_due_) noteFacts(*facts_due_);
  unfit_.leaveOutUnread(state_.counts(), counts_before_);
  numbers_.finish(track_.left_out);
  for (auto& [name, device] : recordings_) {
    for (const std::size_t series : {kJoints, kPose}) store(device, series);
    keepStated(device);
  }
  auto samples = store_.finish();
  if (!samples.ok()) return samples.error();
  track_.samples = std::move(*samples);
  std::erase_if(track_.events, [](const Event& event) { return event.source.empty(); });
  return {};
}

void TrackRecorder::read(const Statement& statement) {
  numbers_.read(statement);
  switch (statement.kind) {
    case StatementKind::joints:
    case StatementKind::joint:
    case StatementKind::order:
      if (Recording* device = touched(statement.name)) {
        device->says_joints = device->says_joints || statement.kind != StatementKind::order;
        if (statement.kind == StatementKind::joints) {
          device->says_all_joints = true;
        } else if (statement.kind == StatementKind::joint) {
          device->says_values.insert(device->says_values.end(), statement.names.begin(),
                                     statement.names.end());
        }
      }
      break;
    case StatementKind::pose:
      looks_everywhere_ = looks_everywhere_ || isCarriedAnew(state_, statement);
      if (Recording* device = touched(statement.name)) {
        device->says_pose = true;
        const PathView& on = statement.carrier;
        if (!isOn(device->carrier, on)) {
          device->carrier = {on.is_layer, std::string(on.first), std::string(on.second)};
          says_facts_ = true;
        }
      } else {
        says_facts_ = true;
      }
      break;
    case StatementKind::add:
    case StatementKind::remove:
      if (Recording* device = touched(statement.name)) {
        device->says_presence = device->says_pose = true;
        device->says_joints = device->says_all_joints = true;
      }
      sayFact();
      break;
    default:
      if (isOfPath(statement.kind) || isDrawing(statement.kind) ||
          statement.kind == StatementKind::erase) {
        sayFact();
      }
  }
}

TrackRecorder::Recording& TrackRecorder::recording(const std::string& name, const Model* model) {
  Recording& made = recordings_[name];
  made.name = name;
  made.model = model;
  made.track = &track_.devices[name];
  made.track->columns = columnsOf(*model);
  made.track->series.resize(2);
  for (TrackColumn& column : made.track->columns) {
    if (!column.part.empty()) {
      made.track->series[kJoints].width += column.width();
      continue;
    }
    column.series = kPose;
    column.offset = 0;
  }
  made.joint_columns = made.track->series[kJoints].width;
  made.stated_values.resize(made.joint_columns);
  made.track->series[kPose].width = 7;
  made.has_mimics = std::ranges::any_of(model->joints,
                                        [](const Joint& joint) { return joint.mimic.has_value(); });
  made.links = LinkPlacer::of(name, *model, links_);
  if (made.links) made.links->addColumns(*made.track, kJoints);
  return made;
}

const Model* TrackRecorder::modelOf(std::string_view name) const {
  const DeviceState* state = state_.findDevice(name);
  if (state != nullptr && state->presence && state->presence->value.presence == Presence::added &&
      !state->presence->value.model.empty()) {
    const auto model = cell_.models.find(state->presence->value.model);
    if (model != cell_.models.end()) return model->second.get();
  }
  const CellDevice* device = cell_.findDevice(name);
  return device == nullptr ? nullptr : cell_.modelOf(*device);
}

TrackRecorder::Recording* TrackRecorder::touched(std::string_view name) {
  if (last_touched_ == nullptr || last_touched_->name != name) {
    const auto found = recordings_.find(name);
    if (found == recordings_.end()) {
      new_names_.emplace_back(name);
      return nullptr;
    }
    last_touched_ = &found->second;
  }
  if (!last_touched_->is_touched) touched_.push_back(last_touched_);
  last_touched_->is_touched = true;
  return last_touched_;
}

/// One that only packets brought, or that was there before the first packet.
void TrackRecorder::addDevice(const std::string& name, LogTime time) {
  auto found = recordings_.find(name);
  if (found == recordings_.end()) {
    const Model* model = modelOf(name);
    if (model == nullptr) {
      const bool is_of_cell = cell_.findDevice(name) != nullptr;
      unfit_.leaveOut(is_of_cell ? kUnreadModel : "device", name,
                      is_of_cell ? "its model could not be read" : "the cell has no such device",
                      time);
      return;
    }
    recording(name, model);
    found = recordings_.find(name);
  }
  found->second.says_joints = found->second.says_all_joints = true;
  keep(found->second, time, false);
  found->second.says_joints = found->second.says_all_joints = false;
}

void TrackRecorder::keep(Recording& device, LogTime time, bool is_restated) {
  // Packets that are restated for late joiners do not count in the device's rate.
  const auto bin =
      static_cast<std::size_t>(std::max<std::int64_t>(0, (time - track_.start) / kCountBin));
  if (!is_restated) {
    if (device.track->updates.size() <= bin) device.track->updates.resize(bin + 1);
    ++device.track->updates[bin];
  }
  const DeviceState* const state = state_.findDevice(device.name);
  const bool is_first = !std::exchange(device.is_stated, true);
  if (device.says_presence || is_first) {
    device.has_its_model = modelOf(device.name) == device.model;
  }
  if (device.says_joints || is_first) addJoints(device, state, time);
  if (device.says_pose || is_first) addPose(device, state, time);
}

double* TrackRecorder::nextRow(Recording& device, std::size_t series, LogTime time) {
  Pending& pending = device.pending[series];
  if (pending.rows == kBlockRows) store(device, series);
  const std::size_t width = device.track->series[series].width + 1;
  pending.numbers.resize((pending.rows + 1) * width, kUnstated);
  double* const row = pending.numbers.data() + pending.rows * width;
  ++pending.rows;
  *row = std::bit_cast<double>((time - track_.start).count());
  return row + 1;
}

void TrackRecorder::addJoints(Recording& device, const DeviceState* state, LogTime time) {
  if (device.joint_columns == 0) return;
  double* const row = nextRow(device, kJoints, time);
  if (isAbsent(state) || !device.has_its_model || !takesJoints(device, *state)) return;
  if (!device.has_mimics && !state->joints) {
    namedValues(device, *state, row);
  } else {
    // Columns have the values' order.
    const JointVector joints = jointsOf(*device.model, state);
    std::copy_n(joints.values.begin(), device.joint_columns, row);
  }
  if (device.links) device.links->place(row, row + device.joint_columns);
  const bool is_first = device.track->series[kJoints].rows + device.pending[kJoints].rows == 1;
  if (!is_first && !device.says_all_joints) leaveOutUnstated(device, row);
}

bool TrackRecorder::takesJoints(Recording& device, const DeviceState& state) {
  if (state.joints) {
    if (!unfit_.takesValues(device.name, *device.model, state)) return false;
    if (state.joints->value.size() == device.model->positionalCount()) {
      std::fill(device.stated_values.begin(), device.stated_values.end(), true);
      return true;
    }
    const JointVector zero = zeroJoints(*device.model);
    for (const auto& [name, item] : state.named_joints) {
      const auto place = device.model->findJointValue(name);
      if (!place) continue;
      device.stated_values[zero.first_value[place->joint] + place->component] = true;
    }
    return true;
  }
  // Names are looked up once, not for each packet.
  bool is_known = state.named_joints.size() == device.named.size();
  auto known = device.named.begin();
  for (auto it = state.named_joints.begin(); is_known && it != state.named_joints.end(); ++it) {
    is_known = it->first == (known++)->name;
  }
  if (!is_known) {
    device.named.clear();
    const JointVector zero = zeroJoints(*device.model);
    for (const auto& [name, item] : state.named_joints) {
      NamedValue& value = device.named.emplace_back(NamedValue{name, {}});
      if (const auto place = device.model->findJointValue(name)) {
        value.column = zero.first_value[place->joint] + place->component;
        device.stated_values[*value.column] = true;
      }
    }
    unfit_.takesValues(device.name, *device.model, state);
  }
  return std::ranges::any_of(device.named,
                             [](const NamedValue& value) { return value.column.has_value(); });
}

void TrackRecorder::namedValues(Recording& device, const DeviceState& state, double* row) {
  const bool is_whole = device.named.size() == device.joint_columns;
  if (!is_whole) {
    const JointVector zero = zeroJoints(*device.model);
    std::copy_n(zero.values.begin(), device.joint_columns, row);
  }
  auto known = device.named.begin();
  for (const auto& [name, item] : state.named_joints) {
    if (known->column) row[*known->column] = item.value;
    ++known;
  }
}

/// What this packet does not state stays between the packets that do, for interpolation.
void TrackRecorder::leaveOutUnstated(const Recording& device, double* row) const {
  if (device.has_mimics || device.says_values.size() >= device.joint_columns) return;
  for (const NamedValue& value : device.named) {
    if (!value.column ||
        std::ranges::find(device.says_values, value.name) != device.says_values.end()) {
      continue;
    }
    row[*value.column] = kNotHere;
  }
}

void TrackRecorder::addPose(Recording& device, const DeviceState* state, LogTime time) {
  double* const row = nextRow(device, kPose, time);
  if (isAbsent(state)) return;
  Pose stated;
  if (state->pose) {
    device.is_pose_stated = true;
    stated = state->pose->value.pose;
  } else if (const CellDevice* of_cell = cell_.findDevice(device.name)) {
    stated = of_cell->pose;
  }
  const Quat& turn = stated.orientation;
  const double numbers[] = {
      stated.position.x, stated.position.y, stated.position.z, turn.x, turn.y, turn.z, turn.w};
  std::copy(std::begin(numbers), std::end(numbers), row);
}

/// Rows become columns: what is judged together lies together.
void TrackRecorder::store(Recording& device, std::size_t series) {
  Pending& pending = device.pending[series];
  if (pending.rows == 0) return;
  TrackSeries& its = device.track->series[series];
  const std::size_t width = its.width + 1;
  block_.resize(pending.rows * width);
  for (std::size_t row = 0; row < pending.rows; ++row) {
    for (std::size_t column = 0; column < width; ++column) {
      block_[column * pending.rows + row] = pending.numbers[row * width + column];
    }
  }
  for (TrackColumn& column : device.track->columns) {
    if (column.series != series || column.is_stated) continue;
    const double* const values = block_.data() + (column.offset + 1) * pending.rows;
    column.is_stated = std::any_of(values, values + pending.rows,
                                   [](double value) { return std::isfinite(value); });
  }
  its.blocks.push_back(store_.size());
  its.rows += pending.rows;
  store_.append(std::as_bytes(std::span(block_)));
  pending.rows = 0;
  pending.numbers.clear();
}

/// What the model or the cell has where no packet states anything is compared, but is no item.
void TrackRecorder::keepStated(Recording& device) const {
  const JointVector zero = zeroJoints(*device.model);
  const std::vector<Joint>& joints = device.model->joints;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    std::size_t driver = i;
    for (std::size_t k = 0; k < joints.size() && joints[driver].mimic; ++k) {
      driver = joints[driver].mimic->joint;
    }
    if (driver == i || valueCount(joints[i].type) == 0 || valueCount(joints[driver].type) == 0) {
      continue;
    }
    if (device.stated_values[zero.first_value[driver]]) {
      device.stated_values[zero.first_value[i]] = true;
    }
  }
  for (TrackColumn& column : device.track->columns) {
    if (column.kind == TrackColumn::Kind::link_pose) continue;
    const auto first = device.stated_values.begin() + static_cast<std::ptrdiff_t>(column.offset);
    const bool is_stated =
        column.series == kPose
            ? device.is_pose_stated
            : std::any_of(first, first + static_cast<std::ptrdiff_t>(column.width()),
                          [](bool value) { return value; });
    column.is_stated = column.is_stated && is_stated;
  }
}

void TrackRecorder::noteFacts(LogTime time) {
  facts_due_.reset();
  const auto changed = numbers_.takeChanged(state_);
  if (std::exchange(looks_everywhere_, false) || !changed) {
    facts_.note(state_, time, facts_are_restated_);
  } else {
    facts_.note(*changed, time, facts_are_restated_);
  }
}

}  // namespace rocinante
