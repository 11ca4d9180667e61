#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/log/log_follower.h"
#include "recorder/contents/log_cat.h"

namespace rocinante {

struct FollowOptions {
  std::vector<std::string> channels;  ///< patterns of topics, as a shell's; empty: captured ones
  CatFormat format = CatFormat::text;
  bool with_header = true;  ///< a CSV file's first line
};

/// What happens beside the messages.
struct FollowEvents {
  /// Nothing new is there: waits a little; false ends the work.
  std::function<bool()> wait;
  std::function<void(const DamageSpan&)> damaged;
};

/// Gives the chosen messages of a growing log, one a line, until its recorder closes it. What is
/// there is handed over before each wait. Answers how many there were.
Result<std::uint64_t> followLog(LogFollower& follower, const FollowOptions& options,
                                const FollowEvents& events, const TextSink& out);

}  // namespace rocinante
