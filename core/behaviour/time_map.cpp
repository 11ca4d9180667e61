#include "core/behaviour/time_map.h"

#include <algorithm>
#include <cmath>

namespace rocinante {
namespace {

Nanoseconds scaled(Nanoseconds duration, double rate) {
  if (rate == 1) return duration;
  // The difference alone is in double: hours in nanoseconds stay exact.
  return duration + Nanoseconds(std::llround(static_cast<double>(duration.count()) * (rate - 1)));
}

/// `after`: the first knot behind the time.
LogTime mapped(const std::vector<TimeMap::Knot>& knots,
               std::vector<TimeMap::Knot>::const_iterator after, double rate, LogTime time,
               LogTime TimeMap::Knot::*from, LogTime TimeMap::Knot::*to) {
  if (after == knots.begin()) return knots.front().*to + scaled(time - knots.front().*from, rate);
  const TimeMap::Knot& before = *std::prev(after);
  if (after == knots.end()) return before.*to + scaled(time - before.*from, rate);
  const Nanoseconds its = *after.*from - before.*from;
  const double share =
      static_cast<double>((time - before.*from).count()) / static_cast<double>(its.count());
  const Nanoseconds other = *after.*to - before.*to;
  return before.*to + Nanoseconds(std::llround(share * static_cast<double>(other.count())));
}

}  // namespace

LogTime TimeMap::inRun(LogTime accepted_time) const {
  const auto after = std::ranges::upper_bound(knots, accepted_time, {}, &Knot::accepted);
  return mapped(knots, after, rate, accepted_time, &Knot::accepted, &Knot::run);
}

LogTime TimeMap::inAccepted(LogTime run_time) const {
  const auto after = std::ranges::upper_bound(knots, run_time, {}, &Knot::run);
  return mapped(knots, after, 1 / rate, run_time, &Knot::run, &Knot::accepted);
}

LogTime TimeMap::Walk::inAccepted(LogTime run_time) {
  const std::vector<Knot>& all = map_.knots;
  while (after_ < all.size() && all[after_].run <= run_time) ++after_;
  return mapped(all, all.begin() + static_cast<std::ptrdiff_t>(after_), 1 / map_.rate, run_time,
                &Knot::run, &Knot::accepted);
}

double clockRate(const std::vector<TimeMap::Knot>& events) {
  constexpr Nanoseconds kShortest = std::chrono::seconds(10);
  constexpr std::size_t kMaxSampledEvents = 400;
  constexpr double kMaxPpm = 300;
  if (events.size() < 2) return 1;
  const Nanoseconds span = events.back().accepted - events.front().accepted;
  if (span < kShortest) return 1;
  const std::size_t stride = events.size() / kMaxSampledEvents + 1;
  std::vector<double> rates;
  for (std::size_t i = 0; i < events.size(); i += stride) {
    for (std::size_t j = i + stride; j < events.size(); j += stride) {
      const Nanoseconds its = events[j].accepted - events[i].accepted;
      if (its < span / 3) continue;
      rates.push_back(static_cast<double>((events[j].run - events[i].run).count()) /
                      static_cast<double>(its.count()));
    }
  }
  if (rates.empty()) return 1;
  const auto middle = rates.begin() + static_cast<std::ptrdiff_t>(rates.size() / 2);
  std::ranges::nth_element(rates, middle);
  return std::abs(*middle - 1) <= kMaxPpm * 1e-6 ? *middle : 1;
}

}  // namespace rocinante
