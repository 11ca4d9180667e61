#pragma once

#include "player/control/control_socket.h"

namespace rocinante {

/// ControlSocket::open() of a UDP port.
Result<ControlSocket> openUdpControl(const Endpoint& endpoint, AddressFilter allowed,
                                     std::function<void(std::string)> told);

}  // namespace rocinante
