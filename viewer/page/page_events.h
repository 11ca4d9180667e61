#pragma once

#include <string>
#include <vector>

#include "core/packet/session_state.h"

namespace rocinante {

/// JSON: the events of a session as a page lists them: ns from the session's origin, and text. The
/// same as the viewer's own of a log (viewer/web/web_session.h, eventsJson()).
std::string pageEvents(const std::vector<Event>& events, LogTime origin);

}  // namespace rocinante
