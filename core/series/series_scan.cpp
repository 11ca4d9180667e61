#include "core/series/series_scan.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/packet/joint_order.h"
#include "core/series/placed_links.h"
#include "core/session/keyframe.h"

namespace rocinante {
namespace {

constexpr std::size_t kCountBins = 4096;

/// Derived values need those that they are made of.
std::optional<std::set<SeriesKey>> withStated(const std::optional<std::set<SeriesKey>>& only) {
  if (!only) return std::nullopt;
  std::set<SeriesKey> all = *only;
  for (const SeriesKey& key : *only) {
    for (SeriesKey& stated : statedOf(key)) all.insert(std::move(stated));
  }
  return all;
}

}  // namespace

/// What is known of one device, so that a stream of its packets finds its series without names.
struct SeriesScan::Device {
  std::string name;
  bool knows_names = false;
  std::vector<std::string> names;  ///< of positional values; empty: unknown
  std::vector<SeriesId> positions;
  std::map<std::string, SeriesId, std::less<>> joints;
  std::map<std::string, std::vector<SeriesId>, std::less<>> orders;  ///< by source
  std::optional<std::array<SeriesId, 7>> pose;
  std::map<SignalName, SignalSeries, SignalOrder> signals;
  std::string last_writer;
};

/// The links that are asked for.
struct SeriesScan::Links {
  struct Part {
    std::size_t link = 0, number = 0;  ///< into poses(), and into the numbers of a pose
    SeriesId id = 0;
  };
  explicit Links(const Cell& cell) : placed(cell) {}

