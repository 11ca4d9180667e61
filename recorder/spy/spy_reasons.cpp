#include "recorder/spy/spy_reasons.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/duration_text.h"
#include "core/base/plain_text.h"
#include "core/cli/text_table.h"

namespace rocinante {
namespace {

using cli::counted;
using cli::grouped;

/// Silence shorter than this is not a reason yet.
constexpr Nanoseconds kPatience = std::chrono::seconds(2);
constexpr Nanoseconds kClockOff = std::chrono::seconds(1);
/// Sources restate every two seconds by default.
constexpr Nanoseconds kRestatements = std::chrono::seconds(5);

std::string_view hintFor(PacketFault fault) {
  switch (fault) {
    case PacketFault::not_a_packet:
      return "the first line must be RK1 SOURCE SEQUENCE TIME; the shortest is: RK1 me - -";
    case PacketFault::bad_header:
      return "SOURCE[@RUN], then a count from 0 or -, then seconds since the epoch or -";
    case PacketFault::unknown_statement:
      return "a typing error, or a statement of a later version: it is skipped";
    case PacketFault::missing_field:
      return "the line ends too early: see docs/packet-format.md for its fields";
    case PacketFault::extra_field:
      return "names with spaces are written with %20, numbers without thousands' separators";
    case PacketFault::bad_name:
      return "1 to 255 bytes of A-Z a-z 0-9 _ . - : and %XX for everything else";
    case PacketFault::bad_number:
      return "decimal with a point: no comma, no nan, no inf, no unit";
    case PacketFault::bad_color:
      return "#RRGGBB or #RRGGBBAA";
    case PacketFault::bad_string:
      return "put it in double quotes, with \\\" \\\\ and \\n as the only escapes";
    case PacketFault::bad_path:
      return "DEVICE, DEVICE/LINK or layer/NAME";
    case PacketFault::zero_quaternion:
      return "the identity rotation is 0 0 0 1: x y z w, w last";
    case PacketFault::unnormalised_quaternion:
      return "it is normalised and used; is the order x y z w, w last?";
    case PacketFault::too_many:
      return "a limit of docs/packet-format.md is exceeded: the rest is ignored";
    case PacketFault::order_mismatch:
      return "joints and order of one device differ in number: nothing is applied";
  }
  return "";
}

class Reasons {
 public:
  explicit Reasons(SpyReport& report) : report_(report) {}

  void find() {
    for (SpyFault& fault : report_.faults) fault.hint = hintFor(fault.kind);
    for (const SpyEndpoint& each : report_.endpoints) judge(each);
    if (report_.datagrams > 0 && report_.packets == 0) sayNotPacketText();
    for (const SpySource& each : report_.sources) judge(each);
    for (const SpyFault& each : report_.faults) judge(each);
    for (const SpyDevice& each : report_.devices) judge(each);
    if (report_.packets > 0 && report_.devices.empty() && report_.watched >= kPatience) {
      say("no_device", "packets come, but none says anything about a device",
          "joints DEVICE ..., joint DEVICE NAME=..., pose DEVICE ... make things move");
    }
  }

 private:
  void say(std::string name, std::string text, std::string hint) {
    report_.reasons.push_back({std::move(name), std::move(text), std::move(hint)});
  }

  void judge(const SpyEndpoint& endpoint) {
    if (endpoint.datagrams == 0 && report_.watched >= kPatience) {
      say("nothing_arrives",
          fmt::format("nothing has come to {} for {:.0f} s", endpoint.endpoint, seconds()),
          endpoint.watched ? "does it pass this interface, and does filter= let it through? on the "
                             "receiver's machine it does pass"
          : endpoint.multicast
              ? "does the sender send to this group and port, out of the interface named here "
                "(interface=), with a ttl that reaches this machine? 'ip maddr' shows the groups "
                "joined"
              : "does the sender send to this machine and this port? a firewall in between ('nft "
                "list ruleset') drops silently");
    } else if (endpoint.silent && *endpoint.silent >= kPatience) {
      say("silent",
          fmt::format("nothing has come to {} for the last {} s", endpoint.endpoint,
                      secondsText(rounded(*endpoint.silent), 1)),
          "the sender stopped, or the network path is broken");
    }
    if (endpoint.counts.refused > 0) {
      say("refused",
          fmt::format("{} at {} came from senders that --allow does not name",
                      counted(endpoint.counts.refused, "datagram"), endpoint.endpoint),
          "name a network with --allow for every sender that should be accepted");
    }
    if (endpoint.counts.incomplete > 0) {
      say("incomplete",
          fmt::format("{} at {} lost some of their fragments",
                      counted(endpoint.counts.incomplete, "datagram"), endpoint.endpoint),
          "lost on the way; datagrams within the MTU (1,472 bytes on Ethernet) need no fragments");
    }
    if (endpoint.counts.malformed > 0) {
      say("malformed",
          fmt::format("{} at {} were malformed IP or UDP",
                      counted(endpoint.counts.malformed, "frame"), endpoint.endpoint),
          "a capture may have kept only the beginning of each frame (tcpdump -s)");
    }
    if (endpoint.dropped > 0) {
      say("kernel_drops",
          fmt::format("the kernel dropped {} at {} before they could be read",
                      counted(endpoint.dropped, "datagram"), endpoint.endpoint),
          "this machine is too busy, or net.core.rmem_max is too small for the rate");
    }
  }

