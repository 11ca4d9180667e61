#pragma once

#include <cstdint>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/net/receive_buffer.h"
#include "core/report/account.h"

namespace rocinante {

/// Moves datagrams from their sources into a HandOver: ReceiveLoop those of sockets,
/// CaptureFileLoop those of a capture file, StreamLoop those of a stream. One thread, that of a
/// Reception.
class InputLoop {
 public:
  virtual ~InputLoop() = default;

  /// The start of the session's time line.
  virtual LogTime begins() const = 0;
  /// True when the recording lasts by the clock. A file is read as fast as the log is written, and
  /// lasts as long as its stamps say.
  virtual bool isLive() const = 0;
  /// True when the source continues next time after the datagrams that noteSaved() named; their
  /// stamps then lie anywhere before or after begins().
  virtual bool keepsPlace() const { return false; }
  /// The first `count` datagrams are in the log's file. For the writing thread.
  virtual void noteSaved(std::uint64_t count) { (void)count; }

  /// Moves what is there, up to a limit. True when something was moved.
  virtual Result<bool> pass() = 0;
  /// How long to sleep after a pass that returned `moved`.
  virtual Nanoseconds pauseAfter(bool moved) = 0;
  /// Everything was read: never for sockets.
  virtual bool ended() const = 0;
  /// Longest that delivery may be delayed: wait this long before finish() to get everything.
  virtual Nanoseconds deliveryDelay() const = 0;
  /// Moves what still waits, and ends the HandOver. Call it also after a failure: what was received
  /// is kept.
  virtual Status finish() = 0;

  /// The busiest complete second of an endpoint so far; 0 for a file.
  virtual ReceiveRate busiest(std::uint32_t endpoint) const = 0;
  /// What it changed of the datagrams, beside the account of their source.
  virtual Account leftOut() const { return {}; }
};

}  // namespace rocinante
