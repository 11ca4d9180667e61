#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/net/endpoint.h"

namespace rocinante::bench {

/// A wire of this process's own: from now on it lives in a new network namespace whose only way out
/// is one end of a veth pair; at the other end a process of another namespace hears a multicast
/// group and keeps the kernel's time stamp of each numbered datagram. Gone with the process.
class ReplayWire {
 public:
  static constexpr std::size_t kMax = 4'000'000;  ///< datagrams of one replay

  /// Refused without the rights for a namespace. Call before any thread is started.
  static Result<std::unique_ptr<ReplayWire>> make();
  ~ReplayWire();
  ReplayWire(const ReplayWire&) = delete;
  ReplayWire& operator=(const ReplayWire&) = delete;

  Endpoint to() const;            ///< the group, by this end
  SocketAddress from() const;     ///< this end's address
  std::string interface() const;  ///< this end's name

  /// Forgets what came.
  void clear(std::size_t count);
  /// Waits until all `count` came, or nothing new for a while.
  void settle(std::size_t count) const;
  /// CLOCK_REALTIME in nanoseconds by number, 0 where none came.
  std::vector<std::int64_t> arrivals(std::size_t count) const;
  /// Those that came again, or before one with a smaller number.
  std::uint64_t disorder() const;

 private:
  struct Heard;
  explicit ReplayWire(Heard* heard) : heard_(heard) {}

  Heard* heard_;  ///< shared with the listening process
  int listener_ = -1;
};

}  // namespace rocinante::bench
