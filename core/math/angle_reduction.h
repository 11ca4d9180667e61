#pragma once

namespace rocinante {

/// An angle reduced by a whole number of right angles.
struct ReducedAngle {
  double high;        ///< in [-pi/4, pi/4]
  double low;         ///< the rest, below a unit in the last place of `high`
  unsigned quadrant;  ///< right angles subtracted, modulo 4
};

/// Reduces a finite, non-negative angle. `high + low` is good to 70 bits for every double: the
/// product with 2/pi is made with integers, from the digits that matter to the result.
ReducedAngle reduceAngle(double angle_rad);

}  // namespace rocinante
