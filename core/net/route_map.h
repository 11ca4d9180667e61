#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/net/endpoint.h"

namespace rocinante {

/// A topic that goes to another endpoint when a log is played: a pattern and the endpoint.
struct RouteMap {
  std::string pattern;
  Endpoint to;

  /// "TOPIC=EP", where TOPIC ends at the first `=`.
  static Result<RouteMap> parse(std::string_view text);

  bool matches(const std::string& topic) const;
};

}  // namespace rocinante
