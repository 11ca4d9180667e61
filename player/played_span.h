#pragma once

#include <set>
#include <string>

#include "core/packet/session_state.h"
#include "core/result.h"
#include "core/time.h"
#include "player/log_merge.h"

namespace rocinante {

/// The part of a session to be played: [from, until).
struct PlayedSpan {
  LogTime from{};
  LogTime until{};
};

/// What a player says before it plays from a moment on.
struct StateBefore {
  SessionState state;
  /// What the logs name and `state` does not know: who speaks for the first time later.
  std::set<std::string> silent_sources;
};

/// The state just before `moment`: the fold of every message with log_time < moment, so that
/// playing from `moment` continues it.
Result<StateBefore> stateBefore(LogMerge& logs, LogTime moment);

}  // namespace rocinante
