#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>

#include "core/net/port_holder.h"
#include "core/net/system_socket.h"
#include "core/net/udp_socket.h"

namespace rocinante {
namespace {

constexpr std::size_t kSendBatch = 128;
// ECONNREFUSED from an earlier datagram replaces the result of one send, so it is sent again. After
// this many in a row the datagram counts as sent.
constexpr int kRefusals = 8;

Status configureMulticast(SystemSocket& socket, const Endpoint& to) {
  const Result<unsigned> interface = interfaceIndex(to);
  if (!interface) return interface.error();
  const auto index = static_cast<int>(*interface);
  if (to.address.is_ipv6) {
    if (index != 0 && !socket.setOption(IPPROTO_IPV6, IPV6_MULTICAST_IF, index)) {
      return systemError("cannot send through this interface", to);
    }
    if (!socket.setOption(IPPROTO_IPV6, IPV6_MULTICAST_LOOP, 1)) {
      return systemError("cannot send to listeners on this machine", to);
    }
    if (to.ttl && !socket.setOption(IPPROTO_IPV6, IPV6_MULTICAST_HOPS, *to.ttl)) {
      return systemError("cannot set the hop limit", to);
    }
    return {};
  }
  ip_mreqn request{};
  request.imr_ifindex = index;
  if (index != 0 && ::setsockopt(socket.descriptor(), IPPROTO_IP, IP_MULTICAST_IF, &request,
                                 sizeof request) != 0) {
    return systemError("cannot send through this interface", to);
  }
  if (!socket.setOption(IPPROTO_IP, IP_MULTICAST_LOOP, 1)) {
    return systemError("cannot send to listeners on this machine", to);
  }
  if (to.ttl && !socket.setOption(IPPROTO_IP, IP_MULTICAST_TTL, *to.ttl)) {
    return systemError("cannot set the time to live", to);
  }
  return {};
}

Status configureUnicast(SystemSocket& socket, const Endpoint& to) {
  if (!to.address.is_ipv6 && !socket.setOption(SOL_SOCKET, SO_BROADCAST, 1)) {
    return systemError("cannot allow broadcast addresses", to);
  }
  if (!to.ttl) return {};
  const bool set = to.address.is_ipv6 ? socket.setOption(IPPROTO_IPV6, IPV6_UNICAST_HOPS, *to.ttl)
                                      : socket.setOption(IPPROTO_IP, IP_TTL, *to.ttl);
  if (!set) return systemError("cannot set the time to live", to);
  return {};
}

/// The error for a port that cannot be bound; `errno` says why.
Error portError(const SocketAddress& from, const Endpoint& to) {
  const std::string what = "cannot send from port " + std::to_string(from.port);
  if (errno == EADDRINUSE) {
    if (const std::optional<PortHolder> holder = portHolder(from)) {
      return {
          ErrorKind::refused,
          what + ": it is held by " + holder->name + " (pid " + std::to_string(holder->pid) + ")",
          to.text()};
    }
  }
  return systemError(what, to);
}

Status connectTo(SystemSocket& socket, const Endpoint& to, std::uint16_t local_port) {
  sockaddr_storage system{};
  if (to.source || local_port != 0) {
    SocketAddress from = to.source.value_or(SocketAddress{});
    from.is_ipv6 = to.address.is_ipv6;
    if (local_port != 0) from.port = local_port;
    const socklen_t length = toSystem(from, system);
    if (::bind(socket.descriptor(), reinterpret_cast<sockaddr*>(&system), length) != 0) {
      if (local_port != 0) return portError(from, to);
      return systemError("cannot send from the address of source=", to);
    }
  }
  SocketAddress address = to.address;
  if (to.isMulticast() && address.is_ipv6) {
    const Result<unsigned> interface = interfaceIndex(to);
    if (!interface) return interface.error();
    address.scope_id = *interface;
  }
  const socklen_t length = toSystem(address, system);
  if (::connect(socket.descriptor(), reinterpret_cast<sockaddr*>(&system), length) != 0) {
    return systemError("cannot send to this address", to);
  }
  return {};
}

}  // namespace

struct UdpSender::Impl {
  Result<std::size_t> sendSome(std::span<const ByteView> payloads, int flags);

