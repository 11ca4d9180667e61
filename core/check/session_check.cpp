#include "core/check/session_check.h"

#include <fmt/format.h>

#include <algorithm>

namespace rocinante {
namespace {

/// Most devices that are counted separately; only a hostile session has more.
constexpr std::size_t kMaxDevices = 10000;

bool isStatic(StatementKind kind) {
  switch (kind) {
    case StatementKind::joints:
    case StatementKind::joint:
    case StatementKind::pose:
    case StatementKind::event:
    case StatementKind::seen:
      return false;
    default:
      return true;
  }
}

}  // namespace

SessionCheck::SessionCheck(const Cell& cell) : cell_(cell), rules_(cell.rules), layers_(cell) {
  motion_.velocity_factor = rules_.threshold("joint.velocity");
  motion_.acceleration = rules_.threshold("joint.acceleration");
  expectDevices();
}

SessionCheck::~SessionCheck() = default;

void SessionCheck::expectDevices() {
  using Standing = DeviceJudge::Standing;
  for (const CellDevice& device : cell_.devices) {
    const Standing standing = device.optional ? Standing::optional : Standing::there;
    newDevice(device.name).appearInCell(cell_.modelOf(device), standing);
  }
  ByName<DeviceOwners> owners;
  for (const CellSource& source : cell_.sources) {
    if (!source.devices.empty()) bound_sources_.insert(source.name);
    for (const std::string& device : source.devices) owners[device].names.push_back(source.name);
    // A ghost is known to the cell, but drawn only when its source speaks.
    for (const auto& [ghost, original] : source.ghost_of) {
      if (!source.devices.empty()) owners[ghost].names.push_back(source.name);
      const CellDevice* device = cell_.findDevice(original);
      if (device == nullptr || devices_.contains(ghost)) continue;
      newDevice(ghost).appearInCell(cell_.modelOf(*device), Standing::ghost);
    }
  }
  for (auto& [name, judge] : devices_) {
    DeviceOwners own = std::move(owners[name]);
    own.bound = &bound_sources_;
    judge.setOwners(std::move(own));
  }
}

DeviceJudge& SessionCheck::newDevice(std::string_view name) {
  DeviceJudge& judge =
      devices_.emplace(std::string(name), DeviceJudge(std::string(name), motion_)).first->second;
  DeviceOwners anybody;
  anybody.bound = &bound_sources_;
  judge.setOwners(std::move(anybody));
  return judge;
}

Decoder* SessionCheck::decoderFor(std::string_view encoding) {
  if (Decoder* const* const known = decoder_cache_.find(encoding)) return *known;
  auto found = decoders_.find(encoding);
  if (found == decoders_.end()) {
    found = decoders_.emplace(std::string(encoding), makeDecoder(encoding)).first;
  }
  decoder_cache_.remember(found->first, found->second.get());
  return found->second.get();
}

SessionCheck::Source& SessionCheck::sourceNamed(std::string_view name) {
  if (Source* const* const known = source_cache_.find(name)) return **known;
  auto found = sources_.find(name);
  if (found == sources_.end()) {
    const auto listed = std::find_if(cell_.sources.begin(), cell_.sources.end(),
                                     [&](const CellSource& source) { return source.name == name; });
    const CellSource* const expected = listed == cell_.sources.end() ? nullptr : &*listed;
    const auto number = static_cast<std::uint32_t>(source_names_.size());
    source_names_.emplace_back(name);
    SourceJudge judge(source_names_.back(), number, SourceThresholds::of(rules_, expected));
    const SourceCounts& counts = state_.counts().find(name)->second;
    found = sources_.emplace(source_names_.back(), Source{std::move(judge), &counts}).first;
  }
  source_cache_.remember(found->first, &found->second);
  return found->second;
}

DeviceJudge* SessionCheck::deviceNamed(std::string_view name) {
  if (DeviceJudge* const* const known = device_cache_.find(name)) return *known;
  auto found = devices_.find(name);
  if (found == devices_.end()) {
    if (devices_.size() >= kMaxDevices) return nullptr;
    newDevice(name);
    found = devices_.find(name);
  }
  device_cache_.remember(found->first, &found->second);
  return &found->second;
}

void SessionCheck::add(LogTime time, std::string_view encoding, bool captured, ByteView datagram) {
  if (captured) ++datagrams_;
  end_ = std::max(end_, time);
  PacketPlace place;
  place.time = time;
  place.packet = datagrams_;
  place.datagram = datagram;
  Decoder* const decoder = decoderFor(encoding);
  if (decoder == nullptr) {
    faults_.takeUndecoded(encoding, place);
    return;
  }
  const Packet* const packet = decoder->decode(datagram);
  if (!decoder->faults().empty()) faults_.takeFaults(decoder->faults(), place);
  if (packet == nullptr) return;
  if (captured) ++packets_;

  const std::uint64_t relay_gap_before =
      packet->header.via ? relayGap(packet->header.via->relay) : 0;
  const Applied applied = state_.apply(time, *packet);
  state_.takeEvents();
  if (applied == Applied::refused) {
    refused_.hit(place);
    return;
  }
  if (packet->header.via && relayGap(packet->header.via->relay) > relay_gap_before) {
    relay_gap_.hit(place);
  }
  Source& source = sourceNamed(packet->header.source);
  place.line = 1;
  place.sequence = packet->header.sequence.value_or(0);
  source.judge.take(packet->header, applied, *source.counts, place);
  // A late packet is dropped whole and has no effect.
  if (applied == Applied::late) return;
  for (const Statement& statement : packet->statements) {
    place.line = statement.line;
    judge(statement, source.judge, place);
  }
}

std::uint64_t SessionCheck::relayGap(std::string_view relay) const {
  const auto found = state_.relays().find(relay);
  return found == state_.relays().end() ? 0 : found->second.gap;
}

void SessionCheck::judge(const Statement& statement, SourceJudge& source,
                         const PacketPlace& place) {
  if (isStatic(statement.kind)) source.takeStatic(place);
  if (!statement.carrier.first.empty()) judgePath(statement.carrier, place);
  switch (statement.kind) {
    case StatementKind::show:
    case StatementKind::hide:
    case StatementKind::color:
      return judgePath(statement.path, place);
    case StatementKind::line:
    case StatementKind::points:
    case StatementKind::label:
    case StatementKind::erase:
    case StatementKind::event:
    case StatementKind::view:
      return;
    default:
      return judgeOfDevice(statement, source, place);
  }
}

void SessionCheck::judgeOfDevice(const Statement& statement, SourceJudge& source,
                                 const PacketPlace& place) {
  DeviceJudge* const device = deviceNamed(statement.name);
  if (device == nullptr) return;
  if (statement.kind == StatementKind::add) return judgeAdd(statement, *device, place);
  if (statement.kind == StatementKind::remove) return device->disappear(place);
  device->mention(place);
  switch (statement.kind) {
    case StatementKind::joints:
      device->writtenBy(source.name(), place);
      return judgeJoints(statement, source, *device, place);
    case StatementKind::joint:
      device->writtenBy(source.name(), place);
      return device->judgeNamed(statement.names, statement.numbers, place);
    case StatementKind::order:
      return device->judgeOrder(statement.names, place);
    case StatementKind::pose:
      device->writtenBy(source.name(), place);
      return device->judgePose(place);
    default:
      return;
  }
}

void SessionCheck::judgeJoints(const Statement& statement, const SourceJudge& source,
                               DeviceJudge& device, const PacketPlace& place) {
  // An order may have been forgotten since it was given: by `remove`, or a restatement without it.
  const bool ordered = device.hasOrderOf(source.number()) && [&] {
    const DeviceState* const said = state_.findDevice(statement.name);
    return said != nullptr && said->orders.contains(source.name());
  }();
  device.judgeJoints(statement.numbers, ordered, place);
}

void SessionCheck::judgeAdd(const Statement& statement, DeviceJudge& device,
                            const PacketPlace& place) {
  const auto known = cell_.models.find(std::string(statement.text));
  const Model* model = known == cell_.models.end() ? nullptr : known->second.get();
  const bool had_model = device.hasModel();
  device.appearByAdd(model, statement, place);
  if (had_model) return;
  // Values sent before the device had a model are kept and count from now on.
  const auto said = state_.devices().find(statement.name);
  if (said == state_.devices().end()) return;
  const DeviceState& earlier = said->second;
  PacketPlace then = place;
  then.is_restated = true;
  if (earlier.joints) {
    then.source = sourceNamed(earlier.joints->owner).judge.number();
    device.judgeJoints(earlier.joints->value, false, then);
  }
  for (const auto& [joint, item] : earlier.named_joints) {
    then.source = sourceNamed(item.owner).judge.number();
    device.judgeEarlier(joint, item.value, then);
  }
}

void SessionCheck::judgePath(const PathView& path, const PacketPlace& place) {
  if (path.is_layer) return layers_.judge(path.second, place);
  DeviceJudge* const device = deviceNamed(path.first);
  if (device == nullptr) return;
  device->mention(place);
  device->judgeLink(path.second, place);
}

void SessionCheck::finish(CheckReport& report) const {
  report.datagrams = datagrams_;
  report.packets = packets_;
  report.sources = source_names_;
  std::sort(report.sources.begin(), report.sources.end());
  std::set<std::string, std::less<>> missing;
  for (const CellSource& source : cell_.sources) {
    if (!sources_.contains(source.name)) missing.insert(source.name);
  }
  std::vector<std::string_view> devices;
  for (const CellDevice& device : cell_.devices) devices.push_back(device.name);
  const SessionRoster roster{source_names_, missing, devices};
  faults_.report(report.findings);
  layers_.report(report.findings);
  for (const auto& [name, device] : devices_) device.report(roster, report.findings);
  reportSources(roster, report.findings);
  log_.report(report.findings);
}

void SessionCheck::reportSources(const SessionRoster& roster,
                                 std::vector<Finding>& findings) const {
  for (const auto& [name, source] : sources_) source.judge.report(end_, findings);
  if (refused_.count > 0) {
    findings.push_back(
        refused_.finding("source.refused", "", "packets of more sources than the limit allows"));
  }
  std::uint64_t relay_gap = 0;
  for (const auto& [relay, counts] : state_.relays()) relay_gap += counts.gap;
  if (relay_gap > 0) {
    findings.push_back(
        relay_gap_.finding("source.relay-gap", "",
                           "packets that a relay sent on, by its own count, and that never "
                           "arrived"));
    findings.back().count = relay_gap;
  }
  reportMissing(roster, findings);
}

void SessionCheck::reportMissing(const SessionRoster& roster,
                                 std::vector<Finding>& findings) const {
  for (const CellSource& source : cell_.sources) {
    if (!roster.missing.contains(source.name)) continue;
    // A device that no source drives reports that itself.
    std::string instead;
    bool is_told = false;
    for (const std::string& name : source.devices) {
      const auto device = devices_.find(name);
      if (device == devices_.end()) continue;
      is_told = is_told || device->second.isUndriven();
      if (instead.empty()) instead = device->second.stranger();
    }
    if (is_told) continue;
    std::string text =
        fmt::format("the cell expects source {}, which never sent a packet", source.name);
    if (!instead.empty()) text += fmt::format("; {} writes its devices", instead);
    findings.push_back(makeFinding("source.missing", source.name, std::move(text)));
    if (!instead.empty()) findings.back().hint = "one of the two uses another name for it";
  }
}

}  // namespace rocinante
