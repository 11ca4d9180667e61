#include "core/behaviour/column_finding.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/behaviour/motion_judge.h"

namespace rocinante {
namespace {

constexpr std::int64_t kCurvePoints = 400;

double roundedFigure(double value) { return std::round(value * 1e4) / 1e4; }

/// A signal may be of any size: six digits.
double roundedNumber(double value) {
  if (!std::isfinite(value) || value == 0) return value;
  const double digit = std::pow(10, std::floor(std::log10(std::abs(value))) - 5);
  return digit > 0 ? std::round(value / digit) * digit : value;
}

double scaleOf(const TrackColumn& column) {
  if (column.kind == TrackColumn::Kind::number) return 1;
  return column.kind == TrackColumn::Kind::length ? kMillimetres : kDegrees;
}

/// The entry of `limits` with which the run were the same, in two digits.
std::string acceptingLimit(const std::string& item, const ColumnMeasure& measure) {
  const double needed = std::max(measure.largest, measure.missing);
  const double digit = std::pow(10, std::floor(std::log10(needed)) - 1);
  const double limit = std::ceil(needed * 1.02 / digit) * digit;
  if (!std::isfinite(limit) || limit < needed) return {};
  return fmt::format("\"{}\" = {{ {} = {:.4g} }}", item, measure.key, limit);
}

/// Of a value that is stated when it changes, one packet is beyond its limit, and what it states
/// holds. `last` for one that does not.
std::size_t endOfHeld(const std::vector<double>& run, const std::vector<double>& accepted,
                      std::size_t first, std::size_t last, double limit, std::int64_t step) {
  constexpr std::int64_t kHeld = 100'000'000;
  std::size_t held = last;
  while (held + 1 < run.size() && std::abs(run[held + 1] - accepted[held + 1]) > limit) ++held;
  return static_cast<std::int64_t>(held - first) * step < kHeld ? last : held;
}

/// In words, from values at equal times.
std::string howColumnsDiffer(const JudgedColumn& judged, const ColumnMeasure& measure) {
  constexpr std::int64_t kMargin = 2'100'000'000;  // as much beside what is late by a second
  constexpr std::int64_t kMostMoments = 4'000;
  constexpr std::int64_t kFinest = 1'000'000;
  const std::int64_t from = std::max<std::int64_t>(0, *measure.first - kMargin);
  const std::int64_t until = std::min(judged.times.end(), measure.last + kMargin);
  const std::int64_t step = std::max(kFinest, (until - from) / kMostMoments);
  std::vector<double> run, accepted;
  for (std::int64_t time = from; time <= until; time += step) {
    for (auto [samples, values] :
         {std::pair(&judged.run, &run), std::pair(&judged.accepted.front(), &accepted)}) {
      double value = std::numeric_limits<double>::quiet_NaN();
      static_cast<void>(samples->valueAt(time, &value));
      values->push_back(value);
    }
  }
  if (run.size() < 2) return {};
  const auto placeOf = [&](std::int64_t time) {
    return std::min(static_cast<std::size_t>(std::max<std::int64_t>(0, time - from) / step),
                    run.size() - 1);
  };
  const std::size_t first = placeOf(*measure.first);
  const double scale = scaleOf(judged.column);
  std::size_t last = placeOf(measure.last);
  if (last < first + 2) last = endOfHeld(run, accepted, first, last, measure.limit / scale, step);
  return howItDiffers({run, accepted, first, last, static_cast<double>(step) * 1e-9, scale,
                       measure.limit, measure.unit});
}

std::string sentenceOf(const JudgedColumn& judged, const ColumnMeasure& measure) {
  std::string text = fmt::format("{}: {} beyond what was accepted, since {}", judged.item,
                                 figureText(measure.largest, measure.unit),
                                 judged.times.bothTimes(*measure.first));
  if (Nanoseconds(measure.at - *measure.first) >= std::chrono::milliseconds(1)) {
    text += fmt::format("; largest at {}", judged.times.bothTimes(measure.at));
  }
  if (judged.column.width() != 1) return text;
  const std::string how = howColumnsDiffer(judged, measure);
  return how.empty() ? text : text + "; " + how;
}

}  // namespace

RunCurve runCurve(const RunTimes& times, const std::vector<ColumnSamples>& accepted,
                  const ColumnSamples& run, const TrackColumn& column, std::int64_t reach,
                  double limit) {
  const double scale = scaleOf(column);
  const auto rounded = column.kind == TrackColumn::Kind::number ? roundedNumber : roundedFigure;
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
    curve.least.push_back(rounded(base * scale + least));
    curve.most.push_back(rounded(base * scale + most));
    curve.value.push_back(rounded(base * scale + value));
  }
  return curve;
}

RunFinding findingAt(const JudgedColumn& judged, std::int64_t time) {
  RunFinding finding;
  finding.kind = judged.column.kind == TrackColumn::Kind::number ? RunFinding::Kind::signal
                 : judged.column.width() == 7                    ? RunFinding::Kind::pose
                                                                 : RunFinding::Kind::joint;
  finding.item = judged.item;
  finding.first_accepted = finding.at_accepted = finding.until_accepted =
      judged.times.sinceOrigin(time);
  finding.first_run = finding.at_run = judged.times.sinceRunOrigin(time);
  return finding;
}

RunFinding findingOf(const JudgedColumn& judged, const ColumnMeasure& measure, std::int64_t reach) {
  RunFinding finding = findingAt(judged, *measure.first);
  finding.unit = measure.unit;
  finding.limit = measure.limit;
  finding.largest = measure.largest;
  finding.at_accepted = judged.times.sinceOrigin(measure.at);
  finding.at_run = judged.times.sinceRunOrigin(measure.at);
  finding.until_accepted = judged.times.sinceOrigin(measure.last);
  finding.what = sentenceOf(judged, measure);
  finding.accept = acceptingLimit(judged.item, measure);
  if (judged.column.width() == 1) {
    finding.curve =
        runCurve(judged.times, judged.accepted, judged.run, judged.column, reach, measure.limit);
  }
  return finding;
}

}  // namespace rocinante
