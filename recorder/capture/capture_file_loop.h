#pragma once

#include <optional>
#include <span>

#include "core/net/datagram_source.h"
#include "core/recording/capture_blocks.h"
#include "core/recording/hand_over.h"
#include "recorder/capture/input_loop.h"

namespace rocinante {

/// Reads a capture file into a HandOver in place of a ReceiveLoop: as fast as the log is written,
/// without dropping anything. One thread; reads no clock.
class CaptureFileLoop : public InputLoop {
 public:
  /// `source` and `out` must outlive the loop; `begins`: see firstMoment().
  CaptureFileLoop(DatagramSource& source, HandOver& out, LogTime begins)
      : source_(source), blocks_(out), out_(out), begins_(begins) {}

  LogTime begins() const override { return begins_; }
  bool isLive() const override { return false; }
  /// Reads one batch. False when the queue was full.
  Result<bool> pass() override;
  Nanoseconds pauseAfter(bool moved) override;
  bool ended() const override { return left_.empty() && source_.ended(); }
  Nanoseconds deliveryDelay() const override { return Nanoseconds(0); }
  Status finish() override;
  ReceiveRate busiest(std::uint32_t) const override { return {}; }
  Account leftOut() const override { return blocks_.leftOut(); }

 protected:
  /// An empty batch; returns what pass() returns. A file has more behind it, or ends.
  virtual bool passEmpty() { return true; }
  void noteLoss(const LossCounts& counts) { blocks_.noteLoss(counts, begins_); }

  DatagramSource& source_;
  CaptureBlocks blocks_;

 private:
  HandOver& out_;
  LogTime begins_;
  std::span<const ReceivedDatagram> left_;  ///< rest of the last batch, for which there was no room
};

/// When the first datagram of a capture file was seen; empty when it holds none.
Result<std::optional<LogTime>> firstMoment(const Endpoint& file);

}  // namespace rocinante
