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
#include "core/report/account.h"
#include "core/report/finding.h"
#include "core/report/traffic_findings.h"

namespace rocinante {

/// Traffic of one listening endpoint.
struct SpyEndpoint {
  std::string endpoint;  ///< with the bound port
  Reach reach = Reach::unicast;
  std::uint64_t datagrams = 0;
  std::uint64_t bytes = 0;
  std::uint64_t dropped = 0;  ///< by the kernel
  InputCounts counts;
  Account left_out;  ///< by kind: frames that became no datagram
  std::uint64_t senders = 0;
  std::optional<Nanoseconds> silent;  ///< since the last datagram; empty when none came
};

/// A sender: one address and port at one endpoint.
struct SpySender {
  std::size_t endpoint = 0;  ///< index in SpyReport::endpoints
  std::string address;
  std::string to;  ///< destination of watched traffic
  std::uint64_t datagrams = 0;
  std::uint64_t packets = 0;  ///< of these, packet text or decoded
  double rate_hz = 0;         ///< over the last two seconds
  std::size_t smallest_bytes = 0;
  std::size_t largest_bytes = 0;
  Nanoseconds silent{};
  std::string first_bytes;  ///< of the first datagram that is not a packet; safe to print
};

/// One SOURCE, from any sender.
struct SpySource {
  std::string name;
  std::string run;
  std::vector<std::string> senders;  ///< the first few addresses
  std::uint64_t turns = 0;           ///< times that an earlier sender sent again after another
  std::uint64_t packets = 0;         ///< applied
  double rate_hz = 0;
  std::uint64_t gap = 0, late = 0, restarts = 0, faults = 0;
  std::uint64_t restated = 0;  ///< packets that restate
  std::uint64_t by_others = 0;
  std::uint64_t duplicates = 0;  ///< of `late`: a number received before
  Nanoseconds silent{};
  /// TIME minus the arrival of the last packet: the clock difference minus the transit time.
  std::optional<Nanoseconds> clock_offset;
};

struct SpyDevice {
  std::string name;
  std::vector<std::string> sources;  ///< the first few that wrote to it
  std::uint64_t statements = 0;      ///< joints, joint and pose
  double rate_hz = 0;
  std::uint64_t changes = 0;   ///< of these, those with new values
  Nanoseconds silent{};        ///< since the last statement about it
  std::string presence;        ///< "added MODEL", "removed" or empty
  std::vector<double> joints;  ///< last positional values, radians and metres
  std::map<std::string, double> named_joints;
  std::optional<Pose> pose;
  std::string carrier;  ///< "arm/tool", or empty for the world; safe to print
};

/// A signal as it was stated last.
struct SpySignal {
  std::string name;   ///< "signal arm mode": as packets write it
  std::string value;  ///< likewise, with its unit; safe to print, cut
  SignalKind kind{};
  double number = 0;   ///< of booleans 1 or 0
  std::string text;    ///< of texts; as stated
  std::string unit;    ///< empty: none was stated
  std::string source;  ///< that stated it last
};

/// A drawing that a source has not removed.
struct SpyDrawing {
  std::string name, source;
  std::size_t parts = 0;  ///< parts received
  std::string text;       ///< the statement of its first part; safe to print, cut
};

/// An `event` text of a source, with its count.
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
  std::string line;  ///< safe to print; empty when the datagram is not text
  std::uint32_t line_number = 0;
  std::uint32_t column = 0;  ///< in bytes, from 1; 0: the whole line
  std::string hint;
};

/// A field of the last datagram that a decoder could read.
struct SpyField {
  std::string name;
  std::optional<std::string> value;  ///< safe to print, cut; empty: the datagram lacks it
  std::optional<double> number;      ///< the value as a number, if it is one
  bool declared = true;              ///< false: the bytes name it, no declaration points to it
  bool used = true;                  ///< by a line, a condition or the decoder itself
};

/// A declared decoder and what became of the datagrams that fit it.
struct SpyDecoder {
  std::string name, kind;
  std::uint64_t packets = 0, refused = 0;
  std::uint64_t empty = 0;       ///< none of its lines applied
  std::string reason;            ///< why the last one was refused
  std::vector<SpyField> fields;  ///< declared ones first
};

/// The observations of a spy up to a moment.
struct SpyReport {
  Nanoseconds watched{};
  std::uint64_t datagrams = 0;
  std::uint64_t packets = 0;  ///< packet text, and what decoders made
  std::uint64_t decoded = 0;  ///< of these, made by decoders
  std::vector<SpyEndpoint> endpoints;
  std::vector<SpySender> senders;    ///< in order of appearance
  std::uint64_t more_senders = 0;    ///< datagrams of senders beyond those kept
  std::vector<SpyDecoder> decoders;  ///< as declared
  std::vector<SpySource> sources;    ///< by name
  std::vector<SpyDevice> devices;    ///< by name
  std::vector<SpySignal> signals;    ///< by device and name, then those of no device
  std::vector<SpyDrawing> drawings;  ///< by source and name
  std::vector<SpyEvent> events;      ///< by source and text
  std::uint64_t more_events = 0;     ///< events beyond those kept
  std::vector<SpyFault> faults;      ///< the most frequent first
  Findings reasons;                  ///< why something may not move, likeliest first
};

}  // namespace rocinante
