#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

namespace rocinante {

/// Linear light in [0, 1] to the nearest 8-bit sRGB value, computed only with + - * /: the C
/// library's pow differs between CPUs.
class SrgbCurve {
 public:
  SrgbCurve() {
    for (std::size_t i = 0; i < bounds_.size(); ++i) {
      bounds_[i] = linearOf((static_cast<double>(i) + 0.5) / 255.0);
    }
  }

  /// NaN gives 0.
  std::uint8_t encode(float linear) const {
    const auto above =
        std::upper_bound(bounds_.begin(), bounds_.end(), double{linear},
                         [](double value, double bound) { return !(value >= bound); });
    return static_cast<std::uint8_t>(above - bounds_.begin());
  }

  /// The linear light of a level, 0 to 255, which encode() turns back into it.
  static float decode(int level) {
    return static_cast<float>(linearOf(static_cast<double>(level) / 255.0));
  }

 private:
  static double linearOf(double encoded) {
    if (encoded <= 0.04045) return encoded / 12.92;
    // x^2.4 = x^2 * (x^2)^(1/5); the root by Newton's rule, which has converged after 60 rounds
    // from 1 for any x in (0, 1].
    const double x = (encoded + 0.055) / 1.055;
    const double square = x * x;
    double root = 1;
    for (int i = 0; i < 60; ++i) {
      const double fourth = root * root * root * root;
      root = root - (root * fourth - square) / (5 * fourth);
    }
    return square * root;
  }

  std::array<double, 255> bounds_;  ///< between encoded i and i + 1
};

}  // namespace rocinante
