#include <linux/sock_diag.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <time.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <vector>

#include "core/net/group_membership.h"
#include "core/net/port_holder.h"
#include "core/net/receive_buffer.h"
#include "core/net/system_socket.h"
#include "core/net/udp_socket.h"

namespace rocinante {
namespace {

constexpr std::size_t kBatch = 256;
// Buffers exactly 64 KiB apart would share the few lines of one cache set.
constexpr std::size_t kBufferStagger = 192;
// Room for SCM_TIMESTAMPNS and SO_RXQ_OVFL.
constexpr std::size_t kControlBytes =
    CMSG_SPACE(sizeof(timespec)) + CMSG_SPACE(sizeof(std::uint32_t));

#ifndef IPV6_MULTICAST_ALL
constexpr int IPV6_MULTICAST_ALL = 29;  // from linux/in6.h, which conflicts with netinet/in.h
#endif

Error portTaken(const Endpoint& endpoint) {
  const std::optional<PortHolder> holder = portHolder(endpoint.address);
  const std::string by = holder ? holder->name + " (pid " + std::to_string(holder->pid) + ")"
                                : std::string("another process");
  const std::string advice = endpoint.isMulticast() ? ", which does not share it; use another port"
                                                    : "; " + std::string(kTakenPortAdvice);
  return {ErrorKind::refused,
          "port " + std::to_string(endpoint.address.port) + " is held by " + by + advice,
          endpoint.text()};
}

Status configure(SystemSocket& socket, const Endpoint& endpoint,
                 const UdpReceiver::Options& options) {
  const bool forced = socket.setOption(SOL_SOCKET, SO_RCVBUFFORCE, options.receive_buffer_bytes);
  if (!forced && !socket.setOption(SOL_SOCKET, SO_RCVBUF, options.receive_buffer_bytes)) {
    return systemError("cannot set the receive buffer", endpoint);
  }
  if (!socket.setOption(SOL_SOCKET, SO_TIMESTAMPNS, 1)) {
    return systemError("cannot ask for the kernel's time stamps", endpoint);
  }
  if (!socket.setOption(SOL_SOCKET, SO_RXQ_OVFL, 1)) {
    return systemError("cannot ask for the kernel's drop counts", endpoint);
  }
  if (endpoint.address.is_ipv6 && !socket.setOption(IPPROTO_IPV6, IPV6_V6ONLY, 1)) {
    return systemError("cannot keep the socket to IPv6", endpoint);
  }
  if (!endpoint.isMulticast()) return {};
  // Each receiver of a group gets a copy. Without the second option a socket also receives groups
  // and interfaces that other sockets of this machine joined.
  const bool set = endpoint.address.is_ipv6 ? socket.setOption(IPPROTO_IPV6, IPV6_MULTICAST_ALL, 0)
                                            : socket.setOption(IPPROTO_IP, IP_MULTICAST_ALL, 0);
  if (!set || !socket.setOption(SOL_SOCKET, SO_REUSEADDR, 1)) {
    return systemError("cannot share the multicast port", endpoint);
  }
  return {};
}

Status bindTo(SystemSocket& socket, const Endpoint& endpoint) {
  SocketAddress address = endpoint.address;
  if (address.is_ipv6 && address.isMulticast()) {
    const Result<unsigned> interface = interfaceIndex(endpoint);
    if (!interface) return interface.error();
    address.scope_id = *interface;
  }
  sockaddr_storage system{};
  const socklen_t length = toSystem(address, system);
  if (::bind(socket.descriptor(), reinterpret_cast<sockaddr*>(&system), length) == 0) return {};
  if (errno == EADDRINUSE) return portTaken(endpoint);
  return systemError("cannot listen here", endpoint);
}

/// Binds a receiving socket; the caller joins its group.
Result<SystemSocket> listenAt(const Endpoint& endpoint, const UdpReceiver::Options& options) {
  Result<SystemSocket> socket = SystemSocket::open(endpoint);
  if (!socket) return socket;
  if (Status done = configure(*socket, endpoint, options); !done) return done.error();
  if (Status done = bindTo(*socket, endpoint); !done) return done.error();
  return socket;
}

/// A group with interface or link scope (ff01::, ff02::) is bound to its interface with the
/// address.
bool isBoundToInterface(const SocketAddress& group) {
  const unsigned scope = group.address[1] & 0x0FU;
  return group.is_ipv6 && (scope == 1 || scope == 2);
}

}  // namespace

struct UdpReceiver::Impl {
  Impl(SystemSocket open_socket, const Endpoint& bound_endpoint, const SocketAddress& bound,
       const Options& chosen)
      : socket(std::move(open_socket)),
        endpoint(bound_endpoint),
        bound_address(bound),
        options(chosen),
        // Not initialised: pages that no datagram reaches cost nothing.
        buffers(new std::byte[kBatch * (chosen.datagram_bytes + kBufferStagger)]) {
    for (std::size_t i = 0; i < kBatch; ++i) {
      pieces[i] = {buffers.get() + i * (chosen.datagram_bytes + kBufferStagger),
                   chosen.datagram_bytes};
      headers[i].msg_hdr.msg_iov = &pieces[i];
      headers[i].msg_hdr.msg_iovlen = 1;
      headers[i].msg_hdr.msg_name = &senders[i];
      headers[i].msg_hdr.msg_control = controls[i].bytes.data();
    }
    rearm(kBatch);
  }

