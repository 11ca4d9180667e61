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

/// Empties sockets into a HandOver as fast as they fill, and accounts for what was dropped. It does
/// nothing else: what a datagram means is the writing thread's business. One thread; reads no
/// clock but through `look`.
class ReceiveLoop {
 public:
  using Look = std::function<ClockReading()>;
  struct Callbacks {
    /// Everything received, batch by batch, before anything else is done with it.
    std::function<void(std::span<const ReceivedDatagram>)> tee;
    /// Sentences for people: an interface is gone, the receive buffer is small for the rate.
    std::function<void(const std::string&)> note;
  };

  /// `sources` (index = endpoint) and `out` must outlive the loop. What `callbacks` holds may be
  /// null.
  ReceiveLoop(std::vector<DatagramSource*> sources, Look look, HandOver& out, Callbacks callbacks);
  ReceiveLoop(std::vector<DatagramSource*> sources, Look look, HandOver& out)
      : ReceiveLoop(std::move(sources), std::move(look), out, Callbacks()) {}

  /// Receives what waits at every source, or much of it. True when there was something: call again
  /// at once; else sleep a little. Fails when a socket does.
  Result<bool> pass();

  /// Takes what still waits, asks for the final drop counts, hands everything over. Call it also
  /// after a failure: what was received is kept.
  Status finish();

  const SessionClock& clock() const { return clock_; }
  /// The busiest second of an endpoint so far, as far as seconds are over.
  const ReceiveRate& busiest(std::uint32_t endpoint) const { return listeners_[endpoint].busiest; }
  /// For so long the system may keep what has arrived: before finish(), whoever wants all of it
  /// waits.
  Nanoseconds deliveryDelay() const;

 private:
  struct Listener {
    DatagramSource* source;
    LogTime last{};           ///< of the latest datagram: times of one socket do not go back
    LogTime drained_until{};  ///< whatever arrived before this has been received
    LogTime checked{};        ///< when drops were last asked for
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
