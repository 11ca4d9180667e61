#include "viewer/ui/live/live_reason.h"

#include <fmt/format.h>

#include "core/base/count_text.h"
#include "core/base/duration_text.h"

namespace rocinante {
namespace {

/// Silence shorter than this is not reported.
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
    return "does the traffic pass this interface, and does filter= let it through?";
  }
  if (endpoint.isMulticast()) {
    return "does the sender send to this group and port, out of the interface named here "
           "(interface=), with a ttl that reaches this machine?";
  }
  return "does the sender send to this machine and port? a firewall drops packets silently";
}

}  // namespace

std::optional<LiveReason> liveReason(const LiveFacts& facts) {
  if (facts.datagrams == 0) {
    if (facts.watched < kPatience || facts.endpoints.empty()) return std::nullopt;
    return LiveReason{fmt::format("nothing received on {} for {}", allOf(facts.endpoints),
                                  wholeSeconds(facts.watched)),
                      hintFor(facts.endpoints.front())};
  }
  if (facts.undecoded == facts.datagrams) {
    return LiveReason{fmt::format("{} received, none of them a packet{}{}",
                                  countText(facts.datagrams, "datagram"),
                                  facts.undecoded_sample.empty() ? "" : "; the first begins ",
                                  facts.undecoded_sample),
                      "packet text must begin with: RK1 SOURCE SEQUENCE TIME"};
  }
  if (facts.silent >= kPatience) {
    return LiveReason{fmt::format("nothing received for the last {}", wholeSeconds(facts.silent)),
                      "the sender stopped, or the connection is cut; the last known state is "
                      "shown"};
  }
  if (facts.devices_spoken_of == 0 && facts.watched >= kPatience) {
    return LiveReason{"packets arrive, but none is about a device",
                      "joints DEVICE ..., joint DEVICE NAME=..., pose DEVICE ... make things move"};
  }
  if (!facts.unknown_device.empty()) {
    return LiveReason{
        fmt::format("packets name {}, which is not in this cell", facts.unknown_device),
        "a device must be in the cell or be added first with `add`"};
  }
  return std::nullopt;
}

}  // namespace rocinante
