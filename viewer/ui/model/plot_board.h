#pragma once

#include <cstddef>
#include <vector>

#include "core/series/series_key.h"

namespace rocinante {

/// The values that are plotted beside the scene, in the order in which they were chosen. Plain
/// values.
class PlotBoard {
 public:
  static constexpr std::size_t kMaxCurves = 20;
  /// In interface units; the window bounds it further.
  static constexpr float kLeastHeight = 90;

  struct Curve {
    SeriesKey key;
    std::size_t color = 0;  ///< below kMaxCurves, different for each
  };

  const std::vector<Curve>& curves() const { return curves_; }
  bool shown() const { return !hidden && !curves_.empty(); }
  /// Null when it is not plotted.
  const Curve* find(const SeriesKey& key) const;
  /// False when it is full. The board is shown again.
  bool add(SeriesKey key);
  void remove(const SeriesKey& key);
  bool toggle(const SeriesKey& key);
  void clear() { curves_.clear(); }

  bool hidden = false;  ///< the curves are kept
  float height = 200;
  std::vector<SeriesKey> dragged;  ///< by the mouse, to be dropped onto the plots

 private:
  std::vector<Curve> curves_;
};

}  // namespace rocinante
