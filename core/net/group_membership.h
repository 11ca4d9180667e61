#pragma once

#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/net/endpoint.h"
#include "core/net/route_socket.h"

namespace rocinante {

/// A socket's membership in the multicast group of its endpoint, kept through interfaces that go
/// and come back: the kernel forgets a membership with the interface that it was on, and one that
/// is made anew under the same name is another to it. Down and up again keeps it. One thread.
class GroupMembership {
 public:
  /// refused when the endpoint's interface does not exist or the system will not join.
  static Result<GroupMembership> join(int socket, const Endpoint& endpoint);

  /// What has become of the interface since the last look.
  enum class Change {
    none,
    gone,   ///< nothing can be heard until it is back
    moved,  ///< interface() is another now: renew()
  };
  Change look();
  /// Joins where the group is to be heard now. After a failure look() says moved again.
  Status renew(int socket);

  /// The index joined by; 0 when it is gone, or the system did not say.
  unsigned interface() const { return joined_; }

 private:
  GroupMembership(Endpoint endpoint, unsigned interface)
      : endpoint_(std::move(endpoint)), joined_(interface), last_(interface) {}
  unsigned wanted() const;

  Endpoint endpoint_;
  RouteSocket routes_;
  unsigned joined_ = 0;
  unsigned last_ = 0;  ///< the index joined by last, also when it is gone
  bool gone_told_ = false;
  bool moved_ = false;
};

}  // namespace rocinante
