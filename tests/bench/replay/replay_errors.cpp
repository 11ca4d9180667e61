#include "tests/bench/replay/replay_errors.h"

#include <algorithm>
#include <cmath>

namespace rocinante::bench {
namespace {

constexpr std::size_t kWindow = 100;

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double percentileOf(const std::vector<double>& sorted, double share) {
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
  return sorted[std::min(sorted.size() - 1, rank == 0 ? 0 : rank - 1)];
}

}  // namespace

ReplayErrors replayErrors(const std::vector<Nanoseconds>& due,
                          const std::vector<std::int64_t>& arrived_ns, const PlaybackSpeed& speed) {
  std::vector<std::int64_t> lag_ns;
  for (std::size_t i = 0; i < due.size(); ++i) {
    if (arrived_ns[i] != 0) lag_ns.push_back(arrived_ns[i] - speed.realDuration(due[i]).count());
  }
  ReplayErrors errors;
  errors.arrived = lag_ns.size();
  if (lag_ns.empty()) return errors;
  const std::size_t window = std::min(kWindow, lag_ns.size());
  const auto first_end = lag_ns.begin() + static_cast<std::ptrdiff_t>(window);
  const std::int64_t line = *std::min_element(lag_ns.begin(), first_end);
  std::vector<double> signed_us;
  std::vector<double> amount_us;
  for (const std::int64_t lag : lag_ns) {
    signed_us.push_back(static_cast<double>(lag - line) / 1e3);
    amount_us.push_back(std::abs(signed_us.back()));
  }
  const auto end = static_cast<std::ptrdiff_t>(window);
  errors.drift_us = medianOf({signed_us.end() - end, signed_us.end()}) -
                    medianOf({signed_us.begin(), signed_us.begin() + end});
  std::sort(amount_us.begin(), amount_us.end());
  errors.p50_us = percentileOf(amount_us, 0.5);
  errors.p99_us = percentileOf(amount_us, 0.99);
  errors.max_us = amount_us.back();
  return errors;
}

}  // namespace rocinante::bench
