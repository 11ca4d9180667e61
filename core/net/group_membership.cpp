#include "core/net/group_membership.h"

#include <linux/netlink.h>
#include <linux/rtnetlink.h>
#include <net/if.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "core/net/system_socket.h"

namespace rocinante {
namespace {

int openNetlink(std::uint32_t groups) {
  const int descriptor = ::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_ROUTE);
  if (descriptor < 0) return -1;
  sockaddr_nl self{};
  self.nl_family = AF_NETLINK;
  self.nl_groups = groups;
  if (::bind(descriptor, reinterpret_cast<sockaddr*>(&self), sizeof self) == 0) return descriptor;
  ::close(descriptor);
  return -1;
}

/// Calls `each(header)` for the messages of one netlink datagram.
template <class Each>
void forEachMessage(const char* bytes, std::size_t length, Each each) {
  std::size_t at = 0;
  while (length - at >= sizeof(nlmsghdr)) {
    const auto* header = reinterpret_cast<const nlmsghdr*>(bytes + at);
    if (header->nlmsg_len < sizeof(nlmsghdr) || header->nlmsg_len > length - at) return;
    each(*header);
    // The last message need not be padded.
    at += std::min<std::size_t>(NLMSG_ALIGN(header->nlmsg_len), length - at);
  }
}

/// RTA_OIF of a route in the answer to RTM_GETROUTE.
unsigned outgoingInterface(const nlmsghdr& header) {
  const auto* route = static_cast<const rtmsg*>(NLMSG_DATA(&header));
  auto left = static_cast<int>(RTM_PAYLOAD(&header));
  for (const rtattr* each = RTM_RTA(route); RTA_OK(each, left); each = RTA_NEXT(each, left)) {
    unsigned index = 0;
    if (each->rta_type != RTA_OIF || RTA_PAYLOAD(each) < sizeof index) continue;
    std::memcpy(&index, RTA_DATA(each), sizeof index);
    return index;
  }
  return 0;
}

struct RouteRequest {
  nlmsghdr header;
  rtmsg route;
  rtattr attribute;
  std::array<std::uint8_t, 16> address;
};

int levelOf(const Endpoint& endpoint) {
  return endpoint.address.is_ipv6 ? IPPROTO_IPV6 : IPPROTO_IP;
}

/// Joins for any sender, or for the one that the endpoint names. 0: the system's routes choose.
Status joinBy(unsigned interface, int socket, const Endpoint& endpoint) {
  int answer = 0;
  if (endpoint.source) {
    group_source_req request{};
    request.gsr_interface = interface;
    toSystem(endpoint.address, request.gsr_group);
    toSystem(*endpoint.source, request.gsr_source);
    answer =
        ::setsockopt(socket, levelOf(endpoint), MCAST_JOIN_SOURCE_GROUP, &request, sizeof request);
  } else {
    group_req request{};
    request.gr_interface = interface;
    toSystem(endpoint.address, request.gr_group);
    answer = ::setsockopt(socket, levelOf(endpoint), MCAST_JOIN_GROUP, &request, sizeof request);
  }
  // Already joined there is a success.
  const int already = endpoint.source ? EADDRNOTAVAIL : EADDRINUSE;
  if (answer != 0 && errno != already) {
    return systemError("cannot join the multicast group", endpoint);
  }
  return {};
}

/// Leaves the whole group, also for one sender: this works even when the interface is gone.
void leave(unsigned interface, int socket, const Endpoint& endpoint) {
  group_req request{};
  request.gr_interface = interface;
  toSystem(endpoint.address, request.gr_group);
  (void)::setsockopt(socket, levelOf(endpoint), MCAST_LEAVE_GROUP, &request, sizeof request);
}

}  // namespace

RouteSocket::RouteSocket()
    : descriptor_(openNetlink(RTMGRP_LINK | RTMGRP_IPV4_IFADDR | RTMGRP_IPV6_IFADDR |
                              RTMGRP_IPV4_ROUTE | RTMGRP_IPV6_ROUTE)) {}

RouteSocket::~RouteSocket() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

RouteSocket::RouteSocket(RouteSocket&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)) {}

