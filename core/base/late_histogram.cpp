#include "core/base/late_histogram.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace rocinante {
namespace {

/// The upper end of the bin of `us`: 32 bins per doubling.
std::uint64_t coarseBin(std::uint64_t us) {
  const int shift = static_cast<int>(std::bit_width(us)) - 6;
  return ((us >> shift) + 1) << shift;
}

Nanoseconds median(std::vector<Nanoseconds> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

LateHistogram::LateHistogram() : pages_(kPages) { pages_[0] = std::make_unique<Page>(); }

void LateHistogram::add(Nanoseconds late) {
  const std::int64_t ns = std::max<std::int64_t>(late.count(), 0);
  const std::uint64_t us = static_cast<std::uint64_t>(ns) / 1000 + (ns % 1000 != 0 ? 1 : 0);
  ++count_;
  max_us_ = std::max(max_us_, us);
  const std::uint64_t page = us / kPageBins;
  if (page >= kPages) {
    ++beyond_[coarseBin(us)];
    return;
  }
  if (!pages_[page]) pages_[page] = std::make_unique<Page>();
  ++(*pages_[page])[us % kPageBins];
}

std::uint64_t LateHistogram::percentile(double share) const {
  if (count_ == 0) return 0;
  const auto wanted = static_cast<std::uint64_t>(
      std::clamp(std::ceil(share * static_cast<double>(count_)), 1.0, static_cast<double>(count_)));
  std::uint64_t seen = 0;
  for (std::size_t page = 0; page < kPages; ++page) {
    if (!pages_[page]) continue;
    for (std::size_t bin = 0; bin < kPageBins; ++bin) {
      seen += (*pages_[page])[bin];
      if (seen >= wanted) return page * kPageBins + bin;
    }
  }
  for (const auto& [upper_us, count] : beyond_) {
    seen += count;
    if (seen >= wanted) return std::min(upper_us, max_us_);
  }
  return max_us_;
}

std::vector<LateHistogram::Bin> LateHistogram::bins() const {
  std::vector<Bin> bins;
  std::uint64_t up_to_us = 1;
  const auto count = [&](std::uint64_t us, std::uint64_t how_many) {
    if (how_many == 0) return;
    // 1, 2, 5, 10: a bound that begins with a 2 is followed by 2.5 times itself.
    while (up_to_us < us) {
      std::uint64_t first = up_to_us;
      while (first >= 10) first /= 10;
      up_to_us = first == 2 ? up_to_us / 2 * 5 : up_to_us * 2;
    }
    if (bins.empty() || bins.back().up_to_us < up_to_us) bins.push_back({up_to_us, 0});
    bins.back().count += how_many;
  };
  for (std::size_t page = 0; page < kPages; ++page) {
    if (!pages_[page]) continue;
    for (std::size_t bin = 0; bin < kPageBins; ++bin) {
      count(page * kPageBins + bin, (*pages_[page])[bin]);
    }
  }
  for (const auto& [upper_us, how_many] : beyond_) count(upper_us, how_many);
  return bins;
}

void DriftMeter::add(Nanoseconds error) {
  if (first_.size() < kWindow) first_.push_back(error);
  if (last_.size() < kWindow) {
    last_.push_back(error);
    return;
  }
  last_[next_] = error;
  next_ = (next_ + 1) % kWindow;
}

Nanoseconds DriftMeter::drift() const {
  return first_.empty() ? Nanoseconds(0) : median(last_) - median(first_);
}

}  // namespace rocinante
