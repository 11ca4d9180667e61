#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "core/base/time.h"

namespace rocinante {

/// Equal parts of the session's time over which a channel's activity is measured.
inline constexpr std::size_t kActivityParts = 24;

/// How fast messages came, by part of the session. Between two messages less than two parts apart
/// the stream flows: one message, spread evenly over the time between them. So a steady rate is the
/// same in every part, wherever parts begin between its messages; counting messages would give 7
/// and 8 by turns. A message with no such neighbour counts as one in its own part. Plain values.
class Activity {
 public:
  /// By part: messages a part's length while the stream flowed; 0 where nothing came.
  using Parts = std::array<double, kActivityParts>;

  Activity(LogTime start, LogTime end);

  /// In order of time; earlier than the one before counts as at the same time.
  void add(LogTime time);
  Parts parts() const;

 private:
  struct Part {
    double messages = 0;
    double flowed = 0;  ///< of the part's length: 0 to 1
  };
  double placeOf(LogTime time) const;
  static void addAlone(std::array<Part, kActivityParts>& parts, double place);
  void addFlow(double from, double to);

  LogTime start_;
  double part_ns_;
  std::array<Part, kActivityParts> parts_{};
  std::optional<double> last_;  // place of the last message, in parts
  bool last_has_neighbour_ = false;
};

/// Eight heights, the tallest for the fastest part; a dot where nothing came, so that a silence
/// is seen.
std::string activityStrip(const Activity::Parts& parts);

}  // namespace rocinante
