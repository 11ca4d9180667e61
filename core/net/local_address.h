#pragma once

#include "core/net/endpoint.h"

namespace rocinante {

/// True when the address is one of this machine's own.
bool isLocalAddress(const SocketAddress& address);

}  // namespace rocinante
