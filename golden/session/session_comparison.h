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
  std::string camera;  ///< empty: as render chooses
  int width = 640, height = 480, samples = 4;
  Tolerance tolerance = Tolerance::loose();  ///< of pictures
  bool pictures = true;
};

/// Two recordings of one scenario, compared by events, by state and by pictures
/// (docs/programs/golden.md, "session"). a is what was accepted.
struct SessionComparison {
  EventAlignment events;
  LogTime origin_a{}, origin_b{};
  SessionDeviation state;
  /// The moments at which both were drawn, as a suite's frames: names "start", "event-picked",
  /// "worst-arm-elbow" ...; a is the golden.
  SuiteReport pictures;
  std::vector<LogTime> times_b;  ///< of b, by picture: when it was drawn
  /// Of either log, in the span that is compared, or where it may hide an event: what differs, and
  /// what does not, may be by that.
  StateDamage damage;

  /// incomparable where a log is damaged; same when no event is missing, nothing is beyond its
  /// limit and every picture is the same.
  Verdict verdict() const;
};

/// not_found when the two have no time in common. `progress` is told what is being done.
Result<SessionComparison> judgeSessions(const std::filesystem::path& cell,
                                        const CellOptions& options, const SessionQuestion& question,
                                        const std::function<void(const std::string&)>& progress);

}  // namespace rocinante
