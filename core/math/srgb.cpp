#include "core/math/srgb.h"

#include <cmath>

namespace rocinante {

double srgbOfLinear(double linear) {
  if (!(linear > 0.0)) return 0.0;
  if (linear >= 1.0) return 1.0;
  if (linear <= 0.0031308) return linear * 12.92;
  // x^(1/2.4) is the cube root of x^(5/4). Newton's rule from 1 has converged after 30 rounds for
  // any argument from 0.0007, which is 0.0031308^(5/4), to 1.
  const double cube = linear * std::sqrt(std::sqrt(linear));
  double root = 1.0;
  for (int i = 0; i < 30; ++i) root -= (root * root * root - cube) / (3.0 * root * root);
  return 1.055 * root - 0.055;
}

}  // namespace rocinante
