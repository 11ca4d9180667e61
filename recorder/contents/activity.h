#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "core/base/time.h"

namespace rocinante {

/// Equal parts of the session's time over which a channel's activity is measured.
inline constexpr std::size_t kActivityParts = 24;

/// The message rate in each part of the session. One message is spread evenly over the time between
/// two messages less than two parts apart. So a steady rate is the same in every part, wherever
/// parts begin between its messages; counting messages would alternate between, say, 7 and 8. A
/// message without such a neighbour counts as one in its own part. Plain values.
class Activity {
 public:
  /// By part: messages per length of a part while the stream flowed; 0 where nothing came.
  using Parts = std::array<double, kActivityParts>;

  Activity(LogTime start, LogTime end);

  /// Call in time order; a time earlier than the previous one counts as equal to it.
  void add(LogTime time);
  Parts parts() const;

 private:
  struct Part {
    double messages = 0;
    double flowed = 0;  ///< fraction of the part: 0 to 1
  };
  double placeOf(LogTime time) const;
  static void addAlone(std::array<Part, kActivityParts>& parts, double place);
  void addFlow(double from, double to);

  LogTime start_;
  double part_ns_;
  std::array<Part, kActivityParts> parts_{};
  std::optional<double> last_;  // time of the last message, in parts
  bool last_has_neighbour_ = false;
};

/// Bars of eight heights, the tallest for the fastest part; a dot where nothing came.
std::string activityStrip(const Activity::Parts& parts);

}  // namespace rocinante
