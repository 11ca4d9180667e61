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
  /// Where it was sent, from a source that watches others' traffic; borrowed as the payload is.
  /// Null: to the source's boundAddress().
  const SocketAddress* destination = nullptr;
};

/// What came to a source and was not given on. None of it is a loss: it was not wanted, or was no
/// datagram.
struct InputCounts {
  std::uint64_t refused = 0;     ///< datagrams from a sender that is not allowed
  std::uint64_t echoes = 0;      ///< datagrams that this program itself sent on
  std::uint64_t incomplete = 0;  ///< datagrams of which fragments never came, or contradict
  std::uint64_t malformed = 0;   ///< frames that break the rules of IP or UDP
  std::uint64_t other = 0;       ///< frames that are no UDP
  bool operator==(const InputCounts&) const = default;
};

/// Where datagrams come from: a UDP socket, watched traffic, or what a test hands in. One thread.
class DatagramSource {
 public:
  virtual ~DatagramSource() = default;

  /// What is waiting, up to a batch; empty when nothing is. Never blocks.
  virtual Result<std::span<const ReceivedDatagram>> receive() = 0;

  /// Datagrams dropped before they could be received, as far as those received told.
  virtual std::uint64_t dropped() const = 0;
  /// The same asked for now: also counts drops after the last datagram received. Never goes back.
  virtual Result<std::uint64_t> droppedByNow() = 0;
  virtual InputCounts counts() const { return {}; }

  /// Now and then, when receive() gave nothing: mends what the system took away, such as a group
  /// whose interface was made anew. A sentence for the user when that changes what is heard.
  virtual std::optional<std::string> maintain() { return std::nullopt; }
  /// For so long the system may keep what has arrived before it gives it: 0 for a socket.
  virtual Nanoseconds deliveryDelay() const { return Nanoseconds(0); }
  /// Nothing will ever come again: the end of a capture file.
  virtual bool ended() const { return false; }
  /// For poll(); -1: there is none, ask again in a few milliseconds. May change with tend().
  virtual int fileDescriptor() const { return -1; }
  /// What the kernel granted for waiting datagrams, as it counts it; 0: not of this kind.
  virtual std::uint64_t receiveBufferBytes() const { return 0; }

  virtual const Endpoint& endpoint() const = 0;
  /// The endpoint's address with the port that was bound (":0" takes a free one).
  virtual const SocketAddress& boundAddress() const = 0;
};

/// The source's endpoint with the port that was bound, as users are told it.
std::string boundText(const DatagramSource& source);

}  // namespace rocinante
