#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "viewer/picture/picture.h"

namespace rocinante {

/// A link's pixels in one picture.
struct Region {
  std::vector<std::uint8_t> inside;  ///< by pixel, row by row: 0 or 1
  std::int64_t pixels = 0;
  double x = 0, y = 0;        ///< its centroid; meaningless when empty
  bool touches_edge = false;  ///< cut by the picture's edge: its centroid is not the link's
};
Region regionOf(const std::vector<std::uint32_t>& ids, int width, int height, std::uint32_t id);

/// Movement of a region's pixels from one picture to another of the same size.
struct Shift {
  double right = 0, down = 0;  ///< pixels, to a fraction
  /// Mean cost of placing one over the other, 0 (equal) to 1 (no fit): with this shift and without
  /// any.
  double cost = 0, cost_unmoved = 0;
};

/// Finds the shift that best places `from`'s region over `to`'s by outlines and colours, searching
/// a few pixels around the difference of the centroids and around zero. Empty when one region is
/// empty.
std::optional<Shift> registerRegions(const Picture& from, const Region& from_region,
                                     const Picture& to, const Region& to_region);

/// Blurred by 1 2 1 in both directions, so that fractional movements of jagged edges can be found.
Picture smoothed(const Picture& picture);

/// Finds the shift of a region of `from` in `to`, whose outlines are unknown, at most `window`
/// pixels away, by the colours of the region and of a border of two pixels around it.
std::optional<Shift> findRegion(const Picture& from, const Region& region, const Picture& to,
                                int window);

}  // namespace rocinante
