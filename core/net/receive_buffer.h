#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "core/base/time.h"

namespace rocinante {

/// Extends the kernel's 32-bit count of drops beyond its wrap. Readings may come out of order:
/// a datagram carries the count at the time it was queued, SO_MEMINFO the current one.
class DropCounter {
 public:
  /// Readings less than 2^31 ahead of the highest advance the count; others are older.
  void update(std::uint32_t reading);
  std::uint64_t total() const { return total_; }

 private:
  std::uint64_t total_ = 0;
};

/// The load of a socket: its busiest second so far.
struct ReceiveRate {
  double datagrams_a_second = 0;
  double bytes_a_datagram = 0;  ///< of payload, on average
};

/// How long other processes may keep a receiver from running.
constexpr Nanoseconds kReceiveStall = std::chrono::milliseconds(50);

/// The bytes that the kernel charges a receive buffer for one datagram, as measured on loopback:
/// 832 for a payload of 100. A network card's driver may charge more, and rarely less.
std::uint64_t chargedBytes(std::size_t payload_bytes);

/// The receive buffer, as the kernel counts it, that loses nothing at this rate while the receiver
/// does not run for `stall`.
std::uint64_t neededReceiveBuffer(const ReceiveRate& rate, Nanoseconds stall = kReceiveStall);

/// When `granted_bytes` are too few for the rate: the problem, and the setting that solves it.
std::optional<std::string> receiveBufferAdvice(const std::string& endpoint,
                                               std::uint64_t granted_bytes, const ReceiveRate& rate,
                                               Nanoseconds stall = kReceiveStall);

}  // namespace rocinante
