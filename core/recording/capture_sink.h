#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/log/log_profile.h"
#include "core/log/log_types.h"
#include "core/packet/session_state.h"
#include "core/recording/flow_table.h"
#include "core/recording/octet_decoder.h"
#include "core/recording/recorded_files.h"
#include "core/recording/session_clock.h"

namespace rocinante {

/// A datagram in the session's time order. Everything is borrowed for the call.
struct CapturedDatagram {
  std::size_t flow = 0;                  ///< index in the recording's FlowTable
  const FlowChannel* channel = nullptr;  ///< the channel of that flow
  std::uint32_t sequence = 0;            ///< the recorder's count on the channel, modulo 2^32
  LogTime time{};
  std::int64_t publish_time_ns = 0;
  ByteView payload;
  /// The decoded packet, of it or made from it; null: none.
  const Packet* packet = nullptr;
  /// The packet that was made of octets: written directly behind them, with the same time, sender's
  /// time and sequence. Null: none was.
  const MadePacket* made = nullptr;

  /// False for a restatement by another program: not a message of the session.
  bool captured() const { return !channel->topic.starts_with(profile::kOwnTopics); }
};

/// The output of a recording: one log, a sequence of pieces, or a ring in memory from which files
/// are written. Called in time order, on the writing thread alone; reads no clock. A sink that is
/// one log needs neither seams nor triggers.
class CaptureSink {
 public:
  virtual ~CaptureSink() = default;

  /// The session's state before the first recorded datagram, which arrives at `moment`. Called
  /// before anything else, at most once.
  virtual Status begin(const SessionState& preceding, LogTime moment) = 0;

  /// True when data from `time` on belongs to a new piece: the caller must then write the losses
  /// and clock steps up to `time`, which belong to the old piece, and call seam().
  virtual bool seamDue(LogTime /*time*/) { return false; }
  virtual Status seam(LogTime /*time*/) { return {}; }

  /// After an error the recording is over: nothing more will be kept.
  virtual Status write(const CapturedDatagram& datagram) = 0;
  virtual Status writeLoss(const LossSpan& span) = 0;
  virtual Status writeStep(const ClockStep& step) = 0;

  /// Called a few hundred times a second, also when nothing arrives: everything before `reached`
  /// was written.
  virtual Status flush(LogTime reached, SteadyTime now) = 0;
  /// Writes the open chunk now, whatever its age: losses that the disk causes here can still be
  /// recorded.
  virtual Status flushAll() = 0;
  /// Closes what is open, with `reason`, and waits until it is done.
  virtual Status close(const std::string& reason) = 0;

  /// Asks for a new piece as soon as possible (SIGHUP).
  virtual void askForSeam() {}
  /// Saves the contents of a ring, as of `moment`; `why` is for users.
  virtual void trigger(LogTime /*moment*/, const std::string& /*why*/) {}

  /// All bytes ever written, including those in deleted files. Grows whenever a file grows.
  virtual std::uint64_t bytesWritten() const = 0;
  /// By flow: datagrams given to write() that the disk refused. Exact after flushAll() and close().
  virtual std::vector<std::uint64_t> refusedByFlow() const = 0;
  /// Complete after close(). Empty for a sink whose files its owner knows.
  virtual RecordedFiles files() const { return {}; }
  /// How much of the session a ring holds in memory.
  virtual Nanoseconds held() const { return Nanoseconds(0); }
};

}  // namespace rocinante
