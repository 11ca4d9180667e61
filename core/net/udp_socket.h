#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/bytes.h"
#include "core/net/endpoint.h"
#include "core/result.h"
#include "core/time.h"

namespace rocinante {

/// A datagram as the socket gave it.
struct ReceivedDatagram {
  ByteView payload;  ///< borrowed from the receiver until its next receive()
  SocketAddress sender;
  WallTime kernel_time{};  ///< the kernel's stamp (SO_TIMESTAMPNS), CLOCK_REALTIME
  bool truncated = false;
};

/// A listening UDP socket: many datagrams a call, with the kernel's time stamps and drop counts.
/// UDP_GRO stays off: it hides drops and shares one stamp. Linux. One thread.
class UdpReceiver {
 public:
  struct Options {
    int receive_buffer_bytes = 32 << 20;  ///< SO_RCVBUFFORCE when allowed, else SO_RCVBUF
  };

  /// Binds exclusively when the endpoint is unicast; a port that is taken is refused with the
  /// holder's name and pid when they can be found. Joins the group when it is multicast.
  static Result<UdpReceiver> open(const Endpoint& endpoint, const Options& options);
  static Result<UdpReceiver> open(const Endpoint& endpoint) { return open(endpoint, Options()); }

  ~UdpReceiver();
  UdpReceiver(UdpReceiver&&) noexcept;
  UdpReceiver& operator=(UdpReceiver&&) noexcept;

  /// What is waiting, up to a batch; empty when nothing is. Never blocks.
  Result<std::span<const ReceivedDatagram>> receive();

  /// Datagrams that the kernel dropped since open (SO_RXQ_OVFL, counted beyond 32 bits).
  std::uint64_t dropped() const;
  /// The same by SO_MEMINFO, which also counts drops after the last datagram received.
  Result<std::uint64_t> droppedByNow();
  /// What the kernel granted, as it counts it.
  int receiveBufferBytes() const;

  const Endpoint& endpoint() const;
  /// The endpoint with the port that was bound (":0" takes a free one).
  const SocketAddress& boundAddress() const;
  int fileDescriptor() const;  ///< for poll()

 private:
  struct Impl;
  explicit UdpReceiver(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// A sending UDP socket, unicast or multicast. One thread.
class UdpSender {
 public:
  static Result<UdpSender> open(const Endpoint& to);

  ~UdpSender();
  UdpSender(UdpSender&&) noexcept;
  UdpSender& operator=(UdpSender&&) noexcept;

  /// Sends one datagram. ECONNREFUSED (nobody listens) is no failure; a full buffer waits.
  Status send(ByteView payload);
  /// Sends all of them, in order, in as few system calls as can be (sendmmsg).
  Status send(std::span<const ByteView> payloads);

  const Endpoint& endpoint() const;

 private:
  struct Impl;
  explicit UdpSender(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace rocinante
