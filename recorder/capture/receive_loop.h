#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/net/datagram_source.h"
#include "core/net/receive_buffer.h"
#include "core/recording/hand_over.h"
#include "core/recording/session_clock.h"

namespace rocinante {

/// Empties sockets into a HandOver as fast as they fill, and counts dropped datagrams. The writing
/// thread interprets the datagrams. One thread; reads clocks only through `look`.
class ReceiveLoop {
 public:
  using Look = std::function<ClockReading()>;
  struct Callbacks {
    /// Called first with every batch received.
    std::function<void(std::span<const ReceivedDatagram>)> tee;
    /// Sentences for the user: an interface is gone, the receive buffer is too small for the rate.
    std::function<void(const std::string&)> note;
  };

  /// `sources` (index = endpoint) and `out` must outlive the loop. The functions in `callbacks` may
  /// be empty.
  ReceiveLoop(std::vector<DatagramSource*> sources, Look look, HandOver& out, Callbacks callbacks);
  ReceiveLoop(std::vector<DatagramSource*> sources, Look look, HandOver& out)
      : ReceiveLoop(std::move(sources), std::move(look), out, Callbacks()) {}

  /// Receives what waits at every source, up to a limit. True when datagrams came: call again at
  /// once; else sleep briefly. Fails when a socket fails.
  Result<bool> pass();

  /// Receives what still waits, reads the final drop counts and hands everything over. Call it also
  /// after a failure: received datagrams are kept.
  Status finish();

  const SessionClock& clock() const { return clock_; }
  /// The busiest complete second of an endpoint so far.
  const ReceiveRate& busiest(std::uint32_t endpoint) const { return listeners_[endpoint].busiest; }
  /// Longest the kernel may delay delivery. Wait this long before finish() to receive everything.
  Nanoseconds deliveryDelay() const;

 private:
  struct Listener {
    DatagramSource* source;
    LogTime last{};           ///< time of the latest datagram; never goes back within a socket
    LogTime drained_until{};  ///< everything that arrived before this was received
    LogTime checked{};        ///< when drops were last read
    std::uint64_t dropped = 0;
    std::uint64_t datagrams = 0, bytes = 0;  ///< since rate_since
    LogTime rate_since{};
    ReceiveRate busiest;
    bool small_buffer_told = false;
  };

  void lookAgain();
  Result<bool> drain(std::uint32_t endpoint);
  void keep(std::uint32_t endpoint, const ReceivedDatagram& datagram);
  void noteDrops(std::uint32_t endpoint, std::uint64_t dropped);
  Status askForDrops();
  void maintain(Listener& listener);
  void measureRate(Listener& listener);
  void handOverBlock(std::optional<LogTime> drained_until);

  Look look_;
  HandOver& out_;
  Callbacks callbacks_;
  SessionClock clock_;
  std::vector<Listener> listeners_;
  std::unique_ptr<DatagramBlock> block_;  ///< being filled; null, or not empty
  LogTime block_began_{};
  LogTime asked_{};
  std::vector<EndpointLoss> losses_;
  std::vector<ClockStep> steps_;
};

}  // namespace rocinante
