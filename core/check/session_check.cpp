#include "core/check/session_check.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/check/fault_rules.h"

namespace rocinante {
namespace {

/// Devices and layers that are told apart; a hostile session has more, nobody reads them.
constexpr std::size_t kMostDevices = 10000;
constexpr std::size_t kMostNames = 200;

}  // namespace

SessionCheck::SessionCheck(const Cell& cell) : cell_(cell) {
  for (const CellDevice& device : cell.devices) {
    devices_.emplace(device.name, device.name)
        .first->second.appearInCell(cell.modelOf(device), device.optional);
    if (!device.layer.empty()) layers_.emplace(device.layer, true);
  }
  for (const CellLayer& layer : cell.layers) layers_.emplace(layer.name, true);
  for (const CellSource& source : cell.sources) {
    // A ghost is known to the cell, but drawn only when its source speaks.
    for (const auto& [ghost, original] : source.ghost_of) {
      const CellDevice* device = cell.findDevice(original);
      if (device != nullptr && devices_.find(ghost) == devices_.end()) {
        devices_.emplace(ghost, ghost).first->second.appearInCell(cell.modelOf(*device), true);
      }
    }
  }
}

SessionCheck::~SessionCheck() = default;

Decoder* SessionCheck::decoderFor(std::string_view encoding) {
  auto found = decoders_.find(encoding);
  if (found == decoders_.end()) {
    found = decoders_.emplace(std::string(encoding), makeDecoder(encoding)).first;
  }
  return found->second.get();
}

SessionCheck::Source& SessionCheck::sourceNamed(std::string_view name) {
  auto found = sources_.find(name);
  if (found == sources_.end()) {
    found = sources_.emplace(std::string(name), Source()).first;
    found->second.name = std::string(name);
    found->second.number = static_cast<std::uint32_t>(source_names_.size());
    source_names_.push_back(found->second.name);
  }
  if (found->second.counts == nullptr) {
    const auto counts = state_.counts().find(name);
    if (counts != state_.counts().end()) found->second.counts = &counts->second;
  }
  return found->second;
}

DeviceJudge* SessionCheck::deviceNamed(std::string_view name) {
  auto found = devices_.find(name);
  if (found == devices_.end()) {
    if (devices_.size() >= kMostDevices) return nullptr;
    found = devices_.emplace(std::string(name), std::string(name)).first;
  }
  return &found->second;
}

void SessionCheck::add(LogTime time, std::string_view encoding, bool captured, ByteView datagram) {
  if (captured) ++datagrams_;
  Place place{time, datagrams_, datagram, 0};
  Decoder* const decoder = decoderFor(encoding);
  if (decoder == nullptr) {
    auto found = undecoded_.find(encoding);
    if (found == undecoded_.end()) {
      found = undecoded_.emplace(std::string(encoding), Tally()).first;
    }
    found->second.hit(place);
    return;
  }
  const Packet* const packet = decoder->decode(datagram);
  countFaults(decoder->faults(), place);
  if (packet == nullptr) return;
  if (captured) ++packets_;

  const Applied applied = state_.apply(time, *packet);
  state_.takeEvents();
  if (applied == Applied::refused) {
    refused_.hit(place);
    return;
  }
  Source& source = sourceNamed(packet->header.source);
  watchSource(source, place);
  // A late packet is dropped whole: what it says reaches nobody.
  if (applied == Applied::late) return;
  for (const Statement& statement : packet->statements) {
    place.line = statement.line;
    judge(statement, source, place);
  }
}

void SessionCheck::countFaults(std::span<const FaultAt> faults, Place place) {
  for (const FaultAt& fault : faults) {
    const auto kind = static_cast<std::size_t>(fault.fault);
    place.line = std::max<std::uint32_t>(fault.line, 1);
    if (faults_[kind].hit(place)) fault_columns_[kind] = fault.column;
  }
}

void SessionCheck::watchSource(Source& source, const Place& place) {
  if (source.counts == nullptr) return;
  const auto watch = [&](std::uint64_t now, std::uint64_t& seen, Tally& tally) {
    if (now == seen) return;
    if (now > seen) tally.hit(place);
    seen = now;
  };
  watch(source.counts->gap, source.gap_seen, source.gap);
  watch(source.counts->late, source.late_seen, source.late);
  watch(source.counts->restarts, source.restarts_seen, source.restart);
}

void SessionCheck::judge(const Statement& statement, Source& source, const Place& place) {
  if (!statement.carrier.first.empty()) judgePath(statement.carrier, place);
  switch (statement.kind) {
    case StatementKind::show:
    case StatementKind::hide:
    case StatementKind::color:
      judgePath(statement.path, place);
      return;
    case StatementKind::line:
    case StatementKind::points:
    case StatementKind::label:
    case StatementKind::erase:
    case StatementKind::event:
    case StatementKind::view:
      return;
    default:
      break;
  }
  DeviceJudge* const device = deviceNamed(statement.name);
  if (device == nullptr) return;
  device->mention(place);
  switch (statement.kind) {
    case StatementKind::joints:
      return judgeJoints(statement, source, *device, place);
    case StatementKind::joint:
      return device->judgeNamed(statement.names, statement.numbers, source.number, place);
    case StatementKind::order:
      return device->judgeOrder(statement.names, source.number, place);
    case StatementKind::pose:
      return device->judgePose(source.number, place);
    case StatementKind::add:
      return judgeAdd(statement, *device, place);
    default:
      return;
  }
}

void SessionCheck::judgeJoints(const Statement& statement, const Source& source,
                               DeviceJudge& device, const Place& place) {
  // An order may have been forgotten since it was given: by `remove`, or a restatement without it.
  const auto said = state_.devices().find(statement.name);
  const bool ordered = said != state_.devices().end() && !said->second.orders.empty() &&
                       said->second.orders.find(source.name) != said->second.orders.end();
  device.judgeJoints(statement.numbers, ordered, source.number, place);
}

void SessionCheck::judgeAdd(const Statement& statement, DeviceJudge& device, const Place& place) {
  const auto known = cell_.models.find(std::string(statement.text));
  const Model* model = known == cell_.models.end() ? nullptr : known->second.get();
  device.appearByAdd(model, statement, place);
  // What was said before the device appeared is kept, and counts from now on.
  const auto said = state_.devices().find(statement.name);
  if (said != state_.devices().end() && said->second.joints) {
    device.judgeJoints(said->second.joints->value, false,
                       sourceNamed(said->second.joints->owner).number, place);
  }
}

void SessionCheck::judgePath(const PathView& path, const Place& place) {
  if (path.is_layer) {
    if (layers_.find(path.second) != layers_.end()) return;
    auto found = unknown_layers_.find(path.second);
    if (found == unknown_layers_.end()) {
      if (unknown_layers_.size() == kMostNames) return;
      found = unknown_layers_.emplace(std::string(path.second), Tally()).first;
    }
    found->second.hit(place);
    return;
  }
  DeviceJudge* const device = deviceNamed(path.first);
  if (device == nullptr) return;
  device->mention(place);
  device->judgeLink(path.second, place);
}

void SessionCheck::addLoss(const LossSpan& span) { losses_[span.endpoint].push_back(span); }
void SessionCheck::addDamage(const DamageSpan& span) { damage_.push_back(span); }

void SessionCheck::finish(CheckReport& report) const {
  report.datagrams = datagrams_;
  report.packets = packets_;
  report.sources = source_names_;
  std::sort(report.sources.begin(), report.sources.end());
  for (std::size_t kind = 0; kind < kPacketFaultCount; ++kind) {
    if (faults_[kind].count == 0) continue;
    const FaultRule& rule = ruleOf(static_cast<PacketFault>(kind));
    std::string text(rule.text);
    if (fault_columns_[kind] > 0) {
      text += fmt::format("; the first at column {}", fault_columns_[kind]);
    }
    report.findings.push_back(
        faults_[kind].finding(std::string(rule.rule), rule.severity, "", std::move(text)));
  }
  for (const auto& [encoding, tally] : undecoded_) {
    report.findings.push_back(tally.finding("packet.unknown-protocol", Severity::warning, encoding,
                                            "datagrams that nothing here can decode"));
  }
  for (const auto& [layer, tally] : unknown_layers_) {
    report.findings.push_back(tally.finding("packet.unknown-layer", Severity::warning, layer,
                                            fmt::format("the cell has no layer {}", layer)));
  }
  if (refused_.count > 0) {
    report.findings.push_back(refused_.finding("source.refused", Severity::error, "",
                                               "packets of more sources than there is room for"));
  }
  for (const auto& [name, device] : devices_) device.report(source_names_, report.findings);
  reportSources(report.findings);
  reportLosses(report.findings);
}

void SessionCheck::reportSources(std::vector<Finding>& findings) const {
  for (const auto& [name, source] : sources_) {
    if (source.counts == nullptr) continue;
    const SourceCounts& counts = *source.counts;
    const auto add = [&](const Tally& tally, std::uint64_t count, const char* rule,
                         Severity severity, std::string text) {
      if (count == 0) return;
      findings.push_back(tally.finding(rule, severity, source.name, std::move(text)));
      findings.back().count = count;
    };
    add(source.gap, counts.gap, "source.gap", Severity::warning,
        fmt::format("packets of source {} that never came", name));
    add(source.late, counts.late, "source.late", Severity::warning,
        fmt::format("packets of source {} that came late or twice, and were dropped", name));
    add(source.restart, counts.restarts, "source.restart", Severity::note,
        fmt::format("restarts of source {}", name));
  }
}

void SessionCheck::reportLosses(std::vector<Finding>& findings) const {
  for (const auto& [endpoint, spans] : losses_) {
    LossCounts sum;
    for (const LossSpan& span : spans) sum += span.counts;
    Finding finding;
    finding.rule = "log.loss";
    finding.severity = Severity::warning;
    finding.count = sum.kernel + sum.queue + sum.disk;
    finding.subject = endpoint;
    finding.first = spans.front().from;
    finding.last = spans.front().until;
    for (const LossSpan& span : spans) {
      finding.first = std::min(*finding.first, span.from);
      finding.last = std::max(*finding.last, span.until);
    }
    finding.text = fmt::format(
        "datagrams to {} that were not recorded: {} by the kernel, {} by the queue, {} by the disk",
        endpoint, sum.kernel, sum.queue, sum.disk);
    if (sum.truncated > 0) finding.text += fmt::format("; {} more are cut short", sum.truncated);
    if (finding.count == 0) finding.count = sum.truncated;
    if (finding.count > 0) findings.push_back(std::move(finding));
  }
  for (const DamageSpan& span : damage_) {
    Finding finding;
    finding.rule = "log.damage";
    finding.severity = Severity::error;
    finding.text =
        fmt::format("bytes {} to {} of the log cannot be used: {}", span.from, span.to, span.cause);
    if (span.messages_lost) {
      finding.text += fmt::format(" ({} messages lost)", *span.messages_lost);
    }
    findings.push_back(std::move(finding));
  }
}

}  // namespace rocinante
