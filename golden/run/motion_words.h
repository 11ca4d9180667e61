#pragma once

#include <string>
#include <vector>

namespace rocinante {

/// One joint of a run beside the accepted one, on one grid; radians or metres. A list of one number
/// never changes.
struct MotionShape {
  const std::vector<double>& run;
  const std::vector<double>& accepted;
  std::size_t first = 0, last = 0;  ///< samples between which they differ
  double step_s = 0;
  double scale = 1;  ///< to the unit
  double limit = 0;  ///< in the unit
  const char* unit = "";
};

/// How the two differ, when it has a simple form: "frozen at 12.3°", "its sign is flipped", "offset
/// by +0.50°", "50 ms late". Empty otherwise.
std::string howItDiffers(const MotionShape& shape);

}  // namespace rocinante
