#include "core/net/group_membership.h"

#include <net/if.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>

#include "core/net/system_socket.h"

namespace rocinante {
namespace {

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
  const bool lost = !changes.told_everything || std::find(changes.gone.begin(), changes.gone.end(),
                                                          joined_) != changes.gone.end();
  if (lost) joined_ = 0;
  const unsigned now = wanted();
  moved_ = now != 0 && now != joined_;
  if (moved_) {
    gone_told_ = false;
    return Change::moved;
  }
  // Without an interface name the group may still arrive through the former interface.
  const bool gone = now == 0 && (!endpoint_.interface.empty() || joined_ == 0);
  if (!gone || last_ == 0 || gone_told_) return Change::none;
  joined_ = 0;
  gone_told_ = true;
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
