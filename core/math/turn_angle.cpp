#include "core/math/turn_angle.h"

#include <cmath>

#include "core/math/trigonometry.h"

namespace rocinante {

double turnAngle(const Mat4& a, const Mat4& b) {
  // The columns of rotations that are an angle t apart differ by 8 sin(t/2)^2 in all. Their trace
  // has the cosine of t instead, in which half the digits of a small angle are lost.
  double squares = 0;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      const double apart = a[column][row] - b[column][row];
      squares += apart * apart;
    }
  }
  const double sine_of_half = std::sqrt(squares / 8);
  // NaN stays NaN: no comparison with it holds.
  return 2 * arcSine(sine_of_half > 1 ? 1 : sine_of_half);
}

}  // namespace rocinante
