#include "core/clearance/clearance_figure.h"

#include <algorithm>
#include <cmath>

namespace rocinante {

double roundedClearance(double metres) {
  if (!(metres > 0)) return 0;
  return std::max(1.0, std::floor(metres * 1e5 + 0.5)) / 1e5;
}

}  // namespace rocinante
