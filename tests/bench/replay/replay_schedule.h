#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/base/time.h"
#include "core/net/endpoint.h"

namespace rocinante::bench {

/// Datagrams and when each is due after the first, in log time. Whole microseconds: what all three
/// file formats can say.
struct Schedule {
  std::vector<Nanoseconds> due;

  static Schedule regular(double rate_hz, std::size_t count);
  /// Gaps as of independent senders (exponential), the same in every run.
  static Schedule poisson(double rate_hz, std::size_t count);
};

/// Six joints as packet text of 100 bytes, the number in a last line that readers skip.
std::string payloadOf(std::size_t number);
/// The number of a datagram that ends with such a payload, whatever stands before it; -1: none.
std::int64_t numberOf(ByteView datagram);

/// The same schedule as the three programs read it.
Status writeMcap(const std::filesystem::path& path, const Schedule& schedule);
/// Ethernet frames to a multicast group (libpcap format, microseconds).
void writePcap(const std::filesystem::path& path, const Schedule& schedule,
               const SocketAddress& from, const SocketAddress& to);
/// lcm-logger's format: 28-byte big-endian event headers.
void writeLcm(const std::filesystem::path& path, const Schedule& schedule);

}  // namespace rocinante::bench
