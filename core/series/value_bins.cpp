#include "core/series/value_bins.h"

#include <algorithm>
#include <cassert>

namespace rocinante {
namespace {

/// Nanoseconds from `start` to `time`, not below 0. Of times before 1970 too, whose difference may
/// not fit.
std::int64_t since(LogTime start, LogTime time) {
  if (time <= start) return 0;
  const auto span = static_cast<std::uint64_t>(time.time_since_epoch().count()) -
                    static_cast<std::uint64_t>(start.time_since_epoch().count());
  constexpr auto kMax = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  return static_cast<std::int64_t>(std::min(span, kMax));
}

/// The width that one doubling gives; as wide as times can be in the end.
std::int64_t doubled(std::int64_t width) {
  return width > std::numeric_limits<std::int64_t>::max() / 2
             ? std::numeric_limits<std::int64_t>::max()
             : 2 * width;
}

}  // namespace

void ValueBin::append(const ValueBin& later) {
  if (later.hasSample()) {
    low = std::min(low, later.low);
    high = std::max(high, later.high);
    last = later.last;
  }
  if (!later.holds()) ends = later.ends;
}

void StateBin::append(const StateBin& later) {
  seen |= later.seen;
  if (later.hasSample()) last = later.last;
  if (!later.holds()) ends = later.ends;
}

template <class Bin>
TimeBins<Bin>::TimeBins(LogTime start, Nanoseconds width, std::size_t max_bins)
    : start_(start), width_(width.count()), max_bins_(max_bins) {
  assert(width_ >= 1 && max_bins_ >= 2);
}

template <class Bin>
Bin& TimeBins<Bin>::binAt(LogTime time) {
  const std::int64_t at = since(start_, time);
  auto index = static_cast<std::size_t>(at / width_);
  while (index >= max_bins_) {
    mergePairs();
    index = static_cast<std::size_t>(at / width_);
  }
  if (index + 1 < bins_.size()) index = bins_.size() - 1;
  if (index >= bins_.size()) bins_.resize(index + 1);
  return bins_[index];
}

template <class Bin>
void TimeBins<Bin>::mergePairs() {
  for (std::size_t pair = 0; 2 * pair < bins_.size(); ++pair) {
    Bin merged = bins_[2 * pair];
    if (2 * pair + 1 < bins_.size()) merged.append(bins_[2 * pair + 1]);
    bins_[pair] = merged;
  }
  bins_.resize((bins_.size() + 1) / 2);
  width_ = doubled(width_);
}

template <class Bin>
void TimeBins<Bin>::halve() {
  if (max_bins_ < 4) return;
  max_bins_ /= 2;
  mergePairs();
  bins_.shrink_to_fit();
}

template <class Bin>
std::vector<BinColumn<Bin>> TimeBins<Bin>::columns(LogTime from, LogTime until,
                                                   std::size_t count) const {
  std::vector<Column> columns(count);
  if (count == 0 || until <= from) return columns;
  // In double: columns are pixels, and a bin that lies on an edge may fall on either side.
  const double per_bin = static_cast<double>(width_);
  const double offset = from >= start_ ? -static_cast<double>(since(start_, from))
                                       : static_cast<double>(since(from, start_));
  const double column = static_cast<double>(since(from, until)) / static_cast<double>(count);
  std::optional<typename Bin::Value> held;
  std::size_t next = 0;  // of the columns whose held value is not known yet
  for (std::size_t i = 0; i < bins_.size(); ++i) {
    if (bins_[i].holds()) continue;
    const double begins = offset + static_cast<double>(i) * per_bin;
    if (begins >= 0) {
      const double at = begins / column;
      if (at >= static_cast<double>(count)) break;
      const auto place = static_cast<std::size_t>(at);
      for (; next < place; ++next) columns[next].held = held;
      columns[place].bin.append(bins_[i]);
    }
    held.reset();
    if (!bins_[i].ends) held = bins_[i].last;
  }
  for (; next < count; ++next) columns[next].held = held;
  return columns;
}

template class TimeBins<ValueBin>;
template class TimeBins<StateBin>;

CountBins::CountBins(LogTime start, Nanoseconds width, std::size_t max_bins)
    : start_(start), width_(width.count()), max_bins_(max_bins) {
  assert(width_ >= 1 && max_bins_ >= 2);
}

void CountBins::add(LogTime time, std::int64_t count) {
  const std::int64_t at = since(start_, time);
  while (static_cast<std::uint64_t>(at / width_) >= max_bins_) {
    for (std::size_t pair = 0; 2 * pair < counts_.size(); ++pair) {
      const bool whole = 2 * pair + 1 < counts_.size();
      counts_[pair] = counts_[2 * pair] + (whole ? counts_[2 * pair + 1] : 0);
    }
    counts_.resize((counts_.size() + 1) / 2);
    width_ = doubled(width_);
  }
  const auto index = static_cast<std::size_t>(at / width_);
  if (index >= counts_.size()) counts_.resize(index + 1);
  counts_[index] += count;
  total_ += count;
}

std::vector<float> CountBins::rates(LogTime from, LogTime until, std::size_t count,
                                    Nanoseconds least, LogTime end) const {
  std::vector<float> rates(count, 0.0F);
  if (count == 0 || until <= from || counts_.empty()) return rates;
  // How many came before each bin; within a bin they are taken as evenly spread.
  std::vector<double> before(counts_.size() + 1, 0.0);
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    before[i + 1] = before[i] + static_cast<double>(counts_[i]);
  }
  const double per_bin = static_cast<double>(width_);
  const auto came_until = [&](double at) {
    const double bin = std::clamp(at / per_bin, 0.0, static_cast<double>(counts_.size()));
    const auto whole = std::min(static_cast<std::size_t>(bin), counts_.size() - 1);
    return before[whole] + (before[whole + 1] - before[whole]) * (bin - static_cast<double>(whole));
  };
  const double first = from >= start_ ? static_cast<double>(since(start_, from))
                                      : -static_cast<double>(since(from, start_));
  const double column = static_cast<double>(since(from, until)) / static_cast<double>(count);
  const double half = std::max({column, static_cast<double>(least.count()), per_bin}) / 2;
  const double whole = static_cast<double>(since(start_, end));
  for (std::size_t i = 0; i < count; ++i) {
    const double middle = first + (static_cast<double>(i) + 0.5) * column;
    const double begin = std::max(0.0, middle - half);
    const double stop = std::min(whole, middle + half);
    if (stop <= begin) continue;
    rates[i] = static_cast<float>((came_until(stop) - came_until(begin)) / (stop - begin) * 1e9);
  }
  return rates;
}

}  // namespace rocinante
