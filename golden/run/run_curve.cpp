#include "golden/run/run_curve.h"

#include <algorithm>
#include <cmath>

#include "golden/run/motion_judge.h"

namespace rocinante {
namespace {

constexpr std::size_t kCurvePoints = 400;

double roundedFigure(double value) { return std::round(value * 1e4) / 1e4; }

}  // namespace

RunCurve CurveKeeper::reduced(const RunGrids& grids, double scale,
                              const std::vector<double>& reference, double limit) const {
  RunCurve curve;
  const std::size_t stretch = samples_.size() / kCurvePoints + 1;
  for (std::size_t begin = 0; begin < samples_.size(); begin += stretch) {
    const std::size_t end = std::min(begin + stretch, samples_.size());
    double least = INFINITY, most = -INFINITY, value = 0, farthest = -INFINITY;
    for (std::size_t i = begin; i < end; ++i) {
      const double base = reference[reference.size() == 1 ? 0 : samples_[i]] * scale;
      least = std::min(least, base + least_[i]);
      most = std::max(most, base + most_[i]);
      const double outside = std::max(value_[i] - most_[i], least_[i] - value_[i]);
      if (outside <= farthest) continue;
      farthest = outside;
      value = base + value_[i];
    }
    curve.seconds.push_back(roundedFigure(secondsOf(grids.sinceOrigin(samples_[begin]))));
    curve.least.push_back(roundedFigure(least - limit));
    curve.most.push_back(roundedFigure(most + limit));
    curve.value.push_back(roundedFigure(value));
  }
  return curve;
}

}  // namespace rocinante
