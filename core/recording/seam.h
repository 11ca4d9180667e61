#pragma once

#include "core/base/time.h"
#include "core/packet/session_state.h"

namespace rocinante {

// Where one piece of a session ends and the next begins.

/// Whether the seam that is wanted since `since` may be at `time`: where no restatement is
/// unfinished, or after a second. A restatement is abandoned after that, so only an unbroken chain
/// of them delays a seam longer.
bool seamFits(const SessionState& state, LogTime time, LogTime since);

/// The begin of the interval with the moment, of those of `length` that are counted from `origin`.
/// It may lie before the origin; `length` is positive.
LogTime intervalBegin(LogTime time, LogTime origin, Nanoseconds length);

}  // namespace rocinante
