#include "player/relay/relay_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/foreign/decode/decode_account_json.h"

namespace rocinante {

std::uint64_t RelayReport::lost() const {
  std::uint64_t lost = served_dropped;
  for (const Input& each : inputs) lost += each.dropped;
  for (const Output& each : outputs) lost += each.dropped;
  return lost;
}

std::string jsonText(const RelayReport& report) {
  Json json;
  json["format"] = 1;
  json["name"] = report.name;
  json["run"] = report.run;
  json["seconds"] = report.seconds;
  json["scheduling"] = report.scheduling;
  json["received"] = report.counts.received;
  json["applied"] = report.counts.applied;
  json["late"] = report.counts.late;
  json["refused"] = report.counts.refused;
  json["other"] = report.counts.other;
  json["looped"] = report.counts.looped;
  json["lost"] = report.lost();
  json["inputs"] = Json::array();
  for (const RelayReport::Input& each : report.inputs) {
    json["inputs"].push_back({{"endpoint", each.endpoint},
                              {"datagrams", each.datagrams},
                              {"dropped", each.dropped},
                              {"refused", each.counts.refused},
                              {"echoes", each.counts.echoes}});
    if (!each.counts.untrusted) continue;
    Json& untrusted = json["inputs"].back()["untrusted"];
    for (std::size_t i = 0; i < kUntrustedReasons; ++i) {
      const auto reason = static_cast<Untrusted>(i);
      untrusted[std::string(nameOf(reason))] = each.counts.untrusted->of(reason);
    }
  }
  json["outputs"] = Json::array();
  for (const RelayReport::Output& each : report.outputs) {
    json["outputs"].push_back({{"endpoint", each.endpoint},
                               {"output", each.number},
                               {"whole", each.whole},
                               {"forwarded", each.forwarded},
                               {"conflated", each.conflated},
                               {"dropped", each.dropped},
                               {"trouble", each.trouble}});
  }
  const SubscriptionDesk::Counts& asked = report.requests;
  json["subscribers"] = {{"now", report.subscribers},        {"most", report.most_subscribers},
                         {"forwarded", report.served},       {"conflated", report.served_conflated},
                         {"dropped", report.served_dropped}, {"requests", asked.requests},
                         {"challenged", asked.challenged},   {"refused", asked.refused},
                         {"ignored", asked.ignored},         {"malformed", asked.malformed}};
  if (report.decoded) json["decoded"] = decode::accountJson(*report.decoded);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string summaryText(const RelayReport& report) {
  const RelayInputCounts& counts = report.counts;
  std::string text = fmt::format(
      "{} received: {} applied, {} late, {} refused, {} looped, {} not packet text\n",
      counts.received, counts.applied, counts.late, counts.refused, counts.looped, counts.other);
  for (const RelayReport::Input& each : report.inputs) {
    text += fmt::format("from {}: {} datagrams, {} dropped by the kernel, {} refused",
                        each.endpoint, each.datagrams, each.dropped, each.counts.refused);
    const UntrustedCounts untrusted = each.counts.untrusted.value_or(UntrustedCounts{});
    if (untrusted.total() > 0) text += fmt::format(", not trusted: {}", untrusted.text());
    text += '\n';
  }
  for (const RelayReport::Output& each : report.outputs) {
    text += fmt::format(
        "to {}: {} forwarded {}, {} dropped{}\n", each.endpoint, each.forwarded,
        each.whole ? "whole" : fmt::format("filtered, {} values conflated", each.conflated),
        each.dropped, each.trouble.empty() ? "" : ": " + each.trouble);
  }
  if (report.requests.bytes_in > 0) {
    text += fmt::format(
        "subscribers: at most {}, {} datagrams, {} values conflated, {} dropped; "
        "{} requests refused\n",
        report.most_subscribers, report.served, report.served_conflated, report.served_dropped,
        report.requests.refused);
  }
  if (report.decoded) {
    text += fmt::format("{} decoded:\n{}", report.decoded->decoded(),
                        decode::accountText(*report.decoded));
  }
  return text;
}

}  // namespace rocinante
