#pragma once

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

/// The state just before `moment`: the fold of every message with log_time < moment, so that
/// playing from `moment` continues it. Every SOURCE that the logs name or that spoke before
/// `moment` is among its `sources`, also when it has said nothing yet.
struct StateBefore {
  SessionState state;
  std::set<std::string> sources;
};
Result<StateBefore> stateBefore(LogMerge& logs, LogTime moment);

}  // namespace rocinante
