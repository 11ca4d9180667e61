#pragma once

#include <vector>

#include "core/net/endpoint.h"

namespace rocinante {

/// The kernel's reports on interfaces and routes (rtnetlink). Where access is denied, it answers
/// that anything may have changed and that nothing is known. Linux. One thread.
class RouteSocket {
 public:
  struct Changes {
    bool any = false;             ///< interfaces, addresses or routes changed
    bool told_everything = true;  ///< false: more may have happened than `gone` lists
    std::vector<unsigned> gone;   ///< indexes of removed interfaces
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

}  // namespace rocinante
