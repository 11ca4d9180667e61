#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "core/net/datagram_sink.h"
#include "core/net/datagram_source.h"

namespace rocinante {

/// How to hear a unicast port that another program holds, as the error of a taken port says it.
inline constexpr std::string_view kTakenPortAdvice = "use multicast, a relay, --tee or pcap://";

/// A receiving UDP socket: many datagrams a call, with the kernel's timestamps and drop counts.
/// UDP_GRO stays off: it hides drops and gives one timestamp to several datagrams. Linux. One
/// thread.
class UdpReceiver final : public DatagramSource {
 public:
  struct Options {
    int receive_buffer_bytes = 32 << 20;  ///< SO_RCVBUFFORCE when allowed, else SO_RCVBUF
    /// Longer datagrams are cut and marked. No UDP datagram over IPv4 or IPv6 is longer than this.
    std::size_t datagram_bytes = 65'536;
  };

  /// Binds exclusively when the endpoint is unicast; a taken port is refused, with the holder's
  /// name and pid when they can be found. Joins the group when the endpoint is multicast, and then
  /// receives only that group (and only from `source`, if the endpoint names one). [::]:PORT
  /// receives IPv6 only.
  static Result<UdpReceiver> open(const Endpoint& endpoint, const Options& options);
  static Result<UdpReceiver> open(const Endpoint& endpoint) { return open(endpoint, Options()); }

  ~UdpReceiver() override;
  UdpReceiver(UdpReceiver&&) noexcept;
  UdpReceiver& operator=(UdpReceiver&&) noexcept;

  Result<std::span<const ReceivedDatagram>> receive() override;

  /// Sends one datagram from the bound port, without waiting: a full socket drops it. For requests
  /// whose answers come here.
  Status sendTo(const SocketAddress& to, ByteView payload);

  /// Datagrams that the kernel dropped since open (SO_RXQ_OVFL, counted beyond 32 bits).
  std::uint64_t dropped() const override;
  /// The same from SO_MEMINFO, which also counts drops after the last datagram received.
  Result<std::uint64_t> droppedByNow() override;
  /// The buffer that the kernel granted, as it counts it (twice the size requested).
  std::uint64_t receiveBufferBytes() const override;
  /// Rejoins the group when its interface was removed and has returned, or when the routes to it
  /// have changed; returns a sentence when it does.
  std::optional<std::string> maintain() override;

  const Endpoint& endpoint() const override;
  const SocketAddress& boundAddress() const override;
  int fileDescriptor() const override;

 private:
  struct Impl;
  explicit UdpReceiver(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// A sending UDP socket, unicast or multicast. One thread.
class UdpSender final : public DatagramSink {
 public:
  /// bad_argument when the endpoint has no host or port 0. The endpoint's `source` is the local
  /// address to send from. Multicast datagrams also reach listeners on this machine.
  static Result<UdpSender> open(const Endpoint& to) { return open(to, 0); }
  /// The same from a given local port; refused, with its holder, when the port is taken. 0: any
  /// port.
  static Result<UdpSender> open(const Endpoint& to, std::uint16_t local_port);

  ~UdpSender() override;
  UdpSender(UdpSender&&) noexcept;
  UdpSender& operator=(UdpSender&&) noexcept;

  /// Sends one datagram. ECONNREFUSED (no listener) is not a failure; a full buffer waits.
  Status send(ByteView payload);
  /// Sends all of them, in order, in as few system calls as possible (sendmmsg).
  Status send(std::span<const ByteView> payloads) override;
  /// Sends as many from the front as go without waiting, and returns how many; 0 when the socket or
  /// the device is full. A failure concerns the first.
  Result<std::size_t> sendWithoutWaiting(std::span<const ByteView> payloads) override;

  const Endpoint& endpoint() const override;
  /// The address the datagrams come from, as a receiver on this machine sees it.
  const SocketAddress& localAddress() const;
  int fileDescriptor() const override;  ///< for socket options and transmit timestamps

 private:
  struct Impl;
  explicit UdpSender(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace rocinante
