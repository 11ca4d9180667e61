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

/// Datagrams of one endpoint that were sent and are not kept, or not whole.
struct EndpointLoss {
  std::uint32_t endpoint = 0;
  LogTime from, until;
  LossCounts counts;
};

/// Adds `loss` to the one of the same endpoint in `losses`, widening its span, or appends it: the
/// list holds at most one an endpoint.
void addLoss(std::vector<EndpointLoss>& losses, const EndpointLoss& loss);

/// What the writing thread takes at a time.
struct TakenOver {
  std::vector<std::unique_ptr<DatagramBlock>> blocks;  ///< in order of receiving
  std::vector<EndpointLoss> losses;
  std::vector<ClockStep> steps;
  LogTime drained_until;  ///< whatever arrived before this is in a block taken by now
  bool finished = false;  ///< nothing will follow
};

/// The bounded queue between the receiving and the writing thread. Its memory is `max_blocks`
/// blocks, made when first needed; when all are taken the receiver has to count what it drops.
class HandOver {
 public:
  explicit HandOver(std::size_t max_blocks) : max_blocks_(max_blocks) {}

  /// For the receiving thread: an empty block, or null when all are in use.
  std::unique_ptr<DatagramBlock> freeBlock();
  /// `block` may be null: then only the rest is told. `losses` and `steps` are emptied.
  void give(std::unique_ptr<DatagramBlock> block, std::vector<EndpointLoss>& losses,
            std::vector<ClockStep>& steps, std::optional<LogTime> drained_until);
  void finish();
  /// Which part of the blocks is in use, 0 to 1: near 1 the receiver is about to drop.
  double fill();

  /// For the writing thread: what was given, waiting for a block at most so long.
  TakenOver take(Nanoseconds at_most);
  void giveBack(std::unique_ptr<DatagramBlock> block);

 private:
  std::mutex mutex_;
  std::condition_variable given_;
  const std::size_t max_blocks_;
  std::size_t made_ = 0;
  std::vector<std::unique_ptr<DatagramBlock>> free_;  ///< last used on top: it is in the cache
  TakenOver waiting_;
};

}  // namespace rocinante
