#pragma once

#include <cstdint>
#include <string_view>

#include "core/base/time.h"
#include "core/report/finding.h"

namespace rocinante {

// Why nothing may move, as every program says it that listens: docs/programs/spy.md lists the ids.

/// Silence shorter than this is not reported.
constexpr Nanoseconds kPatience = std::chrono::seconds(2);

/// What to do about datagrams that are not packet text.
constexpr std::string_view kPacketTextHint =
    "packet text must begin with: RK1 SOURCE SEQUENCE TIME";

/// How datagrams reach an endpoint.
enum class Reach : std::uint8_t {
  unicast,
  multicast,
  watched,     ///< pcap://: traffic that has another receiver
  subscribed,  ///< subscribe://: what a relay sends
  served,      ///< nats://: what a server forwards
};

/// `endpoints`: those listened on, as text, since `watched` ago.
Finding nothingReceived(std::string_view endpoints, Reach reach, Nanoseconds watched);
/// `reasons`: how many of them for which reason.
Finding nothingTrusted(std::uint64_t datagrams, std::string_view reasons);
/// `endpoint` may be empty: all of them.
Finding nothingSince(std::string_view endpoint, Nanoseconds silent);
/// `sample`: the beginning of the first datagram, printable; `sender`: its sender. Both may be
/// empty.
Finding nothingDecoded(std::uint64_t datagrams, std::string_view sample, std::string_view sender);
/// Packets come, and none is about a device.
Finding noDeviceNamed();
/// Packets name a device that the cell does not have.
Finding unknownDevice(const std::string& name);

}  // namespace rocinante
