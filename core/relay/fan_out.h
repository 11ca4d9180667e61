#pragma once

#include <sys/socket.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/net/datagram_sink.h"
#include "core/net/endpoint.h"

namespace rocinante {

/// What became of the datagrams of one step.
struct SendOutcome {
  std::uint64_t sent = 0;
  std::uint64_t dropped = 0;     ///< no room in time, or refused by the system
  std::optional<Error> trouble;  ///< the first refusal
};

/// Sends the datagrams in order, without blocking in the system: where there is no room it calls
/// `wait_for_room`, which returns false when the rest is to be dropped. A datagram that the system
/// refuses is dropped alone. The step that `record --tee` and a relay's `--to` share.
SendOutcome sendInOrder(DatagramSink& sink, std::span<const ByteView> payloads,
                        const std::function<bool()>& wait_for_room);

/// Sends datagrams to many addresses from one UDP socket, hundreds in a system call (sendmmsg). The
/// socket is the caller's and must outlive this. Linux. One thread.
class FanOut {
 public:
  /// An address as the system wants it; made once for each listener.
  class Destination {
   public:
    explicit Destination(const SocketAddress& address);

   private:
    friend class FanOut;
    sockaddr_storage address_{};
    socklen_t bytes_ = 0;
  };
  struct Outcome {
    std::uint64_t sent = 0;
    std::uint64_t dropped = 0;  ///< no room in time, or refused by the system
  };

  explicit FanOut(int socket) : socket_(socket) {}

  /// Both are borrowed until flush().
  void add(ByteView payload, const Destination& to);
  bool full() const { return messages_.size() >= kMessages; }
  bool empty() const { return messages_.empty(); }

  /// Sends what was added, in order; empty afterwards. Where the socket has no room it calls
  /// `wait_for_room`, which returns false when the rest is to be dropped. A datagram that the
  /// system refuses (no route, too long) is dropped alone.
  Outcome flush(const std::function<bool()>& wait_for_room);

 private:
  static constexpr std::size_t kMessages = 1024;  ///< the most that sendmmsg takes

  int socket_;
  std::vector<iovec> pieces_;
  std::vector<mmsghdr> messages_;
};

}  // namespace rocinante
