#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/recording/capture_sink.h"
#include "core/recording/session_writer.h"

namespace rocinante {

/// A log just made, with nothing in it but what is attached.
struct MadePiece {
  LogWriter log;
  PieceFile file;
};

/// One log of a recording, being written. Channels are made as flows appear in it.
class PieceLog {
 public:
  PieceLog(MadePiece made, const KeyframeOptions& keyframes);

  /// As SessionWriter's; `origin` is that of the session, when it is known by now.
  Status begin(const SessionState& preceding, LogTime moment, std::optional<LogTime> origin);
  /// Folds the datagram; decodes it when it does not say what it was decoded to.
  Status write(const CapturedDatagram& datagram, bool decoded = true);
  Status writeLoss(const LossSpan& span) { return session_.log().writeLoss(span); }
  Status writeStep(const ClockStep& step);
  Status flush(SteadyTime now);
  Status flushAll() { return session_.log().flush(); }
  /// A file that another program disturbed is no error here: newDisturbance().
  Status close(const std::string& reason);
  /// What another program did to the file, once, after flush(), which looks every second, or
  /// close() has found it.
  std::optional<Error> newDisturbance();

  const SessionState& state() const { return session_.state(); }
  std::uint64_t bytes() const { return session_.log().bytesWritten(); }
  const PieceFile& file() const { return file_; }
  /// Nothing was written yet but what is attached and what preceded.
  bool empty() const { return packets_ == 0; }
  std::optional<LogTime> lastTime() const { return end_; }

  PieceFacts facts() const;
  /// Adds what the disk refused, by flow.
  void addRefused(std::vector<std::uint64_t>& by_flow) const;

 private:
  SessionWriter session_;
  PieceFile file_;
  SteadyTime looked_{};
  std::optional<Error> disturbance_;
  bool disturbance_told_ = false;
  std::vector<std::optional<ChannelId>> channels_;  ///< by flow
  std::optional<ChannelId> clock_channel_;
  std::uint32_t steps_ = 0;
  std::uint64_t packets_ = 0;
  std::optional<LogTime> start_, end_;
};

}  // namespace rocinante
