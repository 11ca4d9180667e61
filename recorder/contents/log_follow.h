#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/log/log_follower.h"
#include "recorder/contents/log_cat.h"

namespace rocinante {

struct FollowOptions {
  std::vector<std::string> channels;  ///< patterns of topics; empty: the captured ones
  CatFormat format = CatFormat::text;
  bool with_header = true;  ///< print CSV's line of column names
};

struct FollowEvents {
  /// Called when nothing new is there: waits a little; false ends the work.
  std::function<bool()> wait;
  std::function<void(const DamageSpan&)> damaged;
};

/// Prints the chosen messages of a growing log, one per line, until its recorder closes it.
/// Everything available is printed before each wait. Returns the number of messages.
Result<std::uint64_t> followLog(LogFollower& follower, const FollowOptions& options,
                                const FollowEvents& events, const TextSink& out);

}  // namespace rocinante
