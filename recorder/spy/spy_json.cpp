#include "recorder/spy/spy_json.h"

#include "core/check/judges/fault_rules.h"
#include "core/report/json_text.h"

namespace rocinante {
namespace {

Json endpointJson(const SpyEndpoint& each) {
  Json json;
  json["endpoint"] = each.endpoint;
  json["datagrams"] = each.datagrams;
  json["bytes"] = each.bytes;
  json["senders"] = each.senders;
  json["dropped"] = each.dropped;
  json["refused"] = each.counts.refused;
  json["strangers"] = each.counts.strangers;
  json["requests"] = each.counts.requests;
  json["incomplete"] = each.counts.incomplete;
  json["malformed"] = each.counts.malformed;
  json["left_out"] = leftOutJson(each.left_out);
  if (each.counts.untrusted) {
    for (std::size_t i = 0; i < kUntrustedReasons; ++i) {
      json["untrusted"][std::string(nameOf(static_cast<Untrusted>(i)))] =
          each.counts.untrusted->by_reason[i];
    }
  }
  json["silent_s"] = each.silent ? Json(secondsOf(*each.silent)) : Json();
  return json;
}

Json senderJson(const SpySender& each, const SpyReport& report) {
  Json json;
  json["sender"] = each.address;
  json["endpoint"] = report.endpoints[each.endpoint].endpoint;
  json["to"] = orNull(each.to);
  json["rate_hz"] = each.rate_hz;
  json["datagrams"] = each.datagrams;
  json["packets"] = each.packets;
  json["smallest_bytes"] = each.smallest_bytes;
  json["largest_bytes"] = each.largest_bytes;
  json["silent_s"] = secondsOf(each.silent);
  json["first_bytes"] = orNull(each.first_bytes);
  return json;
}

Json sourceJson(const SpySource& each) {
  Json json;
  json["source"] = each.name;
  json["run"] = each.run;
  json["senders"] = each.senders;
  json["rate_hz"] = each.rate_hz;
  json["packets"] = each.packets;
  json["gap"] = each.gap;
  json["late"] = each.late;
  json["restarts"] = each.restarts;
  json["restated"] = each.restated;
  json["by_others"] = each.by_others;
  json["faults"] = each.faults;
  json["silent_s"] = secondsOf(each.silent);
  json["clock_offset_s"] = each.clock_offset ? Json(secondsOf(*each.clock_offset)) : Json();
  return json;
}

Json decoderJson(const SpyDecoder& each) {
  Json json;
  json["decoder"] = each.name;
  json["kind"] = each.kind;
  json["packets"] = each.packets;
  json["refused"] = each.refused;
  json["empty"] = each.empty;
  json["reason"] = orNull(each.reason);
  json["fields"] = Json::array();
  for (const SpyField& field : each.fields) {
    json["fields"].push_back({{"field", field.name},
                              {"value", field.number ? Json(*field.number) : orNull(field.value)},
                              {"declared", field.declared},
                              {"used", field.used}});
  }
  return json;
}

Json deviceJson(const SpyDevice& each) {
  Json json;
  json["device"] = each.name;
  json["sources"] = each.sources;
  json["rate_hz"] = each.rate_hz;
  json["statements"] = each.statements;
  json["changes"] = each.changes;
  json["silent_s"] = secondsOf(each.silent);
  json["presence"] = each.presence;
  json["joints"] = each.joints;
  json["named_joints"] = Json::object();
  for (const auto& [joint, value] : each.named_joints) json["named_joints"][joint] = value;
  json["pose"] = Json();
  if (each.pose) {
    const auto& [at, turn] = *each.pose;
    json["pose"] = {at.x, at.y, at.z, turn.x, turn.y, turn.z, turn.w};
  }
  json["carrier"] = each.carrier;
  return json;
}

Json signalJson(const SpySignal& each) {
  Json json;
  json["signal"] = each.name;
  json["value"] = each.kind == SignalKind::number    ? Json(each.number)
                  : each.kind == SignalKind::boolean ? Json(each.number != 0)
                                                     : Json(each.text);
  json["unit"] = orNull(each.unit);
  json["source"] = each.source;
  return json;
}

Json faultJson(const SpyFault& each) {
  Json json;
  json["fault"] = std::string(nameOf(each.kind));
  json["count"] = each.count;
  json["sender"] = each.sender;
  json["line"] = each.line_number;
  json["column"] = each.column;
  json["text"] = each.line;
  json["hint"] = each.hint;
  json["id"] = ruleOf(each.kind).rule;
  return json;
}

}  // namespace

std::string spyJson(const SpyReport& report, bool indented) {
  Json json;
  json["format"] = 1;
  json["watched_s"] = secondsOf(report.watched);
  json["datagrams"] = report.datagrams;
  json["packets"] = report.packets;
  json["decoded"] = report.decoded;
  json["more_senders"] = report.more_senders;
  json["more_events"] = report.more_events;
  for (const char* key : {"endpoints", "senders", "decoders", "sources", "devices", "signals",
                          "drawings", "events", "faults", "reasons"}) {
    json[key] = Json::array();
  }
  for (const auto& each : report.endpoints) json["endpoints"].push_back(endpointJson(each));
  for (const auto& each : report.senders) json["senders"].push_back(senderJson(each, report));
  for (const auto& each : report.decoders) json["decoders"].push_back(decoderJson(each));
  for (const auto& each : report.sources) json["sources"].push_back(sourceJson(each));
  for (const auto& each : report.devices) json["devices"].push_back(deviceJson(each));
  for (const auto& each : report.signals) json["signals"].push_back(signalJson(each));
  for (const SpyDrawing& each : report.drawings) {
    json["drawings"].push_back({{"drawing", each.name},
                                {"source", each.source},
                                {"parts", each.parts},
                                {"statement", each.text}});
  }
  for (const SpyEvent& each : report.events) {
    json["events"].push_back({{"event", each.text},
                              {"source", each.source},
                              {"count", each.count},
                              {"silent_s", secondsOf(each.silent)}});
  }
  for (const auto& each : report.faults) json["faults"].push_back(faultJson(each));
  for (const Finding& each : report.reasons) {
    json["reasons"].push_back({{"text", each.text},
                               {"hint", each.hint},
                               {"id", each.rule},
                               {"severity", nameOf(each.severity)},
                               {"count", each.count},
                               {"example", each.example}});
  }
  return jsonText(json, indented ? 2 : -1);
}

}  // namespace rocinante
