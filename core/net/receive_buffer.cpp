#include "core/net/receive_buffer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rocinante {
namespace {

// The kernel's overhead per datagram: its own record of it, and the headers and the list of pages
// beside its bytes.
constexpr std::uint64_t kRecord = 256;
constexpr std::uint64_t kBeside = 392;
// Small allocations come in these sizes; larger datagrams get pages of their own.
constexpr std::uint64_t kSizes[] = {576, 1'024, 2'048, 4'096, 8'192, 16'384};
constexpr std::uint64_t kBesidePages = 832;

std::uint64_t nextPowerOfTwo(std::uint64_t value) {
  std::uint64_t power = 1;
  while (power < value) power *= 2;
  return power;
}

}  // namespace

void DropCounter::update(std::uint32_t reading) {
  const std::uint32_t ahead = reading - static_cast<std::uint32_t>(total_);
  if (ahead < (std::uint32_t{1} << 31)) total_ += ahead;
}

std::uint64_t chargedBytes(std::size_t payload_bytes) {
  for (const std::uint64_t size : kSizes) {
    if (payload_bytes + kBeside <= size) return kRecord + size;
  }
  return payload_bytes + kBesidePages;
}

std::uint64_t neededReceiveBuffer(const ReceiveRate& rate, Nanoseconds stall) {
  const double waiting =
      std::ceil(rate.datagrams_a_second * std::chrono::duration<double>(stall).count());
  const auto bytes = static_cast<std::size_t>(std::clamp(rate.bytes_a_datagram, 0.0, 65'507.0));
  return static_cast<std::uint64_t>(std::clamp(waiting, 0.0, 1e9)) * chargedBytes(bytes);
}

std::optional<std::string> receiveBufferAdvice(const std::string& endpoint,
                                               std::uint64_t granted_bytes, const ReceiveRate& rate,
                                               Nanoseconds stall) {
  const std::uint64_t needed = neededReceiveBuffer(rate, stall);
  if (needed <= granted_bytes || granted_bytes == 0) return std::nullopt;
  const auto bytes = static_cast<std::size_t>(std::clamp(rate.bytes_a_datagram, 0.0, 65'507.0));
  const double held_ms = static_cast<double>(granted_bytes) /
                         static_cast<double>(chargedBytes(bytes)) / rate.datagrams_a_second * 1e3;
  // The kernel doubles the requested size, up to net.core.rmem_max.
  const std::uint64_t setting = nextPowerOfTwo((needed + 1) / 2);
  return fmt::format(
      "the receive buffer of {} holds {:.0f} ms of {:.0f} datagrams/s, and a busy machine may be "
      "away for {} ms: run sysctl -w net.core.rmem_max={} and restart, or run as root",
      endpoint, held_ms, rate.datagrams_a_second,
      std::chrono::duration_cast<std::chrono::milliseconds>(stall).count(), setting);
}

}  // namespace rocinante
