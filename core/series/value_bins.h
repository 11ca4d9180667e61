#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/base/time.h"

namespace rocinante {

/// What one value did in one stretch of time. Single precision: for pictures, not for judging.
struct ValueBin {
  float low = std::numeric_limits<float>::infinity();
  float high = -std::numeric_limits<float>::infinity();
  float last = 0;     ///< as the stretch ends; unused without a sample
  bool ends = false;  ///< as the stretch ends there is no value any more

  bool hasSample() const { return low <= high; }
  /// Nothing happened: the value of the bin before holds.
  bool holds() const { return !hasSample() && !ends; }
  /// Adds what happened later in the same stretch.
  void append(const ValueBin& later);
};

/// What a picture has room for: one column of pixels.
struct ValueColumn {
  ValueBin bin;
  /// The value at the right edge of the column, which may be older than the column; empty: none.
  std::optional<float> held;
};

/// The smallest, largest and last value of equal stretches of time, from `start` on: at most as
/// many bins as asked for, whose width doubles whenever a sample lies behind the last one. Values
/// hold between samples. A plain value.
class ValueBins {
 public:
  /// `width`: of a bin at first, at least 1 ns.
  ValueBins(LogTime start, Nanoseconds width, std::size_t max_bins);

  /// Times must not go back; earlier ones count in the last bin.
  void add(LogTime time, double value) {
    const auto sample = static_cast<float>(value);
    ValueBin& bin = binAt(time);
    if (sample < bin.low) bin.low = sample;
    if (sample > bin.high) bin.high = sample;
    bin.last = sample;
    bin.ends = false;
  }
  /// From `time` on there is no value.
  void end(LogTime time) { binAt(time).ends = true; }

  /// Halves the number of bins, now and at most.
  void halve();

  LogTime start() const { return start_; }
  Nanoseconds width() const { return Nanoseconds(width_); }
  std::span<const ValueBin> bins() const { return bins_; }
  std::uint64_t bytes() const { return bins_.capacity() * sizeof(ValueBin); }

  /// What happened in [from, until), in `count` equal columns. A bin belongs to the column in which
  /// it begins.
  std::vector<ValueColumn> columns(LogTime from, LogTime until, std::size_t count) const;

 private:
  ValueBin& binAt(LogTime time);
  void mergePairs();

  LogTime start_;
  std::int64_t width_;
  std::size_t max_bins_;
  std::vector<ValueBin> bins_;
};

/// How often something happened in equal stretches of time; widths double as in ValueBins.
class CountBins {
 public:
  CountBins(LogTime start, Nanoseconds width, std::size_t max_bins);

  void add(LogTime time, std::int64_t count = 1);
  std::int64_t total() const { return total_; }
  LogTime start() const { return start_; }
  Nanoseconds width() const { return Nanoseconds(width_); }
  std::span<const std::int64_t> counts() const { return counts_; }

  /// How many per second around the middle of each of `count` columns of [from, until): over the
  /// column or over `least`, whichever is longer, but not beyond [start, end).
  std::vector<float> rates(LogTime from, LogTime until, std::size_t count, Nanoseconds least,
                           LogTime end) const;

 private:
  LogTime start_;
  std::int64_t width_;
  std::size_t max_bins_;
  std::int64_t total_ = 0;
  std::vector<std::int64_t> counts_;
};

}  // namespace rocinante
