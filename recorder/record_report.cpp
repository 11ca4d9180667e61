#include "recorder/record_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/size_text.h"

namespace rocinante {
namespace {

using Json = nlohmann::ordered_json;

double secondsOf(Nanoseconds duration) { return std::chrono::duration<double>(duration).count(); }

std::string counted(std::uint64_t count, std::string_view one) {
  return fmt::format("{} {}{}", count, one, count == 1 ? "" : "s");
}

std::string endpointText(const ListenedEndpoint& listened) {
  Endpoint endpoint = listened.endpoint;
  endpoint.address.port = listened.bound.port;
  return endpoint.text();
}

void addCounts(Json& object, const LossCounts& counts) {
  object["kernel"] = counts.kernel;
  object["queue"] = counts.queue;
  object["disk"] = counts.disk;
  object["truncated"] = counts.truncated;
}

}  // namespace

std::string statusText(const RecordProgress& now, const RecordProgress& before) {
  const double span = secondsOf(now.elapsed - before.elapsed);
  const std::uint64_t news = now.packets - std::min(now.packets, before.packets);
  const double rate = span > 0 ? static_cast<double>(news) / span : 0;
  return fmt::format("{:.1f} s   {:.0f} packets/s   {}   {} lost   {}", secondsOf(now.elapsed),
                     rate, counted(now.packets, "packet"), now.lost, sizeText(now.log_bytes));
}

std::string summaryText(const RecordSummary& summary) {
  std::string text =
      fmt::format("recorded {} on {} in {:.1f} s: {} ({})", counted(summary.packets, "packet"),
                  counted(summary.channels, "channel"), secondsOf(summary.duration),
                  summary.log.string(), sizeText(summary.log_bytes));
  for (const EndpointAccount& each : summary.endpoints) {
    const LossCounts& lost = each.losses;
    if (lost == LossCounts{}) continue;
    text += fmt::format("\nlost at {}: {} in the kernel, {} in the queue, {} on the disk; {} cut",
                        endpointText(each.listened), lost.kernel, lost.queue, lost.disk,
                        lost.truncated);
  }
  return text;
}

std::string summaryJson(const RecordSummary& summary) {
  Json object;
  object["format"] = 1;
  object["log"] = summary.log.string();
  object["packets"] = summary.packets;
  object["restated"] = summary.restated;
  object["bytes"] = summary.log_bytes;
  object["payload_bytes"] = summary.payload_bytes;
  object["channels"] = summary.channels;
  object["duration_s"] = secondsOf(summary.duration);
  addCounts(object["losses"], summary.losses);
  object["complete"] = !summary.trouble;
  object["reason"] = summary.reason;
  object["late"] = summary.late;
  object["endpoints"] = Json::array();
  for (const EndpointAccount& each : summary.endpoints) {
    Json endpoint;
    endpoint["endpoint"] = endpointText(each.listened);
    endpoint["packets"] = each.recorded;
    addCounts(endpoint["losses"], each.losses);
    object["endpoints"].push_back(std::move(endpoint));
  }
  // A file name that is no UTF-8 must not throw.
  return object.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace rocinante
