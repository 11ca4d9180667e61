#include "viewer/ui/live/live_reason.h"

#include "core/report/traffic_findings.h"

namespace rocinante {
namespace {

std::string allOf(const std::vector<Endpoint>& endpoints) {
  std::string text;
  for (const Endpoint& endpoint : endpoints) {
    text += (text.empty() ? "" : ", ") + endpoint.text();
  }
  return text;
}

Reach reachOf(const Endpoint& endpoint) {
  if (endpoint.isPcap()) return Reach::watched;
  if (endpoint.isSubscription()) return Reach::subscribed;
  if (endpoint.isNats()) return Reach::served;
  return endpoint.isMulticast() ? Reach::multicast : Reach::unicast;
}

}  // namespace

std::optional<Finding> liveReason(const LiveFacts& facts) {
  if (facts.datagrams == 0 && facts.untrusted.total() > 0) {
    return nothingTrusted(facts.untrusted.total(), facts.untrusted.text());
  }
  if (facts.datagrams == 0) {
    if (facts.watched < kPatience || facts.endpoints.empty()) return std::nullopt;
    Finding nothing =
        nothingReceived(allOf(facts.endpoints), reachOf(facts.endpoints.front()), facts.watched);
    if (!facts.news.empty()) nothing.hint = facts.news;
    return nothing;
  }
  if (facts.undecoded == facts.datagrams) {
    return nothingDecoded(facts.datagrams, facts.undecoded_sample, "");
  }
  // People who look on together may be silent.
  if (facts.silent >= kPatience && !facts.only_windows) {
    Finding silence = nothingSince("", facts.silent);
    if (facts.any_window) silence.text += ", except from other windows";
    silence.hint += "; the last known state is shown";
    if (!facts.news.empty()) silence.hint = facts.news;
    return silence;
  }
  if (facts.devices_spoken_of == 0 && facts.watched >= kPatience && !facts.only_windows) {
    return noDeviceNamed();
  }
  if (!facts.unknown_device.empty()) return unknownDevice(facts.unknown_device);
  return std::nullopt;
}

}  // namespace rocinante
