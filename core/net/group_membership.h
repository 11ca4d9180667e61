#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/net/endpoint.h"

namespace rocinante {

/// The kernel's reports on interfaces and routes (rtnetlink). Where access is denied, it answers
/// that anything may have changed and that nothing is known. Linux. One thread.
class RouteSocket {
 public:
  struct Changes {
    bool any = false;            ///< interfaces, addresses or routes changed
    bool is_complete = true;     ///< false: more may have happened than `gone` lists
    std::vector<unsigned> gone;  ///< indexes of removed interfaces
  };

  RouteSocket();
  ~RouteSocket();
  RouteSocket(RouteSocket&& other) noexcept;
  RouteSocket& operator=(RouteSocket&& other) noexcept;

  /// The changes since the last call. Never blocks.
  Changes takeChanges();

 private:
  int descriptor_ = -1;
};

/// The index of the interface through which the system would send there; 0 when there is no route,
/// or the system does not tell.
unsigned interfaceTowards(const SocketAddress& address);

/// A socket's membership in the multicast group of its endpoint, kept while interfaces disappear
/// and return: the kernel drops a membership with its interface, and treats an interface recreated
/// under the same name as a new one. Setting an interface down and up again keeps the membership.
/// One thread.
class GroupMembership {
 public:
  /// refused when the endpoint's interface does not exist or the system will not join.
  static Result<GroupMembership> join(int socket, const Endpoint& endpoint);

  /// The state of the interface since the last look.
  enum class Change {
    none,
    gone,   ///< nothing is received until it returns
    moved,  ///< interface() has changed: call renew()
  };
  Change look();
  /// Joins on the interface that now carries the group. After a failure look() returns moved again.
  Status renew(int socket);

  /// The index joined; 0 when the interface is gone, or the system did not report it.
  unsigned interface() const { return joined_; }

 private:
  GroupMembership(Endpoint endpoint, unsigned interface)
      : endpoint_(std::move(endpoint)), joined_(interface), last_(interface) {}
  unsigned wanted() const;

  Endpoint endpoint_;
  RouteSocket routes_;
  unsigned joined_ = 0;
  unsigned last_ = 0;  ///< the last index joined, also when the interface is gone
  bool gone_reported_ = false;
  bool moved_ = false;
};

}  // namespace rocinante
