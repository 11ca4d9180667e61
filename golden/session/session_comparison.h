#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/behaviour/run_spec.h"
#include "core/cell/cell.h"
#include "core/session/event_alignment.h"
#include "core/session/timeline.h"
#include "golden/report/report.h"
#include "viewer/view/picture_terms.h"

namespace rocinante {

struct SessionQuestion {
  std::filesystem::path a, b;
  std::vector<std::filesystem::path> more_accepted;  ///< beside a; b is judged in the band of all
  RunSpec spec;
  std::string camera;  ///< empty: chosen as by `render`
  PictureTerms picture;
  Tolerance tolerance = Tolerance::loose();  ///< for pictures
  bool pictures = true;
};

/// Two recordings of one scenario, compared by behaviour and pictures (docs/programs/golden.md,
/// "session"). a is the accepted one.
struct SessionComparison {
  EventAlignment events;
  LogTime origin_a{}, origin_b{};
  /// One run, "session": b judged against a. And the drawn moments as frames, named "start",
  /// "event-picked", "worst-arm-elbow" ...; a is the golden.
  SuiteReport report;
  std::vector<LogTime> times_b;  ///< by picture: the time of b
  /// Damage of either log that may hide an event: it makes differences and their absence uncertain.
  StateDamage damage;

  /// incomparable when a log is damaged; same when b behaves as a and every picture is the same.
  Verdict verdict() const;
  const JudgedRun& run() const { return report.runs.front(); }
};

/// not_found when the two have no time in common. `progress` receives the current step. Needs no
/// renderer unless it draws: with several accepted recordings, only what behaves differently.
Result<SessionComparison> judgeSessions(const std::filesystem::path& cell,
                                        const CellOptions& options, const SessionQuestion& question,
                                        const std::function<void(const std::string&)>& progress);

/// Text of several lines, and one JSON object.
std::string sessionText(const SessionComparison& comparison);
std::string sessionJson(const SessionComparison& comparison);

/// The one of `candidates`, times of b, at which b's state is most like that of a at `in_a`: fewest
/// devices, colours and drawings that are not the same, then links nearest to their place relative
/// to the limits, then nearest to `in_b`.
Result<LogTime> nearestMoment(const Cell& cell, Timeline& a, LogTime in_a, Timeline& b,
                              LogTime in_b, const std::vector<LogTime>& candidates,
                              const RunLimits& limits);

}  // namespace rocinante
