#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/time.h"
#include "core/math/vector.h"
#include "core/net/datagram_source.h"
#include "core/packet/packet.h"

namespace rocinante {

/// What has come to one listening endpoint.
struct SpyEndpoint {
  std::string endpoint;  ///< with the port that was bound
  bool multicast = false;
  bool watched = false;  ///< pcap://: traffic that has another receiver
  std::uint64_t datagrams = 0;
  std::uint64_t bytes = 0;
  std::uint64_t dropped = 0;  ///< by the kernel
  InputCounts counts;
  std::uint64_t senders = 0;
  std::optional<Nanoseconds> silent;  ///< since the last datagram; empty when none came
};

/// Who sends: one address and port at one endpoint.
struct SpySender {
  std::size_t endpoint = 0;  ///< index in SpyReport::endpoints
  std::string address;
  std::string to;  ///< of watched traffic: where it sends
  std::uint64_t datagrams = 0;
  std::uint64_t packets = 0;  ///< of those, packet text
  double rate_hz = 0;         ///< over the last two seconds
  std::size_t smallest_bytes = 0;
  std::size_t largest_bytes = 0;
  Nanoseconds silent{};
  std::string first_bytes;  ///< of the first datagram that is no packet; safe to print
};

/// One SOURCE, whoever speaks for it.
struct SpySource {
  std::string name;
  std::string run;
  std::vector<std::string> senders;  ///< the first few addresses
  std::uint64_t turns = 0;           ///< times that an earlier sender spoke again after another
  std::uint64_t packets = 0;         ///< applied
  double rate_hz = 0;
  std::uint64_t gap = 0, late = 0, restarts = 0, faults = 0;
  std::uint64_t restated = 0;  ///< packets that restate
  std::uint64_t by_others = 0;
  Nanoseconds silent{};
  /// TIME less the arrival, of the last packet: the difference of the clocks, less the way.
  std::optional<Nanoseconds> clock_offset;
};

struct SpyDevice {
  std::string name;
  std::vector<std::string> sources;  ///< the first few that wrote about it
  std::uint64_t statements = 0;      ///< joints, joint and pose
  double rate_hz = 0;
  std::uint64_t changes = 0;   ///< of those, such as said something new
  Nanoseconds silent{};        ///< since the last of any statement about it
  std::string presence;        ///< "added MODEL", "removed" or empty
  std::vector<double> joints;  ///< last positional values, radians and metres
  std::map<std::string, double> named_joints;
  std::optional<Pose> pose;
  std::string carrier;  ///< "arm/tool", or empty for the world; safe to print
};

/// Something that a source draws and has not taken back.
struct SpyDrawing {
  std::string name, source;
  std::size_t parts = 0;  ///< of it that have come
  std::string text;       ///< the statement that draws the first of them; safe to print, cut
};

/// What a source said with `event`, however often.
struct SpyEvent {
  std::string text, source;  ///< `text` safe to print, cut
  std::uint64_t count = 0;
  Nanoseconds silent{};  ///< since the last
};

/// One kind of fault, with the first line that has it.
struct SpyFault {
  PacketFault kind{};
  std::uint64_t count = 0;
  std::string sender;
  std::string line;  ///< safe to print; empty when the datagram is no text
  std::uint32_t line_number = 0;
  std::uint32_t column = 0;  ///< in bytes, from 1; 0: the whole line
  std::string hint;
};

/// A reason why something may not move, the likeliest first.
struct SpyReason {
  std::string name;  ///< stable, for scripts: "nothing_arrives", "not_packet_text" ...
  std::string text;
  std::string hint;
};

/// What a spy has seen up to a moment.
struct SpyReport {
  Nanoseconds watched{};
  std::uint64_t datagrams = 0;
  std::uint64_t packets = 0;
  std::vector<SpyEndpoint> endpoints;
  std::vector<SpySender> senders;    ///< in order of appearance
  std::uint64_t more_senders = 0;    ///< beyond what is kept
  std::vector<SpySource> sources;    ///< by name
  std::vector<SpyDevice> devices;    ///< by name
  std::vector<SpyDrawing> drawings;  ///< by source and name
  std::vector<SpyEvent> events;      ///< by source and text
  std::uint64_t more_events = 0;     ///< beyond what is told apart
  std::vector<SpyFault> faults;      ///< the most frequent first
  std::vector<SpyReason> reasons;
};

}  // namespace rocinante
