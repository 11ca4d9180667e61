#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/net/datagram_sink.h"
#include "player/send/paced_sender.h"
#include "player/send/realtime.h"
#include "player/send/route.h"
#include "player/send/transmit_stamps.h"

namespace rocinante {

/// The real SendPort: the steady clock, a timer, and a UDP socket or a server's subject for each
/// route.
class UdpSendPort final : public SendPort {
 public:
  /// Makes the calling thread the pacing one. `wake`, if not negative, is a descriptor that ends a
  /// sleep by becoming readable; it is not read. It must outlive the port. Waits for a server that
  /// is not there yet, as long as the route's endpoint does, and tells so.
  static Result<UdpSendPort> open(const std::vector<Route>& routes, Realtime realtime,
                                  std::function<bool()> stop, int wake = -1,
                                  const std::function<void(std::string_view)>& notify = {});

  SteadyTime now() override;
  void sleepUntil(SteadyTime moment) override;
  bool stopRequested() override { return stop_(); }
  bool hasResumed() override;
  std::size_t longest(std::uint16_t route) const override;
  Status send(std::uint16_t route, std::span<const ByteView> payloads,
              std::span<SteadyTime> sent_at) override;

  /// Waits until what was sent has left.
  Status flush();

  /// Source of the times in `sent_at`, except those of restatements: "kernel", "clock" or "kernel
  /// and clock".
  std::string timingSource() const;
  /// "fifo" if the thread was real-time throughout, else "other".
  std::string scheduling() const { return thread_.isRealtime() ? "fifo" : "other"; }

 private:
  struct Way {
    std::unique_ptr<DatagramSink> sink;
    std::optional<TransmitStamps> stamps;  ///< of a UDP socket
    bool restating = false;
  };

  UdpSendPort(std::vector<Way> ways, PacingThread thread, std::function<bool()> stop, int wake);

  void leaveRealtimeIfHogging();

  std::vector<Way> ways_;
  PacingThread thread_;
  std::function<bool()> stop_;
  int wake_;
  SteadyTime last_sleep_;
  std::optional<Nanoseconds> ran_until_;  ///< CPU time when first checked since the last sleep
  std::uint32_t resumes_;
};

}  // namespace rocinante
