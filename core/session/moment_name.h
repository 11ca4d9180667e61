#pragma once

#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/session/state_damage.h"
#include "core/session/timeline.h"

namespace rocinante {

// How users name a moment of a session, the same for every program (docs/concepts.md, "Moments"):
// by a session time (parseSessionTime()), or by the text of an event or mark, which may be a
// pattern (core/base/pattern.h). `--at TEXT` takes both, the time first; `--event TEXT` an event
// alone.

/// The events whose text matches, oldest first. Damage that may hide one is added to `hiding`.
/// not_found, naming a similar text, when none matches.
Result<std::vector<Event>> eventsNamed(std::string_view pattern, Timeline& session,
                                       StateDamage& hiding);

/// The moment of the only event that matches; bad_argument with their times when there are several,
/// `damaged` when another may be hidden.
Result<LogTime> momentOfEvent(std::string_view pattern, Timeline& session);

/// Whether the text is a time of any session.
bool isSessionTime(std::string_view text);

/// A time of the session, else momentOfEvent(); bad_argument when it is neither.
Result<LogTime> parseMoment(std::string_view text, Timeline& session);

}  // namespace rocinante
