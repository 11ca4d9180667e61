#pragma once

#include <vector>

#include "core/net/endpoint.h"

namespace rocinante {

/// What the kernel tells about interfaces and routes (rtnetlink). Where it may not be asked, it
/// answers that anything may have changed and that nothing is known. Linux. One thread.
class RouteSocket {
 public:
  struct Changes {
    bool any = false;             ///< of interfaces, addresses or routes
    bool told_everything = true;  ///< false: more happened than `gone` says
    std::vector<unsigned> gone;   ///< indexes of interfaces that were taken away
  };

  RouteSocket();
  ~RouteSocket();
  RouteSocket(RouteSocket&& other) noexcept;
  RouteSocket& operator=(RouteSocket&& other) noexcept;

  /// Since the last call. Never blocks.
  Changes takeChanges();

 private:
  int descriptor_ = -1;
};

/// The index of the interface by which the system would send there; 0 when there is no way, or it
/// does not say.
unsigned interfaceTowards(const SocketAddress& address);

}  // namespace rocinante
