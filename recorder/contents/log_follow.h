#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/log/log_reader.h"
#include "recorder/contents/log_cat.h"

namespace rocinante {

struct FollowOptions {
  std::vector<std::string> channels;  ///< patterns of topics; empty: the captured ones
  CatFormat format = CatFormat::text;
  bool from_start = false;  ///< also the messages that are there already
};

struct FollowEvents {
  /// Called when nothing new is there: waits a little; false ends the work.
  std::function<bool()> wait;
  /// Each damage once; without `from_start` only what is found behind the beginning.
  std::function<void(const DamageSpan&)> damaged;
};

/// Prints the chosen messages of a growing log (LogReader::follow) in the order of the file, one
/// per line, until its recorder ends it. Everything available is printed before each wait. Returns
/// the number of messages.
Result<std::uint64_t> followLog(LogReader& log, const FollowOptions& options,
                                const FollowEvents& events, const TextSink& out);

}  // namespace rocinante
