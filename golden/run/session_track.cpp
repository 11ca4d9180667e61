#include "golden/run/session_track.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/cell/posed_scene.h"
#include "core/kinematics/joint_values.h"
#include "core/log/log_reader.h"
#include "core/session/message_folder.h"
#include "core/session/timeline.h"
#include "golden/run/fact_recorder.h"
#include "golden/run/link_tracks.h"
#include "golden/run/track_columns.h"
#include "golden/run/unfit_values.h"

namespace rocinante {
namespace {

constexpr Nanoseconds kFinestStep = std::chrono::milliseconds(20);
/// Of all tracks that are judged together: 400 MB.
constexpr std::int64_t kMaxNumbers = 50'000'000;
constexpr Nanoseconds kBurst = std::chrono::milliseconds(10);
constexpr double kUnstated = std::numeric_limits<double>::quiet_NaN();

class TrackRecorder {
 public:
  TrackRecorder(const Cell& cell, SessionTrack& track)
      : cell_(cell), track_(track), facts_(track.facts) {
    for (const CellDevice& device : cell.devices) {
      if (const Model* model = cell.modelOf(device)) recording(device.name, model);
    }
  }

  void begin(SessionState state) {
    state_ = std::move(state);
    for (auto& [name, device] : recordings_) {
      if (state_.findDevice(name) == nullptr) continue;
      device.last = track_.start;
      device.is_stated = true;
    }
    for (const auto& [name, said] : state_.devices()) {
      if (!recordings_.contains(name)) touch(name, track_.start, true);
    }
    noteFacts(track_.start);
  }

  /// The next packet in log order.
  void add(LogTime time, const Packet& packet) {
    // Packets of one burst, such as the parts of a long line, are one change.
    if (facts_due_ && time - *facts_due_ >= kBurst) noteFacts(*facts_due_);
    touched_.clear();
    bool says_facts = packet.header.part.has_value();
    for (const Statement& statement : packet.statements) {
      switch (statement.kind) {
        case StatementKind::joints:
        case StatementKind::joint:
        case StatementKind::pose:
        case StatementKind::order:
          noteTouched(statement.name);
          break;
        case StatementKind::add:
        case StatementKind::remove:
          noteTouched(statement.name);
          says_facts = true;
          break;
        case StatementKind::event:
        case StatementKind::view:
        case StatementKind::seen:
          break;
        default:
          says_facts = true;
          break;
      }
    }
    for (Recording* device : touched_) keepBefore(*device, time);
    const Applied applied = foldPacket(state_, time, packet, &track_.events);
    if (applied != Applied::yes) return;
    for (Recording* device : touched_) update(*device, time, packet.header.restated);
    if (!facts_due_ && (says_facts || !new_names_.empty())) facts_due_ = time;
  }

  void finish() {
    if (facts_due_) noteFacts(*facts_due_);
    for (auto& [name, device] : recordings_) {
      hold(device, track_.samples);
      device.track->updates.resize(track_.samples);
      device.carriers.resize(track_.samples);
    }
    std::vector<CarriedTrack> carried;
    for (auto& [name, device] : recordings_) {
      carried.push_back({name, device.model, device.track, &device.carriers});
    }
    addLinkTracks(carried, carrier_names_, track_.samples);
    for (auto& [name, device] : track_.devices) dropConstantRows(device);
    std::erase_if(track_.events, [](const Event& event) { return event.source.empty(); });
  }

 private:
  struct Recording {
    std::string name;
    const Model* model = nullptr;
    DeviceTrack* track = nullptr;
    std::size_t own_columns = 0;
    std::size_t filled = 0;  ///< samples that are known
    LogTime last{};          ///< of its last packet
    bool is_stated = false;
    std::vector<double> before, after;  ///< rows around the packet that is being folded
    std::size_t carrier_before = 0;
    bool has_before = false;
    std::vector<std::uint16_t> carriers;  ///< by sample: place in carrier_names_
  };

  LogTime timeOf(std::size_t sample) const {
    return track_.start + track_.step * static_cast<std::int64_t>(sample);
  }

  Recording& recording(const std::string& name, const Model* model) {
    Recording& made = recordings_[name];
    made.name = name;
    made.model = model;
    made.track = &track_.devices[name];
    made.track->columns = columnsOf(*model);
    for (const TrackColumn& column : made.track->columns) made.track->width += column.width();
    made.own_columns = made.track->columns.size();
    made.track->updates.reserve(track_.samples);
    return made;
  }

  const Model* modelOf(std::string_view name) const {
    const DeviceState* said = state_.findDevice(name);
    if (said != nullptr && said->presence && said->presence->value.presence == Presence::added &&
        !said->presence->value.model.empty()) {
      const auto model = cell_.models.find(said->presence->value.model);
      if (model != cell_.models.end()) return model->second.get();
    }
    const CellDevice* device = cell_.findDevice(name);
    return device == nullptr ? nullptr : cell_.modelOf(*device);
  }

