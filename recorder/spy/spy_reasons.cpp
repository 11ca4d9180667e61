#include "recorder/spy/spy_reasons.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/plain_text.h"
#include "core/check/judges/fault_rules.h"
#include "core/cli/text_table.h"
#include "core/report/traffic_findings.h"

namespace rocinante {
namespace {

using cli::counted;

/// Consequences of two senders that share a SOURCE.
constexpr std::array<std::string_view, 4> kByTwoSenders = {"source.late", "source.duplicate",
                                                           "source.restart", "source.clock-step"};

/// Whether lines with this fault are what a rule of `check` finds.
bool isOf(std::string_view rule, PacketFault fault) {
  if (rule == "packet.not-finite") return fault == PacketFault::bad_number;
  if (rule == "packet.unknown-protocol") return fault == PacketFault::not_a_packet;
  return rule == ruleOf(fault).rule;
}

class Reasons {
 public:
  Reasons(SpyReport& report, Findings judged) : report_(report), judged_(std::move(judged)) {}

  void find() {
    for (const SpyEndpoint& each : report_.endpoints) judge(each);
    if (report_.datagrams > 0 && report_.packets == 0) judgeUndecoded();
    for (const SpySource& each : report_.sources) judge(each);
    for (Finding& each : judged_) {
      nameSender(each);
      report_.reasons.push_back(std::move(each));
    }
    for (const SpyDevice& each : report_.devices) judge(each);
    if (report_.packets > 0 && report_.devices.empty() && report_.watched >= kPatience) {
      report_.reasons.push_back(noDeviceNamed());
    }
  }

 private:
  void add(std::string rule, Severity severity, std::string text, std::string hint) {
    report_.reasons.push_back({.rule = std::move(rule),
                               .severity = severity,
                               .text = std::move(text),
                               .hint = std::move(hint)});
  }

  void judge(const SpyEndpoint& endpoint) {
    if (endpoint.datagrams == 0 && report_.watched >= kPatience) {
      report_.reasons.push_back(
          nothingReceived(endpoint.endpoint, endpoint.reach, report_.watched));
    } else if (endpoint.silent && *endpoint.silent >= kPatience) {
      report_.reasons.push_back(nothingSince(endpoint.endpoint, *endpoint.silent));
    }
    if (endpoint.counts.refused > 0) {
      add("live.refused", Severity::warning,
          fmt::format("{} at {} came from senders that --allow does not name",
                      counted(endpoint.counts.refused, "datagram"), endpoint.endpoint),
          "name a network with --allow for every sender that should be accepted");
    }
    if (endpoint.counts.strangers > 0) {
      add("live.strangers", Severity::warning,
          fmt::format("{} at {} did not come from its relay",
                      counted(endpoint.counts.strangers, "datagram"), endpoint.endpoint),
          "somebody else sends to the port of this subscription, or the relay answers from another "
          "address than the one that was asked");
    }
    if (endpoint.counts.requests > 0) {
      add("live.requests", Severity::warning,
          fmt::format("{} at {} for a relay (RKS1)", counted(endpoint.counts.requests, "request"),
                      endpoint.endpoint),
          "a subscribe:// endpoint somewhere names this machine and port, where no relay listens");
    }
    if (const auto& untrusted = endpoint.counts.untrusted; untrusted && untrusted->total() > 0) {
      add("live.untrusted", Severity::warning,
          fmt::format("{} at {} were not trusted: {}", counted(untrusted->total(), "datagram"),
                      endpoint.endpoint, untrusted->text()),
          "docs/signing.md explains each; a sender signs with --key, --trust lists its key");
    }
    if (endpoint.counts.incomplete > 0) {
      add("live.incomplete", Severity::warning,
          fmt::format("{} at {} lost some of their fragments",
                      counted(endpoint.counts.incomplete, "datagram"), endpoint.endpoint),
          "lost on the way; datagrams within the MTU (1,472 bytes on Ethernet) need no fragments");
    }
    if (endpoint.counts.malformed > 0) {
      add("live.malformed", Severity::warning,
          fmt::format("{} at {} were malformed IP or UDP",
                      counted(endpoint.counts.malformed, "frame"), endpoint.endpoint),
          "a capture may have kept only the beginning of each frame (tcpdump -s)");
    }
    if (!endpoint.left_out.empty()) {
      add("live.left-out", Severity::note,
          fmt::format("{}: {}", endpoint.endpoint, accountSentence(endpoint.left_out)),
          "only UDP is read; docs/endpoints.md lists what is read of a frame");
    }
    if (endpoint.dropped > 0) {
      add("log.loss", Severity::warning,
          fmt::format("the kernel dropped {} at {} before they could be read",
                      counted(endpoint.dropped, "datagram"), endpoint.endpoint),
          "this machine is too busy, or net.core.rmem_max is too small for the rate");
    }
  }

  void judgeUndecoded() {
    const auto first = std::ranges::find_if(
        report_.senders, [](const SpySender& each) { return !each.first_bytes.empty(); });
    const bool is_known = first != report_.senders.end();
    report_.reasons.push_back(nothingDecoded(report_.datagrams, is_known ? first->first_bytes : "",
                                             is_known ? first->address : ""));
    std::erase_if(judged_, [](const Finding& each) {
      return each.rule == "packet.unknown-protocol" || each.rule == "packet.not-a-packet";
    });
  }

  void judge(const SpySource& source) {
    if (source.turns == 0 || takesTurnsByRun(source.name)) return;
    const std::string name = plainText(source.name);
    const bool only_copies = source.late > 0 && source.late == source.duplicates;
    if (only_copies && source.restarts <= 1) {
      add("live.two-paths", Severity::note,
          fmt::format("{} and {} both send as {}: {} arrived twice", source.senders[0],
                      source.senders[1], name, counted(source.late, "packet")),
          "one source heard by two paths is fine; otherwise give every sender a SOURCE of its own");
    } else {
      add("live.two-senders", Severity::error,
          fmt::format("{} and {} take turns sending as {}: {} dropped as late, {}",
                      source.senders[0], source.senders[1], name, counted(source.late, "packet"),
                      counted(source.restarts, "restart")),
          "give every sender a SOURCE of its own");
    }
    std::erase_if(judged_, [&](const Finding& each) {
      return each.subject == source.name && std::ranges::count(kByTwoSenders, each.rule) > 0;
    });
  }

  /// Told by their RUNs, which name the senders as well.
  bool takesTurnsByRun(std::string_view source) const {
    return std::ranges::any_of(judged_, [&](const Finding& each) {
      return each.rule == "source.two-senders" && each.subject == source;
    });
  }

  /// A stream has packet numbers for nobody: the first offending line is shown with its sender.
  void nameSender(Finding& finding) const {
    for (const SpyFault& fault : report_.faults) {
      if (!isOf(finding.rule, fault.kind)) continue;
      if (!finding.example.empty() && finding.example != fault.line) continue;
      finding.example = fmt::format("{}, line {}: {}", fault.sender, fault.line_number, fault.line);
      return;
    }
  }

  void judge(const SpyDevice& device) {
    if (device.statements > 1 && device.changes == 0 && report_.watched >= kPatience) {
      add("live.constant", Severity::note,
          fmt::format("{} received {} statements, all with the same values", plainText(device.name),
                      device.statements),
          "the machine is at rest, or its sender reads values that do not change");
    }
  }

  SpyReport& report_;
  Findings judged_;
};

}  // namespace

void addReasons(SpyReport& report, Findings judged) { Reasons(report, std::move(judged)).find(); }

}  // namespace rocinante
