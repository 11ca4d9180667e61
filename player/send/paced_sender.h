#pragma once

#include <cstdint>
#include <span>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/base/time.h"
#include "player/send/datagram_stream.h"
#include "player/send/playback_clock.h"

namespace rocinante {

/// The world that sending acts on: a clock, a sleep and a socket. A test hands in its own.
class SendPort {
 public:
  virtual ~SendPort() = default;

  virtual SteadyTime now() = 0;
  /// May return early (a signal), never much later.
  virtual void sleepUntil(SteadyTime moment) = 0;
  virtual bool stopRequested() = 0;
  /// True once after this process was stopped by a signal and went on.
  virtual bool hasResumed() { return false; }
  /// Sends all by one route, in order; writes when each left into `sent_at`, which is as long as
  /// `payloads`.
  virtual Status send(std::uint16_t route, std::span<const ByteView> payloads,
                      std::span<SteadyTime> sent_at) = 0;
};

/// Told of everything that was sent, in order.
class SendJournal {
 public:
  virtual ~SendJournal() = default;
  virtual void sent(const Due& due, ByteView payload, SteadyTime deadline, SteadyTime sent_at) = 0;
};

enum class SendEnd : std::uint8_t { finished, stopped };

/// Sends a stream on its schedule: nothing early, nothing dropped, nothing out of order. What is
/// due together goes in one call. When it cannot keep up, everything is late and still in order.
/// Fails when the stream or the socket does.
Result<SendEnd> sendOnSchedule(DatagramStream& stream, const PlaybackClock& clock, SendPort& edge,
                               SendJournal& journal);

/// The same without a schedule: as fast as the socket takes them. Each deadline is then the moment
/// it was taken up.
Result<SendEnd> sendAtOnce(DatagramStream& stream, SendPort& edge, SendJournal& journal);

}  // namespace rocinante
