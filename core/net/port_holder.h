#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/net/endpoint.h"

namespace rocinante {

/// A process that has a UDP port.
struct PortHolder {
  std::string name;
  int pid = 0;
};

/// The inodes of the sockets in `table` (the text of /proc/net/udp or udp6) whose binding excludes
/// one to `address`: the same port, and the same address or either of them "any".
std::vector<std::uint64_t> excludingSocketInodes(std::string_view table,
                                                 const SocketAddress& address);

/// Who holds the port of `address`. Empty when nobody does, or /proc will not say (another user's
/// process, another name space).
std::optional<PortHolder> portHolder(const SocketAddress& address);

}  // namespace rocinante
