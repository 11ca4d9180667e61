#pragma once

#include <functional>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/base/time.h"
#include "core/net/endpoint.h"

namespace rocinante {

/// The longest datagram that an IPv4 packet holds.
inline constexpr std::size_t kMaxPcapDatagramBytes = 65'507;

/// Writes a capture file of libpcap's classic format with nanoseconds (magic 0xA1B23C4D, link type
/// RAW): each datagram in IPv4 or IPv6 and UDP headers made for it, with right checksums. Memory is
/// one frame.
class PcapFile {
 public:
  /// Appends bytes to the file, all or fails.
  using Append = std::function<Status(ByteView)>;

  explicit PcapFile(Append append) : append_(std::move(append)) {}

  Status begin();
  /// Both addresses of one family. `datagram` is at most kMaxPcapDatagramBytes. unsupported when
  /// the time is before 1970 or does not fit 32 bits of seconds.
  Status write(LogTime time, const SocketAddress& from, const SocketAddress& to, ByteView datagram);

 private:
  Append append_;
  Bytes frame_;
};

}  // namespace rocinante
