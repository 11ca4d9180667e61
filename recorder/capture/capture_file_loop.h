#pragma once

#include <optional>
#include <span>

#include "core/net/datagram_source.h"
#include "core/recording/hand_over.h"

namespace rocinante {

/// The time line of a capture file: its own timestamps, made monotonic. Timestamps slightly out of
/// order (several network cards, several processors) are raised to the time reached; where the
/// clock was set back, time continues from there and the jump is reported as a step. Pure.
class CaptureTime {
 public:
  /// A larger step back is a clock that was set, not disorder.
  static constexpr Nanoseconds kDisorder = std::chrono::milliseconds(20);

  LogTime at(WallTime stamp);
  /// The clock step that the last timestamp revealed, if any.
  std::optional<ClockStep> takeStep() { return std::exchange(step_, std::nullopt); }

 private:
  std::optional<LogTime> reached_;
  Nanoseconds shift_{0};
  std::optional<ClockStep> step_;
};

/// Reads a capture file into a HandOver in place of a ReceiveLoop: as fast as the log is written,
/// without dropping anything. One thread; reads no clock.
class CaptureFileLoop {
 public:
  /// Both must outlive the loop.
  CaptureFileLoop(DatagramSource& source, HandOver& out) : source_(source), out_(out) {}

  /// Reads one batch. False when the queue was full: try again later.
  Result<bool> pass();
  bool ended() const { return left_.empty() && source_.ended(); }
  /// Hands over what is left; call it also after a failure.
  void finish();

 private:
  bool keep(const ReceivedDatagram& datagram);
  void handOverBlock();

  DatagramSource& source_;
  HandOver& out_;
  CaptureTime time_;
  LogTime reached_{};
  std::span<const ReceivedDatagram> left_;  ///< rest of the last batch, for which there was no room
  std::unique_ptr<DatagramBlock> block_;
  std::vector<EndpointLoss> losses_;
  std::vector<ClockStep> steps_;
};

/// When the first datagram of a capture file was seen; empty when it holds none.
Result<std::optional<LogTime>> firstMoment(const Endpoint& file);

}  // namespace rocinante
