#include "player/relay/relay_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/foreign/decode/decode_account.h"
#include "core/report/account.h"

namespace rocinante {

std::uint64_t RelayReport::lost() const {
  std::uint64_t lost = served_dropped + served_paced.dropped;
  for (const Input& each : inputs) lost += each.dropped;
  for (const Output& each : outputs) lost += each.dropped + each.paced.dropped;
  return lost;
}

namespace {

/// The account of a filter (docs/decisions/030).
Account accountOf(const FilteredOutCounts& counts) {
  Account account;
  if (counts.stopped > 0) {
    account.leaveOut({.kind = "statement",
                      .reason = "does not pass the output's filter",
                      .count = counts.stopped});
  }
  if (counts.signals > 0) {
    account.leaveOut({.kind = "signal",
                      .reason = "does not pass the output's filter of signals",
                      .count = counts.signals});
  }
  if (counts.held > 0) {
    account.leaveOut({.kind = "signal",
                      .reason = "changed too little since it was sent (--min-change)",
                      .count = counts.held});
  }
  if (counts.unreadable > 0) {
    account.leaveOut({.kind = "statement",
                      .reason = "not readable: a filtered output has no words for it",
                      .count = counts.unreadable,
                      .severity = Severity::warning});
  }
  return account;
}

/// A line of its own; empty when nothing was left out.
std::string accountText(const FilteredOutCounts& counts, const std::string& output) {
  const std::string sentence = accountSentence(accountOf(counts));
  return sentence.empty() ? sentence : "for " + output + " " + sentence + "\n";
}

Json pacedJson(const PacedCounts& paced) {
  return {{"waiting", paced.waiting}, {"most", paced.most}, {"dropped", paced.dropped}};
}

/// ", 12 events or changes wait for the link (at most 40), 3 had no room to"; empty when none did.
std::string pacedText(const PacedCounts& paced) {
  if (paced.most == 0 && paced.dropped == 0) return {};
  std::string text = fmt::format(", {} events and changes wait for the link (at most {})",
                                 paced.waiting, paced.most);
  if (paced.dropped > 0) text += fmt::format(", {} had no room to wait", paced.dropped);
  return text;
}

}  // namespace

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
  json["loop"] = nullptr;
  if (report.loop) {
    json["loop"] = {{"source", report.loop->source}, {"after", nullptr}};
    if (report.loop->after) json["loop"]["after"] = secondsOf(*report.loop->after);
  }
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
                               {"paced", pacedJson(each.paced)},
                               {"left_out", leftOutJson(accountOf(each.filtered_out))},
                               {"trouble", each.trouble}});
  }
  const SubscriptionDesk::Counts& asked = report.requests;
  json["subscribers"] = {{"now", report.subscribers},
                         {"most", report.most_subscribers},
                         {"forwarded", report.served},
                         {"conflated", report.served_conflated},
                         {"dropped", report.served_dropped},
                         {"requests", asked.requests},
                         {"challenged", asked.challenged},
                         {"refused", asked.refused},
                         {"ignored", asked.ignored},
                         {"malformed", asked.malformed},
                         {"paced", pacedJson(report.served_paced)},
                         {"left_out", leftOutJson(accountOf(report.served_filtered_out))}};
  if (report.decoded) json["decoded"] = decode::accountJson(*report.decoded);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string summaryText(const RelayReport& report) {
  const RelayInputCounts& counts = report.counts;
  std::string text = fmt::format(
      "{} received: {} applied, {} late, {} refused, {} looped, {} not packet text\n",
      counts.received, counts.applied, counts.late, counts.refused, counts.looped, counts.other);
  if (report.loop) text += report.loop->text() + '\n';
  for (const RelayReport::Input& each : report.inputs) {
    text += fmt::format("from {}: {} datagrams, {} dropped by the kernel, {} refused",
                        each.endpoint, each.datagrams, each.dropped, each.counts.refused);
    const UntrustedCounts untrusted = each.counts.untrusted.value_or(UntrustedCounts{});
    if (untrusted.total() > 0) text += fmt::format(", not trusted: {}", untrusted.text());
    text += '\n';
  }
  for (const RelayReport::Output& each : report.outputs) {
    text += fmt::format(
        "to {}: {} forwarded {}, {} dropped{}{}\n", each.endpoint, each.forwarded,
        each.whole ? "whole" : fmt::format("filtered, {} values conflated", each.conflated),
        each.dropped, pacedText(each.paced), each.trouble.empty() ? "" : ": " + each.trouble);
    text += accountText(each.filtered_out, each.endpoint);
  }
  if (report.requests.bytes_in > 0) {
    text += fmt::format(
        "subscribers: at most {}, {} datagrams, {} values conflated, {} dropped{}; "
        "{} requests refused\n",
        report.most_subscribers, report.served, report.served_conflated, report.served_dropped,
        pacedText(report.served_paced), report.requests.refused);
    text += accountText(report.served_filtered_out, "subscribers");
  }
  if (report.decoded) {
    text += fmt::format("{} decoded:\n{}", report.decoded->decoded(),
                        decode::accountText(*report.decoded));
  }
  return text;
}

}  // namespace rocinante
