#pragma once

#include <cstdint>
#include <span>

#include "core/base/time.h"

namespace rocinante {

/// Asks the kernel when it handed a socket's datagrams to the device (SO_TIMESTAMPING, software
/// transmit stamps), and puts the answers on the steady clock. One thread.
class TransmitStamps {
 public:
  /// `descriptor` is a UDP socket that must outlive this. Where the kernel refuses, there are
  /// simply no stamps.
  explicit TransmitStamps(int descriptor);

  /// After sending as many datagrams as `sent_at` is long: overwrites each with the kernel's stamp,
  /// if there is exactly one for each. One that comes too late (a device that was busy) is no later
  /// datagram's. Datagrams that no device takes have none (multicast with ttl=0 reaches this
  /// machine's own listeners alone); after a while of that it asks no more.
  void collect(std::span<SteadyTime> sent_at);

  std::uint64_t stamped() const { return stamped_; }
  std::uint64_t unstamped() const { return unstamped_; }

 private:
  int descriptor_;
  bool asking_ = false;
  int fruitless_ = 0;
  std::uint32_t next_number_ = 0;  ///< the kernel's, of the datagram that is sent next
  std::uint64_t stamped_ = 0;
  std::uint64_t unstamped_ = 0;
};

}  // namespace rocinante
