#pragma once

#include <cstdint>
#include <span>

#include "core/bytes.h"
#include "core/net/endpoint.h"
#include "core/result.h"
#include "core/time.h"

namespace rocinante {

/// A datagram as the socket gave it.
struct ReceivedDatagram {
  ByteView payload;  ///< borrowed from the source until its next receive()
  SocketAddress sender;
  WallTime kernel_time{};  ///< the kernel's stamp (SO_TIMESTAMPNS), CLOCK_REALTIME
  bool truncated = false;
};

/// Where datagrams come from: a UDP socket, or what a test hands in. One thread.
class DatagramSource {
 public:
  virtual ~DatagramSource() = default;

  /// What is waiting, up to a batch; empty when nothing is. Never blocks.
  virtual Result<std::span<const ReceivedDatagram>> receive() = 0;

  /// Datagrams dropped before they could be received, as far as those received told.
  virtual std::uint64_t dropped() const = 0;
  /// The same asked for now: also counts drops after the last datagram received. Never goes back.
  virtual Result<std::uint64_t> droppedByNow() = 0;

  virtual const Endpoint& endpoint() const = 0;
  /// The endpoint's address with the port that was bound (":0" takes a free one).
  virtual const SocketAddress& boundAddress() const = 0;
};

}  // namespace rocinante
