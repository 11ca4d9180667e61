#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/series/series_key.h"

namespace rocinante {

/// The values that are plotted beside the scene, over time or one over another, in the order in
/// which they were chosen. Plain values.
class PlotBoard {
 public:
  static constexpr std::size_t kMaxCurves = 20;
  static constexpr std::size_t kMaxPaths = 6;
  /// In interface units; the window bounds it further.
  static constexpr float kLeastHeight = 90;
  static constexpr float kPathHeight = 320;

  struct Curve {
    SeriesKey key;
    std::size_t color = 0;  ///< below kMaxCurves + kMaxPaths, different for each
  };
  /// One value over another.
  struct Path {
    SeriesKey y, x;
    std::size_t color = 0;  ///< as of curves
    /// `VALUE over VALUE`, as parsePath() reads it.
    std::string text() const { return y.text() + " over " + x.text(); }
  };

  const std::vector<Curve>& curves() const { return curves_; }
  const std::vector<Path>& paths() const { return paths_; }
  bool shown() const { return !hidden && !(curves_.empty() && paths_.empty()); }
  /// Null when it is not plotted.
  const Curve* find(const SeriesKey& key) const;
  /// False when it is full. The board is shown again.
  bool add(SeriesKey key);
  void remove(const SeriesKey& key);
  bool toggle(const SeriesKey& key);
  /// False when there is no room for another. The board is shown again, high enough for it.
  bool addPath(SeriesKey y, SeriesKey x);
  /// False when it was not there.
  bool removePath(const SeriesKey& y, const SeriesKey& x);
  void clear();

  bool hidden = false;  ///< the curves are kept
  float height = 200;
  std::vector<SeriesKey> dragged;  ///< by the mouse, to be dropped onto the plots

 private:
  std::size_t freeColor() const;

  std::vector<Curve> curves_;
  std::vector<Path> paths_;
};

}  // namespace rocinante
