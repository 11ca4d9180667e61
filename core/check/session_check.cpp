#include "core/check/session_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "core/check/judges/clearance_report.h"
#include "core/packet/joint_order.h"

namespace rocinante {
namespace {

/// Most devices that are counted separately; only a hostile session has more.
constexpr std::size_t kMaxDevices = 10000;

}  // namespace

SessionCheck::SessionCheck(const Cell& cell)
    : cell_(cell),
      rules_(cell.rules),
      stream_(rules_, cell.sources),
      layers_(cell),
      signals_(cell),
      carriers_(cell),
      clearance_(cell) {
  expectDevices();
}

SessionCheck::~SessionCheck() = default;

void SessionCheck::expectDevices() {
  using Standing = DeviceJudge::Standing;
  for (const CellDevice& device : cell_.devices) {
    const Standing standing = device.optional ? Standing::optional : Standing::there;
    DeviceJudge& judge = newDevice(device.name);
    judge.appearInCell(cell_.modelOf(device), standing);
    judge.setPlace(device);
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
      devices_.emplace(std::string(name), DeviceJudge(std::string(name), rules_)).first->second;
  DeviceOwners anybody;
  anybody.bound = &bound_sources_;
  judge.setOwners(std::move(anybody));
  return judge;
}

DeviceJudge* SessionCheck::deviceNamed(std::string_view name) {
  if (DeviceJudge* const* const known = device_cache_.find(name)) return *known;
  auto found = devices_.find(name);
  if (found == devices_.end()) {
    if (devices_.size() >= kMaxDevices) return nullptr;
    newDevice(name);
    found = devices_.find(name);
  }
  device_cache_.remember(found->first, &found->second, devices_.size());
  return &found->second;
}

void SessionCheck::add(LogTime time, std::string_view encoding, bool captured, ByteView datagram,
                       std::string_view sender) {
  log_.takeTime(time);
  StreamJudge::Judged judged = stream_.add(time, encoding, captured, datagram, sender);
  stream_.takeEvents();
  if (judged.source == nullptr) return;
  clearance_.take(time, *judged.packet, stream_.state());
  for (const Statement& statement : judged.packet->statements) {
    judged.place.line = statement.line;
    judge(statement, *judged.source, judged.place);
  }
}

void SessionCheck::judge(const Statement& statement, SourceJudge& source,
                         const PacketPlace& place) {
  source.takeStatement(statement, place);
  if (!statement.carrier.first.empty()) judgePath(statement.carrier, place);
  if (isOfPath(statement.kind)) return judgePath(statement.path, place);
  if (isSignal(statement.kind)) {
    if (!statement.path.first.empty()) judgePath(statement.path, place);
    return signals_.take(statement, place);
  }
  if (isOfDevice(statement.kind) || statement.kind == StatementKind::seen) {
    judgeOfDevice(statement, source, place);
  }
}

void SessionCheck::judgeOfDevice(const Statement& statement, SourceJudge& source,
                                 const PacketPlace& place) {
  DeviceJudge* const device = deviceNamed(statement.name);
  if (device == nullptr) return;
  if (statement.kind == StatementKind::add) return judgeAdd(statement, *device, place);
  if (statement.kind == StatementKind::remove) {
    signals_.forget(statement.name);
    return device->disappear(place);
  }
  device->mention(place);
  signals_.takeMotion(statement, place);
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
      if (!statement.carrier.first.empty()) {
        carriers_.judge(statement.name, stream_.state(), place);
      }
      return device->judgePose(statement, place);
    default:
      return;
  }
}

void SessionCheck::judgeJoints(const Statement& statement, const SourceJudge& source,
                               DeviceJudge& device, const PacketPlace& place) {
  // An order may have been forgotten since it was given: by `remove`, or a restatement without it.
  const JointsMeaning meaning =
      meaningOfJoints(stream_.state().findDevice(statement.name), source.name(), statement);
  if (meaning.fault == PacketFault::unknown_order) {
    const FaultAt fault{PacketFault::unknown_order, statement.line, 0};
    return stream_.takeFaults({&fault, 1}, place);
  }
  const bool ordered = device.hasOrderOf(source.number()) && meaning.names != nullptr;
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
  const auto& devices = stream_.state().devices();
  const auto found = devices.find(statement.name);
  if (found == devices.end()) return;
  const DeviceState& earlier = found->second;
  PacketPlace then = place;
  then.is_restated = true;
  if (earlier.joints) {
    then.source = stream_.sourceNamed(earlier.joints->owner).number();
    device.judgeJoints(earlier.joints->value, false, then);
  }
  for (const auto& [joint, item] : earlier.named_joints) {
    then.source = stream_.sourceNamed(item.owner).number();
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

void SessionCheck::dropFindings() {
  stream_.dropFindings();
  layers_.dropFindings();
  signals_.dropFindings();
  carriers_.dropFindings();
  log_.dropFindings();
  clearance_.dropFindings();
  device_cache_.clear();
  for (auto each = devices_.begin(); each != devices_.end();) {
    each->second.dropFindings();
    // An order that the state still holds says what later values mean.
    const DeviceState* const found = stream_.state().findDevice(each->first);
    const bool is_over = each->second.isStray() && (found == nullptr || found->orders.empty());
    each = is_over ? devices_.erase(each) : std::next(each);
  }
}

void SessionCheck::finish(CheckReport& report) const {
  report.datagrams = stream_.datagrams();
  report.packets = stream_.packets();
  report.sources = stream_.sourceNames();
  std::sort(report.sources.begin(), report.sources.end());
  std::set<std::string, std::less<>> missing;
  for (const CellSource& source : cell_.sources) {
    if (!stream_.hasSource(source.name)) missing.insert(source.name);
  }
  std::vector<std::string_view> devices;
  for (const CellDevice& device : cell_.devices) devices.push_back(device.name);
  const SessionRoster roster{stream_.sourceNames(), missing, devices};
  stream_.reportDatagrams(report.findings);
  layers_.report(report.findings);
  signals_.report(stream_.sourceNames(), report.findings);
  carriers_.report(report.findings);
  for (const auto& [name, device] : devices_) device.report(roster, report.findings);
  stream_.reportSources(stream_.end(), report.findings);
  reportMissing(roster, report.findings);
  log_.report(report.findings);
  reportClearances(cell_, clearance_.judge(), report.clearances, report.findings);
}

void SessionCheck::reportMissing(const SessionRoster& roster, Findings& findings) const {
  for (const CellSource& source : cell_.sources) {
    if (!roster.missing.contains(source.name)) continue;
    // A device that no source drives reports that itself.
    std::string instead;
    bool is_reported = false;
    for (const std::string& name : source.devices) {
      const auto device = devices_.find(name);
      if (device == devices_.end()) continue;
      is_reported = is_reported || device->second.isUndriven();
      if (instead.empty()) instead = device->second.stranger();
    }
    if (is_reported) continue;
    std::string text =
        fmt::format("the cell expects source {}, which never sent a packet", source.name);
    if (!instead.empty()) text += fmt::format("; {} writes its devices", instead);
    findings.push_back(makeFinding("source.missing", source.name, std::move(text)));
    if (!instead.empty()) findings.back().hint = "one of the two uses another name for it";
  }
}

}  // namespace rocinante
