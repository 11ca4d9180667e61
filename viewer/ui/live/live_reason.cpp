#include "viewer/ui/live/live_reason.h"

#include <fmt/format.h>

#include "core/base/count_text.h"
#include "core/base/duration_text.h"

namespace rocinante {
namespace {

/// Shorter than this nothing can be said about what does not come.
constexpr Nanoseconds kPatience = std::chrono::seconds(2);

std::string wholeSeconds(Nanoseconds time) {
  return fmt::format("{} s", std::chrono::floor<std::chrono::seconds>(time).count());
}

std::string allOf(const std::vector<Endpoint>& endpoints) {
  std::string text;
  for (const Endpoint& endpoint : endpoints) {
    text += (text.empty() ? "" : ", ") + endpoint.text();
  }
  return text;
}

std::string hintFor(const Endpoint& endpoint) {
  if (endpoint.isPcap()) {
    return "does it pass this interface, and does filter= let it through?";
  }
  if (endpoint.isMulticast()) {
    return "does the sender send to this group and port, out of the interface named here "
           "(interface=), with a ttl that reaches this machine?";
  }
  return "does the sender send to this machine and this port? a firewall in between drops in "
         "silence";
}

}  // namespace

std::optional<LiveReason> liveReason(const LiveFacts& facts) {
  if (facts.datagrams == 0) {
    if (facts.watched < kPatience || facts.endpoints.empty()) return std::nullopt;
    return LiveReason{fmt::format("nothing has come to {} for {}", allOf(facts.endpoints),
                                  wholeSeconds(facts.watched)),
                      hintFor(facts.endpoints.front())};
  }
  if (facts.undecoded == facts.datagrams) {
    return LiveReason{
        fmt::format("{} came, and none is a packet{}{}", countText(facts.datagrams, "datagram"),
                    facts.undecoded_sample.empty() ? "" : "; the first begins ",
                    facts.undecoded_sample),
        "packet text begins with: RK1 SOURCE SEQUENCE TIME"};
  }
  if (facts.silent >= kPatience) {
    return LiveReason{fmt::format("nothing has come for the last {}", wholeSeconds(facts.silent)),
                      "the sender stopped, or the way to here is cut; what is shown is what was "
                      "said last"};
  }
  if (facts.devices_spoken_of == 0 && facts.watched >= kPatience) {
    return LiveReason{"packets come, but none says anything about a device",
                      "joints DEVICE ..., joint DEVICE NAME=..., pose DEVICE ... make things move"};
  }
  if (!facts.unknown_device.empty()) {
    return LiveReason{
        fmt::format("packets speak of {}, which this cell does not have", facts.unknown_device),
        "names of devices are those of the cell, or of an `add` before"};
  }
  return std::nullopt;
}

}  // namespace rocinante
