#pragma once

#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/net/endpoint.h"
#include "core/net/route_socket.h"

namespace rocinante {

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
  bool gone_told_ = false;
  bool moved_ = false;
};

}  // namespace rocinante