  void noteTouched(std::string_view name) {
    Recording* device = nullptr;
    if (last_touched_ != nullptr && last_touched_->name == name) {
      device = last_touched_;
    } else if (const auto found = recordings_.find(name); found != recordings_.end()) {
      device = &found->second;
    } else {
      new_names_.emplace_back(name);
      return;
    }
    last_touched_ = device;
    if (std::ranges::find(touched_, device) == touched_.end()) touched_.push_back(device);
  }

  /// A device that only packets brought.
  void touch(const std::string& name, LogTime time, bool at_start) {
    const Model* model = modelOf(name);
    if (model == nullptr) {
      unfit_.leaveOut("device", name, "the cell has no such device", time);
      return;
    }
    Recording& device = recording(name, model);
    for (; !at_start && isDue(device, time); ++device.filled) {
      device.track->rows.insert(device.track->rows.end(), ownWidth(device), kUnstated);
      device.carriers.push_back(0);
    }
    device.last = time;
    device.is_stated = true;
  }

  void rowOf(const Recording& device, std::vector<double>& row, std::size_t& carrier) {
    row.assign(ownWidth(device), kUnstated);
    carrier = 0;
    const DeviceState* said = state_.findDevice(device.name);
    const bool is_removed =
        said != nullptr && said->presence && said->presence->value.presence == Presence::removed;
    if (said == nullptr || is_removed) return;
    if (modelOf(device.name) == device.model &&
        unfit_.takesValues(device.name, *device.model, *said)) {
      const JointVector joints = jointsOf(*device.model, said);
      std::size_t column = 0;
      for (std::size_t joint = 0; joint < device.model->joints.size(); ++joint) {
        const std::size_t count = valueCount(device.model->joints[joint].type);
        for (std::size_t i = 0; i < count; ++i) {
          row[column++] = joints.values[joints.first_value[joint] + i];
        }
      }
    }
    double* const pose = row.data() + row.size() - 7;
    Pose stated;
    Path on;
    if (said->pose) {
      stated = said->pose->value.pose;
      on = said->pose->value.carrier;
    } else if (const CellDevice* of_cell = cell_.findDevice(device.name)) {
      stated = of_cell->pose;
      on = {false, of_cell->on_device, of_cell->on_link};
    }
    const Quat& turn = stated.orientation;
    const double numbers[] = {
        stated.position.x, stated.position.y, stated.position.z, turn.x, turn.y, turn.z, turn.w};
    std::copy(std::begin(numbers), std::end(numbers), pose);
    carrier = carrierNumber(on);
  }
  static std::size_t ownWidth(const Recording& device) {
    const TrackColumn& last = device.track->columns[device.own_columns - 1];
    return last.offset + last.width();
  }

  std::size_t carrierNumber(const Path& path) {
    if (path.first.empty() || path.is_layer) return 0;
    for (std::size_t i = 1; i < carrier_names_.size(); ++i) {
      if (carrier_names_[i] == path) return i;
    }
    if (carrier_names_.size() >= std::numeric_limits<std::uint16_t>::max()) return 0;
    carrier_names_.push_back(path);
    return carrier_names_.size() - 1;
  }

  bool isDue(const Recording& device, LogTime time) const {
    return device.filled < track_.samples && timeOf(device.filled) < time;
  }

  void keepBefore(Recording& device, LogTime time) {
    device.has_before = isDue(device, time);
    if (device.has_before) rowOf(device, device.before, device.carrier_before);
  }

  /// Fills the samples before `time`, at which a packet stated something of the device. Packets
  /// that are restated for late joiners do not count in the device's rate.
  void update(Recording& device, LogTime time, bool restated) {
    const auto sample = static_cast<std::size_t>(std::clamp<std::int64_t>(
        (time - track_.start) / track_.step, 0, static_cast<std::int64_t>(track_.samples) - 1));
    auto& updates = device.track->updates;
    if (updates.size() <= sample) updates.resize(sample + 1);
    if (!restated && updates[sample] < std::numeric_limits<std::uint16_t>::max()) ++updates[sample];
    if (device.has_before) {
      const std::size_t width = ownWidth(device);
      std::size_t carrier = 0;
      rowOf(device, device.after, carrier);
      const bool is_smooth = device.is_stated && time - device.last <= kInterpolated &&
                             carrier == device.carrier_before;
      while (isDue(device, time)) {
        device.track->rows.resize((device.filled + 1) * width);
        double* const row = device.track->rows.data() + device.filled * width;
        if (!device.is_stated) {
          std::fill(row, row + width, kUnstated);
        } else if (is_smooth && timeOf(device.filled) > device.last) {
          const double part =
              secondsOf(timeOf(device.filled) - device.last) / secondsOf(time - device.last);
          std::copy(device.before.begin(), device.before.end(), row);
          for (const TrackColumn& column : device.track->columns) {
            interpolate(column, device.before.data() + column.offset,
                        device.after.data() + column.offset, part, row + column.offset);
          }
        } else {
          std::copy(device.before.begin(), device.before.end(), row);
        }
        device.carriers.push_back(static_cast<std::uint16_t>(device.carrier_before));
        ++device.filled;
      }
      device.has_before = false;
    }
    device.last = time;
    device.is_stated = true;
  }

