#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/session/timeline.h"

namespace rocinante {

/// Exact frames per second: 25, 29.97 (2997/100) or 30000/1001.
struct FrameRate {
  std::int64_t count = 25;
  std::int64_t seconds = 1;
  std::string text() const;  ///< "25" or "30000/1001"
};

/// "25", "29.97" or "30000/1001": above 0, at most 1000.
Result<FrameRate> parseFrameRate(const std::string& text);

/// The moments of a log to draw: only one of `at` (with `at_file`), `every`, `rate` and `events`.
struct MomentChoice {
  std::vector<std::string> at;    ///< session times, or names of events (moment_name.h)
  std::filesystem::path at_file;  ///< more of them, one per line; # begins a comment
  std::string every;              ///< a period, counted from the origin
  std::string rate;               ///< frames per second, counted from the origin
  bool all_events = false;
  std::vector<std::string> events;  ///< patterns (core/base/pattern.h) of events' texts
  std::string from, until;          ///< range, not for `at`; until exclusive

  bool any() const {
    return !at.empty() || !at_file.empty() || !every.empty() || !rate.empty() || all_events ||
           !events.empty();
  }
};

struct RenderMoment {
  std::string text;  ///< as requested, else seconds from the origin
  LogTime time{};
  std::string event;  ///< its text
};

/// The moments in the requested order. bad_argument for invalid text, a time outside the log, no
/// moments, or more than a million. Damage of the log that may hide a requested event is added to
/// `hiding`.
Result<std::vector<RenderMoment>> renderMoments(const MomentChoice& choice, Timeline& session,
                                                StateDamage& hiding);

}  // namespace rocinante