  /// Resets the lengths, which the kernel overwrites with the sizes it filled.
  void rearm(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      headers[i].msg_hdr.msg_namelen = sizeof(sockaddr_storage);
      headers[i].msg_hdr.msg_controllen = kControlBytes;
    }
  }

  /// The timestamp of one datagram; its drop count goes to `drops`.
  WallTime readControl(msghdr& header) {
    timespec stamp{};
    bool stamped = false;
    for (cmsghdr* each = CMSG_FIRSTHDR(&header); each != nullptr;
         each = CMSG_NXTHDR(&header, each)) {
      if (each->cmsg_level != SOL_SOCKET) continue;
      if (each->cmsg_type == SCM_TIMESTAMPNS) {
        std::memcpy(&stamp, CMSG_DATA(each), sizeof stamp);
        stamped = true;
      } else if (each->cmsg_type == SO_RXQ_OVFL && !old_socket) {
        std::uint32_t reading = 0;
        std::memcpy(&reading, CMSG_DATA(each), sizeof reading);
        drops.update(reading);
      }
    }
    if (!stamped) ::clock_gettime(CLOCK_REALTIME, &stamp);
    return WallTime(std::chrono::seconds(stamp.tv_sec) + Nanoseconds(stamp.tv_nsec));
  }

  struct Control {
    alignas(cmsghdr) std::array<char, kControlBytes> bytes;
  };

  /// Opens a new socket. The rest of the old one is received first; its drops stay in the count.
  Status listenAnew();
  Result<std::uint64_t> countDrops();

  SystemSocket socket;
  std::optional<SystemSocket> old_socket;  ///< until it is empty; its drops are counted already
  Endpoint endpoint;
  SocketAddress bound_address;
  Options options;
  std::optional<GroupMembership> membership;
  int granted_buffer_bytes = 0;
  DropCounter drops;
  std::uint64_t drops_before = 0;  ///< of sockets that listened here before
  std::unique_ptr<std::byte[]> buffers;
  std::array<iovec, kBatch> pieces{};
  std::array<sockaddr_storage, kBatch> senders{};
  std::array<Control, kBatch> controls{};
  std::array<mmsghdr, kBatch> headers{};
  std::array<ReceivedDatagram, kBatch> datagrams{};
};

