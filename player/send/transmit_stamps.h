#pragma once

#include <cstdint>
#include <span>

#include "core/base/time.h"

namespace rocinante {

/// Reads the kernel's software transmit timestamps (SO_TIMESTAMPING) of a socket's datagrams,
/// converted to the steady clock. One thread.
class TransmitStamps {
 public:
  /// `descriptor` is a UDP socket that must outlive this. If the kernel refuses, there are no
  /// timestamps.
  explicit TransmitStamps(int descriptor);

  /// Call after sending as many datagrams as `sent_at` is long. Overwrites the times with the
  /// kernel's timestamps if there is exactly one for each. A timestamp that comes too late (from a
  /// busy device) is not assigned to a later datagram. Datagrams that no device takes have none
  /// (multicast with ttl=0 reaches only this machine's listeners); after a while of that it stops
  /// reading.
  void collect(std::span<SteadyTime> sent_at);

  std::uint64_t stamped() const { return stamped_; }
  std::uint64_t unstamped() const { return unstamped_; }

 private:
  int descriptor_;
  bool asking_ = false;
  int fruitless_ = 0;
  std::uint32_t next_number_ = 0;  ///< the kernel's number of the next datagram
  std::uint64_t stamped_ = 0;
  std::uint64_t unstamped_ = 0;
};

}  // namespace rocinante
