#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "core/base/time.h"

namespace rocinante {

/// What comes to a socket: its busiest second so far.
struct ReceiveRate {
  double datagrams_a_second = 0;
  double bytes_a_datagram = 0;  ///< of payload, on average
};

/// For so long a receiver may be held up by others on its machine.
constexpr Nanoseconds kReceiveStall = std::chrono::milliseconds(50);

/// What the kernel charges a receive buffer for a datagram of so many bytes, as measured on
/// loopback: 832 for 100. A network card's driver may charge more, and seldom less.
std::uint64_t chargedBytes(std::size_t payload_bytes);

/// The receive buffer, as the kernel counts it, that loses nothing at this rate while the receiver
/// stands still for `stall`.
std::uint64_t neededReceiveBuffer(const ReceiveRate& rate, Nanoseconds stall = kReceiveStall);

/// When `granted_bytes` are too few for the rate: what is wrong, and the setting that mends it.
std::optional<std::string> receiveBufferAdvice(const std::string& endpoint,
                                               std::uint64_t granted_bytes, const ReceiveRate& rate,
                                               Nanoseconds stall = kReceiveStall);

}  // namespace rocinante
