#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/net/datagram_source.h"

namespace rocinante {

/// Packets that a recorder's tees forwarded and that come back from another sender: recorders whose
/// tees form a circle would forward them for ever. Only packet text, of which a second copy says
/// nothing new. Memory is bounded. One thread.
class TeeEchoes {
 public:
  static constexpr Nanoseconds kSpan = std::chrono::seconds(2);
  static constexpr std::size_t kPackets = 65'536;

  /// What is to be forwarded of the batch: all of it, or what came the first time. Valid until the
  /// next call.
  std::span<const ReceivedDatagram> firsts(std::span<const ReceivedDatagram> batch, SteadyTime now);

  std::uint64_t count() const { return count_; }
  /// After the first echo, once: a sentence for the user.
  std::optional<std::string> news();

 private:
  struct Forwarded {
    SteadyTime time;
    SocketAddress sender;
  };
  bool isEcho(const ReceivedDatagram& datagram, SteadyTime now);

  std::unordered_map<std::uint64_t, Forwarded> forwarded_;
  std::deque<std::pair<SteadyTime, std::uint64_t>> order_;  ///< of forwarded_, oldest first
  std::vector<ReceivedDatagram> firsts_;
  std::uint64_t count_ = 0;
  std::optional<std::string> news_;
};

}  // namespace rocinante
