#include "core/report/traffic_findings.h"

#include <fmt/format.h>

#include "core/base/figure_text.h"

namespace rocinante {
namespace {

std::string wholeSeconds(Nanoseconds time) {
  return fmt::format("{} s", std::chrono::floor<std::chrono::seconds>(time).count());
}

std::string_view hintFor(Reach reach) {
  switch (reach) {
    case Reach::watched:
      return "does it pass this interface, and does filter= let it through? on the receiver's "
             "machine it does pass";
    case Reach::multicast:
      return "does the sender send to this group and port, out of the interface named here "
             "(interface=), with a ttl that reaches this machine? 'ip maddr' shows the groups "
             "joined";
    case Reach::subscribed:
      return "does the relay run there, and does anything that it receives match device= and "
             "source=?";
    case Reach::served:
      return "does the sender publish below this subject, on this server or one that is connected "
             "to "
             "it?";
    case Reach::unicast:
      break;
  }
  return "does the sender send to this machine and this port? a firewall in between ('nft list "
         "ruleset') drops silently";
}

}  // namespace

Finding nothingReceived(std::string_view endpoints, Reach reach, Nanoseconds watched) {
  return {.rule = "live.nothing-received",
          .text = fmt::format("nothing received on {} for {}", endpoints, wholeSeconds(watched)),
          .hint = std::string(hintFor(reach))};
}

Finding nothingTrusted(std::uint64_t datagrams, std::string_view reasons) {
  return {.rule = "live.untrusted",
          .text = fmt::format("{} received, none of them trusted: {}",
                              countText(datagrams, "datagram"), reasons),
          .hint =
              "does the sender sign (--key), does --trust list its key, and are both clocks "
              "right?"};
}

Finding nothingSince(std::string_view endpoint, Nanoseconds silent) {
  return {.rule = "live.silent",
          .severity = Severity::warning,
          .text = fmt::format("nothing received{}{} for the last {}",
                              endpoint.empty() ? "" : " on ", endpoint, wholeSeconds(silent)),
          .hint = "the sender stopped, or the network path is broken"};
}

Finding nothingDecoded(std::uint64_t datagrams, std::string_view sample, std::string_view sender) {
  std::string text =
      fmt::format("{} received, none of them a packet", countText(datagrams, "datagram"));
  if (!sample.empty()) {
    text += sender.empty() ? fmt::format("; the first begins {}", sample)
                           : fmt::format("; the first, from {}, begins {}", sender, sample);
  }
  return {.rule = "live.nothing-decoded",
          .text = std::move(text),
          .hint = std::string(kPacketTextHint)};
}

Finding noDeviceNamed() {
  return {.rule = "live.no-device",
          .severity = Severity::warning,
          .text = "packets arrive, but none is about a device",
          .hint = "joints DEVICE ..., joint DEVICE NAME=..., pose DEVICE ... make things move"};
}

Finding unknownDevice(const std::string& name) {
  return {.rule = "packet.unknown-device",
          .text = fmt::format("the cell has no device {}, and no `add` brings it", name),
          .hint = "name the device as the cell does, or let the source `add` it",
          .subject = name};
}

}  // namespace rocinante
