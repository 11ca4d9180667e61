#include "player/logs/play_routes.h"

#include <algorithm>
#include <charconv>

namespace rocinante {
namespace {

// Each route is an open socket.
constexpr std::size_t kMaxRoutes = 1000;

/// The port in "127.0.0.1:5000" or "[::1]:5000"; 0 for none.
std::uint16_t portOf(const LogChannel& channel) {
  const auto remote = channel.metadata.find("remote");
  if (remote == channel.metadata.end()) return 0;
  const std::string& text = remote->second;
  const std::size_t colon = text.rfind(':');
  std::uint16_t port = 0;
  if (colon == text.npos) return 0;
  const char* end = text.data() + text.size();
  const auto [stop, fault] = std::from_chars(text.data() + colon + 1, end, port);
  return fault == std::errc() && stop == end ? port : std::uint16_t{0};
}

std::uint16_t numberOf(std::vector<Route>& routes, const Route& wanted) {
  const auto found = std::find(routes.begin(), routes.end(), wanted);
  const auto number = static_cast<std::uint16_t>(found - routes.begin());
  if (found == routes.end()) routes.push_back(wanted);
  return number;
}

void addOnce(std::vector<std::uint16_t>& numbers, std::uint16_t number) {
  if (std::find(numbers.begin(), numbers.end(), number) == numbers.end()) numbers.push_back(number);
}

}  // namespace

Result<PlayRoutes> makeRoutes(const MultiLogReader& logs, const Endpoint& to,
                              const std::vector<RouteMap>& maps, bool keep_ports) {
  PlayRoutes routes;
  std::vector<bool> used(maps.size());
  for (std::size_t log = 0; log < logs.logs(); ++log) {
    std::vector<std::uint16_t>& played = routes.played.emplace_back();
    for (const LogChannel& channel : logs.channels(log)) {
      if (!channel.captured() || !logs.chosen(log, channel.id)) continue;
      Route route{to, keep_ports ? portOf(channel) : std::uint16_t{0}, false};
      for (std::size_t i = 0; i < maps.size(); ++i) {
        if (!maps[i].matches(channel.topic)) continue;
        used[i] = true;
        route.to = maps[i].to;
        break;
      }
      if (played.size() <= channel.id) played.resize(channel.id + 1U);
      played[channel.id] = numberOf(routes.all, route);
      const std::uint16_t own = numberOf(routes.all, {route.to, 0, true});
      addOnce(routes.restated_elsewhere, own);
      const auto source = channel.metadata.find("source");
      if (source != channel.metadata.end() && !source->second.empty()) {
        addOnce(routes.restated[source->second], own);
      }
      if (routes.all.size() > kMaxRoutes) {
        return Error{ErrorKind::bad_argument,
                     "more than " + std::to_string(kMaxRoutes) + " sockets would be needed",
                     channel.topic};
      }
    }
  }
  for (std::size_t i = 0; i < maps.size(); ++i) {
    if (!used[i]) {
      return Error{ErrorKind::bad_argument, "no channel to be played matches the map",
                   maps[i].pattern};
    }
  }
  if (routes.all.empty()) routes.all.push_back({to, 0, false});
  return routes;
}

}  // namespace rocinante
