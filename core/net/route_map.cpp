#include "core/net/route_map.h"

#include "core/base/pattern.h"

namespace rocinante {

Result<RouteMap> RouteMap::parse(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == text.npos || equals == 0) {
    return Error{ErrorKind::bad_argument, "a map is TOPIC=ENDPOINT, as in /udp/19960/arm=:5000",
                 std::string(text)};
  }
  const Result<Endpoint> to = Endpoint::parse(text.substr(equals + 1));
  if (!to) return to.error();
  return RouteMap{std::string(text.substr(0, equals)), *to};
}

bool RouteMap::matches(const std::string& topic) const { return patternMatches(pattern, topic); }

}  // namespace rocinante
