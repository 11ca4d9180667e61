#pragma once

#include <memory>
#include <string_view>

#include "core/base/bytes.h"
#include "core/packet/packet.h"

namespace rocinante {

/// Turns datagrams of one message encoding into packets. A log keeps any datagram; its meaning is
/// left to a decoder, and packet text is the first one. Holds scratch memory: one per thread.
class Decoder {
 public:
  virtual ~Decoder() = default;

  /// The MCAP message encoding that this decoder reads: "rk1".
  virtual std::string_view encoding() const = 0;

  /// The packet in `datagram`, or null when it does not hold one (`faults()` then says why). Its
  /// views stay valid until the next call on this decoder, and while `datagram` lives. Otherwise
  /// never fails: a malformed line is skipped and listed among the packet's faults.
  virtual const Packet* decode(ByteView datagram) = 0;

  /// The faults of the last datagram, also when it was not a packet.
  virtual std::span<const FaultAt> faults() const = 0;
};

/// The decoder for `encoding`, or null when there is none (such messages are kept, not decoded).
std::unique_ptr<Decoder> makeDecoder(std::string_view encoding);

/// "rk1" when the datagram begins like packet text, else "octets": the message encoding that a
/// recorder gives the channel.
std::string_view encodingOf(ByteView datagram);

}  // namespace rocinante
