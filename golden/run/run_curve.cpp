#include "golden/run/run_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "golden/run/motion_judge.h"

namespace rocinante {
namespace {

constexpr std::int64_t kCurvePoints = 400;

double roundedFigure(double value) { return std::round(value * 1e4) / 1e4; }

}  // namespace

RunCurve runCurve(const RunTimes& times, const std::vector<ColumnSamples>& accepted,
                  const ColumnSamples& run, double scale, std::int64_t reach, double limit) {
  RunCurve curve;
  const std::int64_t stretch = times.end() / kCurvePoints + 1;
  for (std::int64_t from = 0; from < times.end(); from += stretch) {
    const std::int64_t until = std::min(from + stretch, times.end());
    double base = 0;
    if (!accepted.front().valueAt(from, &base)) continue;
    ApartRange band;
    for (const ColumnSamples& its : accepted) {
      const ApartRange found = its.range(from - reach, until + reach, &base);
      if (!found.any) continue;
      band.add(found.least);
      band.add(found.most);
    }
    const ApartRange own = run.range(from, until, &base);
    const double least = band.least[0] - limit;
    const double most = band.most[0] + limit;
    double value = std::numeric_limits<double>::quiet_NaN();
    if (own.any) value = own.most[0] - most > least - own.least[0] ? own.most[0] : own.least[0];
    curve.seconds.push_back(roundedFigure(secondsOf(times.sinceOrigin(from))));
    curve.least.push_back(roundedFigure(base * scale + least));
    curve.most.push_back(roundedFigure(base * scale + most));
    curve.value.push_back(roundedFigure(base * scale + value));
  }
  return curve;
}

}  // namespace rocinante
