#pragma once

#include <string>

namespace rocinante {

/// "lo, eth0": the network interfaces of this machine, for messages.
std::string interfaceNames();

}  // namespace rocinante
