#pragma once

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "core/log/log_types.h"
#include "core/recording/datagram_block.h"
#include "core/recording/session_clock.h"

namespace rocinante {

/// Datagrams of one endpoint that were sent and not kept, or not whole.
struct EndpointLoss {
  std::uint32_t endpoint = 0;
  LogTime from, until;
  LossCounts counts;
};

/// Adds `loss` to the entry of its endpoint in `losses`, widening the span, or appends it: the list
/// has at most one entry per endpoint.
void addLoss(std::vector<EndpointLoss>& losses, const EndpointLoss& loss);

/// Everything that the writing thread takes in one call.
struct TakenOver {
  std::vector<std::unique_ptr<DatagramBlock>> blocks;  ///< in order of receiving
  std::vector<EndpointLoss> losses;
  std::vector<ClockStep> steps;
  LogTime drained_until;  ///< everything that arrived before this is in a block taken so far
  bool finished = false;  ///< nothing will follow
};

/// The bounded queue between the receiving and the writing thread. Its memory is `max_blocks`
/// blocks, allocated when first needed; when all are in use the receiver must count the datagrams
/// it drops.
class HandOver {
 public:
  explicit HandOver(std::size_t max_blocks) : max_blocks_(max_blocks) {}

  /// For the receiving thread: an empty block, or null when all are in use.
  std::unique_ptr<DatagramBlock> freeBlock();
  /// `block` may be null: then only the rest is handed over. Clears `losses` and `steps`.
  void give(std::unique_ptr<DatagramBlock> block, std::vector<EndpointLoss>& losses,
            std::vector<ClockStep>& steps, std::optional<LogTime> drained_until);
  void finish();
  /// The share of blocks in use, 0 to 1: near 1 the receiver is about to drop.
  double fill();

  /// For the writing thread: takes everything handed over; waits at most this long for a block.
  TakenOver take(Nanoseconds at_most);
  void giveBack(std::unique_ptr<DatagramBlock> block);

 private:
  std::mutex mutex_;
  std::condition_variable given_;
  const std::size_t max_blocks_;
  std::size_t made_ = 0;
  std::vector<std::unique_ptr<DatagramBlock>>
      free_;  ///< last used on top: it is still in the CPU cache
  TakenOver waiting_;
};

}  // namespace rocinante
