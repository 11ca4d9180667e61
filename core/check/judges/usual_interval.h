#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/base/time.h"

namespace rocinante {

/// The usual interval of a stream: the median by time, so that half of the time lies in intervals
/// that are no longer. Packets that come in bursts thus have the interval of their bursts. To a
/// fifth; constant memory.
class UsualInterval {
 public:
  void take(Nanoseconds interval);
  /// Of all intervals together.
  double span_s() const;
  /// 0 before the first interval.
  double seconds() const;
  /// Older intervals count half from now on.
  void fade();
  void clear() { *this = {}; }

 private:
  // Four bins an octave, from a sixteenth of a millisecond to a minute.
  static constexpr std::size_t kBins = 80;
  static constexpr unsigned kFirstOctave = 16;

  std::array<std::int64_t, kBins> time_ns_{};
};

}  // namespace rocinante
