#pragma once

#include <cstdint>
#include <vector>

#include "core/base/time.h"

namespace rocinante {

/// How often something happened, by time: at most 64 bins of one width, which doubles whenever the
/// session outgrows them. Allocates at the first hit only.
class TimeHistogram {
 public:
  static constexpr std::size_t kMaxBins = 64;

  /// `time` should not be before the first hit; earlier ones count in the first bin.
  void hit(LogTime time, std::uint32_t times = 1);

  /// Adds the counts of another, each bin at its start.
  void merge(const TimeHistogram& other);

  /// How often in [start + i * width, start + (i + 1) * width). The last bin is not zero; empty
  /// when nothing happened.
  const std::vector<std::uint32_t>& counts() const { return counts_; }
  LogTime start() const { return start_; }
  Nanoseconds width() const { return width_; }

 private:
  void halve();

  LogTime start_{};
  // 1 ms and a bit: a power of two, so that two histograms of one start have bins that nest.
  Nanoseconds width_{std::int64_t{1} << 20};
  std::vector<std::uint32_t> counts_;
};

}  // namespace rocinante
