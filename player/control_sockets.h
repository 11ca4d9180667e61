#pragma once

#include "player/control_socket.h"

namespace rocinante {

/// The two kinds of ControlSocket::open.
Result<ControlSocket> openUdpControl(const Endpoint& endpoint, AddressFilter allowed,
                                     std::function<void(std::string)> told);
Result<ControlSocket> openUnixControl(const std::filesystem::path& path);

}  // namespace rocinante