RouteSocket& RouteSocket::operator=(RouteSocket&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

RouteSocket::Changes RouteSocket::takeChanges() {
  Changes changes;
  if (descriptor_ < 0) {
    changes.any = true;
    return changes;
  }
  alignas(nlmsghdr) std::array<char, 16'384> bytes;
  for (;;) {
    const ssize_t length = ::recv(descriptor_, bytes.data(), bytes.size(), MSG_DONTWAIT);
    if (length < 0 && errno == EINTR) continue;
    if (length < 0 && errno == ENOBUFS) {
      // The kernel dropped notifications: too many at once.
      changes.any = true;
      changes.is_complete = false;
      continue;
    }
    if (length <= 0) return changes;
    changes.any = true;
    forEachMessage(bytes.data(), static_cast<std::size_t>(length), [&](const nlmsghdr& header) {
      if (header.nlmsg_type != RTM_DELLINK || NLMSG_PAYLOAD(&header, 0) < sizeof(ifinfomsg)) return;
      const auto* link = static_cast<const ifinfomsg*>(NLMSG_DATA(&header));
      // A bridge reports that a port left it; the interface itself still exists.
      if (link->ifi_family == AF_UNSPEC) {
        changes.gone.push_back(static_cast<unsigned>(link->ifi_index));
      }
    });
  }
}

unsigned interfaceTowards(const SocketAddress& address) {
  const int descriptor = openNetlink(0);
  if (descriptor < 0) return 0;
  // The kernel answers at once; a sandbox that drops the request must not hang the program.
  const timeval patience{0, 200'000};
  ::setsockopt(descriptor, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  const std::size_t bytes = address.is_ipv6 ? 16 : 4;
  RouteRequest request{};
  request.header.nlmsg_len =
      static_cast<std::uint32_t>(NLMSG_LENGTH(sizeof(rtmsg)) + RTA_LENGTH(bytes));
  request.header.nlmsg_type = RTM_GETROUTE;
  request.header.nlmsg_flags = NLM_F_REQUEST;
  request.route.rtm_family = address.is_ipv6 ? AF_INET6 : AF_INET;
  request.route.rtm_dst_len = static_cast<unsigned char>(bytes * 8);
  request.attribute.rta_type = RTA_DST;
  request.attribute.rta_len = static_cast<unsigned short>(RTA_LENGTH(bytes));
  request.address = address.address;
  unsigned index = 0;
  if (::send(descriptor, &request, request.header.nlmsg_len, 0) > 0) {
    alignas(nlmsghdr) std::array<char, 8'192> answer;
    const ssize_t length = ::recv(descriptor, answer.data(), answer.size(), 0);
    if (length > 0) {
      forEachMessage(answer.data(), static_cast<std::size_t>(length), [&](const nlmsghdr& header) {
        if (header.nlmsg_type == RTM_NEWROUTE) index = outgoingInterface(header);
      });
    }
  }
  ::close(descriptor);
  return index;
}

Result<GroupMembership> GroupMembership::join(int socket, const Endpoint& endpoint) {
  const Result<unsigned> named = interfaceIndex(endpoint);
  if (!named) return named.error();
  // Made before joining, so that changes from here on are seen.
  GroupMembership membership(endpoint, 0);
  if (Status joined = joinBy(*named, socket, endpoint); !joined) return joined.error();
  membership.joined_ = membership.last_ = membership.wanted();
  return membership;
}

unsigned GroupMembership::wanted() const {
  if (!endpoint_.interface.empty()) return ::if_nametoindex(endpoint_.interface.c_str());
  return interfaceTowards(endpoint_.address);
}

GroupMembership::Change GroupMembership::look() {
  const RouteSocket::Changes changes = routes_.takeChanges();
  if (!changes.any && !moved_) return Change::none;
  const bool lost = !changes.is_complete || std::find(changes.gone.begin(), changes.gone.end(),
                                                      joined_) != changes.gone.end();
  if (lost) joined_ = 0;
  const unsigned now = wanted();
  moved_ = now != 0 && now != joined_;
  if (moved_) {
    gone_reported_ = false;
    return Change::moved;
  }
  // Without an interface name the group may still arrive through the former interface.
  const bool gone = now == 0 && (!endpoint_.interface.empty() || joined_ == 0);
  if (!gone || last_ == 0 || gone_reported_) return Change::none;
  joined_ = 0;
  gone_reported_ = true;
  return Change::gone;
}

Status GroupMembership::renew(int socket) {
  const unsigned now = wanted();
  if (now == 0) return {};
  if (last_ != 0) leave(last_, socket, endpoint_);
  if (Status joined = joinBy(now, socket, endpoint_); !joined) return joined.error();
  joined_ = last_ = now;
  moved_ = false;
  return {};
}

}  // namespace rocinante
