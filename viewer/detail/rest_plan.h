#pragma once

#include <optional>

#include "core/base/time.h"

namespace rocinante {

/// Plans how a window at rest draws its picture once more with everything, in slices of rows that
/// leave time for input between them. Reads no clock, so that it can be tested on simulated
/// machines.
class RestPlan {
 public:
  /// Nothing changed for this long: at rest.
  static constexpr Nanoseconds kRest{100'000'000};
  /// What a slice should take. Geometry costs the same in each, so there are at most kMaxSlices.
  static constexpr Nanoseconds kSlice{8'000'000};
  static constexpr int kMaxSlices = 12;
  /// A picture with a slice that took longer stays as it is: nobody waits for a dozen of them.
  static constexpr Nanoseconds kLongestSlice{3'000'000'000};

  /// What is shown changed at `now`; the picture has `rows` rows. Starts over.
  void changed(SteadyTime now, int rows);

  /// The rows to draw at `now`, below those drawn; 0: not at rest yet, or the picture is whole.
  int rowsAt(SteadyTime now) const;
  /// These rows were drawn; ends the plan when that took far too long.
  void drawn(int rows, Nanoseconds took);

  int rowsDrawn() const { return drawn_; }
  bool whole() const { return rows_ > 0 && drawn_ >= rows_; }
  /// When rowsAt() is first above 0; empty when nothing is left to draw.
  std::optional<SteadyTime> nextAt() const;

 private:
  SteadyTime at_rest_{};
  int rows_ = 0;
  int drawn_ = 0;
  int next_ = 0;  ///< rows of the next slice
};

}  // namespace rocinante