  SystemSocket socket;
  Endpoint endpoint;
  SocketAddress local_address;
  std::array<iovec, kSendBatch> pieces{};
  std::array<mmsghdr, kSendBatch> headers{};
};

UdpSender::UdpSender(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
UdpSender::~UdpSender() = default;
UdpSender::UdpSender(UdpSender&&) noexcept = default;
UdpSender& UdpSender::operator=(UdpSender&&) noexcept = default;

Result<UdpSender> UdpSender::open(const Endpoint& to, std::uint16_t local_port) {
  if (to.scheme == Endpoint::Scheme::udp && (to.address.isAny() || to.address.port == 0)) {
    return Error{ErrorKind::bad_argument, "to send, an endpoint needs a host and a port",
                 to.text()};
  }
  Result<SystemSocket> socket = SystemSocket::open(to);
  if (!socket) return socket.error();
  Status done = to.isMulticast() ? configureMulticast(*socket, to) : configureUnicast(*socket, to);
  if (!done) return done.error();
  if (done = connectTo(*socket, to, local_port); !done) return done.error();
  const Result<SocketAddress> local = socket->localAddress(to);
  if (!local) return local.error();

  auto impl = std::make_unique<Impl>(Impl{std::move(*socket), to, *local});
  for (std::size_t i = 0; i < kSendBatch; ++i) {
    impl->headers[i].msg_hdr.msg_iov = &impl->pieces[i];
    impl->headers[i].msg_hdr.msg_iovlen = 1;
  }
  return UdpSender(std::move(impl));
}

Status UdpSender::send(ByteView payload) { return send(std::span<const ByteView>(&payload, 1)); }

Status UdpSender::send(std::span<const ByteView> payloads) {
  while (!payloads.empty()) {
    const Result<std::size_t> sent = impl_->sendSome(payloads, 0);
    if (!sent) return sent.error();
    payloads = payloads.subspan(*sent);
    if (*sent > 0) continue;
    // A full device queue polls as writable at once, so only the timeout waits.
    const bool device_full = errno == ENOBUFS;
    pollfd writable{impl_->socket.descriptor(), POLLOUT, 0};
    ::poll(&writable, device_full ? 0 : 1, 1);
  }
  return {};
}

Result<std::size_t> UdpSender::sendWithoutWaiting(std::span<const ByteView> payloads) {
  return impl_->sendSome(payloads, MSG_DONTWAIT);
}

/// Sends as many of `payloads` from the front as fit, in one system call; 0 when there is no room,
/// and errno tells which kind.
Result<std::size_t> UdpSender::Impl::sendSome(std::span<const ByteView> payloads, int flags) {
  const std::size_t wanted = std::min(payloads.size(), kSendBatch);
  for (std::size_t i = 0; i < wanted; ++i) {
    // sendmmsg only reads the memory that the pieces point to.
    pieces[i] = {const_cast<std::byte*>(payloads[i].data()), payloads[i].size()};
  }
  for (int refusals = 0;;) {
    const int sent =
        ::sendmmsg(socket.descriptor(), headers.data(), static_cast<unsigned>(wanted), flags);
    if (sent >= 0) return static_cast<std::size_t>(sent);
    switch (errno) {
      case EINTR:
        continue;
      case EAGAIN:
      case ENOBUFS:
        return std::size_t{0};
      case ECONNREFUSED:
        // The error belongs to an earlier datagram; this one has not been sent yet.
        if (++refusals <= kRefusals) continue;
        return std::size_t{1};
      case EMSGSIZE:
        return Error{ErrorKind::bad_argument,
                     "a datagram of " + std::to_string(payloads[0].size()) +
                         " bytes is too long for the network",
                     endpoint.text()};
      default:
        return systemError("cannot send", endpoint);
    }
  }
}

const Endpoint& UdpSender::endpoint() const { return impl_->endpoint; }
const SocketAddress& UdpSender::localAddress() const { return impl_->local_address; }
int UdpSender::fileDescriptor() const { return impl_->socket.descriptor(); }

}  // namespace rocinante
