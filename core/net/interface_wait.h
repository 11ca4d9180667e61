#pragma once

#include <functional>
#include <span>
#include <string>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/net/endpoint.h"

namespace rocinante {

/// Returns when every network interface that the endpoints name exists: a cable adapter that is
/// plugged in later, a VPN, a container's network. `told` hears once which ones are waited for.
/// refused when `longest` passes first; interrupted ones end with refused too, when `stop` says so,
/// which is asked every 20 ms.
Status waitForInterfaces(std::span<const Endpoint> endpoints, Nanoseconds longest,
                         const std::function<void(const std::string&)>& told,
                         const std::function<bool()>& stop);

}  // namespace rocinante
