#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "core/recording/datagram_block.h"

namespace rocinante {

/// Merges the datagrams of several sockets into one time order. Each socket's own arrive in order;
/// a datagram is released when no socket can still hold an earlier one. At equal times the endpoint
/// listed first goes first. Pure.
class ReorderWindow {
 public:
  struct Held {
    DatagramBlock* block = nullptr;
    const Arrival* arrival = nullptr;
    LogTime time;  ///< the arrival's, raised if it came too late for its place
  };

  /// The time that the kernel may take between stamping a datagram and giving it to its socket.
  static constexpr Nanoseconds kWidth = std::chrono::milliseconds(20);

  explicit ReorderWindow(std::size_t endpoint_count) : waiting_(endpoint_count) {}

  /// The block must exist until its last arrival was released.
  void add(DatagramBlock& block);

  /// The earliest datagram that is at least kWidth before `drained_until`, up to which everything
  /// has been added; empty when there is none. Times never go back.
  std::optional<Held> next(LogTime drained_until);
  /// The earliest of all: when nothing more will be added.
  std::optional<Held> nextOfAll();

  /// Datagrams that came too late for their place; they got the time reached by then.
  std::size_t late() const { return late_; }

 private:
  std::optional<Held> take(std::size_t endpoint);
  std::optional<std::size_t> earliest() const;

  std::vector<std::deque<Held>> waiting_;  ///< by endpoint, in order of time
  LogTime reached_{};
  std::size_t late_ = 0;
};

}  // namespace rocinante
