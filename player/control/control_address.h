#pragma once

#include <filesystem>
#include <string_view>

#include "core/base/result.h"
#include "core/net/endpoint.h"

namespace rocinante {

/// Where a player listens for commands: udp://HOST:PORT (also HOST:PORT), or unix:PATH.
struct ControlAddress {
  std::filesystem::path path;  ///< of a Unix socket; empty: use `endpoint`
  Endpoint endpoint;

  static Result<ControlAddress> parse(std::string_view text);
};

}  // namespace rocinante
