#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/base/time.h"
#include "player/send/datagram_stream.h"
#include "player/send/playback_clock.h"

namespace rocinante {

/// The clock, sleep and sockets of a sender. Tests substitute their own.
class SendPort {
 public:
  virtual ~SendPort() = default;

  virtual SteadyTime now() = 0;
  /// May return early (a signal), never much later.
  virtual void sleepUntil(SteadyTime moment) = 0;
  virtual bool stopRequested() = 0;
  /// True once after this process was stopped by a signal and continued.
  virtual bool hasResumed() { return false; }
  /// The longest payload that this route carries.
  virtual std::size_t longest(std::uint16_t route) const {
    (void)route;
    return std::numeric_limits<std::size_t>::max();
  }
  /// Sends all payloads by one route, in order; writes their send times into `sent_at`, which has
  /// the same length.
  virtual Status send(std::uint16_t route, std::span<const ByteView> payloads,
                      std::span<SteadyTime> sent_at) = 0;
};

/// Notified of everything sent, in order.
class SendJournal {
 public:
  virtual ~SendJournal() = default;
  virtual void sent(const Due& due, ByteView payload, SteadyTime deadline, SteadyTime sent_at) = 0;
  /// Longer than its route carries, and not sent.
  virtual void tooLong(const Due& due) { (void)due; }
};

enum class SendEnd : std::uint8_t { finished, stopped };

/// Sends a stream on its schedule: nothing early, dropped or reordered. Datagrams due together go
/// in one call. When it cannot keep up, everything is late and still in order. Fails when the
/// stream or the socket fails.
Result<SendEnd> sendOnSchedule(DatagramStream& stream, const PlaybackClock& clock, SendPort& port,
                               SendJournal& journal);

}  // namespace rocinante
