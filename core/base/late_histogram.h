#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "core/base/time.h"

namespace rocinante {

/// Lateness counts: by whole microsecond up to four seconds, then within 1/32. Memory is bounded
/// for any input: 32 KiB when everything falls within 4 ms, 34 MB at worst.
class LateHistogram {
 public:
  LateHistogram();

  /// Early counts as not late.
  void add(Nanoseconds late);

  std::uint64_t count() const { return count_; }
  /// The smallest lateness, in microseconds rounded up, that `share` (0..1) of all values did not
  /// exceed. 0 when empty.
  std::uint64_t percentile(double share) const;
  struct Bin {
    std::uint64_t up_to_us;  ///< 1, 2, 5, 10 ...; above the previous bin's
    std::uint64_t count;
  };
  /// The non-empty bins, the smallest lateness first.
  std::vector<Bin> bins() const;
  /// Exact, rounded up to a microsecond.
  std::uint64_t max() const { return max_us_; }

 private:
  static constexpr std::size_t kPageBins = 4096;
  static constexpr std::size_t kPages = 1024;
  using Page = std::array<std::uint64_t, kPageBins>;

  std::vector<std::unique_ptr<Page>> pages_;
  std::map<std::uint64_t, std::uint64_t> beyond_;  ///< by the upper end of the bin, microseconds
  std::uint64_t count_ = 0;
  std::uint64_t max_us_ = 0;
};

/// How the error changed from beginning to end: the median of the last 100 values minus the median
/// of the first 100 (of all, when there are fewer). A schedule that is kept does not drift.
class DriftMeter {
 public:
  void add(Nanoseconds error);
  Nanoseconds drift() const;

 private:
  static constexpr std::size_t kWindow = 100;
  std::vector<Nanoseconds> first_;
  std::vector<Nanoseconds> last_;  ///< a ring once it is full
  std::size_t next_ = 0;
};

}  // namespace rocinante
