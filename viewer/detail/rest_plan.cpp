#include "viewer/detail/rest_plan.h"

#include <algorithm>

namespace rocinante {

void RestPlan::changed(SteadyTime now, int rows) {
  at_rest_ = now + kRest;
  rows_ = std::max(rows, 0);
  drawn_ = 0;
  next_ = rows_ / kMaxSlices + 1;
}

int RestPlan::rowsAt(SteadyTime now) const {
  return rows_ == 0 || whole() || now < at_rest_ ? 0 : std::min(next_, rows_ - drawn_);
}

void RestPlan::drawn(int rows, Nanoseconds took) {
  drawn_ = std::min(rows_, drawn_ + rows);
  if (took > kLongestSlice && !whole()) {
    rows_ = 0;
    return;
  }
  const double fits = static_cast<double>(rows) * secondsOf(kSlice) /
                      std::max(secondsOf(took), secondsOf(kSlice) / 100);
  // A slice that was interrupted says little about the next: at most twice as much.
  const double bounded = std::min(fits, 2.0 * rows);
  next_ = std::max(static_cast<int>(bounded), rows_ / kMaxSlices + 1);
}

std::optional<SteadyTime> RestPlan::nextAt() const {
  if (rows_ == 0 || whole()) return std::nullopt;
  return at_rest_;
}

}  // namespace rocinante
