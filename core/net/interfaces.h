#pragma once

#include <functional>
#include <span>
#include <string>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/net/endpoint.h"

namespace rocinante {

/// True for this machine's own addresses: loopback, and those of its interfaces.
bool isOwnAddress(const SocketAddress& address);

/// Returns when every network interface that the endpoints name exists: a cable adapter plugged in
/// later, a VPN, a container's network. `notify` is called once with the missing ones. refused when
/// `longest` passes first, or when `stop` returns true, which is called every 20 ms.
Status waitForInterfaces(std::span<const Endpoint> endpoints, Nanoseconds longest,
                         const std::function<void(const std::string&)>& notify,
                         const std::function<bool()>& stop);

/// "lo, eth0": the network interfaces of this machine, for messages.
std::string interfaceNames();

}  // namespace rocinante
