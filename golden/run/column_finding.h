#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "golden/run/column_samples.h"
#include "golden/run/motion_judge.h"

namespace rocinante {

/// The deviation of one measure of a column over time.
struct ColumnMeasure {
  const char* unit = "°";
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

}  // namespace rocinante
