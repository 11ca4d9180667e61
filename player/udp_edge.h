#pragma once

#include <functional>
#include <string>

#include "core/net/udp_socket.h"
#include "player/paced_sender.h"
#include "player/realtime.h"
#include "player/transmit_stamps.h"

namespace rocinante {

/// The real world to send into: the steady clock, a timer and a UDP socket.
class UdpEdge final : public SendEdge {
 public:
  /// Makes the calling thread the pacing one.
  static Result<UdpEdge> open(const Endpoint& to, Realtime realtime, std::function<bool()> stop);

  SteadyTime now() override;
  void sleepUntil(SteadyTime moment) override;
  bool stopRequested() override { return stop_(); }
  Status send(std::span<const ByteView> payloads, std::span<SteadyTime> sent_at) override;

  /// Where the times of `sent_at` came from: "kernel", "clock" or "kernel and clock".
  std::string timingSource() const;
  /// "fifo" when the thread was real-time all the time, else "other".
  std::string scheduling() const { return thread_.isRealtime() ? "fifo" : "other"; }

 private:
  UdpEdge(UdpSender sender, PacingThread thread, std::function<bool()> stop);

  UdpSender sender_;
  PacingThread thread_;
  std::function<bool()> stop_;
  TransmitStamps stamps_;
  SteadyTime last_sleep_;
};

}  // namespace rocinante