  PlacedLinks placed;
  std::vector<Part> parts;
  bool are_moved = true;  ///< since they were placed last
};

SeriesScan::SeriesScan(Options options)
    : options_(std::move(options)),
      store_({options_.from, options_.until, options_.max_bins, options_.max_bytes,
              withStated(options_.only)}),
      reached_(options_.from),
      all_{countBins(), countBins()} {
  const auto only = withStated(options_.only);
  if (!only) return;
  for (const SeriesKey& key : *only) {
    if (key.kind == SeriesKey::Kind::derived) store_.derive(key);
    const auto number = posePart(key.part);
    if (key.kind != SeriesKey::Kind::link || !number || options_.cell == nullptr) continue;
    if (links_ == nullptr) links_ = std::make_unique<Links>(*options_.cell);
    links_->parts.push_back({links_->placed.add(key), *number, store_.idOf(key)});
  }
}

SeriesScan::~SeriesScan() = default;

CountBins SeriesScan::countBins() const {
  return {options_.from, binWidth(options_.from, options_.until, kCountBins), kCountBins};
}

void SeriesScan::beginWith(SessionState state, LogTime at) {
  began_ = true;
  state_ = std::move(state);
  for (const auto& [name, device_state] : state_.devices()) {
    takeEverything(deviceNamed(name), at);
  }
  if (!state_.signals().empty()) takeEverything(deviceNamed({}), at);
  for (const auto& [name, counts] : state_.counts()) gaps_[name] = counts.gap;
  takeLinks(at);
  store_.settle(LogTime::min());
}

void SeriesScan::add(const LogMessage& message) {
  reached_ = message.log_time;
  if (!began_ && isKeyframeChannel(*message.channel)) {
    // A piece of a session opens with the state that precedes it.
    auto before = KeyframeReader().read(message.payload, message.log_time);
    if (before.ok()) beginWith(std::move(*before));
  }
  began_ = began_ || message.channel->folded();
  const MessageFolder::Folded folded = folder_.fold(state_, message);
  if (folded.packet == nullptr) return;
  if (message.channel->captured()) count(*folded.packet, message.log_time);
  if (!folded.applied) return;
  take(*folded.packet, message.log_time);
  store_.settle(message.log_time);
}

void SeriesScan::addLoss(const LossSpan& span) {
  const std::uint64_t lost = span.counts.kernel + span.counts.queue + span.counts.disk;
  // A log may say any number.
  constexpr std::uint64_t kMax = std::uint64_t{1} << 50U;
  all_.lost.add(span.until, static_cast<std::int64_t>(std::min(lost, kMax)));
}

void SeriesScan::count(const Packet& packet, LogTime time) {
  all_.packets.add(time);
  if (!packet.header.by.empty()) return;
  const std::string_view name = packet.header.source;
  SourceSeries* source = nullptr;
  if (SourceSeries* const* const known = source_cache_.find(name)) {
    source = *known;
  } else {
    auto found = sources_.find(name);
    if (found == sources_.end()) {
      if (sources_.size() >= kMaxSources) return;
      found = sources_.emplace(std::string(name), SourceSeries{countBins(), countBins()}).first;
    }
    source = &found->second;
    source_cache_.remember(found->first, source);
  }
  source->packets.add(time);
  const auto counted = state_.counts().find(name);
  if (counted == state_.counts().end()) return;
  auto known = gaps_.find(name);
  if (known == gaps_.end()) known = gaps_.emplace(std::string(name), 0).first;
  // Late packets fill gaps: they then count down.
  const std::uint64_t gap = counted->second.gap;
  if (gap == known->second) return;
  const auto more = static_cast<std::int64_t>(gap) - static_cast<std::int64_t>(known->second);
  known->second = gap;
  source->lost.add(time, more);
  all_.lost.add(time, more);
}

void SeriesScan::take(const Packet& packet, LogTime time) {
  for (const Statement& statement : packet.statements) {
    takeStatement(statement, packet.header.source, time);
    if (links_ != nullptr && links_->placed.isMovedBy(statement)) links_->are_moved = true;
  }
  // What a restatement leaves out may be gone.
  if (links_ != nullptr && (links_->are_moved || packet.header.restated)) takeLinks(time);
  // What a whole restatement does not say any more is gone.
  const auto& part = packet.header.part;
  if (!packet.header.restated || !part || part->index != part->count) return;
  const auto written = written_by_.find(packet.header.source);
  if (written == written_by_.end()) return;
  for (Device* const device : written->second) takeEverything(*device, time);
}

void SeriesScan::takeStatement(const Statement& statement, std::string_view source, LogTime time) {
  const bool is_signal = isSignal(statement.kind);
  if (!is_signal && !isOfDevice(statement.kind)) return;
  Device& device = deviceNamed(is_signal ? statement.path.first : statement.name);
  if (device.last_writer != source) {
    device.last_writer = source;
    written_by_[std::string(source)].insert(&device);
  }
  if (is_signal) return takeSignals(statement, device, time);
  const DeviceState* const device_state = state_.findDevice(statement.name);
  if (device_state == nullptr || statement.kind == StatementKind::remove)
    return endAll(device, time);
  switch (statement.kind) {
    case StatementKind::joints:
      return takeJoints(statement, source, device, *device_state, time);
    case StatementKind::joint:
      for (std::size_t i = 0; i < statement.names.size(); ++i) {
        store_.record(idOf(device, statement.names[i]), time, statement.numbers[i]);
      }
      return;
    case StatementKind::pose:
      for (std::size_t part = 0; part < kPoseParts.size(); ++part) {
        store_.record(poseIds(device)[part], time, statement.numbers[part]);
      }
      return;
    case StatementKind::add:
      device.knows_names = false;
      return takeEverything(device, time);
    default:  // order: another meaning from now on
      device.orders.clear();
      return;
  }
}

void SeriesScan::takeLinks(LogTime time) {
  if (links_ == nullptr) return;
  links_->are_moved = false;
  links_->placed.place(state_);
  for (const Links::Part& part : links_->parts) {
    if (const auto& pose = links_->placed.poses()[part.link]) {
      store_.record(part.id, time, poseNumbers(*pose)[part.number]);
    } else {
      store_.end(part.id, time);
    }
  }
}

void SeriesScan::takeSignals(const Statement& statement, Device& device, LogTime time) {
  for (std::size_t i = 0; i < statement.names.size(); ++i) {
    SignalSeries& signal = signalOf(device, {statement.path.second, statement.names[i]});
    if (statement.is_default) {
      signal.end(store_, time);
    } else {
      // `signals` keep the unit of a number until the kind changes.
      if (statement.kind == StatementKind::signal ||
          statement.signal_kinds[i] != SignalKind::number) {
        signal.stateUnit(statement.unit);
      }
      signal.take(store_, statement.signal_kinds[i], statement.numbers[i], statement.text, time,
                  options_.states);
    }
  }
}

void SeriesScan::takeAllSignals(Device& device, const Signals& device_state, LogTime time) {
  for (const auto& [name, item] : device_state) signalOf(device, name);
  for (auto& [name, signal] : device.signals) {
    const auto found = device_state.find(name);
    if (found == device_state.end()) {
      signal.end(store_, time);
    } else {
      const SignalValue& value = found->second.value;
      signal.stateUnit(value.unit);
      signal.take(store_, value.kind, value.number, value.text, time, options_.states);
    }
  }
}

void SeriesScan::takeJoints(const Statement& statement, std::string_view source, Device& device,
                            const DeviceState& device_state, LogTime time) {
  const JointsMeaning meaning = meaningOfJoints(&device_state, source, statement);
  if (meaning.fault) return;
  if (meaning.names != nullptr) {
    auto known = device.orders.find(source);
    if (known == device.orders.end()) {
      std::vector<SeriesId> ids;
      for (const std::string& name : *meaning.names) ids.push_back(idOf(device, name));
      known = device.orders.emplace(std::string(source), std::move(ids)).first;
    }
    for (std::size_t i = 0; i < known->second.size(); ++i) {
      store_.record(known->second[i], time, statement.numbers[i]);
    }
    return;
  }
  if (!device.knows_names) learnNames(device, device_state);
  if (device.names.empty()) {
    for (std::size_t i = device.positions.size(); i < statement.numbers.size(); ++i) {
      device.positions.push_back(idOf(device, std::to_string(i + 1)));
    }
  }
  const bool fits = device.names.empty() || device.names.size() == statement.numbers.size();
  for (std::size_t i = 0; i < device.positions.size(); ++i) {
    const SeriesId id = device.positions[i];
    // As it is drawn: as if it had none.
    if (fits && i < statement.numbers.size()) {
      store_.record(id, time, statement.numbers[i]);
    } else {
      store_.end(id, time);
    }
  }
}

void SeriesScan::learnNames(Device& device, const DeviceState& device_state) {
  device.knows_names = true;
  device.names.clear();
  device.positions.clear();
  if (options_.names) device.names = options_.names(device.name, device_state);
  for (const std::string& name : device.names) device.positions.push_back(idOf(device, name));
}

/// All values of the device, as the state has them now.
void SeriesScan::takeEverything(Device& device, LogTime time) {
  // No device has this name: these are the signals of none.
  if (device.name.empty()) return takeAllSignals(device, state_.signals(), time);
  const DeviceState* const device_state = state_.findDevice(device.name);
  if (device_state == nullptr) return endAll(device, time);
  takeAllSignals(device, device_state->signals, time);
  if (!device.knows_names) learnNames(device, *device_state);
  device.orders.clear();
  for (const auto& [name, item] : device_state->named_joints) idOf(device, name);
  if (device_state->joints && device.names.empty()) {
    for (std::size_t i = device.positions.size(); i < device_state->joints->value.size(); ++i) {
      device.positions.push_back(idOf(device, std::to_string(i + 1)));
    }
  }
  for (const auto& [name, id] : device.joints) {
    if (const auto value = jointStated(*device_state, name, device.names)) {
      store_.record(id, time, *value);
    } else {
      store_.end(id, time);
    }
  }
  if (!device_state->pose && !device.pose) return;
  for (std::size_t part = 0; part < kPoseParts.size(); ++part) {
    const SeriesId id = poseIds(device)[part];
    if (device_state->pose) {
      store_.record(id, time, poseNumbers(device_state->pose->value.pose)[part]);
    } else {
      store_.end(id, time);
    }
  }
}

void SeriesScan::endAll(Device& device, LogTime time) {
  device.orders.clear();
  device.knows_names = false;
  for (const auto& [name, id] : device.joints) store_.end(id, time);
  for (auto& [name, signal] : device.signals) signal.end(store_, time);
  if (!device.pose) return;
  for (const SeriesId id : *device.pose) store_.end(id, time);
}

SeriesScan::Device& SeriesScan::deviceNamed(std::string_view name) {
  if (Device* const* const known = device_cache_.find(name)) return **known;
  auto found = devices_.find(name);
  if (found == devices_.end()) {
    found = devices_.emplace(std::string(name), std::make_unique<Device>()).first;
    found->second->name = found->first;
  }
  device_cache_.remember(found->first, found->second.get(), devices_.size());
  return *found->second;
}

std::array<SeriesStore::Id, 7>& SeriesScan::poseIds(Device& device) {
  if (device.pose) return *device.pose;
  device.pose.emplace();
  for (std::size_t part = 0; part < kPoseParts.size(); ++part) {
    (*device.pose)[part] =
        store_.idOf(SeriesKey{SeriesKey::Kind::pose, device.name, std::string(kPoseParts[part])});
  }
  return *device.pose;
}

SeriesScan::SeriesId SeriesScan::idOf(Device& device, std::string_view joint) {
  auto found = device.joints.find(joint);
  if (found == device.joints.end()) {
    const SeriesId id =
        store_.idOf(SeriesKey{SeriesKey::Kind::joint, device.name, std::string(joint)});
    found = device.joints.emplace(std::string(joint), id).first;
  }
  return found->second;
}

std::vector<UnitSeries> SeriesScan::unitsOf(const SeriesKey& key) const {
  const auto device = devices_.find(key.name);
  if (key.kind != SeriesKey::Kind::signal || device == devices_.end()) return {};
  const auto found = device->second->signals.find(SignalNameView{key.link, key.part});
  if (found == device->second->signals.end()) return {};
  return found->second.units(store_);
}

SignalSeries& SeriesScan::signalOf(Device& device, const SignalNameView& name) {
  const auto found = device.signals.find(name);
  if (found != device.signals.end()) return found->second;
  SignalName owned{std::string(name.link), std::string(name.name)};
  SignalSeries signal(SeriesKey{SeriesKey::Kind::signal, device.name, owned.name, owned.link});
  return device.signals.emplace(std::move(owned), std::move(signal)).first->second;
}

}  // namespace rocinante