UdpReceiver::UdpReceiver(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
UdpReceiver::~UdpReceiver() = default;
UdpReceiver::UdpReceiver(UdpReceiver&&) noexcept = default;
UdpReceiver& UdpReceiver::operator=(UdpReceiver&&) noexcept = default;

Result<UdpReceiver> UdpReceiver::open(const Endpoint& endpoint, const Options& options) {
  Result<SystemSocket> socket = listenAt(endpoint, options);
  if (!socket) return socket.error();
  std::optional<GroupMembership> membership;
  if (endpoint.isMulticast()) {
    Result<GroupMembership> joined = GroupMembership::join(socket->descriptor(), endpoint);
    if (!joined) return joined.error();
    membership = std::move(*joined);
  }
  const Result<SocketAddress> bound = socket->localAddress(endpoint);
  if (!bound) return bound.error();

  int granted = 0;
  socklen_t length = sizeof granted;
  if (::getsockopt(socket->descriptor(), SOL_SOCKET, SO_RCVBUF, &granted, &length) != 0) {
    return systemError("cannot read the receive buffer's size", endpoint);
  }
  auto impl = std::make_unique<Impl>(std::move(*socket), endpoint, *bound, options);
  impl->membership = std::move(membership);
  impl->granted_buffer_bytes = granted;
  return UdpReceiver(std::move(impl));
}

Result<std::span<const ReceivedDatagram>> UdpReceiver::receive() {
  const SystemSocket& socket = impl_->old_socket ? *impl_->old_socket : impl_->socket;
  int count = 0;
  do {
    count = ::recvmmsg(socket.descriptor(), impl_->headers.data(), kBatch, MSG_DONTWAIT, nullptr);
  } while (count < 0 && errno == EINTR);
  if (count < 0 && impl_->old_socket) {
    impl_->old_socket.reset();
    return receive();
  }
  if (count < 0) {
    if (errno == EAGAIN || errno == EWOULDBLOCK) return std::span<const ReceivedDatagram>();
    return systemError("cannot receive", impl_->endpoint);
  }
  const auto received = static_cast<std::size_t>(count);
  for (std::size_t i = 0; i < received; ++i) {
    msghdr& header = impl_->headers[i].msg_hdr;
    ReceivedDatagram& datagram = impl_->datagrams[i];
    datagram.payload = {static_cast<const std::byte*>(impl_->pieces[i].iov_base),
                        impl_->headers[i].msg_len};
    datagram.sender = fromSystem(impl_->senders[i]);
    datagram.kernel_time = impl_->readControl(header);
    datagram.truncated = (header.msg_flags & MSG_TRUNC) != 0;
  }
  impl_->rearm(received);
  return std::span<const ReceivedDatagram>(impl_->datagrams.data(), received);
}

Status UdpReceiver::sendTo(const SocketAddress& to, ByteView payload) {
  sockaddr_storage system{};
  const socklen_t length = toSystem(to, system);
  ssize_t sent = 0;
  do {
    sent = ::sendto(impl_->socket.descriptor(), payload.data(), payload.size(), MSG_DONTWAIT,
                    reinterpret_cast<const sockaddr*>(&system), length);
  } while (sent < 0 && errno == EINTR);
  const bool is_full = errno == EAGAIN || errno == EWOULDBLOCK || errno == ENOBUFS;
  if (sent < 0 && !is_full) return systemError("cannot send to " + to.text(), impl_->endpoint);
  return {};
}

std::uint64_t UdpReceiver::dropped() const { return impl_->drops_before + impl_->drops.total(); }

Result<std::uint64_t> UdpReceiver::droppedByNow() { return impl_->countDrops(); }

Result<std::uint64_t> UdpReceiver::Impl::countDrops() {
  std::array<std::uint32_t, SK_MEMINFO_VARS> info{};
  socklen_t length = sizeof info;
  if (::getsockopt(socket.descriptor(), SOL_SOCKET, SO_MEMINFO, info.data(), &length) != 0 ||
      length <= SK_MEMINFO_DROPS * sizeof(std::uint32_t)) {
    return systemError("cannot ask for the kernel's drop count", endpoint);
  }
  drops.update(info[SK_MEMINFO_DROPS]);
  return drops_before + drops.total();
}

Status UdpReceiver::Impl::listenAnew() {
  Endpoint here = endpoint;
  here.address.port = bound_address.port;
  Result<SystemSocket> made = listenAt(here, options);
  if (!made) return made.error();
  if (Status joined = membership->renew(made->descriptor()); !joined) return joined;
  if (const auto counted = countDrops(); counted) drops_before = *counted;
  drops = DropCounter();
  old_socket = std::exchange(socket, std::move(*made));
  return {};
}

std::optional<std::string> UdpReceiver::maintain() {
  // The datagrams waiting in a replaced socket are received first.
  if (!impl_->membership || impl_->old_socket) return std::nullopt;
  switch (impl_->membership->look()) {
    case GroupMembership::Change::none:
      return std::nullopt;
    case GroupMembership::Change::gone:
      return "no route to " + impl_->endpoint.text() + "; nothing is received until it returns";
    case GroupMembership::Change::moved:
      break;
  }
  // A refusal now (an interface that is not up yet) is retried at the next look.
  const Status joined = isBoundToInterface(impl_->endpoint.address)
                            ? impl_->listenAnew()
                            : impl_->membership->renew(impl_->socket.descriptor());
  if (!joined) return std::nullopt;
  return "joined " + impl_->endpoint.text() + " again";
}

std::uint64_t UdpReceiver::receiveBufferBytes() const {
  return static_cast<std::uint64_t>(impl_->granted_buffer_bytes);
}
const Endpoint& UdpReceiver::endpoint() const { return impl_->endpoint; }
const SocketAddress& UdpReceiver::boundAddress() const { return impl_->bound_address; }
int UdpReceiver::fileDescriptor() const { return impl_->socket.descriptor(); }

}  // namespace rocinante
