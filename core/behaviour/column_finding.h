#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/behaviour/column_samples.h"
#include "core/behaviour/motion_judge.h"
#include "core/behaviour/run_judgement.h"

namespace rocinante {

struct RunTimes;

/// The band and the run's value over the accepted session, for a column of one number, in the unit
/// of `limit`. At most a few hundred points: of each stretch the band, and the
/// value that is farthest outside. `reach`: how much earlier or later a value may come.
RunCurve runCurve(const RunTimes& times, const std::vector<ColumnSamples>& accepted,
                  const ColumnSamples& run, const TrackColumn& column, std::int64_t reach,
                  double limit);

/// The deviation of one measure of a column over time.
struct ColumnMeasure {
  std::string unit = "°";
  const char* key = "joint_deg";  ///< of limits
  double limit = 0;
  std::size_t first_component = 0, components = 1;  ///< of an Apart
  std::optional<std::int64_t> first{};              ///< beyond its limit; empty: never
  std::int64_t at = 0, last = 0;                    ///< where it is largest, and beyond at last
  double largest = 0;
  double missing = 0;  ///< of values that the run lacks; the limit must be wider than both
  std::int64_t missing_at = 0;
};

/// A column of all sessions that are compared. Borrows all but the name.
struct JudgedColumn {
  const RunTimes& times;
  std::string item;
  const TrackColumn& column;
  const std::vector<ColumnSamples>& accepted;
  const ColumnSamples& run;
};

/// A finding about a column at a time, without a sentence.
RunFinding findingAt(const JudgedColumn& judged, std::int64_t time);
/// Of a measure that was beyond its limit, where values may come earlier or later by `reach`.
RunFinding findingOf(const JudgedColumn& judged, const ColumnMeasure& measure, std::int64_t reach);

/// One joint of a run beside the accepted one, on one grid; radians or metres. A list of one number
/// never changes.
struct MotionShape {
  const std::vector<double>& run;
  const std::vector<double>& accepted;
  std::size_t first = 0, last = 0;  ///< samples between which they differ
  double step_s = 0;
  double scale = 1;  ///< to the unit
  double limit = 0;  ///< in the unit
  std::string_view unit = "";
};

/// How the two differ, when it has a simple form: "frozen at 12.3°", "its sign is flipped", "offset
/// by +0.50°", "50 ms late". Empty otherwise.
std::string howItDiffers(const MotionShape& shape);

}  // namespace rocinante
