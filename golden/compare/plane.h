#pragma once

#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

namespace rocinante {

/// One number per pixel, rows top to bottom.
template <class Number>
struct Plane {
  int width = 0, height = 0;
  std::vector<Number> values;

  Plane() = default;
  Plane(int columns, int rows)
      : width(columns),
        height(rows),
        values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}

  Number* row(int y) {
    return values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
  }
  const Number* row(int y) const {
    return values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
  }
};

/// `plane` correlated with `horizontal` along its rows and with `vertical` down its columns, only
/// where both are inside: the result is smaller by their lengths minus one.
template <class Number>
Plane<Number> filtered(const Plane<Number>& plane, std::span<const Number> horizontal,
                       std::span<const Number> vertical) {
  const int across = static_cast<int>(horizontal.size());
  const int down = static_cast<int>(vertical.size());
  assert(plane.width >= across && plane.height >= down);
  // Tap by tap over whole rows, so that the compiler can vectorize the loop.
  Plane<Number> rows(plane.width - across + 1, plane.height);
  for (int y = 0; y < rows.height; ++y) {
    const Number* from = plane.row(y);
    Number* to = rows.row(y);
    for (int tap = 0; tap < across; ++tap) {
      const Number weight = horizontal[static_cast<std::size_t>(tap)];
      if (weight == 0) continue;
      for (int x = 0; x < rows.width; ++x) to[x] += weight * from[x + tap];
    }
  }
  Plane<Number> result(rows.width, plane.height - down + 1);
  for (int y = 0; y < result.height; ++y) {
    Number* to = result.row(y);
    for (int tap = 0; tap < down; ++tap) {
      const Number weight = vertical[static_cast<std::size_t>(tap)];
      if (weight == 0) continue;
      const Number* from = rows.row(y + tap);
      for (int x = 0; x < result.width; ++x) to[x] += weight * from[x];
    }
  }
  return result;
}

}  // namespace rocinante
