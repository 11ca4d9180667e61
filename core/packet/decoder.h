#pragma once

#include <memory>
#include <string_view>

#include "core/base/bytes.h"
#include "core/packet/packet.h"

namespace rocinante {

/// Turns datagrams of one message encoding into packets. A log keeps any datagram; what it means
/// is a decoder's business, and packet text is the first. Holds scratch memory: one a thread.
class Decoder {
 public:
  virtual ~Decoder() = default;

  /// The MCAP message encoding that this decoder reads: "rk1".
  virtual std::string_view encoding() const = 0;

  /// The packet in `datagram`, or null when it holds none (`faults()` then says why). What it
  /// points to stays valid until the next call on this decoder, and while `datagram` lives.
  /// Never fails otherwise: a malformed line is left out and listed among the packet's faults.
  virtual const Packet* decode(ByteView datagram) = 0;

  /// The faults of the last datagram, also when it was no packet.
  virtual std::span<const FaultAt> faults() const = 0;
};

/// The decoder for `encoding`, or null when there is none (such messages are kept, not decoded).
std::unique_ptr<Decoder> makeDecoder(std::string_view encoding);

/// "rk1" when the datagram begins as packet text does, else "octets": what a recorder writes as
/// the channel's message encoding.
std::string_view encodingOf(ByteView datagram);

}  // namespace rocinante
