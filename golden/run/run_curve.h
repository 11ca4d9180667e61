#pragma once

#include <vector>

#include "golden/run/run_judgement.h"

namespace rocinante {

struct RunGrids;

/// Keeps the band and the run's value, relative to the first accepted one, while a column is
/// judged.
class CurveKeeper {
 public:
  void add(std::size_t sample, double least, double most, double value) {
    samples_.push_back(sample);
    least_.push_back(least);
    most_.push_back(most);
    value_.push_back(value);
  }
  /// At most a few hundred points: of each stretch the widest band, and the value that is farthest
  /// outside. `reference`: the accepted values, in radians or metres; `scale` makes them the unit.
  RunCurve reduced(const RunGrids& grids, double scale, const std::vector<double>& reference,
                   double limit) const;

 private:
  std::vector<std::size_t> samples_;
  std::vector<double> least_, most_, value_;
};

}  // namespace rocinante
