#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/net/datagram_source.h"
#include "core/recording/hand_over.h"
#include "core/recording/session_clock.h"
#include "recorder/capture/input_loop.h"

namespace rocinante {

/// Empties sockets into a HandOver as fast as they fill, and counts dropped datagrams. The writing
/// thread interprets the datagrams. One thread; reads clocks only through `look`.
class ReceiveLoop final : public InputLoop {
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

  LogTime begins() const override { return begins_; }
  bool isLive() const override { return true; }
  /// Receives what waits at every source. Fails when a socket fails.
  Result<bool> pass() override;
  Nanoseconds pauseAfter(bool moved) override;
  bool ended() const override { return false; }
  Nanoseconds deliveryDelay() const override;
  /// Also reads the final drop counts.
  Status finish() override;
  ReceiveRate busiest(std::uint32_t endpoint) const override {
    return listeners_[endpoint].busiest;
  }

  const SessionClock& clock() const { return clock_; }

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
    bool small_buffer_reported = false;
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
  LogTime begins_{};
  LogTime asked_{};
  int idle_passes_ = 0;  ///< without a datagram, since the last one
  std::vector<EndpointLoss> losses_;
  std::vector<ClockStep> steps_;
};

}  // namespace rocinante
