#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/series/value_bins.h"
#include "viewer/shown/plot_scale.h"
#include "viewer/shown/plot_shape.h"

namespace rocinante {

/// What two values did in the same equal stretches of time: as many columns of each, or none.
struct XyColumns {
  std::vector<ValueColumn> x, y;
};

/// An axis of one value over another: how it is shown, and over how many pixels.
struct XyAxis {
  const PlotValue& value;
  const PlotScale& scale;
  float length = 0;

  /// Pixels from its low end; cut to one length beyond either end.
  float place(double stated) const;
};

/// One value over another as lines and boxes, in pixels from the left end and from the bottom.
struct XyShape {
  /// A stretch in which the two moved more often than once: its path is somewhere in here, and
  /// reaches every side.
  struct Box {
    float left = 0, right = 0, low = 0, high = 0;
    bool operator==(const Box&) const = default;
  };
  /// Through where both were as each stretch ended: each without a gap, one point or more. Both
  /// hold between samples; where one is not there, there is a gap.
  std::vector<std::vector<PlotShape::Point>> lines;
  std::vector<Box> boxes;
};

/// At most a line of as many points as there are columns, and as many boxes. Points within a
/// quarter of a pixel of the one before are left out, and boxes that are smaller than a pixel.
XyShape xyShape(const XyColumns& columns, const XyAxis& x, const XyAxis& y);

using ValueRange = std::pair<double, double>;

/// Widens one of two ranges, about its middle, so that a unit takes as many pixels of `width` as of
/// `height`. Ranges without an extent stay.
void makeEqual(ValueRange& x, ValueRange& y, float width, float height);

/// Where both are at a part of the time, 0 to 1, as stated; empty where one is not there.
std::optional<std::pair<double, double>> pairAt(const XyColumns& columns, double part);

}  // namespace rocinante
