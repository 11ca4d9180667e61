#pragma once

#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>

#include "core/base/bytes.h"
#include "core/base/time.h"

namespace rocinante {

/// What `rocinante serve` sends to a page over its socket (docs/programs/serve.md, "The socket"): a
/// byte that says whether a greeting begins, the session's time as 8 bytes, then packets, each
/// behind its length as 4 bytes. Little-endian.
inline constexpr std::size_t kLiveHeadBytes = 9, kLiveLengthBytes = 4;

/// The head of a message; packets are appended to it.
inline void beginLiveMessage(Bytes& message, bool greets, LogTime time) {
  message.push_back(static_cast<std::byte>(greets ? 1 : 0));
  const auto ns = static_cast<std::uint64_t>(nanosecondsOf(time));
  for (unsigned i = 0; i < 8; ++i) message.push_back(static_cast<std::byte>(ns >> (8 * i)));
}

inline void appendLivePacket(Bytes& message, ByteView packet) {
  for (unsigned i = 0; i < kLiveLengthBytes; ++i) {
    message.push_back(static_cast<std::byte>(packet.size() >> (8 * i)));
  }
  message.insert(message.end(), packet.begin(), packet.end());
}

/// Reads a message; borrows its bytes, allocates nothing.
class LiveMessageReader {
 public:
  /// Empty when the bytes are too few for a head, or it is none.
  static std::optional<LiveMessageReader> of(ByteView message) {
    if (message.size() < kLiveHeadBytes || std::to_integer<int>(message[0]) > 1) return {};
    LiveMessageReader reader;
    reader.greets_ = message[0] != std::byte{0};
    reader.time_ = LogTime(Nanoseconds(static_cast<std::int64_t>(number(message, 1, 8))));
    reader.left_ = message.subspan(kLiveHeadBytes);
    return reader;
  }

  /// Forget what was said before: the state comes anew.
  bool greets() const { return greets_; }
  LogTime time() const { return time_; }
  /// The next packet; empty at the end, or where the message was cut: isCut() tells which.
  std::optional<ByteView> next() {
    if (left_.empty()) return {};
    const std::uint64_t length =
        left_.size() < kLiveLengthBytes ? left_.size() : number(left_, 0, kLiveLengthBytes);
    is_cut_ = left_.size() < kLiveLengthBytes || length > left_.size() - kLiveLengthBytes;
    if (is_cut_) return {};
    const ByteView packet = left_.subspan(kLiveLengthBytes, static_cast<std::size_t>(length));
    left_ = left_.subspan(kLiveLengthBytes + packet.size());
    return packet;
  }
  bool isCut() const { return is_cut_; }

 private:
  static std::uint64_t number(ByteView bytes, std::size_t at, std::size_t count) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < count; ++i) {
      value |= std::to_integer<std::uint64_t>(bytes[at + i]) << (8 * i);
    }
    return value;
  }

  ByteView left_;
  LogTime time_{};
  bool greets_ = false, is_cut_ = false;
};

}  // namespace rocinante
