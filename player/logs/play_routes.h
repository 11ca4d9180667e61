#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/net/endpoint.h"
#include "core/net/route_map.h"
#include "player/logs/multi_log_reader.h"
#include "player/send/route.h"

namespace rocinante {

/// The socket for each datagram. Numbers index `all`.
struct PlayRoutes {
  std::vector<Route> all;
  std::vector<std::vector<std::uint16_t>> played;  ///< by log, by channel id
  /// By SOURCE: every route that carries its datagrams, once each.
  std::map<std::string, std::vector<std::uint16_t>, std::less<>> restated;
  std::vector<std::uint16_t> restated_elsewhere;  ///< for a SOURCE that no channel names

  const std::vector<std::uint16_t>& restatedOf(std::string_view source) const {
    const auto found = restated.find(source);
    return found == restated.end() ? restated_elsewhere : found->second;
  }
};

/// The routes of the chosen channels: to the first of `maps` that matches the topic, else to `to`;
/// from the port of the original sender when `keep_ports`. bad_argument when a map matches no
/// channel, or there are more than 1,000 routes.
Result<PlayRoutes> makeRoutes(const MultiLogReader& logs, const Endpoint& to,
                              const std::vector<RouteMap>& maps, bool keep_ports);

}  // namespace rocinante
