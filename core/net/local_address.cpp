#include "core/net/local_address.h"

#include "core/net/system_socket.h"

namespace rocinante {

bool isLocalAddress(const SocketAddress& address) {
  Endpoint endpoint;
  endpoint.address = address;
  endpoint.address.port = 0;
  const Result<SystemSocket> socket = SystemSocket::open(endpoint);
  if (!socket) return false;
  sockaddr_storage system{};
  const socklen_t length = toSystem(endpoint.address, system);
  // The kernel binds a socket only to an address of the machine.
  return ::bind(socket->descriptor(), reinterpret_cast<sockaddr*>(&system), length) == 0;
}

}  // namespace rocinante
