#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/recording/capture_sink.h"
#include "core/recording/session_writer.h"

namespace rocinante {

/// A new log, empty except for attachments.
struct MadePiece {
  LogWriter log;
  PieceFile file;
};

/// One log of a recording, being written. Channels are added as flows appear.
class PieceLog {
 public:
  PieceLog(MadePiece made, const KeyframeOptions& keyframes);

  /// As SessionWriter's; `origin` is that of the session, if known by now.
  Status begin(const SessionState& preceding, LogTime moment, std::optional<LogTime> origin);
  /// Folds the datagram and the packet that was made of it, which is written directly behind it;
  /// decodes them first if `decoded` is false.
  Status write(const CapturedDatagram& datagram, bool decoded = true);
  Status writeLoss(const LossSpan& span) { return session_.log().writeLoss(span); }
  Status writeStep(const ClockStep& step);
  Status writeMetadata(const LogMetadata& record) { return session_.log().writeMetadata(record); }
  Status flush(SteadyTime now);
  Status flushAll() { return session_.log().flush(); }
  /// A file disturbed by another program is not an error here: see newDisturbance().
  Status close(const std::string& reason);
  /// The disturbance of the file by another program, returned once after flush(), which checks
  /// every second, or close() has found it.
  std::optional<Error> newDisturbance();

  const SessionState& state() const { return session_.state(); }
  std::uint64_t bytes() const { return session_.log().bytesWritten(); }
  const PieceFile& file() const { return file_; }
  /// Holds only attachments and the preceding state so far.
  bool empty() const { return packets_ == 0; }
  std::optional<LogTime> lastTime() const { return end_; }

  PieceFacts facts() const;
  /// Adds the datagrams refused by the disk, by flow.
  void addRefused(std::vector<std::uint64_t>& by_flow) const;

 private:
  Status writeMade(const CapturedDatagram& octets, bool decoded);

  SessionWriter session_;
  PieceFile file_;
  SteadyTime looked_{};
  std::optional<Error> disturbance_;
  bool disturbance_reported_ = false;
  std::vector<std::optional<ChannelId>> channels_;                          ///< by flow
  std::map<std::pair<std::size_t, std::size_t>, ChannelId> made_channels_;  ///< by flow, decoder
  std::optional<ChannelId> clock_channel_;
  std::uint32_t steps_ = 0;
  std::uint64_t packets_ = 0;
  std::optional<LogTime> start_, end_;
};

}  // namespace rocinante
