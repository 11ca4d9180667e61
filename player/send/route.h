#pragma once

#include <cstdint>

#include "core/net/endpoint.h"

namespace rocinante {

/// A socket to send by: where to, and from which port.
struct Route {
  Endpoint to;
  std::uint16_t local_port = 0;  ///< 0: any
  bool restating = false;        ///< the player's own: a receiver can tell it from the session's
  bool operator==(const Route&) const = default;
};

}  // namespace rocinante
