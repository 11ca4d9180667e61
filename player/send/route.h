#pragma once

#include <cstdint>

#include "core/net/endpoint.h"

namespace rocinante {

/// A socket to send from: its destination and local port.
struct Route {
  Endpoint to;
  std::uint16_t local_port = 0;  ///< 0: any
  bool restating = false;        ///< for the player's restatements, which receivers can tell apart
  bool operator==(const Route&) const = default;
};

}  // namespace rocinante
