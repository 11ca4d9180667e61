#include "recorder/spy/spy.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "core/base/plain_text.h"
#include "core/check/judges/fault_rules.h"
#include "core/log/log_profile.h"
#include "core/packet/item_text.h"
#include "core/packet/packet_limits.h"
#include "recorder/spy/shown_datagram.h"
#include "recorder/spy/spy_reasons.h"

namespace rocinante {
namespace {

// Further senders are counted together.
constexpr std::size_t kSenders = 4'096;
constexpr std::size_t kNamesKept = 4;
constexpr std::size_t kEvents = 200;

void keepName(std::vector<std::string>& names, std::string_view name) {
  if (names.size() >= kNamesKept || std::ranges::find(names, name) != names.end()) return;
  names.emplace_back(name);
}

std::size_t valuesHash(const DeviceState& state) {
  std::size_t hash = 0;
  const auto add = [&](double value) {
    hash = hash * 1'099'511'628'211U + std::hash<double>{}(value);
  };
  if (state.joints) std::ranges::for_each(state.joints->value, add);
  for (const auto& [name, value] : state.named_joints) add(value.value);
  if (state.pose) {
    const auto& [position, orientation] = state.pose->value.pose;
    for (const double value : {position.x, position.y, position.z}) add(value);
    for (const double value : {orientation.x, orientation.y, orientation.z, orientation.w}) {
      add(value);
    }
  }
  return hash;
}

}  // namespace

Spy::Spy(const std::vector<ListenedEndpoint>& endpoints, LogTime began,
         std::shared_ptr<const decode::DecoderSet> decoders)
    : began_(began), reached_(began), endpoint_last_(endpoints.size()) {
  if (decoders) decoders_.emplace(std::move(decoders), endpoints);
  for (const ListenedEndpoint& each : endpoints) {
    SpyEndpoint seen;
    seen.endpoint = boundText(each.endpoint, each.bound);
    seen.reach = each.endpoint.isPcap()           ? Reach::watched
                 : each.endpoint.isSubscription() ? Reach::subscribed
                 : each.endpoint.isNats()         ? Reach::served
                 : each.endpoint.isMulticast()    ? Reach::multicast
                                                  : Reach::unicast;
    endpoints_.push_back(std::move(seen));
  }
  for (std::size_t i = 0; i < kPacketFaultCount; ++i) faults_[i].kind = static_cast<PacketFault>(i);
}

Spy::Sender* Spy::senderFor(std::size_t endpoint, const ReceivedDatagram& datagram) {
  const std::string address = senderText(datagram);
  const std::string to = datagram.destination != nullptr ? datagram.destination->text() : "";
  const auto key = std::pair(endpoint, address + to);
  if (const auto found = sender_by_address_.find(key); found != sender_by_address_.end()) {
    return &senders_[found->second];
  }
  if (senders_.size() >= kSenders) {
    ++more_senders_;
    return nullptr;
  }
  ++endpoints_[endpoint].senders;
  sender_by_address_.emplace(key, senders_.size());
  Sender& sender = senders_.emplace_back();
  sender.seen.endpoint = endpoint;
  sender.seen.address = address;
  sender.seen.to = to;
  return &sender;
}

void Spy::add(std::size_t endpoint, const ReceivedDatagram& datagram, LogTime arrived) {
  // The fold needs monotonic times; those of several sockets are only nearly so.
  reached_ = arrived = std::max(arrived, reached_);
  SpyEndpoint& at = endpoints_[endpoint];
  ++at.datagrams;
  at.bytes += datagram.payload.size();
  endpoint_last_[endpoint] = arrived;

  Sender* const sender = senderFor(endpoint, datagram);
  const std::string_view encoding = encodingOf(datagram.payload);
  const MadePacket* const made =
      decoders_ ? decoders_->decode(endpoint, datagram, arrived) : nullptr;
  if (made != nullptr) stream_.addOctets(arrived, encoding, true);
  const ByteView packet_text = made != nullptr ? bytesOf(made->text) : datagram.payload;
  const std::string address = sender != nullptr ? sender->seen.address : senderText(datagram);
  const StreamJudge::Judged judged = stream_.add(arrived, made != nullptr ? "rk1" : encoding,
                                                 made == nullptr, packet_text, address);
  if (sender != nullptr) {
    SpySender& seen = sender->seen;
    const std::size_t bytes = datagram.payload.size();
    seen.smallest_bytes = seen.datagrams == 0 ? bytes : std::min(seen.smallest_bytes, bytes);
    seen.largest_bytes = std::max(seen.largest_bytes, bytes);
    ++seen.datagrams;
    if (judged.packet != nullptr) ++seen.packets;
    if (judged.packet == nullptr && seen.first_bytes.empty()) {
      seen.first_bytes = firstBytes(datagram.payload);
    }
    sender->rate.hit(arrived);
    sender->last = arrived;
  }
  constexpr FaultAt kNotAPacket{PacketFault::not_a_packet, 1, 1};
  const bool is_undecoded = judged.packet == nullptr && judged.faults.empty();
  readFaults(is_undecoded ? std::span(&kNotAPacket, 1) : judged.faults, packet_text, address);
  if (judged.packet != nullptr) readPacket(judged, address);
}

void Spy::setDropped(std::size_t endpoint, std::uint64_t dropped, const InputCounts& counts,
                     Account left_out) {
  endpoints_[endpoint].dropped = dropped;
  endpoints_[endpoint].counts = counts;
  endpoints_[endpoint].left_out = std::move(left_out);
}

void Spy::readPacket(const StreamJudge::Judged& judged, const std::string& sender) {
  const Packet& packet = *judged.packet;
  const LogTime arrived = judged.place.time;
  const PacketHeader& header = packet.header;
  auto found = sources_.find(header.source);
  if (found == sources_.end() && sources_.size() < limits::kSources) {
    found = sources_.emplace(std::string(header.source), Source{}).first;
  }
  if (found != sources_.end()) {
    Source& source = found->second;
    source.rate.hit(arrived);
    source.last = arrived;
    if (header.restated) ++source.restated;
    // A sender that restates for others is not a sender of their SOURCE.
    if (header.by.empty()) hearSender(source, sender);
    // The time of a decoded packet is that of its arrival.
    const bool has_clock = header.by.empty() && !profile::isDecodedSource(header.source);
    if (header.time_ns && has_clock) {
      source.clock_offset = Nanoseconds(*header.time_ns) - arrived.time_since_epoch();
    }
  }
  if (judged.source != nullptr) {
    PacketPlace place = judged.place;
    for (const Statement& statement : packet.statements) {
      place.line = statement.line;
      readPresence(statement, place);
      readStatement(statement, header.source, place);
    }
    readMismatches(packet, place, sender);
  }
  readEvents(arrived);
}

void Spy::readEvents(LogTime arrived) {
  for (const rocinante::Event& event : stream_.takeEvents()) {
    const std::pair key(event.source, event.text);
    auto found = events_.find(key);
    if (found == events_.end() && events_.size() < kEvents) {
      found = events_.emplace(key, Event{}).first;
    }
    if (found == events_.end()) {
      ++more_events_;
      continue;
    }
    ++found->second.count;
    found->second.last = arrived;
  }
}

/// A source that restarts keeps its new port; two senders that share a name take turns.
void Spy::hearSender(Source& source, const std::string& sender) {
  if (sender == source.last_sender) return;
  if (std::ranges::find(source.senders, sender) != source.senders.end()) ++source.turns;
  keepName(source.senders, sender);
  source.last_sender = sender;
}

Spy::Device* Spy::deviceNamed(std::string_view name) {
  auto found = devices_.find(name);
  if (found == devices_.end()) {
    if (devices_.size() >= limits::kDevices) return nullptr;
    found = devices_.emplace(std::string(name), Device{}).first;
  }
  return &found->second;
}

void Spy::readPresence(const Statement& statement, const PacketPlace& place) {
  const bool is_of_path = (isOfPath(statement.kind) && !statement.path.is_layer) ||
                          (isSignal(statement.kind) && !statement.path.first.empty());
  const bool is_of_device = isOfDevice(statement.kind) || statement.kind == StatementKind::seen;
  if (!is_of_path && !is_of_device) return;
  Device* const device = deviceNamed(is_of_path ? statement.path.first : statement.name);
  if (device == nullptr) return;
  if (statement.kind == StatementKind::add) return device->presence.add(place);
  if (statement.kind == StatementKind::remove) return device->presence.remove(place);
  device->presence.mention(place);
}

void Spy::readStatement(const Statement& statement, std::string_view source,
                        const PacketPlace& place) {
  if (!isDeviceValue(statement.kind)) return;
  const bool is_pose = statement.kind == StatementKind::pose;
  Device* const device = deviceNamed(statement.name);
  if (device == nullptr) return;
  keepName(device->sources, source);
  (is_pose ? device->posers : device->drivers)
      .note(is_pose ? device->poser : device->driver, place);
  ++device->statements;
  device->rate.hit(place.time);
  const auto state = stream_.state().devices().find(statement.name);
  if (state == stream_.state().devices().end()) return;
  const std::size_t values = valuesHash(state->second);
  // The first values are not a change.
  if (device->values && *device->values != values) ++device->changes;
  device->values = values;
}

void Spy::readFaults(std::span<const FaultAt> faults, ByteView payload, const std::string& sender) {
  for (const FaultAt& fault : faults) {
    SpyFault& seen = faults_[static_cast<std::size_t>(fault.fault)];
    if (++seen.count > 1) continue;
    seen.sender = sender;
    seen.line_number = std::max<std::uint32_t>(fault.line, 1);
    seen.column = fault.column;
    seen.line = isUtf8(payload) ? plainLine(payload, seen.line_number) : firstBytes(payload);
  }
}

/// Reports joints that do not fit their order, which only the fold can tell.
void Spy::readMismatches(const Packet& packet, const PacketPlace& place,
                         const std::string& sender) {
  const auto counts = stream_.state().counts().find(packet.header.source);
  const auto source = sources_.find(packet.header.source);
  if (counts == stream_.state().counts().end() || source == sources_.end()) return;
  for (std::size_t i = 0; i < kOrderFaults.size(); ++i) {
    std::uint64_t& known = source->second.mismatches[i];
    std::uint64_t news = counts->second.faults[static_cast<std::size_t>(kOrderFaults[i])] - known;
    known += news;
    for (const Statement& statement : packet.statements) {
      if (news == 0) break;
      const bool is_tagged = kOrderFaults[i] == PacketFault::unknown_order;
      if (statement.kind != StatementKind::joints || statement.order_tag.has_value() != is_tagged) {
        continue;
      }
      const FaultAt fault{kOrderFaults[i], statement.line, 0};
      readFaults({&fault, 1}, place.datagram, sender);
      stream_.takeFaults({&fault, 1}, place);
      --news;
    }
  }
}

SpyDevice Spy::deviceReport(const std::string& name, const DeviceState& state, LogTime now) {
  SpyDevice report;
  report.name = name;
  report.silent = now - std::min(state.last_write, now);
  if (const auto found = devices_.find(name); found != devices_.end()) {
    Device& device = found->second;
    report.sources = device.sources;
    report.statements = device.statements;
    report.changes = device.changes;
    report.rate_hz = device.rate.perSecond(now);
  }
  if (state.presence) {
    const PresenceValue& presence = state.presence->value;
    report.presence =
        presence.presence == Presence::removed ? "removed" : "added " + plainText(presence.model);
    keepName(report.sources, state.presence->owner);
  }
  if (state.joints) report.joints = state.joints->value;
  for (const auto& [joint, value] : state.named_joints) {
    report.named_joints.emplace(joint, value.value);
  }
  if (state.pose) {
    report.pose = state.pose->value.pose;
    const Path& carrier = state.pose->value.carrier;
    report.carrier = plainText(carrier.first);
    if (!carrier.second.empty()) report.carrier += "/" + plainText(carrier.second);
  }
  return report;
}

Findings Spy::judgements(LogTime now) const {
  Findings findings;
  stream_.reportSources(now, findings);
  stream_.reportDatagrams(findings);
  for (const auto& [name, device] : devices_) {
    device.presence.report(name, findings);
    device.drivers.report(name, "the joints of device " + name + " are", stream_.sourceNames(),
                          findings);
    device.posers.report(name, "the poses of device " + name + " are", stream_.sourceNames(),
                         findings);
  }
  return findings;
}

SpyReport Spy::report(LogTime now) {
  const SessionState& state = stream_.state();
  now = std::max(now, reached_);
  SpyReport report;
  report.watched = now - began_;
  report.datagrams = stream_.datagrams();
  report.packets = stream_.packets();
  if (decoders_) {
    report.decoded = decoders_->decoded();
    report.decoders = decoders_->report();
  }
  report.endpoints = endpoints_;
  for (std::size_t i = 0; i < endpoints_.size(); ++i) {
    if (endpoints_[i].datagrams > 0) report.endpoints[i].silent = now - endpoint_last_[i];
  }
  for (Sender& sender : senders_) {
    report.senders.push_back(sender.seen);
    report.senders.back().rate_hz = sender.rate.perSecond(now);
    report.senders.back().silent = now - sender.last;
  }
  report.more_senders = more_senders_;
  for (auto& [name, source] : sources_) {
    SpySource& seen = report.sources.emplace_back();
    seen.name = name;
    seen.senders = source.senders;
    seen.turns = source.turns;
    seen.rate_hz = source.rate.perSecond(now);
    seen.restated = source.restated;
    seen.silent = now - source.last;
    seen.clock_offset = source.clock_offset;
    if (const auto known = state.sources().find(name); known != state.sources().end()) {
      seen.run = known->second.run;
    }
    if (const auto counted = state.counts().find(name); counted != state.counts().end()) {
      const SourceCounts& counts = counted->second;
      seen.packets = counts.packets;
      seen.gap = counts.gap;
      seen.late = counts.late;
      seen.restarts = counts.restarts;
      seen.by_others = counts.by_others;
      seen.duplicates = counts.duplicates;
      for (const std::uint64_t count : counts.faults) seen.faults += count;
    }
  }
  for (const auto& [name, device] : state.devices()) {
    report.devices.push_back(deviceReport(name, device, now));
  }
  const auto add_signal = ByKind{
      [&](const SignalItem& item) { report.signals.push_back(shownSignal(item)); },
      [](const auto&) {},
  };
  for (const auto& [name, device] : state.devices()) eachItemOf(name, device, add_signal);
  for (const auto& [name, item] : state.signals()) eachItemOf(name, item, add_signal);
  for (const auto& [key, drawing] : state.drawings()) {
    SpyDrawing& seen = report.drawings.emplace_back();
    std::tie(seen.source, seen.name) = key;
    eachItemOf(key, drawing, [&](const DrawingItem& part) {
      if (seen.parts++ == 0) seen.text = shownText(statementText(part));
    });
  }
  for (const auto& [key, event] : events_) {
    report.events.push_back({shownText(key.second), key.first, event.count, now - event.last});
  }
  report.more_events = more_events_;
  for (const SpyFault& fault : faults_) {
    if (fault.count > 0) report.faults.push_back(fault);
  }
  std::ranges::stable_sort(report.faults, std::greater{}, &SpyFault::count);
  for (SpyFault& fault : report.faults) fault.hint = ruleOf(fault.kind).hint;
  addReasons(report, judgements(now));
  return report;
}

}  // namespace rocinante