  void sayNotPacketText() {
    std::string example;
    for (const SpySender& each : report_.senders) {
      if (each.first_bytes.empty()) continue;
      example = fmt::format("; {} sent {}", each.address, each.first_bytes);
      break;
    }
    say("not_packet_text",
        fmt::format("{} came, and none is a packet{}", counted(report_.datagrams, "datagram"),
                    example),
        "packet text begins with: RK1 SOURCE SEQUENCE TIME");
  }

  void judge(const SpySource& source) {
    const std::string name = plainText(source.name);
    if (source.turns > 0) {
      say("two_senders",
          fmt::format("{} and {} take turns sending as {}: {} dropped as late, {}",
                      source.senders[0], source.senders[1], name, counted(source.late, "packet"),
                      counted(source.restarts, "restart")),
          "give every sender a SOURCE of its own");
    } else if (source.late > 0 && source.late * 4 >= source.packets) {
      say("late",
          fmt::format("{} of {} dropped as late, {} applied", counted(source.late, "packet"), name,
                      grouped(source.packets)),
          "SEQUENCE must grow by one with every datagram, and begin at 0 when the source starts");
    }
    if (source.gap > 0) {
      say("gap", fmt::format("{} of {} never came", counted(source.gap, "packet"), name),
          "lost on the way: the network, or a receiver's buffer");
    }
    if (source.restarts > 1 && source.restarts * 4 >= source.packets) {
      say("restarts",
          fmt::format("{} restarted {} times in {}", name, source.restarts,
                      counted(source.packets, "packet")),
          "choose RUN once, when the source starts");
    }
    if (source.clock_offset && std::chrono::abs(*source.clock_offset) >= kClockOff) {
      const bool ahead = *source.clock_offset > Nanoseconds(0);
      say("clock",
          fmt::format("the clock of {} is {} s {} this machine's", name,
                      secondsText(rounded(std::chrono::abs(*source.clock_offset)), 1),
                      ahead ? "ahead of" : "behind"),
          "nothing here depends on it, but comparing times with other logs does");
    }
    if (source.packets > 0 && source.restated == 0 && report_.watched >= kRestatements) {
      say("never_restates", fmt::format("{} has restated nothing in {:.0f} s", name, seconds()),
          "late joiners miss what was sent only once: add, order, colours, drawings");
    }
  }

  void judge(const SpyFault& fault) {
    if (fault.kind == PacketFault::not_a_packet && report_.packets == 0)
      return;  // reported by sayNotPacketText()
    const std::string where =
        fault.column > 0 ? fmt::format("line {}, column {}", fault.line_number, fault.column)
                         : fmt::format("line {}", fault.line_number);
    say(std::string(nameOf(fault.kind)),
        fmt::format("{}: {}, the first from {}, {}: {}", nameOf(fault.kind),
                    counted(fault.count, "line"), fault.sender, where, fault.line),
        fault.hint);
  }

  void judge(const SpyDevice& device) {
    const std::string name = plainText(device.name);
    if (device.presence == "removed" && device.statements > 0) {
      say("removed", fmt::format("{} has been removed", name),
          "statements about it are kept and shown when it is added again");
    }
    if (device.sources.size() > 1) {
      say("two_sources",
          fmt::format("{} and {} both write {}", plainText(device.sources[0]),
                      plainText(device.sources[1]), name),
          "the last write wins: the device will jump between them");
    }
    if (device.statements > 1 && device.changes == 0 && report_.watched >= kPatience) {
      say("constant",
          fmt::format("{} received {} statements, all with the same values", name,
                      device.statements),
          "the machine is at rest, or its sender reads values that do not change");
    }
  }

  double seconds() const { return std::chrono::duration<double>(report_.watched).count(); }
  static Nanoseconds rounded(Nanoseconds time) {
    return std::chrono::round<std::chrono::milliseconds>(time);
  }

  SpyReport& report_;
};

}  // namespace

void findReasons(SpyReport& report) { Reasons(report).find(); }

}  // namespace rocinante
