#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "core/recording/datagram_block.h"

namespace rocinante {

/// Puts the datagrams of several sockets into one order of time. Each socket's own come in order;
/// one is let go when no socket can still hold an earlier one. Equal times: the endpoint listed
/// first goes first. Pure.
class ReorderWindow {
 public:
  struct Held {
    DatagramBlock* block = nullptr;
    const Arrival* arrival = nullptr;
    LogTime time;  ///< the arrival's, raised if it came too late to stand in its place
  };

  /// What the kernel may take between stamping a datagram and giving it to its socket.
  static constexpr Nanoseconds kWidth = std::chrono::milliseconds(20);

  explicit ReorderWindow(std::size_t endpoint_count) : waiting_(endpoint_count) {}

  /// The block must stay until its last arrival was let go.
  void add(DatagramBlock& block);

  /// The earliest datagram that lies kWidth before `drained_until`, up to which everything has been
  /// added; empty when there is none. Times never go back.
  std::optional<Held> next(LogTime drained_until);
  /// The earliest of all: when nothing will be added.
  std::optional<Held> nextOfAll();

  /// Datagrams that came too late for their place; they stand at the time then reached.
  std::size_t late() const { return late_; }

 private:
  std::optional<Held> take(std::size_t endpoint);
  std::optional<std::size_t> earliest() const;

  std::vector<std::deque<Held>> waiting_;  ///< by endpoint, in order of time
  LogTime reached_{};
  std::size_t late_ = 0;
};

}  // namespace rocinante
