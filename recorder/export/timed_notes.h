#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/foreign/session/session_format.h"
#include "core/session/moment_walk.h"

namespace rocinante {

/// A sentence about a moment.
struct TimedNote {
  LogTime time;
  EventLevel level = EventLevel::info;
  std::string name, text;
};

/// Events, marks and losses of a session, to be written among its messages in order of time.
class TimedNotes {
 public:
  /// Those in [from, until), and `more` of that span. Reads the log once.
  static Result<TimedNotes> of(MomentWalk& session, LogTime from, LogTime until,
                               const std::vector<TimedNote>& more = {});

  /// Those up to and including `moment` that were not written yet.
  Status write(SessionFormat& format, MessageSink& out, LogTime moment);

 private:
  std::vector<TimedNote> notes_;  ///< by time
  std::size_t next_ = 0;
};

}  // namespace rocinante
