#pragma once

#include <optional>
#include <string>

namespace rocinante {

/// A length to draw beside a picture: 1, 2 or 5 times a power of ten metres.
struct ScaleBar {
  double metres = 1;
  double pixels = 100;
  std::string text;  ///< "500 mm", "2 m", "10 km"
};

/// The longest bar of at most `longest_px`; empty when a pixel's size is NaN or outside nanometres
/// to a million kilometres.
std::optional<ScaleBar> scaleBar(double metres_per_pixel, double longest_px);

}  // namespace rocinante
