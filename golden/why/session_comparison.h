#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/model/cell.h"
#include "core/result.h"
#include "golden/report.h"
#include "golden/why/session_deviation.h"

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

  /// No event is missing, nothing is beyond its limit, every picture is the same.
  bool same() const;
};

/// not_found when the two have no time in common. `progress` is told what is being done.
Result<SessionComparison> judgeSessions(const std::filesystem::path& cell,
                                        const CellOptions& options, const SessionQuestion& question,
                                        const std::function<void(const std::string&)>& progress);

/// For people, several lines; for scripts, one JSON object.
std::string sessionText(const SessionComparison& comparison);
std::string sessionJson(const SessionComparison& comparison);

}  // namespace rocinante
