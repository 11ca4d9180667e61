#include "player/control/control_socket.h"

#include <utility>

#include "player/control/udp_control.h"
#include "player/control/unix_control.h"

namespace rocinante {

Result<ControlSocket> ControlSocket::open(const ControlAddress& address, AddressFilter allowed,
                                          std::function<void(std::string)> told) {
  if (!address.path.empty()) return openUnixControl(address.path);
  return openUdpControl(address.endpoint, std::move(allowed), std::move(told));
}

}  // namespace rocinante
