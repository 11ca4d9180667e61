#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/base/time.h"
#include "core/net/endpoint.h"

namespace rocinante {

/// A datagram as the socket gave it.
struct ReceivedDatagram {
  ByteView payload;  ///< borrowed from the source until its next receive()
  SocketAddress sender;
  WallTime kernel_time{};  ///< the kernel's stamp (SO_TIMESTAMPNS), CLOCK_REALTIME
  bool truncated = false;
  /// The destination, from a source that watches others' traffic; borrowed like the payload. Null:
  /// the source's boundAddress().
  const SocketAddress* destination = nullptr;
};

/// Arrivals that a source did not pass on. None of them is a loss: they were not wanted, or were
/// not datagrams.
struct InputCounts {
  std::uint64_t refused = 0;     ///< datagrams from a sender that is not allowed
  std::uint64_t echoes = 0;      ///< datagrams that this program itself forwarded
  std::uint64_t incomplete = 0;  ///< datagrams with missing or contradictory fragments
  std::uint64_t malformed = 0;   ///< frames that break the rules of IP or UDP
  std::uint64_t other = 0;       ///< frames that are not UDP
  bool operator==(const InputCounts&) const = default;
};

/// A source of datagrams: a UDP socket, watched traffic, or a test's fake. One thread.
class DatagramSource {
 public:
  virtual ~DatagramSource() = default;

  /// The waiting datagrams, up to a batch; empty when there are none. Never blocks.
  virtual Result<std::span<const ReceivedDatagram>> receive() = 0;

  /// Datagrams dropped before they could be received, as reported with those received so far.
  virtual std::uint64_t dropped() const = 0;
  /// The same, queried now: also counts drops after the last datagram received. Never decreases.
  virtual Result<std::uint64_t> droppedByNow() = 0;
  virtual InputCounts counts() const { return {}; }

  /// To be called now and then when receive() gave nothing: repairs what the system took away, such
  /// as the membership of a group whose interface was recreated. Returns a sentence for the user
  /// when this changes what is received.
  virtual std::optional<std::string> maintain() { return std::nullopt; }
  /// The longest that the kernel may delay delivery: 0 for a socket.
  virtual Nanoseconds deliveryDelay() const { return Nanoseconds(0); }
  /// Nothing more will ever arrive: the end of a capture file.
  virtual bool ended() const { return false; }
  /// For poll(); -1: there is none, ask again in a few milliseconds. May change with maintain().
  virtual int fileDescriptor() const { return -1; }
  /// The buffer for waiting datagrams that the kernel granted, as it counts it; 0: not a socket.
  virtual std::uint64_t receiveBufferBytes() const { return 0; }

  virtual const Endpoint& endpoint() const = 0;
  /// The endpoint's address with the port that was bound (":0" takes a free one).
  virtual const SocketAddress& boundAddress() const = 0;
};

/// The source's endpoint with the port that was bound, as shown to users.
std::string boundText(const DatagramSource& source);

}  // namespace rocinante
