#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "core/net/endpoint.h"
#include "core/result.h"

namespace rocinante {

/// Where a player hears commands: udp://HOST:PORT (also HOST:PORT), or unix:PATH.
struct ControlAddress {
  std::filesystem::path path;  ///< of a Unix socket; empty: `endpoint`
  Endpoint endpoint;

  static Result<ControlAddress> parse(std::string_view text);
};

/// A block of addresses, ADDRESS/BITS; an address alone is a block of one.
struct AddressBlock {
  SocketAddress address;
  int bits = 0;

  static Result<AddressBlock> parse(std::string_view text);
  bool holds(const SocketAddress& other) const;
};

/// True of this machine's own addresses: loopback, and those of its interfaces.
bool isOwnAddress(const SocketAddress& address);

}  // namespace rocinante
