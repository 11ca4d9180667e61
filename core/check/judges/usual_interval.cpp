#include "core/check/judges/usual_interval.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace rocinante {

void UsualInterval::take(Nanoseconds interval) {
  if (interval.count() <= 0) return;
  const auto ns = static_cast<std::uint64_t>(interval.count());
  const auto octave = static_cast<unsigned>(std::bit_width(ns)) - 1;
  std::size_t bin = 0;
  if (octave >= kFirstOctave) {
    bin = 4 * std::size_t{octave - kFirstOctave} + ((ns >> (octave - 2)) & 3U);
  }
  time_ns_[std::min(bin, kBins - 1)] += interval.count();
}

double UsualInterval::span_s() const {
  return static_cast<double>(std::accumulate(time_ns_.begin(), time_ns_.end(), std::int64_t{0})) *
         1e-9;
}

double UsualInterval::seconds() const {
  const std::int64_t all = std::accumulate(time_ns_.begin(), time_ns_.end(), std::int64_t{0});
  std::int64_t below = 0;
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    below += time_ns_[bin];
    if (below == 0 || 2 * below < all) continue;
    const double middle = 1.125 + 0.25 * static_cast<double>(bin % 4);
    return std::ldexp(middle, static_cast<int>(kFirstOctave + bin / 4)) * 1e-9;
  }
  return 0;
}

void UsualInterval::fade() {
  for (std::int64_t& each : time_ns_) each /= 2;
}

}  // namespace rocinante
