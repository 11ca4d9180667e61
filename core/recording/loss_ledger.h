#pragma once

#include <vector>

#include "core/recording/hand_over.h"

namespace rocinante {

/// The account of datagrams that were sent to each endpoint and are missing from the log, or not
/// whole there. Merges single losses into spans of about kSpan, so that a flood of losses does not
/// flood the log, and returns them when the log has reached their time. Pure.
class LossLedger {
 public:
  static constexpr Nanoseconds kSpan = std::chrono::milliseconds(100);

  explicit LossLedger(std::size_t endpoint_count) : totals_(endpoint_count) {}

  void add(const EndpointLoss& loss);

  /// The spans to write now that the log has reached `time`; each is returned once.
  std::vector<EndpointLoss> due(LogTime time);
  /// All that ended by `time`, however short, and were not returned yet.
  std::vector<EndpointLoss> upTo(LogTime time);
  /// All that were not returned yet.
  std::vector<EndpointLoss> rest();

  /// The sum of everything added, by endpoint.
  const std::vector<LossCounts>& totals() const { return totals_; }

 private:
  std::vector<LossCounts> totals_;
  std::vector<EndpointLoss> gathering_;  ///< at most one an endpoint
  LogTime gathered_since_{};
  std::vector<EndpointLoss> ripe_;
};

}  // namespace rocinante
