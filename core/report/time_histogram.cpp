#include "core/report/time_histogram.h"

#include <algorithm>
#include <limits>

namespace rocinante {
namespace {

std::uint32_t sum(std::uint32_t a, std::uint32_t b) {
  return a > std::numeric_limits<std::uint32_t>::max() - b
             ? std::numeric_limits<std::uint32_t>::max()
             : a + b;
}

}  // namespace

void TimeHistogram::hit(LogTime time, std::uint32_t times) {
  if (counts_.empty()) {
    counts_.reserve(kMaxBins);
    start_ = time;
  }
  // Unsigned: the two may be farther apart than a signed duration reaches.
  const std::uint64_t since =
      time > start_ ? static_cast<std::uint64_t>(time.time_since_epoch().count()) -
                          static_cast<std::uint64_t>(start_.time_since_epoch().count())
                    : 0;
  while (since / static_cast<std::uint64_t>(width_.count()) >= kMaxBins) halve();
  const std::size_t bin = since / static_cast<std::uint64_t>(width_.count());
  if (bin >= counts_.size()) counts_.resize(bin + 1);
  counts_[bin] = sum(counts_[bin], times);
}

void TimeHistogram::merge(const TimeHistogram& other) {
  for (std::size_t i = 0; i < other.counts_.size(); ++i) {
    if (other.counts_[i] == 0) continue;
    hit(other.start_ + static_cast<std::int64_t>(i) * other.width_, other.counts_[i]);
  }
}

void TimeHistogram::halve() {
  width_ *= 2;
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    const std::uint32_t count = counts_[i];
    counts_[i] = 0;
    counts_[i / 2] = sum(counts_[i / 2], count);
  }
  counts_.resize((counts_.size() + 1) / 2);
}

}  // namespace rocinante
