#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "viewer/picture/picture.h"

namespace rocinante {

/// Where a link's pixels lie in one picture.
struct Region {
  std::vector<std::uint8_t> inside;  ///< by pixel, row by row: 0 or 1
  std::int64_t pixels = 0;
  double x = 0, y = 0;        ///< its centroid; meaningless when empty
  bool touches_edge = false;  ///< cut by the picture's edge: its centroid is not the link's
};
Region regionOf(const std::vector<std::uint32_t>& ids, int width, int height, std::uint32_t id);

/// How far a region's pixels went from one picture to another of the same size.
struct Shift {
  double right = 0, down = 0;  ///< pixels, to a fraction
  /// Mean cost of laying one over the other, 0 (equal) to 1 (nothing fits): with this shift, and
  /// without any.
  double cost = 0, cost_unmoved = 0;
};

/// Finds the shift that lays `from`'s region best over `to`'s: outlines and colours together,
/// a few pixels around the difference of the centroids and around none. Empty when one is empty.
std::optional<Shift> registerRegions(const Picture& from, const Region& from_region,
                                     const Picture& to, const Region& to_region);

/// Each pixel with its neighbours, 1 2 1 in both directions: what moved by a part of a pixel is
/// then found again where it is, jagged edges and all.
Picture smoothed(const Picture& picture);

/// Finds where the pixels of `from` inside a region are found in `to`, whose outlines are not
/// known, at most `window` pixels away: by colours, and those of a rim of two pixels around it.
std::optional<Shift> findRegion(const Picture& from, const Region& region, const Picture& to,
                                int window);

}  // namespace rocinante
