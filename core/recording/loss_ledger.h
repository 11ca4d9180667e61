#pragma once

#include <vector>

#include "core/recording/hand_over.h"

namespace rocinante {

/// The account of what was sent to each endpoint and is not in the log, or not whole. Gathers
/// single losses into spans of about kSpan, so that a flood of losses does not flood the log, and
/// gives them out when the log has reached their time. Pure.
class LossLedger {
 public:
  static constexpr Nanoseconds kSpan = std::chrono::milliseconds(100);

  explicit LossLedger(std::size_t endpoint_count) : totals_(endpoint_count) {}

  void add(const EndpointLoss& loss);

  /// The spans to write, now that the log has reached `time`; each is given once.
  std::vector<EndpointLoss> due(LogTime time);
  /// All that are over by `time`, of whatever span, and were not given yet.
  std::vector<EndpointLoss> upTo(LogTime time);
  /// All that were not given yet.
  std::vector<EndpointLoss> rest();

  /// By endpoint, everything added.
  const std::vector<LossCounts>& totals() const { return totals_; }

 private:
  std::vector<LossCounts> totals_;
  std::vector<EndpointLoss> gathering_;  ///< at most one an endpoint
  LogTime gathered_since_{};
  std::vector<EndpointLoss> ripe_;
};

}  // namespace rocinante
