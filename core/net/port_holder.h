#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/net/endpoint.h"

namespace rocinante {

/// A process that holds a UDP port.
struct PortHolder {
  std::string name;
  int pid = 0;
};

/// The inodes of the sockets in `table` (the text of /proc/net/udp or udp6) whose binding excludes
/// one to `address`: the same port, and the same address or either of them "any".
std::vector<std::uint64_t> excludingSocketInodes(std::string_view table,
                                                 const SocketAddress& address);

/// The process that holds the port of `address`. Empty when none does, or /proc does not show it
/// (another user's process, another name space).
std::optional<PortHolder> portHolder(const SocketAddress& address);

}  // namespace rocinante
