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
  using Value = float;
  using Stated = double;
  float low = std::numeric_limits<float>::infinity();
  float high = -std::numeric_limits<float>::infinity();
  float last = 0;     ///< as the stretch ends; unused without a sample
  bool ends = false;  ///< as the stretch ends there is no value any more

  bool hasSample() const { return low <= high; }
  /// Nothing happened: the value of the bin before holds.
  bool holds() const { return !hasSample() && !ends; }
  void take(Stated value) {
    const auto sample = static_cast<Value>(value);
    if (sample < low) low = sample;
    if (sample > high) high = sample;
    last = sample;
    ends = false;
  }
  /// Adds what happened later in the same stretch.
  void append(const ValueBin& later);
};

/// Which states a value had in one stretch of time, by their numbers: none is lost.
struct StateBin {
  using Value = std::uint8_t;
  using Stated = Value;
  static constexpr std::size_t kStates = 64;
  std::uint64_t seen = 0;  ///< a bit for each
  Value last = 0;          ///< as the stretch ends; unused without a sample
  bool ends = false;       ///< as in ValueBin

  bool hasSample() const { return seen != 0; }
  bool holds() const { return !hasSample() && !ends; }
  /// Below kStates.
  void take(Stated state) {
    seen |= std::uint64_t{1} << state;
    last = state;
    ends = false;
  }
  void append(const StateBin& later);
};

/// What a picture has room for: one column of pixels.
template <class Bin>
struct BinColumn {
  Bin bin;
  /// The value at the right edge of the column, which may be older than the column; empty: none.
  std::optional<typename Bin::Value> held;
};
using ValueColumn = BinColumn<ValueBin>;
using StateColumn = BinColumn<StateBin>;

/// What a value did in equal stretches of time, from `start` on: at most as many bins as asked for,
/// whose width doubles whenever a sample lies behind the last one. Values hold between samples. A
/// plain value.
template <class Bin>
class TimeBins {
 public:
  using Column = BinColumn<Bin>;
  /// `width`: of a bin at first, at least 1 ns.
  TimeBins(LogTime start, Nanoseconds width, std::size_t max_bins);

  /// Times must not go back; earlier ones count in the last bin.
  void add(LogTime time, typename Bin::Stated value) { binAt(time).take(value); }
  /// From `time` on there is no value.
  void end(LogTime time) { binAt(time).ends = true; }

  /// Halves the number of bins, now and at most.
  void halve();

  LogTime start() const { return start_; }
  Nanoseconds width() const { return Nanoseconds(width_); }
  std::span<const Bin> bins() const { return bins_; }
  std::uint64_t bytes() const { return bins_.capacity() * sizeof(Bin); }

  /// What happened in [from, until), in `count` equal columns. A bin belongs to the column in which
  /// it begins.
  std::vector<Column> columns(LogTime from, LogTime until, std::size_t count) const;

 private:
  Bin& binAt(LogTime time);
  void mergePairs();

  LogTime start_;
  std::int64_t width_;
  std::size_t max_bins_;
  std::vector<Bin> bins_;
};

/// Lowest, highest and last of a number.
using ValueBins = TimeBins<ValueBin>;
/// The states of a boolean or a text.
using StateBins = TimeBins<StateBin>;

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
