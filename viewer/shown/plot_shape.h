#pragma once

#include <vector>

#include "core/series/value_bins.h"
#include "viewer/shown/plot_scale.h"

namespace rocinante {

/// A curve as lines and bars, in pixels from the left end and from the bottom of its lane.
struct PlotShape {
  struct Point {
    float x = 0, y = 0;
    bool operator==(const Point&) const = default;
  };
  /// A column in which the value moves so fast that only its extent can be seen.
  struct Bar {
    float x = 0, low = 0, high = 0;
    bool operator==(const Bar&) const = default;
  };
  std::vector<std::vector<Point>> lines;  ///< each without a gap, at least two points
  std::vector<Bar> bars;
};

/// `columns` one pixel wide, in a lane of `height` pixels. Values hold between samples: a line is
/// level until the next one. Points that lie within a quarter of a pixel of a level or straight
/// line are left out. Values far outside of the lane are cut to it.
PlotShape plotShape(const std::vector<ValueColumn>& columns, const PlotValue& value,
                    const PlotScale& scale, float height);

}  // namespace rocinante
