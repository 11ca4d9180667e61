#pragma once

#include <string>

namespace rocinante {

/// "lo, eth0": the network interfaces of this machine, for a sentence.
std::string interfaceNames();

}  // namespace rocinante
