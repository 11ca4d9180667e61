#pragma once

#include "core/net/endpoint.h"

namespace rocinante {

/// True for this machine's own addresses: loopback, and those of its interfaces.
bool isOwnAddress(const SocketAddress& address);

}  // namespace rocinante
