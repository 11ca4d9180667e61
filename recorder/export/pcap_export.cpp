#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "core/base/figure_text.h"
#include "core/log/log_profile.h"
#include "core/net/endpoint.h"
#include "core/packet/text_number.h"
#include "recorder/export/exports.h"
#include "recorder/export/session_census.h"

namespace rocinante {
namespace {

constexpr std::uint64_t kProgressMessages = 4096;
constexpr std::uint16_t kStandInPort = 19960;

struct FlowAddresses {
  SocketAddress from, to;
  bool made_up = false;
};

/// "127.0.0.1:19960", "[::1]:19960": no name is looked up.
std::optional<SocketAddress> addressOf(std::string_view text) {
  const std::size_t colon = text.rfind(':');
  if (colon == text.npos || colon == 0) return std::nullopt;
  std::string_view host = text.substr(0, colon);
  if (host.front() == '[' && host.back() == ']') host = host.substr(1, host.size() - 2);
  const std::optional<std::uint64_t> port = readUnsigned(text.substr(colon + 1));
  if (!port || *port > 0xFFFF) return std::nullopt;
  // A zone names an interface of the recorder's machine.
  host = host.substr(0, host.find('%'));
  Result<SocketAddress> address = SocketAddress::parse(host, static_cast<std::uint16_t>(*port));
  if (!address) return std::nullopt;
  return *address;
}

std::optional<SocketAddress> metadataAddress(const LogChannel& channel, const char* key) {
  const auto found = channel.metadata.find(key);
  return found == channel.metadata.end() ? std::nullopt : addressOf(found->second);
}

SocketAddress standIn(const char* host) { return SocketAddress::parse(host, kStandInPort).value(); }

/// The datagram's destination: the group or port that its topic begins with, at the local address.
std::optional<SocketAddress> destinationOf(const LogChannel& channel) {
  std::string_view topic = channel.topic;
  if (topic.starts_with(profile::kRestatedPrefix))
    topic.remove_prefix(profile::kRestatedPrefix.size());
  constexpr std::string_view kUdpTopics = "/udp/";
  std::optional<SocketAddress> local = metadataAddress(channel, "local");
  if (topic.starts_with(kUdpTopics)) {
    topic.remove_prefix(kUdpTopics.size());
    const std::string_view root = topic.substr(0, topic.find('/'));
    if (const auto group = addressOf(root)) return group;
  }
  return local;
}

FlowAddresses addressesOf(const LogChannel& channel) {
  FlowAddresses flow;
  const std::optional<SocketAddress> from = metadataAddress(channel, "remote");
  const std::optional<SocketAddress> to = destinationOf(channel);
  flow.made_up = !from || !to || from->is_ipv6 != to->is_ipv6;
  flow.from = flow.made_up ? standIn("192.0.2.1") : *from;
  flow.to = flow.made_up ? standIn("192.0.2.2") : *to;
  if (flow.to.isAny()) {
    const std::uint16_t port = flow.to.port;
    flow.to = standIn(flow.to.is_ipv6 ? "::1" : "127.0.0.1");
    flow.to.port = port;
  }
  return flow;
}

/// Decoded packets were never sent.
bool isTraffic(const LogChannel& channel) {
  return channel.received() && channel.topic != profile::kRestatedKeyframeTopic;
}

}  // namespace

Result<PcapExportReport> exportPcap(LogReader& log, LogTime from, LogTime until, PcapFile& out,
                                    const ExportProgress& progress) {
  std::vector<std::optional<FlowAddresses>> flows;
  std::set<std::string> made_up;
  for (const LogChannel& channel : log.channels()) {
    if (flows.size() <= channel.id) flows.resize(channel.id + 1U);
    if (isTraffic(channel)) flows[channel.id] = addressesOf(channel);
  }
  PcapExportReport report;
  std::uint64_t too_long = 0;
  std::map<std::string, std::uint64_t, std::less<>> others;
  std::uint64_t count = 0;
  const LogSummary& summary = log.summary();
  const double whole = std::max(secondsOf(summary.end - summary.start), 1e-9);
  if (Status begun = out.begin(); !begun) return begun.error();
  if (Status found = log.seek(from); !found) return found.error();
  while (true) {
    const Result<std::optional<LogMessage>> message = log.next();
    if (!message) return message.error();
    if (!*message || (*message)->log_time >= until) break;
    const std::optional<FlowAddresses>& flow = flows[(*message)->channel->id];
    if (!flow) {
      // Keyframes repeat what the datagrams say.
      if ((*message)->channel->topic != profile::kKeyframeTopic) {
        ++others[(*message)->channel->topic];
      }
      continue;
    }
    if ((*message)->payload.size() > kMaxPcapDatagramBytes) {
      ++too_long;
      continue;
    }
    if (flow->made_up) made_up.insert((*message)->channel->topic);
    Status written = out.write((*message)->log_time, flow->from, flow->to, (*message)->payload);
    if (!written) return written.error();
    ++report.datagrams;
    if (!progress || ++count % kProgressMessages != 0) continue;
    const double part = secondsOf((*message)->log_time - summary.start) / whole;
    if (Status on = progress(std::clamp(part, 0.0, 1.0)); !on) return on.error();
  }
  if (too_long > 0) {
    report.gaps.push_back(fmt::format("{} longer than a UDP packet can be (65,507 bytes) left out",
                                      countText(too_long, "message")));
  }
  for (const auto& [topic, messages] : others) {
    report.left_out.leaveOut({.kind = "message",
                              .name = topic,
                              .reason = "was no datagram on a network",
                              .count = messages,
                              .severity = Severity::warning});
  }
  addAttachments(report.left_out, log, "a capture has no attachments");
  for (const std::string& topic : made_up) {
    report.notes.push_back(fmt::format(
        "{} has no addresses in the log: 192.0.2.1 and 192.0.2.2 stand for them", topic));
  }
  return report;
}

}  // namespace rocinante
