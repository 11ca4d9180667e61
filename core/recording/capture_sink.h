#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/log/log_profile.h"
#include "core/log/log_types.h"
#include "core/packet/session_state.h"
#include "core/recording/flow_table.h"
#include "core/recording/recorded_files.h"
#include "core/recording/session_clock.h"

namespace rocinante {

/// One datagram in the session's order of time. Everything is borrowed for the call.
struct CapturedDatagram {
  std::size_t flow = 0;                  ///< index in the recording's FlowTable
  const FlowChannel* channel = nullptr;  ///< that flow's
  std::uint32_t sequence = 0;            ///< the recorder's count on the channel, modulo 2^32
  LogTime time{};
  std::int64_t publish_time_ns = 0;
  ByteView payload;
  const Packet* packet = nullptr;  ///< what it was decoded to; null when it is none

  /// False for what someone else restates: no message of the session.
  bool captured() const { return !channel->topic.starts_with(profile::kOwnTopics); }
};

/// Where a recording goes: one log, a sequence of pieces, or a ring in memory of which files are
/// written. Told everything in order of time, on the writing thread alone; reads no clock.
class CaptureSink {
 public:
  virtual ~CaptureSink() = default;

  /// What was heard of the session before the first datagram that is recorded, which comes at
  /// `moment`. Before anything else, at most once.
  virtual Status begin(const SessionState& preceding, LogTime moment) = 0;

  /// True when what comes from `time` on belongs to a new piece: what the old one is still to be
  /// told, losses and clock steps up to then, must be told now, and then seam() called.
  virtual bool seamDue(LogTime time) = 0;
  virtual Status seam(LogTime time) = 0;

  /// An error is the last thing that the recording says: nothing more will be kept.
  virtual Status write(const CapturedDatagram& datagram) = 0;
  virtual Status writeLoss(const LossSpan& span) = 0;
  virtual Status writeStep(const ClockStep& step) = 0;

  /// Some hundred times a second, also when nothing comes: everything before `reached` was told.
  virtual Status flush(LogTime reached, SteadyTime now) = 0;
  /// The open chunk now, whatever its age: what the disk refuses of it can still be told.
  virtual Status flushAll() = 0;
  /// Closes what is open, with `reason`, and waits for it.
  virtual Status close(const std::string& reason) = 0;

  /// A new piece as soon as there can be one (SIGHUP).
  virtual void askForSeam() = 0;
  /// What a ring holds is to be kept, as of `moment`; `why` for people.
  virtual void trigger(LogTime moment, const std::string& why) = 0;

  /// Everything ever written, in files that are gone too. Grows whenever something came into a
  /// file.
  virtual std::uint64_t bytesWritten() const = 0;
  /// By flow: datagrams given to write() that the disk refused. Exact after flushAll() and close().
  virtual std::vector<std::uint64_t> refusedByFlow() const = 0;
  /// Complete after close().
  virtual RecordedFiles files() const = 0;
  /// How much of the session waits in memory to be triggered.
  virtual Nanoseconds held() const { return Nanoseconds(0); }
};

}  // namespace rocinante