  void hold(Recording& device, std::size_t until) {
    const std::size_t width = ownWidth(device);
    std::size_t carrier = 0;
    rowOf(device, device.before, carrier);
    if (!device.is_stated) std::ranges::fill(device.before, kUnstated);
    device.track->rows.reserve(until * width);
    for (; device.filled < until; ++device.filled) {
      device.track->rows.insert(device.track->rows.end(), device.before.begin(),
                                device.before.end());
      device.carriers.push_back(static_cast<std::uint16_t>(carrier));
    }
  }

  static void dropConstantRows(DeviceTrack& device) {
    const std::size_t count = device.width == 0 ? 0 : device.rows.size() / device.width;
    for (std::size_t i = 1; i < count; ++i) {
      for (std::size_t j = 0; j < device.width; ++j) {
        const double a = device.rows[j];
        const double b = device.rows[i * device.width + j];
        if (a != b && !(std::isnan(a) && std::isnan(b))) return;
      }
    }
    device.rows.resize(std::min(device.rows.size(), device.width));
    device.rows.shrink_to_fit();
  }

  void noteFacts(LogTime time) {
    facts_due_.reset();
    for (const std::string& name : std::exchange(new_names_, {})) {
      if (!recordings_.contains(name)) touch(name, time, false);
    }
    facts_.note(state_, time);
  }

  const Cell& cell_;
  SessionTrack& track_;
  SessionState state_;
  std::map<std::string, Recording, std::less<>> recordings_;
  std::vector<Recording*> touched_;
  Recording* last_touched_ = nullptr;
  std::vector<std::string> new_names_;
  std::vector<Path> carrier_names_{Path{}};  ///< the first: the world
  FactRecorder facts_;
  UnfitValues unfit_{track_};
  std::optional<LogTime> facts_due_;  ///< when something was stated that is not noted yet
};

/// Numbers that a sample of this cell takes, about.
std::size_t trackWidth(const Cell& cell) {
  std::size_t width = 1;
  for (const CellDevice& device : cell.devices) {
    const Model* model = cell.modelOf(device);
    if (model == nullptr) continue;
    width += 7 + 7 * tipLinks(*model).size();
    for (const Joint& joint : model->joints) width += valueCount(joint.type);
  }
  return width;
}

}  // namespace

const TrackColumn* DeviceTrack::find(std::string_view part, bool is_link) const {
  for (const TrackColumn& column : columns) {
    if (column.part == part && (column.kind == TrackColumn::Kind::link_pose) == is_link) {
      return &column;
    }
  }
  return nullptr;
}

Nanoseconds trackStep(const Cell& cell, const std::vector<std::filesystem::path>& logs) {
  Nanoseconds longest{0};
  for (const std::filesystem::path& log : logs) {
    const auto reader = LogReader::open(log);
    if (reader.ok()) longest = std::max(longest, reader->summary().end - reader->summary().start);
  }
  const auto width = static_cast<std::int64_t>(trackWidth(cell) * logs.size());
  const std::int64_t samples = std::max<std::int64_t>(1000, kMaxNumbers / width);
  return kFinestStep * (longest / (kFinestStep * samples) + 1);
}

Result<SessionTrack> trackSession(const Cell& cell, const std::filesystem::path& log,
                                  Nanoseconds step) {
  auto timeline = Timeline::open(log);
  if (!timeline.ok()) return timeline.error();
  const LogSummary summary = timeline->log().summary();
  if (!summary.closed) {
    return Error{ErrorKind::damaged,
                 "the log has no end, so perhaps not the whole session; `rocinante log recover` "
                 "writes a whole log of what it has",
                 log.string()};
  }
  if (summary.messages == 0) {
    return Error{ErrorKind::not_found, "the log has no message to judge", log.string()};
  }
  SessionTrack track;
  track.origin = summary.origin;
  track.start = summary.start;
  track.end = summary.end;
  track.step = step;
  track.samples = static_cast<std::size_t>((track.end - track.start) / step) + 1;
  TrackRecorder recorder(cell, track);
  const auto first = timeline->stateAt(track.start - Nanoseconds(1));
  if (!first.ok()) return first.error();
  recorder.begin(**first);
  auto reader = LogReader::open(log);
  if (!reader.ok()) return reader.error();
  if (Status found = reader->seek(track.start); !found) return found.error();
  MessageFolder folder;
  for (;;) {
    const auto message = reader->next();
    if (!message.ok()) return message.error();
    if (!*message || (*message)->log_time > track.end) break;
    if (!(*message)->channel->folded()) continue;
    if (const Packet* packet = folder.decode(**message))
      recorder.add((*message)->log_time, *packet);
  }
  if (!reader->unreadable().empty() && !reader->damage().empty()) {
    const DamageSpan& span = reader->damage().front();
    return Error{ErrorKind::damaged, "the log is damaged and was not seen whole: " + span.cause,
                 log.string() + ", byte " + std::to_string(span.from)};
  }
  recorder.finish();
  return track;
}

}  // namespace rocinante
