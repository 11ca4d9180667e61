#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "golden/report/report.h"
#include "golden/session/session_deviation.h"

namespace rocinante {

struct SessionQuestion {
  std::filesystem::path a, b;
  SessionLimits limits;
  std::string camera;  ///< empty: chosen as by `render`
  int width = 640, height = 480, samples = 4;
  Tolerance tolerance = Tolerance::loose();  ///< for pictures
  bool pictures = true;
};

/// Two recordings of one scenario, compared by events, state and pictures (docs/programs/golden.md,
/// "session"). a is the accepted one.
struct SessionComparison {
  EventAlignment events;
  LogTime origin_a{}, origin_b{};
  SessionDeviation state;
  /// The drawn moments as frames of a suite, named "start", "event-picked", "worst-arm-elbow" ...;
  /// a is the golden.
  SuiteReport pictures;
  std::vector<LogTime> times_b;  ///< by picture: the time of b
  /// Damage of either log in the compared range, or where it may hide an event. It makes
  /// differences and their absence uncertain.
  StateDamage damage;

  /// incomparable when a log is damaged; same when no event is missing, no deviation is beyond its
  /// limit and every picture is the same.
  Verdict verdict() const;
};

/// not_found when the two have no time in common. `progress` receives the current step.
Result<SessionComparison> judgeSessions(const std::filesystem::path& cell,
                                        const CellOptions& options, const SessionQuestion& question,
                                        const std::function<void(const std::string&)>& progress);

}  // namespace rocinante
