#pragma once

#include <sys/socket.h>

#include <string_view>

#include "core/base/result.h"
#include "core/net/endpoint.h"

namespace rocinante {

/// Shared by the two sockets: system addresses, and socket options with checked results. For
/// core/net's own sources.

/// Fills `system` and returns its length.
socklen_t toSystem(const SocketAddress& address, sockaddr_storage& system);
SocketAddress fromSystem(const sockaddr_storage& system);

/// An open socket, closed with its owner.
class SystemSocket {
 public:
  static Result<SystemSocket> open(const Endpoint& endpoint);
  explicit SystemSocket(int descriptor) : descriptor_(descriptor) {}
  ~SystemSocket();
  SystemSocket(SystemSocket&& other) noexcept;
  SystemSocket& operator=(SystemSocket&& other) noexcept;

  int descriptor() const { return descriptor_; }
  bool setOption(int level, int name, int value);
  Result<SocketAddress> localAddress(const Endpoint& endpoint) const;

 private:
  int descriptor_ = -1;
};

/// "cannot DO: No such device (udp://...)", from errno.
Error systemError(std::string_view what, const Endpoint& endpoint);

/// The index of the endpoint's interface; 0 when it names none. refused when the interface does not
/// exist, with a list of those that do.
Result<unsigned> interfaceIndex(const Endpoint& endpoint);

}  // namespace rocinante
