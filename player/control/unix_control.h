#pragma once

#include "player/control/control_socket.h"

namespace rocinante {

/// ControlSocket::open() of a Unix socket.
Result<ControlSocket> openUnixControl(const std::filesystem::path& path);

}  // namespace rocinante
