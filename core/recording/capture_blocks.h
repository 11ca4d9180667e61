#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/net/datagram_source.h"
#include "core/recording/capture_time.h"
#include "core/recording/hand_over.h"

namespace rocinante {

/// Fills blocks with the datagrams of a capture file or another kept stream, by its own times, and
/// hands them over. Drops nothing. One thread.
class CaptureBlocks {
 public:
  /// `out` must outlive it.
  explicit CaptureBlocks(HandOver& out) : out_(out) {}

  /// Takes the next datagram; false when the queue has no room for it: then it is to be given
  /// again.
  bool keep(const ReceivedDatagram& datagram);
  /// At the moment that is reached; `otherwise` before the first datagram.
  void noteLoss(const LossCounts& counts, LogTime otherwise);
  /// Hands over what is there, whether or not the block is full.
  void handOver();
  Account leftOut() const { return time_.leftOut(); }

 private:
  HandOver& out_;
  CaptureTime time_;
  std::optional<LogTime> reached_;  ///< empty before the first datagram
  std::unique_ptr<DatagramBlock> block_;
  std::vector<EndpointLoss> losses_;
  std::vector<ClockStep> steps_;
};

}  // namespace rocinante
