#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/session/timeline.h"

namespace rocinante {

/// Pictures a second, exactly: 25, 29.97 (2997/100) or 30000/1001.
struct FrameRate {
  std::int64_t count = 25;
  std::int64_t seconds = 1;
  std::string text() const;  ///< "25" or "30000/1001"
};

/// "25", "29.97" or "30000/1001": above 0, at most 1000.
Result<FrameRate> parseFrameRate(const std::string& text);

/// Which moments of a log are drawn, as the arguments say it: one of `at` (with `at_file`),
/// `every`, `rate` and `events` alone.
struct MomentChoice {
  std::vector<std::string> at;    ///< session times
  std::filesystem::path at_file;  ///< more of them, one a line; # begins a comment
  std::string every;              ///< a duration: multiples of it, from the origin
  std::string rate;               ///< frames a second, from the origin
  bool all_events = false;
  std::vector<std::string> events;  ///< patterns (core/base/pattern.h) of events' texts
  std::string from, until;          ///< not of `at`: only these, until exclusive

  bool any() const {
    return !at.empty() || !at_file.empty() || !every.empty() || !rate.empty() || all_events ||
           !events.empty();
  }
};

struct RenderMoment {
  std::string text;  ///< as it was asked for, else seconds from the origin
  LogTime time{};
  std::string event;  ///< its text
};

/// In the order asked for. bad_argument for what cannot be read, a time outside the log, or when no
/// moment is left; more than a million are surely a slip of the hand. Damage of the log that may
/// hide an event which is asked for is added to `hiding`.
Result<std::vector<RenderMoment>> renderMoments(const MomentChoice& choice, Timeline& session,
                                                StateDamage& hiding);

}  // namespace rocinante
